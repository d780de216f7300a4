#pragma once

#include <optional>
#include <string>
#include <vector>

#include "x11/lessons/lesson.h"
#include "x11/lessons/lesson_controls.h"
#include "x11/lessons/lesson_page.h"
#include "x11/lessons/lesson_sight.h"
#include "x11/window/bench.h"

namespace xnewell {

/// Lessons in the window, without a server: which step is shown, what was answered, and what keys and pointer
/// do. A step has its own scene and settings; those of the window come back when the user leaves the lesson.
class LessonBench : public Bench {
 public:
  /// The host must outlive it.
  explicit LessonBench(Host& host) : Bench{host} {}

  /// Opens a lesson at its first step. The host must switch to this view.
  void start(Lesson lesson);
  /// 0 <= step < steps.
  void goTo(int step);
  [[nodiscard]] int step() const { return step_; }
  /// Null if no lesson is open.
  [[nodiscard]] const Lesson* lesson() const { return lesson_ ? &*lesson_ : nullptr; }
  [[nodiscard]] bool showsList() const { return listing_; }

  // The state of the last drawing.
  [[nodiscard]] const LessonPage& page() const { return page_; }
  [[nodiscard]] const LessonLayout& layout() const { return at_; }
  /// The rows of the list.
  [[nodiscard]] const std::vector<Rect>& rows() const { return rows_; }

  [[nodiscard]] bool press(const Key& key, const Setup& setup) override;
  [[nodiscard]] bool grab(int x, int y) override;
  void dragTo(int x, int y) override;
  void drop() override { held_.reset(); }
  /// Opens the step that the user left, or the list.
  void enter() override;
  void leave() override;
  [[nodiscard]] bool moving() const override { return state_.moving; }
  void tick() override;

  [[nodiscard]] Rect picture(const Layout& at) const override;
  [[nodiscard]] PaletteEffects stored(const Setup& setup) const override;
  [[nodiscard]] bool late(const Setup&) const override { return late_; }
  void draw(IndexImage& image, const Desk& desk) override;
  [[nodiscard]] std::string status() const override;
  [[nodiscard]] std::string aside() const override;
  [[nodiscard]] std::vector<Legend> legend() override;
  [[nodiscard]] std::vector<HelpLine> help() override;

 private:
  /// What the user did with a question.
  struct Taken {
    std::optional<int> chosen;
    bool given = false, hint = false;
  };
  [[nodiscard]] const LessonStep& now() const { return lesson_->steps[static_cast<std::size_t>(step_)]; }
  [[nodiscard]] Taken& taken() { return taken_[static_cast<std::size_t>(step_)]; }
  /// The exhibit of the step, or of the answer that was given.
  [[nodiscard]] const Exhibit& exhibit() const;
  void openExhibit();
  void choose(int answer);
  void give();
  void goOn(int steps);
  void leaveForGood();
  void showList(bool shown);
  void openListed();
  bool pressInList(const Key& key);
  bool pressControl(char letter);
  void arrow(int along, int up);
  void end(bool high);
  void nextFocus(int direction);
  /// Changes the settings through Host::change(), so that it can be undone.
  void change(LessonControl control, const std::function<void(Setup&)>& edit);
  void drawStep(IndexImage& image, const Desk& desk);
  [[nodiscard]] LessonPage pageOf(const Desk& desk, const IndexImage* lower);
  [[nodiscard]] LessonList list() const;

  std::vector<LessonEntry> entries_;  ///< read when they are first needed
  int listed_ = 0;                    ///< row of the list
  bool listing_ = true;
  std::optional<Lesson> lesson_;
  int step_ = 0;
  std::vector<Taken> taken_;  ///< one for each step
  LessonState state_;
  std::optional<LessonControl> focus_;
  std::optional<PictureCache> lower_;  ///< of Stage::SideBySide
  Setup first_;                        ///< of the step
  std::vector<std::string> caption_;   ///< of captionOf_, filled in
  int captionOf_ = -1;
  bool changed_ = false;  ///< the settings are not those of the step
  bool late_ = true, opened_ = false, handing_ = false;
  std::optional<LessonControl> held_;  ///< what is dragged: a slider, or the picture
  int x_ = 0, y_ = 0;                  ///< the pointer
  // The state of the last drawing.
  Rect sight_;
  double aspect_ = 1;
  LessonLayout at_;
  LessonPage page_;
  std::vector<Rect> rows_;
  std::string counts_;
};

}  // namespace xnewell
