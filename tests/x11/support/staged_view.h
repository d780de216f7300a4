#pragma once

#include <optional>
#include <string>
#include <vector>

#include "shading/picture/picture_cache.h"
#include "x11/window/window_view.h"

namespace xnewell {

/// The surroundings of one bench in a window, which do nothing but what is said anew.
class QuietHost : public Host {
 public:
  void open(Scene, const xnewell::Setup&) override {}
  void close() override {}
  void undo() override {}
  void pressLetter(char) override {}
  void switchTo(View) override {}
  void explain(double, double) override {}
  void explainWrong() override {}
  void sortFrom(int) override {}
  void fill(const std::string&) override {}
  void compare(const xnewell::Setup&) override {}
  void change(char, const std::function<void(xnewell::Setup&)>&) override {}
};

/// What the workbench does for a bench, and no more.
class StagedView : public QuietHost {
 public:
  StagedView(const char* scene, int divisions, int width, int height, const xnewell::Setup& first = {})
      : now{first},
        layout{layoutOf(width, height)},
        image{width, height, 0},
        pictures{readScene(scene, divisions)} {
    now.picture.camera = completed(now.picture.camera, pictures.scene().camera);
  }

  [[nodiscard]] const xnewell::Setup& setup() const override { return now; }
  [[nodiscard]] const xnewell::Setup& defaults() const override { return now; }
  void open(Scene scene, const xnewell::Setup& s) override {
    pictures = PictureCache{std::move(scene)}, now = s;
  }
  void undo() override {
    if (undone.empty()) return;
    now = undone.back();
    undone.pop_back();
  }
  void compare(const xnewell::Setup& B) override { compared = B; }
  void ask(Question asked) override { question = std::move(asked); }
  void notify(std::string notice) override { notices.push_back(std::move(notice)); }
  void tell(std::string news) override { notices.push_back(std::move(news)); }
  void change(char, const std::function<void(xnewell::Setup&)>& edit) override {
    undone.push_back(now);
    edit(now);
  }

  void press(WindowView& bench, std::string_view letters) {
    for (const char c : letters) taken = bench.press({NamedKey::Letter, c});
  }
  void press(WindowView& bench, NamedKey name) { taken = bench.press({name}); }

  void draw(WindowView& bench, bool dragging = false) {
    const Rect at = bench.frame(layout);
    PictureSettings s = bench.painted(now).picture;
    s.width = at.width, s.height = at.height;
    plan = CellPlan{s.table.kind};
    const Picture picture = pictures.make(s, plan[Cell::Well]);
    palette = picture.palette(plan);
    const CellUse use = cellUse(picture.image());
    bench.draw(image, {.picture = picture,
                       .plan = plan,
                       .palette = palette,
                       .use = use,
                       .setup = now,
                       .layout = layout,
                       .dragging = dragging,
                       .coarse = false});
  }

  [[nodiscard]] IndexImage part(const Rect& r) const {
    IndexImage copy{r.width, r.height, 0};
    if (r.x < 0 || r.y < 0 || r.x + r.width > image.width || r.y + r.height > image.height) {
      ADD_FAILURE() << "a part beyond the window";
      return copy;
    }
    for (int j = 0; j < r.height; ++j) std::copy_n(image.row(r.y + j) + r.x, r.width, copy.row(j));
    return copy;
  }

  xnewell::Setup now;
  Layout layout;
  IndexImage image;
  CellPlan plan{};
  Palette palette{};
  PictureCache pictures;
  std::vector<std::string> notices;
  std::vector<xnewell::Setup> undone;
  std::optional<xnewell::Setup> compared;
  std::optional<Question> question;
  bool taken = false;  ///< whether the bench took the last key
};

}  // namespace xnewell
