#include "x11/views/table_curves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "shading/picture/palette_effects.h"
#include "shading/picture/picture_cache.h"
#include "x11/views/colors_page.h"
#include "x11/views/plot.h"

namespace xnewell::THIS_FILE {

namespace {

Picture made(const char* scene, ColorPlan plan, const TableSettings& table) {
  PictureSettings s;
  s.width = 80, s.height = 60;
  s.colors = plan;
  s.table = table;
  return makePicture(readScene(scene, 3), s, CellPlan{table.kind}[Cell::Well]);
}

}  // namespace

// Known values: of the 240 levels of `corrected`, with the quotient 1.01650299..., 240 are distinct at 16
// bits and 144 at 8 bits. A linear table of 240 has 240 distinct levels at either.
TEST(TableCurves, CountDistinctLevels) {
  const TableSettings corrected{.kind = TableKind::Corrected};
  EXPECT_EQ(distinctLevels(corrected, 16), 240);
  EXPECT_EQ(distinctLevels(corrected, 8), 144);
  EXPECT_EQ(distinctLevels({.kind = TableKind::Linear}, 8), 240);
  EXPECT_NEAR(ratioOf(ColorTable{corrected}), 1.01650299, 5e-9);
  EXPECT_NEAR(std::pow(ratioOf(ColorTable{{.kind = TableKind::Corrected, .shades = 64, .I0 = 0.1}}), 63), 10,
              1e-9);
}

// What is told is counted from what is stored. A bent curve has fewer levels at 8 bits, and a table of 8 bits
// has no more at 16. This test collects the red values one by one.
TEST(TableCurves, CountStoredLevels) {
  for (const int bits : {8, 16}) {
    const Picture picture = made("teapot", ColorPlan::OneHue, {.kind = TableKind::Corrected, .bits = bits});
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
      const Picture picture = made("teapot", ColorPlan::OneHue, {.kind = row.id, .shades = shades});
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
  const Picture picture = made("teapot", ColorPlan::OneHue, {.kind = TableKind::Corrected});
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
  const Picture picture = made("teapot", ColorPlan::OneHue, corrected);
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
  const Picture hues = made("hues", ColorPlan::Hues, {});
  EXPECT_EQ(storedCurves(hues, hues.palette(CellPlan{})).size(), 7u);
  EXPECT_EQ(stepCurves(hues, hues.palette(CellPlan{})).size(), 7u);

  const Picture cube = made("hues", ColorPlan::Cube, {});
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
