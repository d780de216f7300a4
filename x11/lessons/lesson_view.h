#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "x11/kit/control.h"
#include "x11/lessons/lesson.h"
#include "x11/lessons/lesson_page.h"
#include "x11/window/layout.h"
#include "x11/window/setting_controls.h"
#include "x11/window/window_view.h"

namespace xnewell {

/// What a student answered in lessons, for himself and for his teacher, in a file (answer_file.h).
class KeptAnswers {
 public:
  /// From now on each answer is written to this file. What it holds already is kept.
  /// @throws ParseError, std::system_error
  void keepIn(const std::string& file);
  /// The file in the folder where the user's programs keep their state; "" if there is none.
  /// @see XDG Base Directory Specification 0.8, XDG_STATE_HOME
  [[nodiscard]] static std::string usualFile();

  /// Adds it to what the file holds by now: another window may have answered.
  /// @throws std::system_error if the file cannot be written, or ParseError
  void add(const Lesson& lesson, int step, int answer);

  /// "2 of 3 right at the first try"; "" if no question of the lesson was answered.
  [[nodiscard]] std::string score(const std::string& lesson) const;

 private:
  struct Question {
    std::vector<int> tries;
    int right;
  };
  using Steps = std::map<int, Question>;  ///< from 0

  void read();

  std::map<std::string, Steps> lessons_;
  std::string file_;
};

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
  /// for none. `done` says which lesson has just ended.
  void draw(Pen& pen, const Layout& at, ControlList& places, const Lesson* open, const KeptAnswers& answers,
            std::string_view done);

 private:
  void openRow(int row);

  std::function<void(const LessonEntry&)> open_;
  std::vector<LessonEntry> entries_;
  int chosen_ = 0, drawn_ = -1;  ///< rows
};

/// What the controls that only lessons have can change.
struct LessonState {
  StepFigure figure;          ///< the figure as it is shown now: names, wrong faces, effects
  int event = 1, events = 1;  ///< the step of the depth sort's run, and how many there are
  bool moving = false;        ///< the ramp moves
  bool late = true;           ///< the page does not show it yet
};

/// The controls of a step, in the step's order: those of the window, which change the host's setup, and a few
/// that only lessons have. `aspect` is that of the picture, width to height. State and host must outlive
/// them.
[[nodiscard]] Controls stepControls(const LessonStep& step, LessonState& state, Host& host, double aspect);

/// Lessons in the window, without a server: which step is shown, what was answered, and what keys and pointer
/// do. A step has its own scene and settings; those of the window come back when the user leaves the lesson.
class LessonView : public WindowView {
 public:
  /// The host must outlive it.
  explicit LessonView(Host& host)
      : WindowView{host}, lessons_{[this](const LessonEntry& entry) { start(readLesson(entry.file)); }} {}
  LessonView(LessonView&&) = delete;  // its list points to it

  /// Opens a lesson at its first step. The host must switch to this view.
  void start(Lesson lesson);
  /// Closes the lesson, so that the view begins with the list. Another view must be shown.
  void forget() { lesson_.reset(), listing_ = true; }
  /// All lessons, and the score of one; "" if nothing of it was answered.
  [[nodiscard]] const std::vector<LessonEntry>& entries() {
    lessons_.read();
    return lessons_.entries();
  }
  [[nodiscard]] std::string score(const std::string& lesson) const { return answers_.score(lesson); }
  /// Keeps all answers in this file, from now on. @throws ParseError, std::system_error
  void keepAnswers(const std::string& file) { answers_.keepIn(file); }
  /// Keeps them in the usual file. If that holds anything else, says so, and keeps nothing.
  void keepAnswersAsUsual();
  /// 0 <= step < steps.
  void goTo(int step);
  [[nodiscard]] int step() const { return step_; }
  /// Null if no lesson is open.
  [[nodiscard]] const Lesson* lesson() const { return lesson_ ? &*lesson_ : nullptr; }
  [[nodiscard]] bool showsList() const { return listing_; }

  // The state of the last drawing.
  [[nodiscard]] const LessonPage& page() const { return page_; }
  [[nodiscard]] const LessonLayout& layout() const { return at_; }

  [[nodiscard]] Controls controls() override;
  [[nodiscard]] KeyTable ownKeys() override;
  /// Opens the step that the user left, or the list.
  void enter() override;
  void leave() override;
  [[nodiscard]] bool moving() const override { return state_.moving; }
  void tick() override;

  [[nodiscard]] Rect picture(const Layout& at) const override;
  [[nodiscard]] Rect frame(const Layout& at) const override { return picture(at); }
  [[nodiscard]] PaletteEffects stored(const Setup& setup) const override;
  [[nodiscard]] bool late(const Setup& setup) const override;
  void draw(Painter paint, const DrawContext& context) override;
  [[nodiscard]] std::string status() const override { return counts_; }
  [[nodiscard]] std::string aside() const override;

 private:
  /// What the user did with a question.
  struct Taken {
    std::optional<int> chosen;
    bool given = false, hint = false;
  };
  [[nodiscard]] const LessonStep& now() const { return lesson_->steps[static_cast<std::size_t>(step_)]; }
  [[nodiscard]] Taken& taken() { return taken_[static_cast<std::size_t>(step_)]; }
  [[nodiscard]] const Taken& taken() const { return taken_[static_cast<std::size_t>(step_)]; }
  void openFigure();
  void choose(int answer);
  void give();
  void goOn(int steps);
  void leaveForGood();
  void showList(bool shown);
  [[nodiscard]] Controls rows() { return stepControls(now(), state_, host_, aspect_); }
  void placeButtons();
  void drawStep(Painter paint, const DrawContext& context);
  [[nodiscard]] LessonPage pageOf(const DrawContext& context, const IndexImage* lower);

  LessonList lessons_;
  bool listing_ = true;  ///< the list is shown
  std::string done_;     ///< the lesson that has just ended, in words for the list
  std::optional<Lesson> lesson_;
  int step_ = 0;
  std::vector<Taken> taken_;  ///< one for each step
  KeptAnswers answers_;
  LessonState state_;
  std::optional<PictureCache> lower_;  ///< of View::SideBySide
  std::vector<std::string> caption_;   ///< of captionOf_, filled in
  int captionOf_ = -1;
  bool opened_ = false;   ///< the window shows the lesson's scene
  bool handing_ = false;  ///< the next view keeps that scene
  // The state of the last drawing.
  std::optional<Setup> drawn_;
  bool changed_ = false;  ///< the settings are not those of the step
  double aspect_ = 1;
  glm::dvec2 pixel_{0.5};  ///< what view 8 explains: shares of the picture's width and height
  LessonLayout at_;
  LessonPage page_;
  std::string counts_;
};

}  // namespace xnewell
