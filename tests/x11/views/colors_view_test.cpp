#include "x11/views/colors_page.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "shading/picture/cell_use.h"
#include "shading/picture/picture_cache.h"
#include "tests/support/seeds.h"
#include "x11/views/color_strip.h"

namespace xnewell::THIS_FILE {

namespace {

constexpr int kStripAndFoot = 88;

ViewSettings settingsOf(int width, int height, TableKind kind = TableKind::Linear) {
  ViewSettings s;
  s.view = View::Colors;
  s.picture.width = width, s.picture.height = height;
  s.picture.shading = Shading::Gouraud;
  s.picture.table.kind = kind;
  s.cells = CellPlan{kind};
  return s;
}

ColorsLayout layoutOfView(int width, int height) {
  return layoutOfColors({16, 16, width - 32, height - kStripAndFoot - 28});
}

struct PlannedScene {
  const char* scene;
  ColorPlan plan;
};
constexpr std::array kPlans{PlannedScene{"teapot", ColorPlan::OneHue}, PlannedScene{"hues", ColorPlan::Hues},
                            PlannedScene{"hues", ColorPlan::Cube}, PlannedScene{"hues", ColorPlan::Chosen}};

int countIn(const IndexImage& image, const Rect& area, int cell) {
  int count = 0;
  for (int j = area.y; j < area.y + area.height; ++j)
    count += static_cast<int>(std::count(image.row(j) + area.x, image.row(j) + area.x + area.width, cell));
  return count;
}

/// The picture within the view, and how it uses its cells.
struct Shown {
  IndexImage image;
  CellUse use;
};
Shown shownIn(const IndexImage& view, const ColorsLayout& at) {
  Shown shown{IndexImage{at.picture.width, at.picture.height, 0}, {}};
  for (int j = 0; j < at.picture.height; ++j)
    std::copy_n(view.row(at.picture.y + j) + at.picture.x, at.picture.width, shown.image.row(j));
  shown.use = cellUse(shown.image);
  return shown;
}

}  // namespace

// The parts lie within the page and do not overlap, from the least size to the largest, in a picture of the
// view and in a window.
TEST(ColorsLayout, PartsDoNotMeet) {
  for (const auto& [w, h] :
       {std::pair{736, 428}, {768, 453}, {992, 612}, {1568, 1044}, {736, 1500}, {4000, 428}, {8160, 8000}}) {
    SCOPED_TRACE(testing::Message() << w << " x " << h);
    const Rect body{16, 48, w, h};
    const ColorsLayout at = layoutOfColors(body);
    const auto widened = [](Rect r, int left, int above, int right, int below) {
      return Rect{r.x - left, r.y - above, r.width + left + right, r.height + above + below};
    };
    const std::array parts{widened(at.grid, 26, 24, 2, 2),
                           at.facts,
                           widened(at.stored, kPlotLeft, 20, kPlotRight, 4),
                           widened(at.steps, kPlotLeft, 20, kPlotRight, kPlotBelow),
                           at.table,
                           at.picture};
    for (std::size_t p = 0; p < parts.size(); ++p) {
      EXPECT_FALSE(parts[p].empty());
      EXPECT_EQ(intersection(parts[p], widened(body, 0, 0, 2, 0)), parts[p]) << p;
      for (std::size_t q = 0; q < p; ++q) EXPECT_TRUE(intersection(parts[p], parts[q]).empty()) << p << q;
    }
    EXPECT_GE(at.pitch, 12);
    EXPECT_GE(std::min({at.stored.height, at.steps.height, at.picture.width}), 60);
    for (int cell = 0; cell < 256; ++cell)
      EXPECT_EQ(cellInGrid(at, at.grid.x + cell % 16 * at.pitch, at.grid.y + cell / 16 * at.pitch), cell);
    EXPECT_FALSE(cellInGrid(at, at.grid.x - 1, at.grid.y) ||
                 cellInGrid(at, at.grid.x + at.grid.width, at.grid.y));
  }
}

// A line whose options do not fit beside each other has as many rows as they need. The next line begins below
// them: each option is hit where it is drawn, and nothing is drawn over it.
TEST(ColorsLayout, LinesKeepApart) {
  const Control wide{.kind = Control::Kind::Choice,
                     .label = "table",
                     .options = {"brief", "linear", "corrected", "squared", "cubed"}},
      next{.kind = Control::Kind::Choice, .label = "stored", .options = {"8 bits", "16 bits"}};
  PictureCache pictures{readScene("teapot", 2)};
  for (const auto& [w, h] : {std::pair{736, 428}, {992, 612}}) {
    SCOPED_TRACE(testing::Message() << w << " x " << h);
    const ColorsLayout at = layoutOfColors({16, 16, w, h});
    PictureSettings settings;
    settings.width = at.picture.width, settings.height = at.picture.height;
    const CellPlan plan{settings.table.kind};
    const Picture picture = pictures.make(settings, plan[Cell::Well]);
    const Palette palette = picture.palette(plan);
    const CellUse use = cellUse(picture.image());
    const std::vector<Curve> steps = stepsSeen(picture, palette, plan, {});
    const auto drawn = [&](const std::vector<Control>& lines) {
      IndexImage image{w + 32, h + 32, plan[Cell::Paper]};
      drawColorsPage(image, at,
                     {.picture = picture,
                      .palette = palette,
                      .steps = steps,
                      .plan = plan,
                      .use = use,
                      .aside = "",
                      .lines = lines,
                      .hint = ""});
      return image;
    };
    const IndexImage none = drawn({}), first = drawn({wide}), both = drawn({wide, next});
    const RowStyle style = tableStyle(at, false);
    const ControlPlace above = placeInRow(wide, at.table.x, firstTableLine(at), style);
    const ControlPlace below = placeInRow(next, at.table.x, firstTableLine(at) + above.area.height, style);
    ASSERT_EQ(above.options.size(), 5u);
    ASSERT_EQ(below.options.size(), 2u);
    int ofWide = 0, ofNext = 0;
    for (int y = at.table.y; y < at.table.y + at.table.height; ++y)
      for (int x = at.table.x; x < at.table.x + at.table.width; ++x) {
        const bool inWide = first.row(y)[x] != none.row(y)[x], inBoth = both.row(y)[x] != none.row(y)[x];
        if (inWide) {
          ASSERT_EQ(both.row(y)[x], first.row(y)[x]);
          ASSERT_FALSE(below.area.has(x, y)) << x << ", " << y;
        } else if (inBoth) {
          ASSERT_FALSE(above.area.has(x, y)) << x << ", " << y;
        }
        ofWide += inWide, ofNext += inBoth && !inWide;
      }
    EXPECT_GT(ofWide, 500);
    EXPECT_GT(ofNext, 200);
  }
}

// Nothing runs over the right margin or from the page into the strip, for every plan and however many effects
// are told.
TEST(ColorsView, NothingIsCutOff) {
  for (const auto& [scene, plan] : kPlans) {
    PictureCache pictures{readScene(scene, 3)};
    for (const auto& [w, h] : {std::pair{768, 560}, {800, 600}, {1024, 768}, {1600, 1200}, {768, 1200}}) {
      SCOPED_TRACE(testing::Message() << scene << ' ' << w << " x " << h);
      ViewSettings s = settingsOf(w, h, TableKind::Corrected);
      s.picture.colors = plan;
      s.effects = {.hueTurn = 120, .gamma = 2.2};
      if (plan == ColorPlan::OneHue || plan == ColorPlan::Hues) {
        s.effects.stored = TableKind::Linear, s.effects.rotate = 100;
        s.effects.bend = CurvePoint{100, 120};
      }
      const IndexImage image = drawView(pictures, s).image;
      ASSERT_EQ(std::pair(image.width, image.height), std::pair(w, h));
      const int strip = h - kStripAndFoot;
      for (const Rect& margin :
           {Rect{0, 0, 12, strip}, Rect{w - 12, 0, 12, strip}, Rect{0, 0, w, 10}, Rect{0, strip - 11, w, 11}})
        EXPECT_EQ(countIn(image, margin, s.cells[Cell::Paper]), margin.width * margin.height);
    }
  }
}

// A cell that the picture uses is large in the grid and has a bar in the strip; any other cell is small and
// has none. Both show the use of the picture next to them, and the strip says how many cells are used.
TEST(ColorsView, MarksAreTheUseOfThePicture) {
  for (const auto& [scene, plan] : kPlans) {
    SCOPED_TRACE(scene);
    PictureCache pictures{readScene(scene, 4)};
    ViewSettings s = settingsOf(1024, 768);
    s.picture.colors = plan;
    s.cell = 200;
    const IndexImage view = drawView(pictures, s).image;
    const ColorsLayout at = layoutOfView(1024, 768);
    const CellUse use = shownIn(view, at).use;
    const CellRange cells = sceneCells(pictures.last());
    const int strip = 768 - kStripAndFoot, large = (at.pitch - 2) * (at.pitch - 2);
    int used = 0, unused = 0;
    for (int cell = cells.first; cell <= cells.last(); ++cell) {
      if (std::abs(cell - 200) < 2) continue;  // the inspected cell's mark covers these
      const Rect square{at.grid.x + cell % 16 * at.pitch, at.grid.y + cell / 16 * at.pitch, at.pitch,
                        at.pitch};
      const int pixels = countIn(view, square, cell), side = at.pitch * 2 / 5;
      ASSERT_EQ(pixels, use.samples[cell] > 0 ? large : side * side) << cell;
      const int bar = countIn(view, {4 * cell + 1, strip + 5, 2, 18}, s.cells[Cell::Ink]);
      ASSERT_EQ(bar > 0, use.samples[cell] > 0) << cell;
      (use.samples[cell] > 0 ? used : unused) += 1;
    }
    EXPECT_GT(used, 40);
    if (plan != ColorPlan::Chosen) {
      EXPECT_GT(unused, 5);
    }
  }
}

// On a screen that other programs share, a free cell has any colour. No pixel of the view has its number.
TEST(ColorsView, PaintsNothingWithFreeCells) {
  PictureCache pictures{readScene("teapot", 4)};
  ViewSettings s = settingsOf(1024, 768);
  s.picture.table.shades = 40;
  const IndexImage view = drawView(pictures, s).image;
  for (int cell = 51; cell <= 250; ++cell) ASSERT_EQ(countIn(view, {0, 0, 1024, 768}, cell), 0) << cell;
}

// A longer bar stands for more samples.
TEST(ColorStrip, BarsGrowWithTheUse) {
  CellUse use;
  for (int cell = 0; cell < 256; ++cell) use.samples[cell] = cell * cell;
  IndexImage image{1024, 60, 2};
  drawColorStrip(Painter{image}, {0, 0, 1024, 60}, CellPlan{}, use, {.rule = "", .shortRule = ""}, false);
  int before = 0;
  for (int cell = 0; cell < 256; ++cell) {
    const int bar = countIn(image, {4 * cell, 0, 3, 20}, CellPlan{}[Cell::Ink]) / 3;
    EXPECT_GE(bar, before);
    EXPECT_EQ(cellInStrip({0, 0, 1024, 60}, 4 * cell + 2, 30), cell);
    before = bar;
  }
  EXPECT_GE(before, 15);
}

// The view shows what is stored, in the inspected cell too. If that cell is lit, its palette entry changes,
// and exactly its samples in the small picture change. The small picture is the picture at that size.
TEST(ColorsView, LightsWhatIsAskedFor) {
  PictureCache pictures{readScene("teapot", 6)};
  ViewSettings s = settingsOf(1024, 768, TableKind::Corrected);
  const ColoredImage plainly = drawView(pictures, s);
  EXPECT_EQ(plainly.palette, pictures.last().palette(s.cells));
  const ColorsLayout at = layoutOfView(1024, 768);
  const int cell = medianCell(cellUse(shownIn(plainly.image, at).image, pictures.last().faceImage()),
                              sceneCells(pictures.last()));
  s.effects.lit = cell;
  const ColoredImage view = drawView(pictures, s);
  for (int c = 0; c < 256; ++c) EXPECT_EQ(view.palette[c], c == cell ? kLit : plainly.palette[c]);
  EXPECT_EQ(shownIn(view.image, at).image, shownIn(plainly.image, at).image);
  const IndexImage alone = pictures.last().paint(s.cells[Cell::Well]).image;
  EXPECT_EQ(shownIn(view.image, at).image, alone);
  EXPECT_GT(std::ranges::count(alone.pixels, cell), 20);
}

// --cell chooses the inspected cell, which may be one of the tool's. Without --cell, --lit chooses it.
TEST(ColorsView, InspectsWhatIsAskedFor) {
  PictureCache pictures{readScene("teapot", 3)};
  ViewSettings s = settingsOf(768, 560);
  const IndexImage usual = drawView(pictures, s).image;
  for (const int cell : {0, 8, 20, 255}) {
    s.cell = cell;
    const ColoredImage shown = drawView(pictures, s);
    EXPECT_EQ(shown.palette, pictures.last().palette(s.cells));
    EXPECT_NE(shown.image, usual);
  }
  s.cell = 20;
  s.effects.lit = 20;
  const IndexImage twenty = drawView(pictures, s).image;
  s.cell.reset();
  EXPECT_EQ(drawView(pictures, s).image, twenty);
  s.cell = 21;
  EXPECT_NE(drawView(pictures, s).image, twenty);
}

// Words next to the inspected cell's point hide no part of any curve. If one curve covers the whole plot, as
// that of a cube's largest channels does, the words hide no part of the other.
TEST(ColorsView, WordsStandBesideTheCurves) {
  for (const auto& [scene, plan] : kPlans)
    for (const TableKind kind : {TableKind::Linear, TableKind::Corrected}) {
      PictureCache pictures{readScene(scene, 3)};
      ViewSettings s = settingsOf(1024, 768, kind);
      s.picture.colors = plan;
      const CellPlan& cells = s.cells;
      const Rect plot = layoutOfView(1024, 768).stored;
      s.cell = cells[Cell::Paper];
      const IndexImage bare = drawView(pictures, s).image;
      int curve = 0;
      for (int cell = 11; cell <= 250; cell += kSanitized ? 49 : 7) {
        SCOPED_TRACE(testing::Message() << scene << ' ' << static_cast<int>(plan) << ' ' << cell);
        s.cell = cell;
        const IndexImage image = drawView(pictures, s).image;
        int hidden = 0;
        for (int j = plot.y; j < plot.y + plot.height; ++j)
          for (int i = plot.x; i < plot.x + plot.width; ++i) {
            const bool line = bare.row(j)[i] == cells[Cell::Ink] ||
                              (plan != ColorPlan::Cube && bare.row(j)[i] == cells[Cell::Faint]);
            curve += line;
            hidden += line && image.row(j)[i] == cells[Cell::Paper];
          }
        EXPECT_EQ(hidden, 0);
      }
      EXPECT_GT(curve, kSanitized ? 100 : 1000);
    }
}

// Effects change colours and the words about them, but not the cells of the picture, of the grid's marks or
// of the strip.
TEST(ColorsView, EffectsLeaveIndicesAlone) {
  PictureCache pictures{readScene("teapot", 4)};
  ViewSettings s = settingsOf(800, 600);
  s.cell = 100;
  const ColoredImage plain = drawView(pictures, s);
  const ColorsLayout at = layoutOfView(800, 600);
  for (const PaletteEffects& effects :
       {PaletteEffects{.stored = TableKind::Corrected}, PaletteEffects{.hueTurn = 90},
        PaletteEffects{.gamma = 0.5}, PaletteEffects{.bend = CurvePoint{90, 10}},
        PaletteEffects{.rotate = -3}}) {
    s.effects = effects;
    const ColoredImage changed = drawView(pictures, s);
    EXPECT_NE(changed.palette, plain.palette);
    EXPECT_EQ(shownIn(changed.image, at).image, shownIn(plain.image, at).image);
    for (int j = 0; j < 600; ++j) {
      const bool inGrid = j < at.grid.y + at.grid.height;
      const bool inStrip = j >= 600 - kStripAndFoot && j < 600 - 28;
      ASSERT_TRUE(std::equal(plain.image.row(j),
                             plain.image.row(j) + (inStrip  ? 800
                                                   : inGrid ? 320
                                                            : 0),
                             changed.image.row(j)))
          << j;
    }
  }
}

}  // namespace xnewell::THIS_FILE
