#include "shading/color/hue_plan.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>

namespace xnewell::THIS_FILE {

namespace {

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

}  // namespace

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

// No other division has a smaller sum of steps. The test tries all divisions where there are few.
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
  }
  EXPECT_GT(divided, 10'000);
}

// Every shade is of use: one shade fewer of any hue makes the sum larger.
TEST(HuePlan, EveryShadeIsNeeded) {
  int spare = 0, more = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 rng{seed};
    const std::vector<HueNeed> needs = randomNeeds(rng, 1 + int(rng() % 6));
    const TableSettings settings{};
    const std::vector<int> shades = shadesOf(planHues(needs, settings));
    int given = 0;
    for (std::size_t k = 0; k < needs.size(); ++k) {
      given += shades[k];
      if (shades[k] == 2) continue;
      std::vector<int> fewer = shades;
      --fewer[k];
      EXPECT_GT(sumOfSteps(needs, settings, fewer), sumOfSteps(needs, settings, shades));
      ++more;
    }
    spare += given < 240;
  }
  EXPECT_GT(spare, 10);
  EXPECT_GT(more, 300);
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

// The order of the hues only moves their cells, except for ties.
TEST(HuePlan, OrderMovesCellsOnly) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 rng{seed};
    std::vector<HueNeed> needs = randomNeeds(rng, 2 + int(rng() % 20));
    const TableSettings settings{.kind = TableKind::Corrected};
    std::vector<int> shades = shadesOf(planHues(needs, settings));
    std::reverse(needs.begin(), needs.end());
    std::reverse(shades.begin(), shades.end());
    EXPECT_EQ(shadesOf(planHues(needs, settings)), shades);
  }
}

}  // namespace xnewell::THIS_FILE
