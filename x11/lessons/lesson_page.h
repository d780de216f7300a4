#pragma once

#include <optional>
#include <string>
#include <vector>

#include "x11/kit/control_list.h"

namespace xnewell {

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
