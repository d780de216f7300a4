#pragma once

#include <optional>
#include <string>
#include <vector>

#include "shading/color/index_image.h"
#include "shading/color/palette.h"
#include "x11/drawing/rect.h"

namespace xnewell {

/// The right of a lesson's page: heading, paragraphs, question, the step's controls, and the way on. Also the
/// list of all lessons. Words are broken to the column; what is where is found before it is drawn, so that
/// the pointer and the tests know it.

inline constexpr int kLessonColumn = 320;  ///< pixels

/// A control of the step. Sliders have a track, choices options, toggles neither.
struct PageControl {
  char key = 0;
  std::string label;
  std::vector<std::string> options = {};
  int chosen = 0;                                ///< of the options; of a toggle whether it is on
  std::optional<double> track = {}, usual = {};  ///< of a slider, in [0, 1]: where it stands, and stood first
  std::string value = {};                        ///< at the right
  bool focused = false, enabled = true, toggle = false;
};

struct PageQuestion {
  std::string asks;
  std::vector<std::string> answers;
  std::optional<int> chosen;
  bool given = false;  ///< then `says` is what the answer brought
  std::string says;
  std::string hint;  ///< shown; "" for none
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
  int dots = 0;             ///< their centres' y
  std::vector<Line> words;  ///< of caption
  Rect box;                 ///< of the question; empty without one
  std::vector<Line> asks;
  std::vector<Rect> answers;  ///< a row each
  std::vector<std::vector<std::string>> answerLines;
  Rect answer;              ///< the button; empty where there is nothing to answer
  std::vector<Line> after;  ///< hint, or what the answer brought
  int controlsTop = 0;      ///< baseline of the section's name
  std::vector<Rect> controls;
  Rect back, next;
  int end = 0;  ///< below the last of all that flows: at most back.y where all has room
};
[[nodiscard]] LessonLayout layoutOfLesson(const Rect& column, const LessonPage& page, bool compact);
void drawLessonPage(IndexImage& image, const LessonLayout& at, const LessonPage& page, const CellPlan& plan);
/// Texts of one line that end beyond the column, for whoever sees to it that there are none.
[[nodiscard]] std::vector<std::string> tooWide(const LessonPage& page);

/// Where a place on a slider's row lies on its track, in [0, 1]; nothing off the track.
[[nodiscard]] std::optional<double> trackAt(const Rect& row, int x);
/// Which option of a choice's row.
[[nodiscard]] std::optional<int> optionAt(const Rect& row, const PageControl& control, int x);

/// The list of all lessons.
struct LessonList {
  struct Row {
    int number;
    std::string title, shows;
  };
  std::vector<Row> rows;
  int chosen = 0;
  std::optional<int> current;  ///< the one that is open
};
[[nodiscard]] std::vector<Rect> layoutOfList(const Rect& body, const LessonList& list, bool compact);
void drawLessonList(IndexImage& image, const Rect& body, const LessonList& list, const CellPlan& plan,
                    bool compact);

}  // namespace xnewell
