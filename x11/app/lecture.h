#pragma once

#include <optional>
#include <string>
#include <vector>

#include "shading/picture/shared.h"
#include "shading/scene/scene.h"
#include "x11/lessons/lesson.h"
#include "x11/options/options.h"
#include "x11/window/controls.h"

namespace xnewell {

/// A page of a lecture: a scene with its set-up, in one of the views.
struct Page {
  std::string title, notes;
  Scene scene;
  Setup setup;
  WindowPlace place;
  std::optional<Lesson> lesson;  ///< opened in View::Lesson
};

/// The pages of a lecture, and which one is shown. What the audience changes on a page is gone when the page
/// is shown again.
class Lecture {
 public:
  /// At least one page. If `seconds` is not 0, the pages turn by themselves, each after so long without a
  /// key or click, and after the last comes the first.
  Lecture(std::vector<Page> pages, double seconds) : pages_{std::move(pages)}, seconds_{seconds} {}

  [[nodiscard]] const Page& now() const { return pages_[at_]; }
  /// "3 of 12: Why facets?"
  [[nodiscard]] std::string title() const;
  /// Goes to another page. Returns false if there is none there.
  bool turn(int pages);

  /// True if the pages turn by themselves.
  [[nodiscard]] bool plays() const { return seconds_ > 0; }
  /// True if this page has been shown long enough.
  [[nodiscard]] bool isDue() const { return plays() && shown_.ms() >= 1000 * seconds_; }
  void turnByItself();
  /// Somebody uses the page.
  void wait() { shown_ = {}; }

 private:
  std::vector<Page> pages_;
  std::size_t at_ = 0;
  double seconds_;
  Stopwatch shown_;
};

/// Reads the scene that the options name, and settles the options and the scene with each other: what the
/// scene asks for becomes part of `options.picture`, and what the command line replaces leaves the scene.
/// Prints what was strange in the file on standard error.
/// @throws UsageError, ParseError, std::system_error, ViewError
[[nodiscard]] Scene readyScene(Options& options);

}  // namespace xnewell
