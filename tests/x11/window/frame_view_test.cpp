#include <gtest/gtest.h>

#include <utility>

#include "tests/x11/support/staged_view.h"
#include "x11/window/window_view.h"

namespace xnewell::THIS_FILE {

namespace {

/// A whole view: a slider, a choice and a key. It draws a frame around the picture.
class FrameView : public WindowView {
 public:
  explicit FrameView(Host& host) : WindowView{host} {}
  Controls controls() override {
    return {{.kind = Control::Kind::Slider,
             .key = 'v',
             .label = "width",
             .is = "the frame's width",
             .value = width_,
             .range = {1, 40, 1, false, 0},
             .set = [this](double v) { width_ = v; }},
            {.kind = Control::Kind::Choice,
             .key = 'D',
             .label = "cell",
             .is = "the frame's colour",
             .value = cell_,
             .options = {"ink", "alarm"},
             .set = [this](double option) { cell_ = option; }}};
  }
  KeyTable ownKeys() override {
    return {{{'m'}, "least", "make the frame as thin as possible", [this](const Key&) { width_ = 1; }}};
  }
  Rect picture(const Layout& at) const override { return at.picture; }
  bool late(const Setup&) const override { return list_.late() || shown_ != std::pair{width_, cell_}; }
  void draw(Painter paint, const DrawContext& context) override {
    Pen pen{paint, context.plan};
    const Rect& at = context.layout.picture;
    const int w = static_cast<int>(width_);
    pen.paint.fillRect(at, pen(cell_ == 0 ? Cell::Ink : Cell::Alarm));
    paint.within({at.x + w, at.y + w, at.width - 2 * w, at.height - 2 * w})
        .place(context.picture.image(), at.x, at.y);
    list_.forgetPlaces();
    list_.placeColumn(controls(), context.layout.controls.x, context.layout.controls.y + 30);
    list_.draw(pen, controls());
    shown_ = {width_, cell_};
  }
  std::string status() const override { return "a frame"; }

 private:
  double width_ = 8, cell_ = 0;
  std::pair<double, double> shown_;
};

}  // namespace

// The view that the manual shows draws its frame as its controls and its key say.
TEST(FrameViewOfTheManual, DrawsItsFrame) {
  StagedView stage{"cubes", 1, 800, 600};
  FrameView view{stage};
  stage.draw(view);
  const Rect at = stage.layout.picture;
  const auto cellAt = [&](int inside) { return stage.image.row(at.y + at.height / 2)[at.x + inside]; };
  EXPECT_EQ(cellAt(7), stage.plan[Cell::Ink]);
  EXPECT_NE(cellAt(8), stage.plan[Cell::Ink]);
  stage.press(view, "Dm");
  EXPECT_TRUE(view.late(stage.now));
  stage.draw(view);
  EXPECT_EQ(cellAt(0), stage.plan[Cell::Alarm]);
  EXPECT_NE(cellAt(1), stage.plan[Cell::Alarm]);
  EXPECT_FALSE(view.late(stage.now));
}

}  // namespace xnewell::THIS_FILE
