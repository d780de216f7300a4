#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <set>

#include "shading/picture/cell_use.h"
#include "shading/picture/palette_effects.h"
#include "shading/picture/picture_cache.h"
#include "tests/support/seeds.h"
#include "tests/x11/support/ready_workbench.h"
#include "x11/views/cell_facts.h"
#include "x11/views/colors_page.h"
#include "x11/views/plot.h"

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

constexpr std::array kPlans{std::pair{"teapot", ColorPlan::OneHue}, std::pair{"hues", ColorPlan::Hues},
                            std::pair{"hues", ColorPlan::Cube}, std::pair{"hues", ColorPlan::Chosen}};

int countIn(const IndexImage& image, const Rect& area, int cell) {
  return static_cast<int>(std::ranges::count(partOf(image, area).pixels, cell));
}

/// The numbers in a text like `0.1868 <= I < 0.1899`, if it has them, and how many decimals they have.
struct Interval {
  double from = -1, to = -1;
  int decimals = 0;
};
Interval parsed(const std::string& text) {
  Interval interval;
  if (std::sscanf(text.c_str(), "%lf <= I < %lf", &interval.from, &interval.to) == 0) {
    EXPECT_EQ(std::sscanf(text.c_str(), "I < %lf", &interval.to), 1);
  }
  const std::size_t point = text.find('.') + 1;
  interval.decimals =
      static_cast<int>(std::min(text.find_first_not_of("0123456789", point), text.size()) - point);
  return interval;
}

std::string valueOf(const std::vector<CellFact>& facts, std::string_view label) {
  const auto fact = std::ranges::find(facts, label, &CellFact::label);
  return fact == facts.end() ? "" : fact->value;
}

struct Made {
  Picture picture;
  CellUse use;
  Palette palette;
  CellPlan plan;
};
Made made(const char* scene, ColorPlan colors, const TableSettings& table) {
  PictureSettings s;
  s.width = 320, s.height = 240;
  s.shading = Shading::Gouraud;
  s.colors = colors;
  s.table = table;
  const CellPlan plan{table.kind};
  const Picture picture = makePicture(readScene(scene, 8), s, plan[Cell::Well]);
  return {picture, cellUse(picture.image(), picture.faceImage()), picture.palette(plan), plan};
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
    const CellUse use = cellUse(partOf(view, at.picture));
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

// The view shows what is stored, in the inspected cell too. If that cell is lit, its palette entry changes,
// and exactly its samples in the small picture change. The small picture is the picture at that size.
TEST(ColorsView, LightsWhatIsAskedFor) {
  PictureCache pictures{readScene("teapot", 6)};
  ViewSettings s = settingsOf(1024, 768, TableKind::Corrected);
  const ColoredImage plainly = drawView(pictures, s);
  EXPECT_EQ(plainly.palette, pictures.last().palette(s.cells));
  const Rect at = layoutOfView(1024, 768).picture;
  const IndexImage alone = pictures.last().paint(s.cells[Cell::Well]).image;
  const int cell = medianCell(cellUse(alone, pictures.last().faceImage()), sceneCells(pictures.last()));
  s.effects.lit = cell;
  const ColoredImage view = drawView(pictures, s);
  for (int c = 0; c < 256; ++c) EXPECT_EQ(view.palette[c], c == cell ? kLit : plainly.palette[c]);
  EXPECT_EQ(partOf(view.image, at), alone);
  EXPECT_EQ(partOf(plainly.image, at), alone);
  EXPECT_GT(std::ranges::count(alone.pixels, cell), 20);
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

// The strip says what the cells hold, and when the colours were changed.
TEST(ColorStrip, SaysWhatTheCellsHold) {
  const Picture picture = made("teapot", ColorPlan::OneHue, {}).picture;
  const auto rule = [&](const PaletteEffects& effects) { return wordsOf(picture, effects).rule; };
  EXPECT_EQ(rule({}), "linear: cell i holds (i - 10)/255 of the hue");
  EXPECT_EQ(rule({.lit = 40}), rule({}));
  EXPECT_EQ(rule({.rotate = 60}), "linear, changed");
  EXPECT_EQ(rule({.gamma = 1.8}), "linear, changed");
  EXPECT_EQ(rule({.stored = TableKind::Corrected}), "indices of linear, colours of corrected");
}

// The printed ends of a cell's interval are right, for every shade of every table. Numbers with the printed
// decimals pick the cell if and only if they are at least the first end and below the second.
TEST(CellFacts, TheIntervalPicksExactlyThatShade) {
  int checked = 0;
  for (const TableRow& row : kTables)
    for (const int shades : {2, 3, 17, 64, 240})
      for (const double I0 : {1e-6, 0.02, 0.5})
        for (const PickRow& pick : kPicks) {
          const ColorTable table{{.kind = row.id, .shades = shades, .I0 = I0, .pick = pick.id}};
          for (int j = 0; j < shades; ++j) {
            const std::string text = pickedText(table, j);
            SCOPED_TRACE(std::string{row.name} + ' ' + std::to_string(shades) + ' ' + text);
            const auto [from, to, decimals] = parsed(text);
            ASSERT_GE(decimals, 4);
            const double unit = std::pow(10, -decimals);
            ASSERT_EQ(from < 0, j == 0);
            ASSERT_EQ(to < 0, j == shades - 1);
            if (j > 0) {
              ASSERT_EQ(table.shade(from), j);
              ASSERT_LT(table.shade(from - unit * (1 - 1e-9)), j);
            }
            if (j < shades - 1) {
              ASSERT_GT(table.shade(to), j);
              ASSERT_EQ(table.shade(to - unit * (1 - 1e-9)), j);
            }
            ++checked;
          }
        }
  EXPECT_GT(checked, 5'000);
}

// Every cell has facts in every plan, and as many users as were counted. The tool's cells say what they are
// for, and free cells say that nothing needs them.
TEST(CellFacts, EveryCellHasSome) {
  int used = 0;
  for (const auto& [scene, plan] : kPlans) {
    const Made m = made(scene, plan, {.shades = 100});
    int tools = 0, free = 0;
    for (int cell = 0; cell < 256; ++cell) {
      const std::vector<CellFact> facts = factsOf(cell, m.picture, m.palette, m.plan, m.use);
      EXPECT_GE(facts.size(), 3u);
      EXPECT_LE(facts.size(), 7u);
      const std::string holds = valueOf(facts, "holds"), users = valueOf(facts, "used by");
      tools += holds.starts_with("the tool's own: ");
      free += holds == "nothing of ours: a free cell";
      if (!sceneCells(m.picture).has(cell)) continue;
      const int n = m.use.samples[cell], p = m.use.polygons[cell];
      if (n == 0) {
        EXPECT_EQ(users, "no sample");
      } else if (n > 1 && n < 1000 && p > 1) {
        EXPECT_EQ(users, std::to_string(n) + " samples, " + std::to_string(p) + " polygons");
        ++used;
      }
    }
    EXPECT_EQ(tools, kCells);
    EXPECT_EQ(free, 240 - sceneCells(m.picture).count);
  }
  EXPECT_GT(used, 50);
}

// What is told is counted from what is stored. A bent curve has fewer levels at 8 bits, and a table of 8 bits
// has no more at 16. This test collects the red values one by one.
TEST(TableCurves, CountStoredLevels) {
  for (const int bits : {8, 16}) {
    const Picture picture =
        made("teapot", ColorPlan::OneHue, {.kind = TableKind::Corrected, .bits = bits}).picture;
    const CellPlan plan{TableKind::Corrected};
    const Palette plain = picture.palette(plan);
    const Palette bent = withEffects(plain, picture, plan, {.bend = CurvePoint{200, 20}});
    const auto told = [&](const Palette& stored) {
      std::set<int> all, eight;
      for (int cell = picture.table().first(); cell < picture.table().first() + 240; ++cell) {
        all.insert(stored[cell].r);
        eight.insert((stored[cell].r + 128) / 257);
      }
      return std::to_string(all.size()) + " of 240 stored levels distinct, " + std::to_string(eight.size()) +
             " at 8 bits   the eye sees 0 of 0 steps";
    };
    for (const Palette& stored : {plain, bent})
      EXPECT_EQ(levelsText(picture, stored, {}).substr(std::string{"r = 1.01650299   "}.size()),
                told(stored));
    EXPECT_EQ(told(plain).substr(0, 4), bits == 8 ? "144 " : "240 ");
    EXPECT_NE(told(plain), told(bent));
  }
}

// With one hue there is a curve for each table, over the cells that the table would fill. No curve falls. The
// chosen table's curve is what the palette holds.
TEST(TableCurves, OneForEachTable) {
  for (const TableRow& row : kTables)
    for (const int shades : {2, 64, 240}) {
      SCOPED_TRACE(std::string{row.name} + ' ' + std::to_string(shades));
      const Picture picture = made("teapot", ColorPlan::OneHue, {.kind = row.id, .shades = shades}).picture;
      const Palette palette = picture.palette(CellPlan{row.id});
      const std::vector<Curve> curves = storedCurves(picture, palette);
      ASSERT_EQ(curves.size(), kTables.size());
      for (const Curve& curve : curves) {
        EXPECT_EQ(curve.chosen, curve.name == row.name);
        ASSERT_EQ(static_cast<int>(curve.y.size()), shades);
        EXPECT_TRUE(std::ranges::is_sorted(curve.y));
        const auto of = std::ranges::find(kTables, curve.name, &TableRow::name);
        ASSERT_NE(of, kTables.end());
        EXPECT_EQ(curve.first, of->first);
        const ColorTable table{{.kind = of->id, .shades = shades}};
        for (int j = 0; j < shades; ++j) EXPECT_NEAR(curve.y[j], 255 * table.level(j), 0.5 / 257 + 1e-9);
      }
    }
}

// Colours that no table gives are named so, and the table is shown for comparison.
TEST(TableCurves, NameWhatIsStored) {
  const Picture picture = made("teapot", ColorPlan::OneHue, {.kind = TableKind::Corrected}).picture;
  const CellPlan plan{TableKind::Corrected};
  const std::vector<Curve> curves =
      storedCurves(picture, withEffects(picture.palette(plan), picture, plan, {.gamma = 2.2}));
  ASSERT_EQ(curves.size(), 4u);
  EXPECT_EQ(curves[0].name, "as stored");
  EXPECT_EQ(std::ranges::count(curves, true, &Curve::chosen), 1);
  EXPECT_EQ(std::ranges::count(curves, "corrected", &Curve::name), 1);
}

// The lower plot shows this: every step of `corrected` is r, up to the rounding to 16 bits, and above what
// the eye can see. The steps of `linear` fall from 100 % to less than that.
TEST(TableCurves, StepsOfTheCorrectedTableAreEqual) {
  const TableSettings corrected{.kind = TableKind::Corrected};
  const Picture picture = made("teapot", ColorPlan::OneHue, corrected).picture;
  const Palette palette = picture.palette(CellPlan{TableKind::Corrected});
  const double r = 100 * (ratioOf(ColorTable{corrected}) - 1);
  for (const Curve& curve : stepCurves(picture, palette)) {
    SCOPED_TRACE(curve.name);
    EXPECT_TRUE(std::isnan(curve.y.back()));
    if (curve.name == "corrected") {
      for (int j = 0; j + 1 < 240; ++j) {
        // Each value is off by at most half a unit of 65535.
        const double rounding = 100 * 1.02 / (65535 * ColorTable{corrected}.level(j));
        ASSERT_NEAR(curve.y[j], r, rounding) << j;
        ASSERT_GT(curve.y[j], kSeenStep);
      }
    } else {
      const std::size_t first = curve.name == "brief";  // this one begins with black
      EXPECT_EQ(std::isnan(curve.y[0]), first == 1);
      EXPECT_NEAR(curve.y[first], 100, 1e-9);
      EXPECT_NEAR(curve.y[238], 100.0 / 239, 0.01);
    }
  }
}

// With several hues, each has a curve, and nothing is shown for comparison. With single colours, the curve is
// their luminance, and the lower plot shows each colour's distance to its nearest neighbour, which is at
// least that neighbour's own.
TEST(TableCurves, OtherPlansShowWhatIsTrueOfThem) {
  const Picture hues = made("hues", ColorPlan::Hues, {}).picture;
  EXPECT_EQ(storedCurves(hues, hues.palette(CellPlan{})).size(), 7u);
  EXPECT_EQ(stepCurves(hues, hues.palette(CellPlan{})).size(), 7u);

  const Picture cube = made("hues", ColorPlan::Cube, {}).picture;
  const Palette palette = cube.palette(CellPlan{});
  const std::vector<Curve> stored = storedCurves(cube, palette), steps = stepCurves(cube, palette);
  ASSERT_EQ(stored.size(), 2u);
  EXPECT_EQ(stored[0].y.front(), 0);
  EXPECT_NEAR(stored[0].y.back(), 255, 1e-9);
  for (int k = 0; k < 240; ++k) EXPECT_LE(stored[0].y[k], stored[1].y[k] + 1e-9);
  ASSERT_EQ(steps.size(), 1u);
  for (const double y : steps[0].y) EXPECT_GT(y, 0);
}

// Ticks go from below the least value to above the largest, and are 1 or 3 times a power of ten.
TEST(Plot, LogarithmicTicksHoldTheRange) {
  for (const auto& [least, most] : {std::pair{0.3, 100.0}, {0.29, 101.0}, {0.03, 2.0}, {1.0, 1e4}}) {
    const std::vector<double> ticks = logarithmicTicks(least, most);
    EXPECT_LE(ticks.front(), least * (1 + 1e-8));
    EXPECT_GE(ticks.back(), most);
    EXPECT_TRUE(std::ranges::is_sorted(ticks));
    for (std::size_t k = 1; k < ticks.size(); ++k) {
      const double ratio = ticks[k] / ticks[k - 1];
      EXPECT_TRUE(std::abs(ratio - 3) < 1e-9 || std::abs(ratio - 10.0 / 3) < 1e-9) << ratio;
    }
  }
}

// If there is room, every cell has its own column, and the column leads back to the cell.
TEST(Plot, ColumnsLeadBackToCells) {
  const Rect area{480, 40, 460, 170};
  for (const int count : {1, 2, 64, 240}) {
    const Plot plot{.cells = {11, count}, .ticks = {0, 255}, .curves = {}};
    for (int cell = 11; cell < 11 + count; ++cell)
      EXPECT_EQ(cellAtX(plot.cells, area, plotX(plot, area, cell)), cell);
  }
}

}  // namespace xnewell::THIS_FILE
