#pragma once

#include <optional>
#include <string>
#include <vector>

#include "shading/color/index_image.h"
#include "shading/color/palette.h"
#include "x11/drawing/rect.h"

namespace xnewell {

/// The right side of a lesson's page: heading, paragraphs, question, the controls of the step, and the
/// buttons to go on. Also the list of all lessons. Words are broken to the column. The layout is found before
/// anything is drawn, so that the pointer and the tests know it.

inline constexpr int kLessonColumn = 320;  ///< pixels

/// A control of the step. A slider has a track, a choice has options, a toggle has neither.
struct PageControl {
  char key = 0;
  std::string label;
  std::vector<std::string> options = {};
  int chosen = 0;                                ///< the chosen option; for a toggle 1 if it is on
  std::optional<double> track = {}, usual = {};  ///< of a slider, in [0, 1]: its place now, and at first
  std::string value = {};                        ///< at the right
  bool focused = false, enabled = true, toggle = false;
};

struct PageQuestion {
  std::string asks;
  std::vector<std::string> answers;
  std::optional<int> chosen;
  bool given = false;  ///< the answer was given; `says` is the response
  std::string says;
  std::string hint;  ///< the hint, if it is shown; "" for none
  bool hasHint = false;
};

struct LessonPage {
  std::string heading;
  int step = 0, steps = 1;  ///< from 0
  std::vector<std::string> caption;
  std::optional<PageQuestion> question;
  std::vector<PageControl> controls;
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
  Rect answer;              ///< the button; empty if there is nothing to answer
  std::vector<Line> after;  ///< the hint, or the response to the answer
  int controlsTop = 0;      ///< baseline of the name of the section
  std::vector<Rect> controls;
  Rect back, next;
  int end = 0;  ///< y below the last line; at most back.y if everything fits
};
[[nodiscard]] LessonLayout layoutOfLesson(const Rect& column, const LessonPage& page, bool compact);
void drawLessonPage(IndexImage& image, const LessonLayout& at, const LessonPage& page, const CellPlan& plan);
/// One-line texts that are wider than the column; a test checks that there are none.
[[nodiscard]] std::vector<std::string> tooWide(const LessonPage& page);

/// The share of the track of a slider at column x, in [0, 1]; nothing beside the track.
[[nodiscard]] std::optional<double> trackAt(const Rect& row, int x);
/// The option at (x, y), a place in the row of a choice.
[[nodiscard]] std::optional<int> optionAt(const Rect& row, const PageControl& control, int x, int y);

/// The list of all lessons.
struct LessonList {
  struct Row {
    int number;
    std::string title, shows;
  };
  std::vector<Row> rows;
  int chosen = 0;
  std::optional<int> current;  ///< the lesson that is open
};
[[nodiscard]] std::vector<Rect> layoutOfList(const Rect& body, const LessonList& list, bool compact);
void drawLessonList(IndexImage& image, const Rect& body, const LessonList& list, const CellPlan& plan,
                    bool compact);

}  // namespace xnewell
