#include "x11/window/mach_bands_view.h"

#include <gtest/gtest.h>

#include "tests/x11/support/ready_workbench.h"
#include "x11/drawing/sheet.h"

namespace xnewell::THIS_FILE {

// The Mach bands in the window: which scanline is shown, and that a fresh start shows the same.

namespace {

struct InMachBands : ReadyWorkbench {
  explicit InMachBands(const std::string& scene = "teapot", int width = 1024, int height = 768)
      : ReadyWorkbench{{}, width, height, scene} {
    type("4");
    update();
  }
  [[nodiscard]] Rect shownPicture() const {
    Rect at = layoutOfMachBands(layout().width, layout().body.height + 2 * Sheet::kMargin).picture;
    at.y += layout().body.y - Sheet::kMargin;
    return at;
  }
  /// The row of the window where a scanline is marked in white from edge to edge; -1 for nowhere.
  [[nodiscard]] int markedRow() const {
    const Rect at = shownPicture();
    for (int j = at.y; j < at.y + at.height; ++j)
      if (std::all_of(image().row(j) + at.x, image().row(j) + at.x + at.width,
                      [&](std::uint8_t cell) { return cell == plan()[Cell::White]; }))
        return j;
    return -1;
  }
  void press(NamedKey name, bool shift = false) {
    ReadyWorkbench::press({name, 0, shift});
    update();
  }
  using ReadyWorkbench::press;
};

}  // namespace

// The scanline goes up and down by one row, or by ten with Shift, to both ends and no further. It keeps its
// place while the picture is shown.
TEST(MachBandsView, TheScanlineMoves) {
  InMachBands b;
  const int start = b.markedRow();
  ASSERT_GE(start, 0);
  b.press(NamedKey::Up);
  EXPECT_EQ(b.markedRow(), start - 1);
  b.press(NamedKey::Down, true);
  EXPECT_EQ(b.markedRow(), start + 9);
  b.press(NamedKey::Left, true);
  EXPECT_EQ(b.markedRow(), start - 1);
  b.press(NamedKey::Home);
  EXPECT_EQ(b.markedRow(), b.shownPicture().y);
  b.press(NamedKey::Up);
  EXPECT_EQ(b.markedRow(), b.shownPicture().y);
  b.press(NamedKey::End);
  EXPECT_EQ(b.markedRow(), b.shownPicture().y + b.shownPicture().height - 1);
  b.press(NamedKey::Down);
  EXPECT_GE(b.markedRow(), 0);
}

// In a window of another size the scanline crosses the scene at the same place.
TEST(MachBandsView, TheScanlineKeepsItsPlace) {
  InMachBands b{"teapot", 800, 600};
  b.type("=116");  // of 232 rows
  b.press(NamedKey::Return);
  b.update();
  const std::optional<int> row = b.place().scanline;
  b.resize(1600, 1200);
  b.update();
  InMachBands large{"teapot", 1600, 1200};
  large.type("=383");  // of 764
  large.press(NamedKey::Return);
  const Rect at = b.shownPicture();
  const std::uint8_t *const above = b.image().row(b.markedRow() - 1) + at.x, *const same =
                                                                                 large.image().row(
                                                                                     large.markedRow() - 1) +
                                                                                 at.x;
  EXPECT_TRUE(std::equal(above, above + at.width, same));
  b.resize(800, 600);
  b.update();
  EXPECT_EQ(b.place().scanline, row);
}

// At every height of the window the finding is whole: its box ends above the end of the body.
TEST(MachBandsView, TheFindingIsWhole) {
  xnewell::Setup setup;
  setup.divisions = 8;  // the finding has a second sentence then
  ReadyWorkbench b{setup, 1280, 540};
  b.type("4");
  for (int height = 540; height <= 1000; height += 30) {
    b.resize(1280, height);
    b.update();
    const Rect& body = b.layout().body;
    const int last = b.layout().strip.y - 1;
    int white = 0, whiteAbove = 0;
    for (int x = 900; x < 1270; ++x) {
      white += b.image().row(last)[x] == b.plan()[Cell::White];
      for (int y = body.y + body.height / 2; y < last; ++y)
        whiteAbove += b.image().row(y)[x] == b.plan()[Cell::White];
    }
    EXPECT_EQ(white, 0) << height;
    EXPECT_GT(whiteAbove, 20'000) << height;
  }
}

// Dragged in the picture, the scanline stays under the pointer. On its slider it reaches both ends.
TEST(MachBandsView, TheScanlineIsDragged) {
  for (const auto& [w, h] : {std::pair{800, 600}, {1024, 768}, {1600, 1200}}) {
    SCOPED_TRACE(w);
    InMachBands b{"teapot", w, h};
    const Rect at = b.shownPicture();
    ASSERT_TRUE(b.grab(at.x + 50, at.y + 20));
    for (const int y : {at.y + 20, at.y + at.height - 1, at.y + 7, at.y}) {
      b.dragTo(at.x + 60, y);
      b.update(true);
      EXPECT_EQ(b.markedRow(), y);
    }
    b.dragTo(at.x, at.y - 300);
    b.update(true);
    EXPECT_EQ(b.markedRow(), at.y);
    b.settle();
    b.update();
    EXPECT_EQ(b.stale(), Workbench::Stale::Nothing);
  }
}

// A row that is typed is marked. If the picture has no such row, the window says so and nothing changes.
TEST(MachBandsView, ARowIsTyped) {
  InMachBands b;
  b.type("=5");
  b.press(NamedKey::Return);
  const IndexImage five = b.image();
  EXPECT_GE(b.markedRow(), 0);
  for (const char* wrong : {"9999", "-1", "1.5", "99999999999"}) {
    b.type("=");
    b.type(wrong);
    b.press(NamedKey::Return);
    EXPECT_NE(b.image(), five);
    b.press(NamedKey::Escape);
    EXPECT_EQ(b.image(), five) << wrong;
  }
}

// The number of divisions is part of the setup. A change divides the scene again, and undo divides it as
// before. The picture is that of a scene read with these divisions.
TEST(MachBandsView, DivisionsAreUndone) {
  InMachBands b;
  const Palette palette = b.palette();
  const std::size_t faces = b.picture().scene().mesh.firstCorner.size();
  b.type("k");
  b.press(NamedKey::Right);
  EXPECT_EQ(b.picture().scene().divisions, 4);
  EXPECT_EQ(b.setup().divisions, 4);
  b.press(NamedKey::End);
  b.press(NamedKey::Home);
  EXPECT_EQ(b.picture().scene().divisions, 1);
  b.type("1");
  b.update();
  Workbench fresh{readScene("teapot", 1), {}, {}};
  fresh.resize(1024, 768);
  fresh.update();
  const Rect& at = b.layout().picture;
  for (int j = at.y; j < at.y + at.height; ++j)
    ASSERT_TRUE(
        std::equal(b.image().row(j) + at.x, b.image().row(j) + at.x + at.width, fresh.image().row(j) + at.x));
  b.type("u");
  b.update();
  EXPECT_EQ(b.picture().scene().mesh.firstCorner.size(), faces);
  EXPECT_EQ(b.palette(), palette);

  b.type("4k=7");
  b.press(NamedKey::Return);
  EXPECT_EQ(b.picture().scene().divisions, 7);
  for (const char* const wrong : {"0", "33", "2.5", "x"}) {
    b.type("=");
    b.type(wrong);
    b.press(NamedKey::Return);
    b.press(NamedKey::Escape);
    EXPECT_EQ(b.setup().divisions, 7) << wrong;
  }

  InMachBands none{"cycle"};
  const xnewell::Setup setup = none.setup();
  none.type("k");
  none.press(NamedKey::Right);
  EXPECT_EQ(none.setup(), setup);
}

// The method is chosen with its key or by a click. Turning and zooming work as in the picture and leave the
// scanline alone. A scene of colours is shown in one hue here, and in its own colours in the other views.
TEST(MachBandsView, SharesTheSetup) {
  InMachBands b;
  b.type("S");
  b.update();
  EXPECT_NE(b.setup().picture.shading, xnewell::Setup{}.picture.shading);
  const IndexImage before = b.image();
  b.type("t");
  b.press(NamedKey::Right, true);
  EXPECT_TRUE(b.setup().picture.camera.eye.has_value());
  EXPECT_NE(b.image(), before);
  b.type("y");
  const int row = b.markedRow();
  b.press(NamedKey::Down);
  EXPECT_EQ(b.markedRow(), row + 1);

  xnewell::Setup colours;
  colours.picture.colors = ColorPlan::Cube;
  ReadyWorkbench c{colours, 1024, 768, "hues"};
  const IndexImage picture = c.image();
  c.type("4");
  c.update();
  EXPECT_EQ(c.picture().colors().plan(), ColorPlan::OneHue);
  c.type("1");
  c.update();
  EXPECT_TRUE(std::equal(picture.row(100), picture.row(500), c.image().row(100)));
}

}  // namespace xnewell::THIS_FILE
