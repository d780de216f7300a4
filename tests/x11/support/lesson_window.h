#pragma once

#include <optional>
#include <string>
#include <utility>

#include "shading/picture/picture_cache.h"
#include "x11/lessons/lesson_bench.h"

namespace xnewell {

/// A window with one view, the lessons, and without bands: what the workbench does for a bench, and no more.
class LessonWindow : public Host {
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
  void switchTo(WindowView v) override {
    bench.leave();
    view = v;
  }
  void compare(const Setup&) override {}
  void keepWithin(std::optional<AccuracyLimit>) override {}
  [[nodiscard]] std::optional<AccuracyLimit> keptWithin() const override { return {}; }
  void ask(Question) override {}
  void notify(std::string n) override { notice = std::move(n); }
  void tell(std::string n) override { notice = std::move(n); }
  void change(char, const std::function<void(Setup&)>& edit) override { edit(setup_); }
  [[nodiscard]] const Setup& setup() const override { return setup_; }
  [[nodiscard]] const Setup& defaults() const override { return first_; }
  void pressLetter(char) override {}

  /// Returns whether the bench took the key.
  bool press(const Key& key) {
    notice.clear();
    return bench.press(key, Setup{setup_});
  }
  bool press(char letter) { return press(Key{NamedKey::Letter, letter}); }
  bool press(NamedKey name) { return press(Key{name}); }

  const IndexImage& draw() {
    const Rect at = bench.picture(layout);
    PictureSettings settings = setup_.picture;
    settings.width = at.width, settings.height = at.height;
    const CellPlan plan{settings.table.kind};
    const Picture made = pictures->make(settings, plan[Cell::Well]);
    image = IndexImage{layout.width, layout.height, plan[Cell::Paper]};
    const Palette plain = made.palette(plan);
    const CellUse use = cellUse(made.image());
    bench.draw(image, {made, plan, plain, use, setup_, layout, false, false});
    palette = withEffects(plain, made, plan, bench.stored(setup_));
    return image;
  }

  Layout layout;
  xnewell::Setup own;  ///< the window's setup before any lesson
  LessonBench bench{*this};
  std::optional<PictureCache> pictures{readScene("teapot", 3)};
  WindowView view = WindowView::Lesson;
  IndexImage image;
  Palette palette{};
  std::string notice;
  int opened = 0, closed = 0;

 private:
  xnewell::Setup setup_, first_;
};

}  // namespace xnewell
