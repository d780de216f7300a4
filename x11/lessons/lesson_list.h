#pragma once

#include <functional>
#include <vector>

#include "x11/kit/control_list.h"
#include "x11/lessons/kept_answers.h"
#include "x11/lessons/lesson.h"
#include "x11/window/layout.h"

namespace xnewell {

/// The list of all lessons. The arrows choose one; Return or a click opens it.
class LessonList {
 public:
  explicit LessonList(std::function<void(const LessonEntry&)> open) : open_{std::move(open)} {}

  /// Reads the titles, unless they are known.
  void read();
  [[nodiscard]] const std::vector<LessonEntry>& entries() const { return entries_; }
  /// Chooses the lesson with this name, or the first one.
  void choose(const std::string& name);

  /// A button for each row.
  [[nodiscard]] Controls controls();
  [[nodiscard]] KeyTable keys();
  [[nodiscard]] bool late() const { return chosen_ != drawn_; }
  /// Draws the list with the scores, and places its rows in `places`. `open` is the lesson that is open; null
  /// for none.
  void draw(Pen& pen, const Layout& at, ControlList& places, const Lesson* open, const KeptAnswers& answers);

 private:
  void openRow(int row);

  std::function<void(const LessonEntry&)> open_;
  std::vector<LessonEntry> entries_;
  int chosen_ = 0, drawn_ = -1;  ///< rows
};

}  // namespace xnewell
