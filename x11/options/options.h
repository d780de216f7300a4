#pragma once

#include <algorithm>
#include <array>
#include <glm/vec2.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "depthsort/record/replay.h"
#include "shading/figure/figure.h"
#include "shading/picture/picture.h"
#include "shading/scene/settings.h"
#include "shading/trade/configuration.h"
#include "x11/homework/marks_formats.h"
#include "x11/views/difference.h"
#include "x11/views/view_table.h"
#include "x11/views/views.h"
#include "x11/visual/visual.h"

namespace xnewell {

/// Where a view begins, beside its scene and the set-up.
struct WindowPlace {
  View view = View::Picture;
  int step = 0;          ///< of the depth sort, or of the polygon that is filled; of view 9 the stage, from 1
  std::string run = {};  ///< of view 2, and of judge: the file with the run of another program; "" for none
  std::optional<int> scanline = {};         ///< of the view of Mach bands
  std::optional<int> cell = {};             ///< of the view of the colours
  std::optional<std::string> polygon = {};  ///< of view 0: "59.1", or "59" for the face's first part
  std::optional<glm::ivec2> pixel = {};     ///< of view 8: column and row in its picture
  /// Of view 9: FACE.CORNER, or the number of a vertex. "" or none: one in the middle of the picture.
  std::optional<std::string> vertex = {};
  std::optional<std::string> controls =
      {};  ///< the keys of the few in view 1; "": put away; none: all of them
  /// Of view 5: the settings of B that differ from those of A. None: an order worth comparing.
  std::optional<std::vector<Override>> beside = {};
  Unlike difference = Unlike::Face;  ///< of view 5
};

/// The options that say where the view begins, with their values; those that are as without an option are
/// left out. The view itself is not among them.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> optionsOf(const WindowPlace& place);

/// The value of --beside: "order=none shade=phong", or "same" for no settings at all.
[[nodiscard]] std::string besideText(const std::vector<Override>& own);
/// Reads it. @throws UsageError
[[nodiscard]] std::vector<Override> besideOf(const std::string& text);

/// The command line as a value.

enum class Command {
  View,
  Draw,
  Snapshot,
  Figure,
  Explain,
  Trace,
  Trade,
  Extremes,
  Diagnose,
  Judge,
  Grade,
  Questions,
  Lesson,
  Lecture,
  Visuals,
  Scenes,
  Keys,
  RunHeader
};
/// What a command is, in bits.
enum : unsigned {
  kNeedsScene = 1,
  kPng = 2,    ///< -o names a PNG file
  kFills = 4,  ///< it has a server, which may fill polygons
  kPages = 8,  ///< it shows something else than a scene, in a window with room for all controls
};
struct CommandRow {
  Command id;
  std::string_view name, usage, does;
  bool draws = false;  ///< whether it takes a scene, and the settings of pictures
  unsigned bits = 0;
  std::string_view takes = {};   ///< what it takes after the scene, beside options; "" for nothing
  std::string_view output = {};  ///< what must follow -o; "" if it may be left out
  [[nodiscard]] constexpr bool is(unsigned bit) const { return (bits & bit) != 0; }
};
inline constexpr std::array kCommands{
    CommandRow{Command::View, "view", "[view] [SCENE] [options]", "a window; the default command", true,
               kFills},
    CommandRow{Command::Draw, "draw", "draw SCENE -o FILE.png [options]", "the picture, without any X server",
               true, kNeedsScene | kPng, "", "FILE.png"},
    CommandRow{Command::Snapshot, "snapshot", "snapshot SCENE -o FILE.png [options]",
               "the picture through a real X window, read back from the server", true,
               kNeedsScene | kPng | kFills, "", "FILE.png"},
    CommandRow{Command::Figure, "figure", "figure SCENE -o FILE.svg|.pdf|.eps [options]",
               "the picture as areas with smooth borders, for paper and for the web", true, kNeedsScene, "",
               "FILE.svg, FILE.pdf or FILE.eps"},
    CommandRow{Command::Explain, "explain", "explain SCENE X,Y | --viewing [VERTEX]",
               "why a pixel has its colour; what each viewing matrix does to a vertex and to its light", true,
               kNeedsScene},
    CommandRow{Command::Trace, "trace", "trace SCENE [options]",
               "the depth sort's events, one JSON object a line, or as pictures", true, kNeedsScene},
    CommandRow{Command::Trade, "trade", "trade SCENE [-o CHART.png] [--json]",
               "what each short cut saves on the scene, and the error that it costs", true,
               kNeedsScene | kPng},
    CommandRow{Command::Extremes, "extremes", "extremes SCENE [-o CHART.png] [--json]",
               "what becomes wrong first when the scene is scaled, moved, flattened ...", true,
               kNeedsScene | kPng},
    CommandRow{Command::Diagnose, "diagnose", "diagnose SCENE PICTURE.png | --scene-for A,B",
               "which mistake the program made that drew the picture; SCENE and options say what is right",
               true, kNeedsScene | kPng, "PICTURE, a PNG, PPM, BMP or XWD file"},
    CommandRow{Command::Judge, "judge", "judge SCENE ORDER.jsonl | --run RUN.jsonl [--json]",
               "whether a painting order is right, or each step of a depth sort, and what is wrong first",
               true, kNeedsScene, "ORDER, a file of JSON lines"},
    CommandRow{Command::Grade, "grade", "grade SCENE FOLDER -o MARKS.csv [options]",
               "the pictures, painting orders and answers of a class, a row each", true, kNeedsScene,
               "FOLDER, what a class has handed in", "MARKS.csv"},
    CommandRow{Command::Questions, "questions", "questions SCENE [--count N] [--seed S]",
               "questions for an exam about a scene, with computed answers", true, kNeedsScene},
    CommandRow{Command::Lesson, "lesson", "lesson [NAME] [--frames DIR] [--worksheet FILE] [--page FILE]",
               "a guided lesson in the window, as pictures, or to print; without NAME, the window lists all",
               false, kPages},
    CommandRow{Command::Lecture, "lecture", "lecture NAME [--play SECONDS] [--page FILE]",
               "the pages of a lecture in the window: PgDn and PgUp turn them", false, kPages},
    CommandRow{Command::Visuals, "visuals", "visuals [options]",
               "what this X server offers and what xnewell would choose, and why"},
    CommandRow{Command::Scenes, "scenes", "scenes",
               "the built-in scenes, lessons and lectures, one line each"},
    CommandRow{Command::Keys, "keys", "keys", "the keys of all views of the window, as tables"},
    CommandRow{Command::RunHeader, "run-header", "run-header",
               "a header in C++11, with which a depth sort of your own writes its run for `judge --run`"},
};

[[nodiscard]] constexpr const CommandRow& rowOf(Command command) {
  return kCommands[static_cast<std::size_t>(command)];
}

/// What fills the polygons: the server, or our scanline filler.
enum class Fill { XFillPolygon, Scanline };

inline constexpr glm::ivec2 kPictureSize{800, 600}, kWindowSize{1024, 768}, kExtremesSize{160, 120};
inline constexpr glm::ivec2 kLeastWindow{800, 540};  ///< has room for all controls, at scale 1
inline constexpr int kMostScale = 4;                 ///< of the window: pixels of a unit

struct Options {
  Command command = Command::View;
  bool commandMeant = false;        ///< no command was given, and the first argument may be a mistyped one
  std::string scene = "teapot";     ///< or the lesson's name, or the lecture's file
  std::string carrier;              ///< the picture that carries the scene's name and its set-up; "" for none
  std::string handedIn;             ///< diagnose, judge, grade: the picture, order or folder; "" for none
  std::optional<glm::ivec2> pixel;  ///< explain: column and row, from the top left
  int divisions = kDefaultDivisions;
  std::optional<glm::ivec2> size;   ///< none without --size: then kPictureSize or windowSize()
  int scale = 1;                    ///< of the window: pixels of a unit
  std::vector<Override> overrides;  ///< the settings that the command line gives, in its order
  PictureSettings picture;  ///< settle() has these over the scene's own, in the units of the scene's file
  std::vector<std::string> given;    ///< the names of all options on the command line
  std::vector<std::string> values;   ///< what each of these says; "true" for a flag
  std::vector<std::string> carried;  ///< those of `given` that only the carrier gives
  std::vector<std::string> keep;     ///< of kStrippable: what stays in the scene although options give it
  std::string texture;               ///< the file's name; "" for none
  Fill fill = Fill::Scanline;
  std::string visual;  ///< the visual's name; "" if the program chooses
  MapOwner colormap = MapOwner::Private;
  bool nearest = false;  ///< true: a colour that the server lacks becomes the nearest it has, not a mixture
  std::string output, ids;
  std::optional<glm::dvec3> paper;   ///< figure: the colour behind it
  int tolerance = kFigureTolerance;  ///< figure: how far colours from samples may be off, in steps of 1/255
  bool smooth = false;               ///< figure: Gouraud shading as triangles, in PDF
  ModelEdges edges = ModelEdges::None;
  glm::dvec3 edgeColor{0};
  bool bare = false;    ///< the PNG file carries no set-up
  bool stats = false;   ///< also if only --errors was given
  bool errors = false;  ///< with the errors
  bool json = false;    ///< explain, extremes, trade: all numbers instead of the text
  TradeRequest trade;
  /// How wrong the picture may be; the program chooses the cheapest short cuts that stay within it.
  std::optional<AccuracyLimit> accuracy;
  bool wholeWindow = false;
  View view = View::Picture;  ///< draw, snapshot: which view of the picture
  WindowPlace window;         ///< where the window begins
  View show = View::Picture;  ///< what the window's picture shows
  PaletteEffects effects;     ///< for the picture and View::Colors
  bool quick = false;         ///< trace: true for the accelerated run, false for the textbook's
  std::string answers;        ///< lesson, lecture: the file that keeps the answers; "" for none
  std::string sceneFor;       ///< diagnose: the keys of two mistakes; "" for none
  std::string page;           ///< grade: the HTML file to write; "" for none
  std::string rubric;         ///< grade: the file to read; "" for none
  std::string feedback;       ///< grade: the folder to write into; "" for none
  std::string gift;           ///< questions: the file for Moodle to write; "" for none
  int questions = 20;         ///< how many
  int seed = 1;               ///< of the questions
  std::string worksheet;      ///< lesson: the HTML file to write; "" for a window
  std::string solutions;      ///< lesson, questions: the file to write; "" if they follow the questions
  double play = 0;            ///< lecture: seconds until a page turns by itself; 0: never
  std::string frames;         ///< trace, lesson: a folder for pictures; "" for JSON lines, or for a window
  Every every = Every::Cut;   ///< trace: the steps that become pictures

  MarksFormat format = MarksFormat::Csv;  ///< grade: what -o writes

  /// True if the command line gives it. The argument is the name of an option, or "scene".
  [[nodiscard]] bool gave(std::string_view option) const {
    return std::ranges::find(given, option) != given.end();
  }
};

/// The files that the command writes, without folders and answers.
[[nodiscard]] inline std::vector<std::string> outputsOf(const Options& o) {
  std::vector<std::string> all{o.output, o.ids, o.page, o.gift, o.worksheet, o.solutions};
  std::erase(all, "");
  return all;
}

/// The size of the window, in pixels: what --size says, or kWindowSize in units.
[[nodiscard]] inline glm::ivec2 windowSize(const Options& o) {
  return o.size.value_or(kWindowSize * o.scale);
}

/// Wrong usage. The program prints one line on standard error and exits with status 2.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Reads the command line, and refuses what is wrong whatever the scene asks for. Of `picture` only the
/// camera and the limit of pieces are known then. Returns nothing if it printed --help or --version and there
/// is no more to do. @throws UsageError
[[nodiscard]] std::optional<Options> parseOptions(int argc, const char* const* argv);

/// Completes the options of parseOptions(): `picture` becomes `scene`, what the scene asks for, with the
/// overrides of the command line. Refuses what does not go together then. @throws UsageError
void settle(Options& options, const PictureSettings& scene);

}  // namespace xnewell
