#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <set>

#include "shading/color/color_difference.h"
#include "shading/color/color_table.h"
#include "tests/support/full_color_picture.h"

namespace xnewell::THIS_FILE {

namespace {

/// ---- Colour tables

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

/// ---- Differences of colours

struct Pair {
  Lab p, q;
  double difference;
};

// Table 1 of Sharma, Wu, Dalal 2005: each row uncovers a mistake that programs make.
constexpr Pair kPublished[] = {
    {{50.0000, 2.6772, -79.7751}, {50.0000, 0.0000, -82.7485}, 2.0425},
    {{50.0000, 3.1571, -77.2803}, {50.0000, 0.0000, -82.7485}, 2.8615},
    {{50.0000, 2.8361, -74.0200}, {50.0000, 0.0000, -82.7485}, 3.4412},
    {{50.0000, -1.3802, -84.2814}, {50.0000, 0.0000, -82.7485}, 1.0000},
    {{50.0000, -1.1848, -84.8006}, {50.0000, 0.0000, -82.7485}, 1.0000},
    {{50.0000, -0.9009, -85.5211}, {50.0000, 0.0000, -82.7485}, 1.0000},
    {{50.0000, 0.0000, 0.0000}, {50.0000, -1.0000, 2.0000}, 2.3669},
    {{50.0000, -1.0000, 2.0000}, {50.0000, 0.0000, 0.0000}, 2.3669},
    {{50.0000, 2.4900, -0.0010}, {50.0000, -2.4900, 0.0009}, 7.1792},
    {{50.0000, 2.4900, -0.0010}, {50.0000, -2.4900, 0.0010}, 7.1792},
    {{50.0000, 2.4900, -0.0010}, {50.0000, -2.4900, 0.0011}, 7.2195},
    {{50.0000, 2.4900, -0.0010}, {50.0000, -2.4900, 0.0012}, 7.2195},
    {{50.0000, -0.0010, 2.4900}, {50.0000, 0.0009, -2.4900}, 4.8045},
    {{50.0000, -0.0010, 2.4900}, {50.0000, 0.0010, -2.4900}, 4.8045},
    {{50.0000, -0.0010, 2.4900}, {50.0000, 0.0011, -2.4900}, 4.7461},
    {{50.0000, 2.5000, 0.0000}, {50.0000, 0.0000, -2.5000}, 4.3065},
    {{50.0000, 2.5000, 0.0000}, {73.0000, 25.0000, -18.0000}, 27.1492},
    {{50.0000, 2.5000, 0.0000}, {61.0000, -5.0000, 29.0000}, 22.8977},
    {{50.0000, 2.5000, 0.0000}, {56.0000, -27.0000, -3.0000}, 31.9030},
    {{50.0000, 2.5000, 0.0000}, {58.0000, 24.0000, 15.0000}, 19.4535},
    {{50.0000, 2.5000, 0.0000}, {50.0000, 3.1736, 0.5854}, 1.0000},
    {{50.0000, 2.5000, 0.0000}, {50.0000, 3.2972, 0.0000}, 1.0000},
    {{50.0000, 2.5000, 0.0000}, {50.0000, 1.8634, 0.5757}, 1.0000},
    {{50.0000, 2.5000, 0.0000}, {50.0000, 3.2592, 0.3350}, 1.0000},
    {{60.2574, -34.0099, 36.2677}, {60.4626, -34.1751, 39.4387}, 1.2644},
    {{63.0109, -31.0961, -5.8663}, {62.8187, -29.7946, -4.0864}, 1.2630},
    {{61.2901, 3.7196, -5.3901}, {61.4292, 2.2480, -4.9620}, 1.8731},
    {{35.0831, -44.1164, 3.7933}, {35.0232, -40.0716, 1.5901}, 1.8645},
    {{22.7233, 20.0904, -46.6940}, {23.0331, 14.9730, -42.5619}, 2.0373},
    {{36.4612, 47.8580, 18.3852}, {36.2715, 50.5065, 21.2231}, 1.4146},
    {{90.8027, -2.0831, 1.4410}, {91.1528, -1.6435, 0.0447}, 1.4441},
    {{90.9257, -0.5406, -0.9208}, {88.6381, -0.8985, -0.7239}, 1.5381},
    {{6.7747, -0.2908, -2.4247}, {5.8714, -0.0985, -2.2286}, 0.6377},
    {{2.0776, 0.0795, -1.1350}, {0.9033, -0.0636, -0.5514}, 0.9082},
};

// The 34 published pairs come out right to their last decimal, in either order.
TEST(ColorDifference, AsPublished) {
  static_assert(std::size(kPublished) == 34);
  for (const Pair& pair : kPublished) {
    EXPECT_NEAR(ciede2000(pair.p, pair.q), pair.difference, 0.5001e-4);
    EXPECT_NEAR(ciede2000(pair.q, pair.p), pair.difference, 0.5001e-4);
  }
}

// The corners of the sRGB cube have the CIELAB values that tables print, to two decimals. White and grays are
// neutral.
TEST(ColorDifference, LabOfTheCubesCorners) {
  const auto expectLab = [](Rgb16 color, double L, double a, double b) {
    const Lab lab = labFromSrgb(color);
    EXPECT_NEAR(lab.L, L, 0.01);
    EXPECT_NEAR(lab.a, a, 0.01);
    EXPECT_NEAR(lab.b, b, 0.01);
  };
  expectLab({65535, 0, 0}, 53.24, 80.09, 67.20);
  expectLab({0, 65535, 0}, 87.73, -86.18, 83.18);
  expectLab({0, 0, 65535}, 32.30, 79.19, -107.86);
  for (int v = 0; v <= 65535; v += 51) {
    const auto gray = static_cast<std::uint16_t>(v);
    const Lab lab = labFromSrgb(Rgb16{gray, gray, gray});
    ASSERT_NEAR(lab.a, 0, 1e-12);
    ASSERT_NEAR(lab.b, 0, 1e-12);
  }
  expectLab({65535, 65535, 65535}, 100, 0, 0);
  expectLab({0, 0, 0}, 0, 0, 0);
}

// An 8-bit colour equals the 16-bit colour that repeats its bits.
TEST(ColorDifference, EightBitsAreTheSixteenThatRepeatThem) {
  const std::uint8_t rgb[3] = {200, 3, 77};
  const Lab narrow = labFromSrgb(rgb), wide = labFromSrgb(Rgb16{200 * 257, 3 * 257, 77 * 257});
  EXPECT_EQ(narrow.L, wide.L);
  EXPECT_EQ(narrow.a, wide.a);
  EXPECT_EQ(narrow.b, wide.b);
}

// Opposite hues count as half a turn apart, however their angles are rounded. Their difference is the limit
// of that for turns a little smaller. For turns a little larger the mean hue is on the other side.
TEST(ColorDifference, OppositeHuesTakeTheMeanBetweenThem) {
  int jumps = 0;
  for (int k = 1; k < 1000; ++k) {
    const double angle = k * 0.003, tiny = 1e-9;  // radians; the first hue lies below half a turn
    const auto at = [](double turn) { return Lab{50, 30 * std::cos(turn), 30 * std::sin(turn)}; };
    const Lab p = at(angle), opposite{50, -p.a, -p.b};
    const double difference = ciede2000(p, opposite);
    ASSERT_NEAR(difference, ciede2000(p, at(angle + std::numbers::pi - tiny)), 1e-5) << angle;
    jumps += std::abs(difference - ciede2000(p, at(angle + std::numbers::pi + tiny))) > 0.01;
  }
  EXPECT_GT(jumps, 900);
}

}  // namespace

}  // namespace xnewell::THIS_FILE
