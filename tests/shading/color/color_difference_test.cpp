#include "shading/color/color_difference.h"
#include "tests/support/image_difference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace xnewell::THIS_FILE {

namespace {

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

RgbImage filled(int width, int height, std::uint8_t r, std::uint8_t g, std::uint8_t b) {
  RgbImage image{width, height};
  for (std::size_t k = 0; k < image.rgb.size(); k += 3)
    image.rgb[k] = r, image.rgb[k + 1] = g, image.rgb[k + 2] = b;
  return image;
}

}  // namespace

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

// The difference is zero for equal colours only, 100 from black to white, and the same in either order.
TEST(ColorDifference, IsZeroForEqualsAndSymmetric) {
  std::mt19937 rng{2005};
  const auto random = [&] {
    const auto channel = [&] { return static_cast<std::uint16_t>(rng() % 65536); };
    return Rgb16{channel(), channel(), channel()};
  };
  for (int k = 0; k < 20'000; ++k) {
    const Lab p = labFromSrgb(random()), q = labFromSrgb(random());
    ASSERT_EQ(ciede2000(p, p), 0);
    ASSERT_GT(ciede2000(p, q), 0);
    ASSERT_NEAR(ciede2000(p, q), ciede2000(q, p), 1e-9);
  }
  EXPECT_NEAR(ciede2000(labFromSrgb(Rgb16{}), labFromSrgb(Rgb16{65535, 65535, 65535})), 100, 1e-9);
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

// The mean and the largest difference are over the pixels that count, and no others. One of eight pixels
// differs, and is counted or left out.
TEST(ColorDifference, OfPictures) {
  const RgbImage p = filled(4, 2, 10, 200, 30);
  RgbImage q = p;
  q.pixel(2, 1)[0] = 90;
  const double one = ciede2000(labFromSrgb(p.pixel(2, 1)), labFromSrgb(q.pixel(2, 1)));
  ASSERT_GT(one, 1);

  const ImageDifference all = imageDifference(p, q);
  EXPECT_EQ(all.pixels, 8);
  EXPECT_DOUBLE_EQ(all.mean, one / 8);
  EXPECT_EQ(all.largest, one);

  std::vector<std::uint8_t> counts(8, 0);
  const ImageDifference nothing = imageDifference(p, q, counts);
  EXPECT_EQ(nothing.pixels, 0);
  EXPECT_EQ(nothing.mean, 0);
  counts[5] = counts[6] = 1;
  const ImageDifference two = imageDifference(p, q, counts);
  EXPECT_EQ(two.pixels, 2);
  EXPECT_DOUBLE_EQ(two.mean, one / 2);
  counts[6] = 0;
  EXPECT_EQ(imageDifference(p, q, counts).largest, 0);
}

// The comparison of two pictures is the sum over their pixels. The test uses random pairs.
TEST(ColorDifference, OfPicturesIsTheSumOfItsPixels) {
  std::mt19937 rng{34};
  RgbImage p{31, 17}, q{31, 17};
  // There are few values, so that neighbours are often equal in one picture and not in the other.
  for (std::uint8_t& v : p.rgb) v = static_cast<std::uint8_t>(rng() % 2 * 200);
  for (std::uint8_t& v : q.rgb) v = static_cast<std::uint8_t>(rng() % 2 * 200);
  double sum = 0, largest = 0;
  for (int j = 0; j < p.height; ++j)
    for (int i = 0; i < p.width; ++i) {
      const double d = ciede2000(labFromSrgb(p.pixel(i, j)), labFromSrgb(q.pixel(i, j)));
      sum += d, largest = std::max(largest, d);
    }
  const ImageDifference all = imageDifference(p, q);
  EXPECT_NEAR(all.mean, sum / (31 * 17), 1e-12);
  EXPECT_EQ(all.largest, largest);
}

}  // namespace xnewell::THIS_FILE
