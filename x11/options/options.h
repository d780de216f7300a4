#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "depthsort/replay.h"
#include "shading/picture/picture.h"
#include "x11/options/window_view.h"
#include "x11/views/shows.h"
#include "x11/views/views.h"
#include "x11/visual/visual.h"

namespace xnewell {

/// The command line as a value.

enum class Command { View, Draw, Snapshot, Trace, Lesson, Visuals, Scenes };
struct CommandRow {
  Command id;
  std::string_view name, usage, does;
};
inline constexpr std::array kCommands{
    CommandRow{Command::View, "view", "[view] [SCENE] [options]", "a window; the default command"},
    CommandRow{Command::Draw, "draw", "draw SCENE -o FILE.png [options]",
               "the picture, without any X server"},
    CommandRow{Command::Snapshot, "snapshot", "snapshot SCENE -o FILE.png [options]",
               "the picture through a real X window, read back from the server"},
    CommandRow{Command::Trace, "trace", "trace SCENE [options]",
               "the depth sort's events, one JSON object a line, or as pictures"},
    CommandRow{Command::Lesson, "lesson", "lesson [NAME] [--frames DIR]",
               "a guided lesson in the window, or as pictures; without NAME, the list"},
    CommandRow{Command::Visuals, "visuals", "visuals [options]",
               "what this X server offers and what xnewell would choose, and why"},
    CommandRow{Command::Scenes, "scenes", "scenes", "the built-in scenes and lessons, one line each"},
};

/// Who fills the polygons.
enum class Fill { XFillPolygon, Scanline };

inline constexpr glm::ivec2 kPictureSize{800, 600}, kWindowSize{1024, 768};
inline constexpr glm::ivec2 kLeastWindow{800, 600};  ///< with all controls

struct Options {
  Command command = Command::View;
  bool commandMeant = false;     ///< the scene stands where a command may: it may be one, mistyped
  std::string scene = "teapot";  ///< or the lesson
  int divisions = kDefaultDivisions;
  std::optional<glm::ivec2> size;  ///< --size, else kPictureSize or kWindowSize
  PictureSettings picture;         ///< its camera and light in the file's units
  std::vector<std::string> given;  ///< the names of all that the command line says
  bool halfVector = false;         ///< --half-vector; the picture's light has it by then
  std::string texture;             ///< "" for none
  Fill fill = Fill::Scanline;
  std::string visual;  ///< "" for the program's choice
  MapOwner colormap = MapOwner::Private;
  bool nearest = false;  ///< colours that the server lacks become the nearest it has, not a mixture
  std::string output, ids;
  bool stats = false, wholeWindow = false;
  std::string viewName = "picture";
  View view = View::Picture;                    ///< draw, snapshot: what of the picture
  WindowView windowView = WindowView::Picture;  ///< of a window,
  Show show = Show::Shaded;                     ///< and what its picture shows
  std::optional<int> scanline;                  ///< of View::MachBands
  std::optional<int> cell;                      ///< of View::Colors
  PaletteEffects effects;                       ///< of the picture and of View::Colors
  bool quick = false;                           ///< trace: the accelerated run, not the textbook's
  std::string frames;        ///< trace, lesson: a folder for pictures; "" for JSON lines, or a window
  Every every = Every::Cut;  ///< trace: of which steps

  /// Whether the command line says it: an option's name, or "scene".
  [[nodiscard]] bool gave(std::string_view option) const {
    return std::ranges::find(given, option) != given.end();
  }
};

/// Wrong usage: one line for standard error, exit status 2.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// `initially` is what a picture has without any option: the program's defaults, or what a scene asks for.
/// @throws UsageError. Returns nothing when it printed --help and there is no more to do.
[[nodiscard]] std::optional<Options> parseOptions(int argc, const char* const* argv,
                                                  const PictureSettings& initially = {});

}  // namespace xnewell
