#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <utility>

#include "shading/picture/picture_cache.h"
#include "tests/x11/support/staged_view.h"
#include "x11/lessons/lesson_view.h"

namespace xnewell {

/// A window with one view, the lessons, and without bands.
class LessonWindow : public QuietHost {
 public:
  explicit LessonWindow(glm::ivec2 size = {1024, 768}) : layout{layoutOf(size.x, size.y)} {}

  void open(Scene scene, const Setup& s) override {
    pictures.emplace(std::move(scene));
    setup_ = first_ = s;
    ++opened;
  }
  void close() override {
    pictures.emplace(readScene("teapot", 3));
    setup_ = first_ = own;
    ++closed;
  }
  void switchTo(View v) override {
    bench.leave();
    view = v;
  }
  void sortFrom(int step) override {
    sortedFrom = step;
    switchTo(View::DepthSort);
  }
  void ask(Question asked) override { question = std::move(asked); }
  void notify(std::string n) override { notice = std::move(n); }
  void tell(std::string n) override { notice = std::move(n); }
  void change(char, const std::function<void(Setup&)>& edit) override { edit(setup_); }
  [[nodiscard]] const Setup& setup() const override { return setup_; }
  [[nodiscard]] const Setup& defaults() const override { return first_; }

  /// Returns whether the bench took the key.
  bool press(const Key& key) {
    notice.clear();
    return bench.press(key);
  }
  bool press(char letter) { return press(Key{NamedKey::Letter, letter}); }
  bool press(NamedKey name) { return press(Key{name}); }

  const IndexImage& draw() {
    const Rect at = bench.picture(layout);
    PictureSettings settings = setup_.picture;
    settings.width = at.width, settings.height = at.height;
    const CellPlan plan{settings.table.kind};
    const Picture made = pictures->make(settings, plan[Cell::Well]);
    shown = made;
    image = IndexImage{layout.width, layout.height, plan[Cell::Paper]};
    const Palette plain = made.palette(plan);
    const CellUse use = cellUse(made.image());
    bench.draw(image, {made, plan, plain, use, setup_, layout, false, false});
    palette = withEffects(plain, made, plan, bench.stored(setup_));
    return image;
  }

  Layout layout;
  xnewell::Setup own;  ///< the window's setup before any lesson
  LessonView bench{*this};
  std::optional<PictureCache> pictures{readScene("teapot", 3)};
  std::optional<Picture> shown;  ///< the picture that was drawn last
  View view = View::Lesson;
  IndexImage image;
  Palette palette{};
  std::string notice;
  std::optional<Question> question;
  int opened = 0, closed = 0, sortedFrom = -1;

 private:
  xnewell::Setup setup_, first_;
};

/// A window in which the lesson has begun.
inline void begin(LessonWindow& window, const std::string& name) {
  window.bench.enter();
  window.bench.start(readLesson(std::string{XNEWELL_DATA_DIR} + "/lessons/" + name + ".json"));
  window.draw();
}

template <class Visit>
void forEachLesson(Visit&& visit) {
  for (const LessonEntry& entry : builtInLessons()) {
    SCOPED_TRACE(entry.name);
    visit(entry.name);
  }
}

/// Visits every state of every step: as it appears first, with a hint, and with each answer given.
template <class Visit>
void forEachState(LessonWindow& window, Visit&& visit) {
  for (int step = 0; step < static_cast<int>(window.bench.lesson()->steps.size()); ++step) {
    window.bench.goTo(step);
    const std::string place = "step " + std::to_string(step + 1);
    window.draw();
    visit(place);
    const auto& question = window.bench.lesson()->steps[static_cast<std::size_t>(step)].question;
    if (!question) continue;
    window.press('h');
    window.draw();
    visit(place + ", hint");
    for (std::size_t k = 0; k < question->answers.size(); ++k) {
      window.press(static_cast<char>('a' + k));
      window.press(NamedKey::Return);
      window.draw();
      visit(place + ", answer " + std::to_string(k));
    }
  }
}

}  // namespace xnewell
