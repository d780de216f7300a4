#include "x11/stepper/outline.h"

#include <gtest/gtest.h>

#include <cmath>

namespace xnewell::THIS_FILE {

namespace {

constexpr int kSize = 32;

int count(const IndexImage& image, std::uint8_t cell) {
  return static_cast<int>(std::ranges::count(image.pixels, cell));
}

}  // namespace

// A segment looks like its part near the image, however far away its ends are.
TEST(Outline, FarEndsDoNotMatter) {
  for (const double far : {1e2, 1e6, 1e9, 1e12}) {
    IndexImage near{kSize, kSize, 0}, image{kSize, kSize, 0};
    Painter a{near}, b{image};
    segment(a, {-40.0, 16.5}, {80.0, 16.5}, 1);
    segment(a, {7.5, -40.0}, {7.5, 80.0}, 1);
    segment(b, {-far, 16.5}, {far, 16.5}, 1);
    segment(b, {7.5, far}, {7.5, -far}, 1);
    EXPECT_EQ(near, image) << far;
    EXPECT_EQ(count(image, 1), 2 * kSize - 1);
    segment(b, {-far, far + 100}, {far, far + 90}, 2);
    EXPECT_EQ(count(image, 2), 0);
  }
}

// Only pixels within the figure are tinted. Two halves of a square share no pixel, and together they are the
// square.
TEST(Outline, HalvesShareNoTint) {
  const Outline lower{{3, 4}, {3, 27}, {29, 27}}, upper{{3, 4}, {29, 27}, {29, 4}};
  IndexImage a{kSize, kSize, 0}, b{kSize, kSize, 0};
  Painter pa{a}, pb{b};
  const Rect area{0, 0, kSize, kSize};
  tint(pa, area, lower, Stipple::Quarter, 1);
  tint(pb, area, upper, Stipple::Quarter, 1);
  int both = 0;
  for (int j = 0; j < kSize; ++j)
    for (int i = 0; i < kSize; ++i) {
      const bool in = i >= 3 && i < 29 && j >= 4 && j < 27 && stippled(Stipple::Quarter, i, j);
      ASSERT_EQ(a.row(j)[i] + b.row(j)[i], in) << i << ' ' << j;
      both += in;
    }
  EXPECT_GT(both, 100);
}

// If the values at the corners are those of a plane, the zero line lies where the plane is zero. If all
// values have one sign, there is no line.
TEST(Outline, TheZeroLineIsWhereThePlaneIsZero) {
  const Outline square{{0, 0}, {0, 10}, {10, 10}, {10, 0}};
  int lines = 0;
  for (int a = -5; a <= 5; ++a)
    for (int c = -60; c <= 60; c += 7) {
      const auto value = [&](Place p) { return a * p.x + 3 * p.y + c; };
      std::vector<double> values;
      for (const Place& p : square) values.push_back(value(p));
      const bool both = std::ranges::min(values) < 0 && std::ranges::max(values) >= 0;
      const std::optional<Chord> line = zeroLine(square, values);
      ASSERT_EQ(line.has_value(), both);
      if (!line) continue;
      ++lines;
      EXPECT_NEAR(value(line->from), 0, 1e-9);
      EXPECT_NEAR(value(line->to), 0, 1e-9);
    }
  EXPECT_GT(lines, 50);
}

}  // namespace xnewell::THIS_FILE
