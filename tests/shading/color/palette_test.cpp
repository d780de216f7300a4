#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/glm.hpp>
#include <random>
#include <set>

#include "shading/color/color_difference.h"
#include "shading/color/color_plan.h"
#include "shading/color/color_table.h"

namespace xnewell::THIS_FILE {

namespace {

/// ---- Palettes

std::set<int> cellsOf(const CellPlan& plan) {
  std::set<int> cells;
  for (int c = 0; c < kCells; ++c) cells.insert(plan[static_cast<Cell>(c)]);
  return cells;
}

/// What an eye sees that lacks one kind of cone: red, green or blue. Rows of a matrix of linear RGB. Machado,
/// Oliveira, Fernandes 2009, severity 1.
using Eye = std::array<glm::dvec3, 3>;
constexpr std::array<Eye, 4> kEyes{
    Eye{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
    Eye{{{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}},
    Eye{{{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}},
    Eye{{{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}}};

Rgb16 seenBy(const Eye& eye, Rgb16 color) {
  const auto linear = [](double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
  const auto stored = [](double v) {
    v = std::clamp(v, 0.0, 1.0);
    return static_cast<std::uint16_t>(
        std::lround(65535 * (v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055)));
  };
  const glm::dvec3 light{linear(color.r / 65535.0), linear(color.g / 65535.0), linear(color.b / 65535.0)};
  return {stored(glm::dot(eye[0], light)), stored(glm::dot(eye[1], light)), stored(glm::dot(eye[2], light))};
}

// The colours that carry a meaning differ for every eye by a CIEDE2000 of 15, from each other and from what
// they stand on. Two pairs look alike to an eye without blue cones, and have a second sign: a verdict that
// holds stands beside its words, P carries its letter; what has the focus has a bar at its left.
TEST(Palette, MeaningsDifferForEveryEye) {
  const CellPlan plan;
  const Palette palette = makePalette(plan, ColorTable{{}});
  const std::set<std::pair<Cell, Cell>> secondSigns{{Cell::P, Cell::Good}, {Cell::Paper, Cell::Focus}};
  constexpr std::array kShown{Cell::Paper, Cell::Ink,  Cell::Well,  Cell::P,
                              Cell::Q,     Cell::Good, Cell::Alarm, Cell::Focus};
  std::set<std::pair<Cell, Cell>> alike;
  for (const Eye& eye : kEyes)
    for (std::size_t a = 0; a < kShown.size(); ++a)
      for (std::size_t b = std::max<std::size_t>(a + 1, 3); b < kShown.size(); ++b)
        if (ciede2000(labFromSrgb(seenBy(eye, palette[plan[kShown[a]]])),
                      labFromSrgb(seenBy(eye, palette[plan[kShown[b]]]))) < 15)
          alike.emplace(kShown[a], kShown[b]);
  EXPECT_EQ(alike, secondSigns);
}

// The tool's cells are at their usual places, and the well's text is at 250 while `brief` uses 10..249.
TEST(CellPlan, UsualPlaces) {
  const CellPlan linear{TableKind::Linear};
  EXPECT_EQ(linear[Cell::Black], 0);
  EXPECT_EQ(linear[Cell::White], 1);
  EXPECT_EQ(linear[Cell::Well], 8);
  EXPECT_EQ(linear[Cell::WellText], 10);
  EXPECT_EQ(linear[Cell::Focus], 255);
  EXPECT_EQ(CellPlan{TableKind::Brief}[Cell::WellText], 250);
}

// Sixteen different cells are found outside the ramp, wherever the server's black and white are. Black and
// white keep the server's pixels unless these lie within the ramp.
TEST(CellPlan, MovesAsideForTheServersPixels) {
  for (const TableRow& table : kTables)
    for (int black = 0; black < 256; ++black)
      for (const int white : {0, 1, 5, 10, 100, 250, 254, 255}) {
        const CellPlan plan{table.id, black, white};
        const std::set<int> cells = cellsOf(plan);
        ASSERT_EQ(cells.size(), 16u) << black << ' ' << white;
        const auto inRamp = [&](int cell) { return cell >= table.first && cell < table.first + 240; };
        for (const int cell : cells) ASSERT_FALSE(inRamp(cell));
        if (!inRamp(black)) {
          ASSERT_EQ(plan[Cell::Black], black);
        }
        if (!inRamp(white) && white != black) {
          ASSERT_EQ(plan[Cell::White], white);
        }
      }
}

// Cells that fewer shades leave free hold the colours that they are given, those of the default map.
TEST(Palette, UnneededCellsKeepTheirColours) {
  Palette defaults;
  for (int i = 0; i < 256; ++i) defaults[i] = {static_cast<std::uint16_t>(257 * i), 1, 2};
  TableSettings settings;
  settings.shades = 64;
  const ColorTable table{settings};
  const Palette palette = makePalette(CellPlan{TableKind::Linear}, table, defaults);
  EXPECT_EQ(palette[11 + 63], table.color(63));
  for (int i = 11 + 64; i <= 250; ++i) EXPECT_EQ(palette[i], defaults[i]);
  EXPECT_EQ(palette[8], (Rgb16{0x2A2A, 0x2E2E, 0x3535}));
}

/// ---- Hues and their cells

double sumOfSteps(std::span<const HueNeed> needs, const TableSettings& table,
                  const std::vector<int>& shades) {
  double sum = 0;
  for (std::size_t k = 0; k < needs.size(); ++k)
    sum += static_cast<double>(needs[k].samples) * stepOf(needs[k], table, shades[k]);
  return sum;
}

std::vector<int> shadesOf(const std::vector<TableSettings>& ramps) {
  std::vector<int> shades;
  for (const TableSettings& ramp : ramps) shades.push_back(ramp.shades);
  return shades;
}

std::vector<HueNeed> randomNeeds(std::mt19937& rng, int count) {
  std::vector<HueNeed> needs;
  for (int k = 0; k < count; ++k) {
    const double p = static_cast<double>(rng() % 1001) / 1000, q = static_cast<double>(rng() % 1001) / 1000;
    needs.push_back(
        {{1, k / 120.0, 0}, std::min(p, q), std::max(p, q), rng() % 5 ? std::int64_t(rng() % 100'000) : 0});
  }
  return needs;
}

// A single hue with all intensities has the whole table.
TEST(HuePlan, OneHueHasTheWholeTable) {
  for (const TableRow& row : kTables) {
    const TableSettings settings{.kind = row.id};
    const HueNeed need{.samples = 1};
    const std::vector<TableSettings> ramps = planHues({&need, 1}, settings);
    ASSERT_EQ(ramps.size(), 1u);
    const ColorTable whole{settings}, ramp{ramps[0]};
    ASSERT_EQ(ramp.first(), whole.first());
    ASSERT_EQ(ramp.shades(), 240);
    for (int j = 0; j < 240; ++j) EXPECT_EQ(ramp.color(j), whole.color(j));
    for (int k = 0; k <= 1000; ++k) EXPECT_EQ(ramp.cell(k / 1000.0), whole.cell(k / 1000.0));
  }
}

// Ramps lie one after the other within the table's cells, each of two shades or more, for one hue to 120.
// They keep the other settings of the table.
TEST(HuePlan, RampsShareTheCells) {
  for (const TableRow& row : kTables)
    for (const int count : {1, 2, 7, 60, 119, 120}) {
      std::mt19937 rng{unsigned(count)};
      const TableSettings settings{.kind = row.id, .I0 = 0.05, .bits = 8};
      const std::vector<HueNeed> needs = randomNeeds(rng, count);
      const std::vector<TableSettings> ramps = planHues(needs, settings);
      ASSERT_EQ(ramps.size(), needs.size());
      int next = row.first;
      for (int k = 0; k < count; ++k) {
        TableSettings expected = settings;
        expected.hue = needs[k].hue, expected.low = needs[k].low, expected.high = needs[k].high;
        expected.first = next, expected.shades = ramps[k].shades;
        EXPECT_EQ(ramps[k], expected);
        EXPECT_GE(ramps[k].shades, 2);
        next += ramps[k].shades;
      }
      EXPECT_LE(next, row.first + 240);
    }
}

// No other division has a smaller sum of steps, and one shade fewer of any hue has a larger one. The test
// tries all divisions where there are few.
TEST(HuePlan, NoDivisionIsBetter) {
  int divided = 0;
  for (unsigned seed = 0; seed < 600; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 rng{seed};
    const int hues = 1 + int(rng() % 4);
    const TableSettings settings{.kind = kTables[rng() % kTables.size()].id,
                                 .shades = 2 * hues + int(rng() % 9)};
    const std::vector<HueNeed> needs = randomNeeds(rng, hues);
    const std::vector<int> shades = shadesOf(planHues(needs, settings));
    double least = 1e300;
    std::vector<int> tried(hues);
    const std::function<void(int, int)> tryAll = [&](int k, int left) {
      if (k == hues) {
        least = std::min(least, sumOfSteps(needs, settings, tried));
        ++divided;
        return;
      }
      for (int N = 2; N + 2 * (hues - k - 1) <= left; ++N) {
        tried[k] = N;
        tryAll(k + 1, left - N);
      }
    };
    tryAll(0, settings.shades);
    EXPECT_NEAR(sumOfSteps(needs, settings, shades), least, 1e-9 * (1 + least));
    for (std::size_t k = 0; k < needs.size(); ++k) {
      std::vector<int> fewer = shades;
      if (--fewer[k] < 2) continue;
      EXPECT_GT(sumOfSteps(needs, settings, fewer), sumOfSteps(needs, settings, shades));
    }
  }
  EXPECT_GT(divided, 10'000);
}

// The step that counts is that of the ramp's table: the difference of its levels' intensities, or their
// ratio.
TEST(HuePlan, TheStepIsTheTables) {
  for (const TableRow& row : kTables)
    for (const auto& [low, high] : {std::pair{0.0, 1.0}, std::pair{0.3, 0.8}, std::pair{0.01, 0.5}})
      for (const int N : {2, 3, 20, 60}) {
        const TableSettings settings{.kind = row.id, .shades = N, .low = low, .high = high};
        const ColorTable table{settings};
        const double step = row.id == TableKind::Corrected ? table.level(1) / table.level(0) - 1
                                                           : (table.level(1) - table.level(0)) * 255 / 239;
        ASSERT_GT(step, 1.0 / 255);
        EXPECT_NEAR(stepOf({.low = low, .high = high}, settings, N), step, 1e-12);
      }
}

// Hues with equal needs get equal shares, and the first ones get what is left over. Four times the samples
// halve the step.
TEST(HuePlan, NeedDecides) {
  const TableSettings settings{};
  EXPECT_EQ(shadesOf(planHues(std::vector<HueNeed>(7, {.samples = 1000}), settings)),
            (std::vector<int>{35, 35, 34, 34, 34, 34, 34}));
  const std::vector<HueNeed> fourfold{{.samples = 1000}, {.samples = 4000}};
  const std::vector<int> shades = shadesOf(planHues(fourfold, settings));
  EXPECT_NEAR(stepOf(fourfold[0], settings, shades[0]) / stepOf(fourfold[1], settings, shades[1]), 2, 0.02);
  EXPECT_EQ(shades[0] + shades[1], 240);
  // A hue that shows one intensity, or nothing, needs no more than two.
  const std::vector<HueNeed> idle{{.low = 0.5, .high = 0.5, .samples = 9}, {.samples = 0}, {.samples = 1}};
  EXPECT_EQ(shadesOf(planHues(idle, settings)), (std::vector<int>{2, 2, 236}));
  // A tenth of the intensities has 25 steps of 1/255 and no use for finer ones.
  const HueNeed tenth{.low = 0.2, .high = 0.3, .samples = 1};
  EXPECT_EQ(planHues({&tenth, 1}, settings)[0].shades, 27);
}

}  // namespace

}  // namespace xnewell::THIS_FILE
