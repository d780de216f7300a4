#include "shading/color/color_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace xnewell::THIS_FILE {

// r = 50^(1/239) = 1.01650299..., and the brightest corrected shade is full intensity.
TEST(ColorTable, CorrectedRatioAsInTheBook) {
  EXPECT_NEAR(ratioOfShades(0.02, 239), 1.01650299, 5e-9);
  EXPECT_NEAR(ratioOfShades(0.02, 239), std::pow(50.0, 1.0 / 239), 1e-15);
  const ColorTable t{{.kind = TableKind::Corrected}};
  EXPECT_EQ(t.level(0), 0.02);
  EXPECT_EQ(t.level(239), 1.0);
}

// Only 144 of the 240 corrected levels are distinct when stored at 8 bits; all are at 16 bits.
TEST(ColorTable, EightBitsKeep144CorrectedLevels) {
  for (const int bits : {8, 16}) {
    const ColorTable t{{.kind = TableKind::Corrected, .bits = bits}};
    std::set<int> red;
    for (int j = 0; j < 240; ++j) red.insert(t.color(j).r);
    EXPECT_EQ(red.size(), bits == 8 ? 144u : 240u);
  }
}

// The brief's tables at 240 shades, cell by cell: brief 10..249 holds i - 10, linear 11..250 holds i - 10.
TEST(ColorTable, TheBriefsCells) {
  for (const TableKind kind : {TableKind::Brief, TableKind::Linear}) {
    const ColorTable t{{.kind = kind}};
    EXPECT_EQ(t.first(), kind == TableKind::Brief ? 10 : 11);
    for (int j = 0; j < 240; ++j)
      EXPECT_EQ(t.color(j), (Rgb16{static_cast<std::uint16_t>(257 * (t.first() + j - 10)), 0, 0}));
  }
}

// color(I) = round(first + 239 I). Half way between two shades it is the brighter one. Intensities outside
// 0..1 are clamped.
TEST(ColorTable, LinearPicksTheNearest) {
  const ColorTable brief{{.kind = TableKind::Brief}}, linear{{.kind = TableKind::Linear}};
  for (int k = 0; k <= 100'000; ++k) {
    const double I = k / 100'000.0;
    const double exact = 239 * I;
    if (std::abs(exact - std::floor(exact) - 0.5) < 1e-9)
      continue;  // the rounded product may be on either side
    ASSERT_EQ(brief.cell(I), std::lround(10 + 239 * I)) << I;
    ASSERT_EQ(linear.cell(I), std::lround(11 + 239 * I)) << I;
  }
  EXPECT_EQ(brief.cell(0.5 / 239), 11);
  EXPECT_EQ(brief.cell(-3), 10);
  EXPECT_EQ(brief.cell(7), 249);
}

// The nearest in ratio is round(log_r(I / I0)), the nearest in difference the closer stored level; they
// disagree on about 0.2 % of uniformly spread intensities.
TEST(ColorTable, CorrectedPicksTheNearest) {
  const ColorTable log{{.kind = TableKind::Corrected, .pick = Pick::Log}};
  const ColorTable search{{.kind = TableKind::Corrected, .pick = Pick::Search}};
  const double r = std::pow(50.0, 1.0 / 239);
  int differ = 0;
  constexpr int kSteps = 1'000'000;
  for (int k = 0; k <= kSteps; ++k) {
    const double I = static_cast<double>(k) / kSteps;
    const double j = I <= 0.02 ? 0 : std::log(I / 0.02) / std::log(r);
    if (std::abs(j - std::floor(j) - 0.5) > 1e-9) {
      ASSERT_EQ(log.shade(I), std::lround(j)) << I;
    }
    const int s = search.shade(I);
    const double miss = std::abs(search.level(s) - I);
    if (s > 0) {
      ASSERT_LE(miss, std::abs(search.level(s - 1) - I) + 1e-15);
    }
    if (s < 239) {
      ASSERT_LE(miss, std::abs(search.level(s + 1) - I) + 1e-15);
    }
    differ += s != log.shade(I);
  }
  EXPECT_NEAR(differ / double{kSteps}, 0.002, 0.0005);
}

// Levels ascend to 1, and each level picks its own shade. Intensities below I0, at 1 and above give the end
// shades. This holds for 2 to 240 shades and I0 from 1e-6 to 0.5.
TEST(ColorTable, EveryShadeCountAndLowestIntensity) {
  for (const double I0 : {1e-6, 1e-3, 0.02, 0.1, 0.5})
    for (int N = 2; N <= 240; ++N)
      for (const Pick pick : {Pick::Log, Pick::Search}) {
        const ColorTable t{{.kind = TableKind::Corrected, .shades = N, .I0 = I0, .pick = pick}};
        ASSERT_EQ(t.level(0), I0);
        ASSERT_EQ(t.level(N - 1), 1.0);
        for (int j = 0; j < N; ++j) {
          ASSERT_NEAR(t.level(j), I0 * std::pow(1 / I0, double{j * 1.0} / (N - 1)), 1e-12);
          ASSERT_EQ(t.shade(t.level(j)), j);
        }
        ASSERT_EQ(t.shade(0), 0);
        ASSERT_EQ(t.shade(I0 / 2), 0);
        ASSERT_EQ(t.shade(2), N - 1);
      }
}

// A ramp may cover part of the intensities, anywhere in the map. Its ends are those of the part, and levels
// ascend between them. Each intensity of the part is within half a step of its shade's, and intensities
// outside are clamped.
TEST(ColorTable, PartOfTheIntensities) {
  for (const TableKind kind : {TableKind::Brief, TableKind::Linear, TableKind::Corrected})
    for (const auto& [low, high] : {std::pair{0.25, 0.75}, std::pair{0.0, 0.5}, std::pair{0.9, 1.0}})
      for (const int N : {2, 3, 17, 120}) {
        const ColorTable t{{.kind = kind, .shades = N, .first = 100, .low = low, .high = high}};
        EXPECT_EQ(t.first(), 100);
        EXPECT_EQ(t.cell(low), 100);
        EXPECT_EQ(t.cell(high), 100 + N - 1);
        EXPECT_EQ(t.shade(0), 0);
        EXPECT_EQ(t.shade(1), N - 1);
        // What the whole table would hold for the same intensity.
        const auto held = [&](double I) {
          return kind == TableKind::Corrected ? std::max(0.02, I)
                                              : ((kind == TableKind::Linear) + 239 * I) / 255;
        };
        EXPECT_NEAR(t.level(0), held(low), 1e-15);
        EXPECT_NEAR(t.level(N - 1), held(high), 1e-15);
        for (int k = 0; k <= 1000; ++k) {
          const double I = low + (high - low) * k / 1000;
          const int j = t.shade(I);
          if (kind == TableKind::Corrected) {
            const double halfStep = std::pow(high / std::max(0.02, low), 0.5 / (N - 1)) + 1e-12;
            ASSERT_LE(held(I), t.level(j) * halfStep);
            ASSERT_GE(held(I), t.level(j) / halfStep);
          } else {
            ASSERT_NEAR(held(I), t.level(j), 239 * (high - low) / (N - 1) / 2 / 255 + 1e-12);
          }
        }
      }
}

// A single intensity, even one below I0, makes every shade that intensity.
TEST(ColorTable, OneIntensity) {
  for (const double I : {0.0, 0.01, 0.5, 1.0}) {
    const ColorTable corrected{{.kind = TableKind::Corrected, .shades = 2, .low = I, .high = I}};
    const ColorTable linear{{.shades = 2, .low = I, .high = I}};
    for (int j = 0; j < 2; ++j) {
      EXPECT_EQ(corrected.level(j), std::max(0.02, I));
      EXPECT_NEAR(linear.level(j), (1 + 239 * I) / 255, 1e-15);
    }
  }
}

}  // namespace xnewell::THIS_FILE
