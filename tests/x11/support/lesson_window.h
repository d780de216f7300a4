#pragma once

#include <gtest/gtest.h>

#include <array>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <utility>

#include "shading/picture/picture_cache.h"
#include "tests/x11/support/staged_view.h"
#include "x11/lessons/lesson_view.h"

namespace xnewell {

/// The sizes of windows that lessons are tried in.
inline constexpr std::array kSizes{glm::ivec2{800, 540}, glm::ivec2{800, 600}, glm::ivec2{1024, 768},
                                   glm::ivec2{1600, 1200}};

/// A window with one view, the lessons, and without bands.
class LessonWindow : public QuietHost {
 public:
  explicit LessonWindow(glm::ivec2 size = {1024, 768}) : layout{layoutOf(size.x, size.y)} {}
  /// The lesson has begun.
  explicit LessonWindow(const std::string& lesson, glm::ivec2 size = {1024, 768}) : LessonWindow{size} {
    bench.enter();
    bench.start(readLesson(XNEWELL_DATA_DIR "/lessons/" + lesson + ".json"));
    draw();
  }

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
  void goTo(int step) {
    bench.goTo(step);
    draw();
  }
  void answer(char letter) {
    press(letter);
    press(NamedKey::Return);
    draw();
  }
  [[nodiscard]] const std::vector<LessonStep>& steps() const { return bench.lesson()->steps; }

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

/// Visits a window for each lesson, which has begun.
template <class Visit>
void forEachLesson(Visit&& visit, glm::ivec2 size = {1024, 768}) {
  for (const LessonEntry& entry : builtInLessons()) {
    SCOPED_TRACE(entry.name);
    LessonWindow window{entry.name, size};
    visit(window);
  }
}

/// Visits every state of every step of every lesson: as it appears first, with a hint, and with each answer
/// given.
template <class Visit>
void forEachState(Visit&& visit, glm::ivec2 size = {1024, 768}) {
  const auto states = [&](LessonWindow& window) {
    for (int step = 0; step < std::ssize(window.steps()); ++step) {
      SCOPED_TRACE("step " + std::to_string(step + 1));
      window.goTo(step);
      visit(window);
      const auto& question = window.steps()[step].question;
      if (!question) continue;
      window.press('h');
      window.draw();
      visit(window);
      for (std::size_t k = 0; k < question->answers.size(); ++k) {
        SCOPED_TRACE("answer " + std::to_string(k));
        window.answer(static_cast<char>('a' + k));
        visit(window);
      }
    }
  };
  forEachLesson(states, size);
}

}  // namespace xnewell
