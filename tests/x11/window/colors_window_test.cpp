#include "x11/window/colors_view.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/x11/support/ready_workbench.h"

namespace xnewell::THIS_FILE {

// The colour table in the window: what keys and pointer do to the colours, and how it is undone.

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

IndexImage part(const IndexImage& image, const Rect& r) {
  IndexImage copy{r.width, r.height, 0};
  for (int j = 0; j < r.height; ++j) std::copy_n(image.row(r.y + j) + r.x, r.width, copy.row(j));
  return copy;
}

IndexImage withoutStatus(const Workbench& b) {
  return part(b.image(), {0, 0, b.layout().width, b.layout().status.y});
}

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

}  // namespace

// Leaving the view brings the picture's colours back bit for bit, whatever was stored, and the window as it
// was. Esc and r do the same within the view.
TEST(ColorsWindow, LeavingRestoresThePalette) {
  for (const xnewell::Setup& setup : {xnewell::Setup{}, corrected()}) {
    ReadyWorkbench b{setup};
    const Palette palette = b.palette();
    const IndexImage image = withoutStatus(b);
    for (std::size_t k = 0; k < kEffects.size(); ++k) {
      SCOPED_TRACE(k);
      b.type("3");
      b.finish();
      const IndexImage before = withoutStatus(b);
      EXPECT_NE(before, image);
      EXPECT_EQ(b.palette(), palette);
      for (const char leaving : {'e', 'r', '1'}) {
        kEffects[k](b);
        b.finish();
        EXPECT_NE(b.palette(), palette);
        b.settle();
        if (leaving == 'e')
          b.press({NamedKey::Escape});
        else
          b.type({&leaving, 1});
        b.finish();
        EXPECT_EQ(b.palette(), palette);
        EXPECT_FALSE(b.moving());
      }
      EXPECT_EQ(withoutStatus(b), image);
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
  const IndexImage image = b.image(), shown = part(image, picture);
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
    EXPECT_EQ(part(b.image(), picture), shown);
  }
}

// The ramp is back where it was after as many steps as it has shades, and not earlier.
TEST(ColorsWindow, AFullTurnIsNone) {
  xnewell::Setup setup;
  setup.picture.table.shades = 50;
  InColors b{setup};
  const Palette start = b.palette();
  b.type("m");
  b.finish();
  EXPECT_TRUE(b.moving());
  for (int k = 1; k <= 50; ++k) {
    b.tick();
    b.update();
    EXPECT_EQ(b.palette() == start, k == 50) << k;
  }
  b.type("m");
  EXPECT_FALSE(b.moving());
}

// With several hues, each ramp moves by itself: the cells of a ramp keep the same set of colours.
TEST(ColorsWindow, EachRampMovesWithinItself) {
  InColors b{{}, "hues"};
  const Palette start = b.palette();
  b.type("m");
  b.finish();
  for (int k = 0; k < 7; ++k) b.tick();
  b.update();
  EXPECT_NE(b.palette(), start);
  const std::vector<CellRange> ramps = rampsOf(b.picture());
  EXPECT_EQ(ramps.size(), 7u);
  for (const CellRange& ramp : ramps) {
    const auto from = start.begin() + ramp.first;
    EXPECT_TRUE(std::is_permutation(from, from + ramp.count, b.palette().begin() + ramp.first));
  }
}

// While indices are held, another table changes only colours: the picture keeps its cells, and they hold the
// other table's colours. When they are let go, the window is that of a fresh start with that table.
TEST(ColorsWindow, HeldIndicesStayWhenTheTableChanges) {
  InColors b;
  const Rect picture = layoutIn(b).picture;
  const IndexImage shown = part(b.image(), picture);
  b.type("i");
  b.finish();
  b.type("T");
  EXPECT_EQ(b.setup().picture.table.kind, TableKind::Corrected);
  EXPECT_EQ(b.stale(), Stale::Colors);
  b.finish();
  EXPECT_EQ(part(b.image(), picture), shown);
  const ColorTable other{b.setup().picture.table};
  for (int j = 0; j < kMaxShades; ++j) ASSERT_EQ(b.palette()[other.first() + j], other.color(j));

  b.type("i");
  EXPECT_EQ(b.stale(), Stale::Everything);
  b.finish();
  EXPECT_NE(part(b.image(), picture), shown);
  InColors fresh{corrected()};
  EXPECT_EQ(b.palette(), fresh.palette());
  EXPECT_EQ(part(b.image(), picture), part(fresh.image(), picture));
  b.type("iT1");  // held, changed and left again: the table stays, as a setting does
  b.finish();
  EXPECT_NE(b.setup().picture.table.kind, TableKind::Corrected);
  const ColorTable last{b.setup().picture.table};
  EXPECT_EQ(b.palette()[last.first()], last.color(0));
}

// The pointer inspects the cell under it, in the grid, in the strip and in the columns of a plot. The arrows
// go on from there and stop at the ends. The strip and the words show the cell: the image changes.
TEST(ColorsWindow, PointerAndArrowsInspectCells) {
  InColors b;
  const ColorsLayout at = layoutIn(b);
  const auto inspected = [&](int cell) {
    b.finish();
    InColors other;
    other.hover(at.grid.x + cell % 16 * at.pitch + 2, at.grid.y + cell / 16 * at.pitch + 2);
    other.finish();
    return withoutStatus(b) == withoutStatus(other);
  };
  b.hover(4 * 77 + 1, b.layout().strip.y + 30);
  EXPECT_EQ(b.stale(), Stale::Everything);
  EXPECT_TRUE(inspected(77));
  EXPECT_FALSE(inspected(78));
  b.hover(4 * 77 + 2, b.layout().strip.y + 31);
  EXPECT_EQ(b.stale(), Stale::Nothing);  // the same cell
  b.press({NamedKey::Right});
  EXPECT_TRUE(inspected(78));
  b.press({NamedKey::Left, 0, true});
  EXPECT_TRUE(inspected(68));
  b.press({NamedKey::Up});
  EXPECT_TRUE(inspected(52));
  b.press({NamedKey::Down});
  b.press({NamedKey::Down});
  EXPECT_TRUE(inspected(84));
  b.hover(at.steps.x, at.steps.y + 5);
  EXPECT_TRUE(inspected(84));  // what a key or a click chose stays
  b.press({NamedKey::Escape});
  b.hover(at.steps.x, at.steps.y + 5);
  EXPECT_TRUE(inspected(11));
  b.press({NamedKey::End});
  EXPECT_TRUE(inspected(250));
  for (int k = 0; k < 3; ++k) b.press({NamedKey::Right, 0, true});
  EXPECT_TRUE(inspected(255));
  b.press({NamedKey::Home});
  EXPECT_TRUE(inspected(11));
  for (int k = 0; k < 3; ++k) b.press({NamedKey::Up});
  EXPECT_TRUE(inspected(11));
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
  b.press({NamedKey::Home});
  b.type("hh");  // a key that is held repeats
  EXPECT_EQ(lit(), std::vector<int>{11});
  EXPECT_EQ(b.palette()[11], kLit);
  b.press({NamedKey::Right});
  EXPECT_EQ(lit(), std::vector<int>{12});
  b.release('h');
  EXPECT_TRUE(lit().empty());
  b.press({NamedKey::Home});
  b.press({NamedKey::Left});
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

// If cells hold single colours, there is no ramp to move or bend. The window says so, and nothing changes. A
// shade can be lit and gamma applied as elsewhere.
TEST(ColorsWindow, SaysWhatNeedsARamp) {
  xnewell::Setup setup;
  setup.picture.colors = ColorPlan::Cube;
  InColors b{setup, "hues"};
  const Palette start = b.palette();
  const Rect plot = layoutIn(b).stored;
  const IndexImage before = b.image();
  b.type("m");
  b.finish();
  EXPECT_FALSE(b.moving());
  EXPECT_EQ(b.palette(), start);
  EXPECT_NE(b.image(), before);
  EXPECT_FALSE(b.grab(plot.x + 50, plot.y + 50));
  for (const char key : {'g', 'h'}) {
    b.type({&key, 1});
    b.finish();
    EXPECT_NE(b.palette(), start);
    b.press({NamedKey::Escape});
    b.finish();
    EXPECT_EQ(b.palette(), start);
  }
}

// Keys of controls that are not on the screen have no effect here: the setup stays.
TEST(ColorsWindow, LettersBelongToTheScreen) {
  InColors b;
  const xnewell::Setup setup = b.setup();
  b.type("SNOFPKLV[]+-ipadsncoltz");
  b.press({NamedKey::Escape});
  b.press({NamedKey::Tab});
  b.zoom(1.1);
  b.dragTo(5, 5);
  EXPECT_EQ(b.setup(), setup);
  b.type("T");
  EXPECT_NE(b.setup(), setup);
  b.type("u");
  EXPECT_EQ(b.setup(), setup);
}

// A window too small for the view shows the picture, and keys act on the picture. At every larger size the
// view is whole, and no server fills polygons over it.
TEST(ColorsWindow, EverySizeShowsSomething) {
  xnewell::Setup setup;
  setup.fill = Fill::XFillPolygon;
  ReadyWorkbench small{setup, 640, 480};
  const IndexImage picture = small.image();
  small.switchTo(View::Colors);
  small.finish();
  EXPECT_EQ(small.image(), picture);
  EXPECT_TRUE(small.serverFills());
  small.resize(800, 600);
  EXPECT_FALSE(small.serverFills());
  small.finish();
  for (const auto& [w, h] : {std::pair{800, 600}, {801, 767}, {1024, 768}, {1600, 1200}, {3000, 700}}) {
    SCOPED_TRACE(testing::Message() << w << " x " << h);
    small.resize(w, h);
    small.type("gm");
    small.tick();
    small.finish();
    EXPECT_EQ(small.image().width, w);
    EXPECT_EQ(small.image().height, h);
    EXPECT_GT(std::ranges::count(small.image().pixels, CellPlan{}[Cell::Ink]), 4000);
  }
}

}  // namespace xnewell::THIS_FILE
