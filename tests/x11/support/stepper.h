#pragma once

#include <string>
#include <vector>

#include "shading/picture/picture_cache.h"
#include "tests/x11/support/staged_view.h"
#include "x11/stepper/sort_page.h"
#include "x11/stepper/sort_view.h"

namespace xnewell {

/// The depth-sort stepper without a window: a scene, its picture, which is made again when the bench asks for
/// another, and what the bench asks of its host.
class Stepper : private QuietHost {
 public:
  explicit Stepper(Scene scene, int width = 1024, int height = 768)
      : bench{*this}, pictures_{std::move(scene)}, image_{width, height, 0} {
    wanted.picture.camera = completed({}, pictures_.scene().camera);
    layout_ = layoutOf(width, height);
    draw();
  }
  explicit Stepper(const char* scene, int divisions = 3, int width = 1024, int height = 768)
      : Stepper{readScene(scene, divisions), width, height} {}

  SortView bench;
  xnewell::Setup wanted;
  std::vector<std::string> notices;
  std::vector<Question> questions;
  int draws = 0;

  /// Draws as the workbench does: again if the bench wants another picture by then.
  const IndexImage& draw() {
    xnewell::Setup painted;
    do {
      painted = bench.painted(wanted);
      const Rect at = bench.picture(layout_);
      xnewell::Setup sized = painted;
      sized.picture.width = at.width, sized.picture.height = at.height;
      const Picture picture = pictures_.make(sized.picture);
      const CellPlan plan{painted.picture.table.kind};
      const CellUse use;
      const Palette palette = picture.palette(plan);
      bench.draw(image_, {picture, plan, palette, use, painted, layout_, false, false});
      ++draws;
    } while (bench.painted(wanted) != painted);
    return image_;
  }
  void press(const Key& key) {
    if (bench.waits(key)) draw();
    taken = bench.press(key);
  }
  void press(std::string_view letters) {
    for (const char c : letters) press({NamedKey::Letter, c});
  }
  void press(NamedKey name, bool shift = false) { press({name, 0, shift}); }
  bool taken = false;
  /// Presses and releases the button in the middle of a rectangle.
  void click(const Rect& r) { click(r.x + r.width / 2, r.y + r.height / 2); }
  void click(int x, int y) {
    if (bench.grab(x, y)) bench.drop();
  }
  /// Types into the newest question. Returns its objection to the text.
  std::string type(const std::string& text) { return questions.back().take(text); }

  [[nodiscard]] int step() const { return bench.view().step; }
  void goTo(int step) {
    press("g");
    static_cast<void>(type(std::to_string(step)));
  }
  [[nodiscard]] const Picture& picture() const { return pictures_.last(); }
  [[nodiscard]] SortRun& run() { return *bench.run(); }
  [[nodiscard]] std::vector<int> stepsOf(Landmark kind) { return run().landmarks().steps(kind); }
  [[nodiscard]] const Event& event() { return run().sorted().events[step() - 1]; }
  [[nodiscard]] SortLayout places() const {
    SortLayout at = layoutOfSort(layout_.body);
    at.picture = bench.picture(layout_);
    return at;
  }
  [[nodiscard]] const IndexImage& image() const { return image_; }

 private:
  [[nodiscard]] const xnewell::Setup& setup() const override { return wanted; }
  [[nodiscard]] const xnewell::Setup& defaults() const override { return wanted; }
  void ask(Question question) override { questions.push_back(std::move(question)); }
  void notify(std::string notice) override { notices.push_back(std::move(notice)); }
  void tell(std::string news) override { notices.push_back(std::move(news)); }

  PictureCache pictures_;
  Layout layout_;
  IndexImage image_;
};

}  // namespace xnewell
