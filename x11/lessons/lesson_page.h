#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "depthsort/depth_sort.h"
#include "shading/explain/viewing_story.h"
#include "shading/picture/palette_effects.h"
#include "shading/scene/picture_settings.h"
#include "shading/scene/scene.h"
#include "x11/kit/control.h"
#include "x11/views/view_table.h"

namespace xnewell {

/// What a step of a lesson shows: a scene, its settings, and what stands beside it.

/// What may be shown below the picture of a step, or instead of it, with the name that a lesson's file uses.
struct StageRow {
  View id;
  std::string name;  ///< the title of the view, without capitals
};
[[nodiscard]] std::vector<StageRow> stageRows();

/// A step of the textbook run of the depth sort: the n-th of a kind, or the n-th that a test settled.
struct EventChoice {
  std::optional<Event::Kind> kind = {};  ///< any kind if empty
  std::optional<Test> test = {};         ///< if given, `kind` is not used
  int number = 1;                        ///< from 1
  std::string says = {};                 ///< a claim: part of the sentence of the step
};
/// The step of the run, counted from 1; nothing if the run has too few such steps.
[[nodiscard]] std::optional<int> stepOf(const SortedScene& run, const EventChoice& choice);

struct NamedFace {
  int face;  ///< number in the model
  std::string name;
};

/// A number that the words of a step rely on. It is checked against what the program computes
/// (lesson_facts.h).
struct Claim {
  int fact = 0;                                     ///< index into allFacts()
  std::optional<double> is, least = {}, most = {};  ///< any of these may be given
};

struct StepFigure {
  std::shared_ptr<const Scene> scene;
  std::string sceneName;
  PictureSettings settings;    ///< without the size
  View stage = View::Picture;  ///< one of stageRows()
  std::string line;            ///< a line of words over the picture
  std::vector<NamedFace> names;
  bool extents = false;      ///< the z-extents of the named faces are drawn below
  bool named = true;         ///< the names are shown
  bool wrongMarked = false;  ///< samples that show a wrong face are marked
  PaletteEffects effects;
  EventChoice event;       ///< for View::DepthSort
  int stepBits = 24;       ///< for View::Scanline and its facts: after the point of a value that is stepped
  double filled = 0.6;     ///< for View::Scanline: the share of the samples that are filled
  PictureSettings beside;  ///< for View::SideBySide: the lower picture
  std::string upperLine, lowerLine;
  /// For View::Viewing: the stage that is shown, the one at which the light is computed, and the vertex that
  /// is followed.
  ViewStage viewStage = ViewStage::World, shadedIn = ViewStage::World;
  FaceCorner vertex;
  std::vector<Claim> claims;
};

/// The right side of a lesson's page: heading, paragraphs, question, the controls of the step, and the
/// buttons to go on. Words are broken to the column.

inline constexpr int kLessonColumn = 320;  ///< pixels

struct PageQuestion {
  std::string asks;
  std::vector<std::string> answers;
  std::optional<int> chosen;
  bool given = false;  ///< the answer was given; `says` is the response
  bool right = false;  ///< the answer holds
  std::string says;
  std::string hint;  ///< the hint, if it is shown; "" for none
};

struct LessonPage {
  std::string heading;
  int step = 0, steps = 1;  ///< from 0
  std::vector<std::string> caption;
  std::optional<PageQuestion> question;
};

struct LessonLayout {
  struct Line {
    int x, baseline;
    std::string text;
  };
  Rect column;
  bool compact = false;
  int dots = 0;             ///< y of their centres
  std::vector<Line> words;  ///< of the caption
  Rect box;                 ///< of the question; empty if there is none
  std::vector<Line> asks;
  std::vector<Rect> answers;  ///< one row for each answer
  std::vector<std::vector<std::string>> answerLines;
  Rect answer;                  ///< the button; empty if there is nothing to answer
  std::vector<Line> after;      ///< the hint, or the response to the answer
  std::optional<int> controls;  ///< baseline of the name of their section
  Rect back, next;
  int end = 0;  ///< y below the last line; at most back.y if everything fits
};
/// Lays out the page and places the rows of the step's controls, which `list` draws.
[[nodiscard]] LessonLayout layoutOfLesson(const Rect& column, const LessonPage& page, const Controls& rows,
                                          ControlList& list, bool compact);
/// Draws all but the controls.
void drawLessonPage(Pen& pen, const LessonLayout& at, const LessonPage& page);

}  // namespace xnewell
