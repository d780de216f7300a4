#include <gtest/gtest.h>

#include <algorithm>

#include "tests/x11/support/ready_workbench.h"
#include "x11/drawing/sheet.h"
#include "x11/window/colors_view.h"
#include "x11/window/mach_bands_view.h"

namespace xnewell::THIS_FILE {

namespace {

using Stale = Workbench::Stale;

struct InColors : ReadyWorkbench {
  explicit InColors(const xnewell::Setup& setup = {}, const std::string& scene = "teapot")
      : ReadyWorkbench{setup, 1024, 768, scene} {
    type("3");
    update();
  }
};

xnewell::Setup corrected() {
  xnewell::Setup setup;
  setup.picture.table.kind = TableKind::Corrected;
  return setup;
}

ColorsLayout layoutIn(const Workbench& b) { return layoutOfColors(b.layout().body); }

void dragCurve(Workbench& b, int dy) {
  const Rect plot = layoutIn(b).stored;
  ASSERT_TRUE(b.grab(plot.x + plot.width / 2, plot.y + plot.height / 2));
  b.dragTo(plot.x + plot.width / 2, plot.y + plot.height / 2 + dy);
}

/// Keys that change the colours of the view, and no setting of the picture.
const std::array<std::function<void(ReadyWorkbench&)>, 5> kEffects{
    [](ReadyWorkbench& b) { b.type("h"); }, [](ReadyWorkbench& b) { b.type("m"), b.tick(); },
    [](ReadyWorkbench& b) { b.type("g"); }, [](ReadyWorkbench& b) { dragCurve(b, -30); },
    [](ReadyWorkbench& b) { b.type("hgm"), b.tick(), dragCurve(b, 20); }};

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

// The colour table in the window: what keys and pointer do to the colours, and how it is undone.

// Leaving the view brings the picture's colours back bit for bit, whatever was stored, and the window as it
// was. Esc and r do the same within the view.
TEST(ColorsWindow, LeavingRestoresThePalette) {
  for (const xnewell::Setup& setup : {xnewell::Setup{}, corrected()}) {
    ReadyWorkbench b{setup};
    const Palette palette = b.palette();
    const IndexImage image = b.aboveStatus();
    for (std::size_t k = 0; k < kEffects.size(); ++k) {
      SCOPED_TRACE(k);
      b.does("3");
      const IndexImage before = b.aboveStatus();
      EXPECT_NE(before, image);
      EXPECT_EQ(b.palette(), palette);
      for (const char leaving : {'e', 'r', '1'}) {
        kEffects[k](b);
        b.finish();
        EXPECT_NE(b.palette(), palette);
        b.settle();
        if (leaving == 'e')
          b.press(NamedKey::Escape);
        else
          b.type({&leaving, 1});
        b.finish();
        EXPECT_EQ(b.palette(), palette);
        EXPECT_FALSE(b.moving());
      }
      EXPECT_EQ(b.aboveStatus(), image);
    }
  }
}

// A lit shade and the moving ramp change only colours: no index of the window changes. Lasting effects change
// colours first; then the words follow, but the picture's indices do not change.
TEST(ColorsWindow, EffectsAreColorsAlone) {
  InColors b{corrected()};
  b.type("m");
  EXPECT_EQ(b.stale(), Stale::Everything);  // the line of words that says so
  b.finish();
  const Rect picture = layoutIn(b).picture;
  const IndexImage image = b.image(), shown = partOf(image, picture);
  EXPECT_GT(std::ranges::count_if(shown.pixels, [](int cell) { return cell > 10; }), 10'000);
  const auto changesColors = [&](auto&& act) {
    const IndexImage before = b.image();
    const Palette palette = b.palette();
    act();
    EXPECT_EQ(b.stale(), Stale::Colors);
    b.update();
    EXPECT_EQ(b.image(), before);
    EXPECT_NE(b.palette(), palette);
  };
  for (int k = 0; k < 5; ++k) changesColors([&] { b.tick(); });
  changesColors([&] { b.type("h"); });
  b.release('h');  // a tap keeps it lit, and another one ends that
  EXPECT_EQ(b.stale(), Stale::Nothing);
  b.type("h");
  changesColors([&] { b.release('h'); });
  EXPECT_EQ(b.stale(), Stale::Nothing);
  EXPECT_EQ(b.image(), image);

  for (const char key : {'g', 'H', 'B'}) {
    SCOPED_TRACE(key);
    changesColors([&] { b.type({&key, 1}); });
    EXPECT_EQ(b.stale(), Stale::Everything);
    b.update();
    EXPECT_EQ(b.stale(), Stale::Nothing);
    EXPECT_NE(b.image(), image);
    EXPECT_EQ(b.part(picture), shown);
  }
}

// While indices are held, another table changes only colours: the picture keeps its cells, and they hold the
// other table's colours. When they are let go, the window is that of a fresh start with that table.
TEST(ColorsWindow, HeldIndicesStayWhenTheTableChanges) {
  InColors b;
  const Rect picture = layoutIn(b).picture;
  const IndexImage shown = b.part(picture);
  b.does("i");
  b.type("T");
  EXPECT_EQ(b.setup().picture.table.kind, TableKind::Corrected);
  EXPECT_EQ(b.stale(), Stale::Colors);
  b.finish();
  EXPECT_EQ(b.part(picture), shown);
  const ColorTable other{b.setup().picture.table};
  for (int j = 0; j < kMaxShades; ++j) ASSERT_EQ(b.palette()[other.first() + j], other.color(j));

  b.type("i");
  EXPECT_EQ(b.stale(), Stale::Everything);
  b.finish();
  EXPECT_NE(b.part(picture), shown);
  InColors fresh{corrected()};
  EXPECT_EQ(b.palette(), fresh.palette());
  EXPECT_EQ(b.part(picture), fresh.part(picture));
  b.does("iT1");  // held, changed and left again: the table stays, as a setting does
  EXPECT_NE(b.setup().picture.table.kind, TableKind::Corrected);
  const ColorTable last{b.setup().picture.table};
  EXPECT_EQ(b.palette()[last.first()], last.color(0));
}

// The pointer inspects the cell under it, in the grid, in the strip and in the columns of a plot. The arrows
// go on from there and stop at the ends. The strip and the words show the cell: the image changes.
TEST(ColorsWindow, PointerAndArrowsInspectCells) {
  InColors b;
  const ColorsLayout at = layoutIn(b);
  const auto inspects = [&](int cell) {
    const IndexImage before = b.aboveStatus();
    b.finish();
    return b.bench().inspected() == cell && b.aboveStatus() != before;
  };
  const Rect& strip = b.layout().strip;
  b.hover(4 * 77 + 1, strip.y + 30);
  EXPECT_EQ(b.stale(), Stale::Everything);
  EXPECT_TRUE(inspects(77));
  b.hover(4 * 77 + 2, strip.y + 31);
  EXPECT_EQ(b.stale(), Stale::Nothing);  // the same cell
  b.hover(at.grid.x + 13 * at.pitch + 2, at.grid.y + 2 * at.pitch + 2);
  EXPECT_TRUE(inspects(45));
  b.pointAt(4 * 77 + 1, strip.y + 30);
  for (const auto& [name, shift, cell] : {std::tuple{NamedKey::Right, false, 78},
                                          {NamedKey::Left, true, 68},
                                          {NamedKey::Up, false, 52},
                                          {NamedKey::Down, false, 68},
                                          {NamedKey::Down, false, 84}}) {
    b.press({name, 0, shift});
    EXPECT_TRUE(inspects(cell)) << cell;
  }
  b.hover(at.steps.x, at.steps.y + 5);
  EXPECT_EQ(b.bench().inspected(), 84);  // what a key or a click chose stays
  b.press(NamedKey::Escape);
  b.hover(at.steps.x, at.steps.y + 5);
  EXPECT_TRUE(inspects(11));
  b.press(NamedKey::End);
  EXPECT_TRUE(inspects(250));
  for (int k = 0; k < 3; ++k) b.press({NamedKey::Right, 0, true});
  EXPECT_TRUE(inspects(255));
  b.press(NamedKey::Home);
  EXPECT_TRUE(inspects(11));
  for (int k = 0; k < 3; ++k) b.press(NamedKey::Up);
  EXPECT_EQ(b.bench().inspected(), 11);
}

// The inspected cell is lit as long as the key is held, also when another cell is inspected meanwhile. The
// tool's cells are not lit, and the status line says so.
TEST(ColorsWindow, LightsWhatIsInspected) {
  InColors b;
  const Palette start = b.palette();
  const auto lit = [&] {
    b.finish();
    std::vector<int> cells;
    for (int cell = 0; cell < 256; ++cell)
      if (b.palette()[cell] != start[cell]) cells.push_back(cell);
    return cells;
  };
  b.press(NamedKey::Home);
  b.type("hh");  // a key that is held repeats
  EXPECT_EQ(lit(), std::vector<int>{11});
  EXPECT_EQ(b.palette()[11], kLit);
  b.press(NamedKey::Right);
  EXPECT_EQ(lit(), std::vector<int>{12});
  b.release('h');
  EXPECT_TRUE(lit().empty());
  b.press(NamedKey::Home);
  b.press(NamedKey::Left);
  const IndexImage before = b.image();
  b.type("h");
  EXPECT_TRUE(lit().empty());
  EXPECT_NE(b.image(), before);
}

// The curve follows the drag at the cell where it was grabbed, and still rises. Nothing else can be dragged.
TEST(ColorsWindow, TheCurveIsDragged) {
  InColors b;
  const ColorsLayout at = layoutIn(b);
  EXPECT_FALSE(b.grab(at.steps.x + 30, at.steps.y + 5));
  EXPECT_FALSE(b.grab(at.picture.x + 30, at.picture.y + 30));
  const int x = at.stored.x + at.stored.width / 4, cell = cellAtX({11, 240}, at.stored, x);
  ASSERT_TRUE(b.grab(x, at.stored.y + 100));
  b.finish();
  for (const int y : {90, 50, 20}) {
    b.dragTo(x, at.stored.y + y);
    EXPECT_EQ(b.stale(), Stale::Colors);
    b.finish();
    const double asked = 255.0 * (1 - static_cast<double>(y) / (at.stored.height - 1));
    EXPECT_NEAR(b.palette()[cell].r / 257.0, std::min(asked, 240.0), 0.01);
    for (int k = 12; k <= 250; ++k) ASSERT_GE(b.palette()[k].r, b.palette()[k - 1].r) << k;
  }
  b.settle();
  const Palette bent = b.palette();
  b.dragTo(x, at.stored.y + 50);
  b.finish();
  EXPECT_EQ(b.palette(), bent);
}

// The Mach bands in the window: which scanline is shown, and that a fresh start shows the same.

// The scanline goes up and down by one row, or by ten with Shift, to both ends and no further.
TEST(MachBandsView, TheScanlineMoves) {
  InMachBands b;
  const int start = b.markedRow(), first = b.shownPicture().y, last = first + b.shownPicture().height - 1;
  ASSERT_GE(start, 0);
  for (const auto& [name, shift, row] : {std::tuple{NamedKey::Up, false, start - 1},
                                         {NamedKey::Down, true, start + 9},
                                         {NamedKey::Left, true, start - 1},
                                         {NamedKey::Home, false, first},
                                         {NamedKey::Up, false, first},
                                         {NamedKey::End, false, last}}) {
    b.press(name, shift);
    EXPECT_EQ(b.markedRow(), row);
  }
  b.press(NamedKey::Down);
  EXPECT_GE(b.markedRow(), 0);
}

// In a window of another size the scanline crosses the scene at the same place.
TEST(MachBandsView, TheScanlineKeepsItsPlace) {
  InMachBands b{"teapot", 800, 600}, large{"teapot", 1600, 1200};
  b.type("=116");  // of 232 rows
  b.press(NamedKey::Return);
  const std::optional<int> row = b.place().scanline;
  b.resize(1600, 1200);
  b.update();
  large.type("=383");  // of 764
  large.press(NamedKey::Return);
  const auto above = [](const InMachBands& w) {
    return w.part({w.shownPicture().x, w.markedRow() - 1, w.shownPicture().width, 1});
  };
  EXPECT_EQ(above(b), above(large));
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

// A scene of colours is shown in one hue here, and in its own colours in the other views.
TEST(MachBandsView, SharesTheSetup) {
  xnewell::Setup colours;
  colours.picture.colors = ColorPlan::Cube;
  ReadyWorkbench b{colours, 1024, 768, "hues"};
  const IndexImage picture = b.part(b.layout().picture);
  b.does('4');
  EXPECT_EQ(b.picture().colors().plan(), ColorPlan::OneHue);
  b.does('1');
  EXPECT_EQ(b.part(b.layout().picture), picture);
}

}  // namespace xnewell::THIS_FILE
