#include "geometry/exact/extended.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <random>

#include "geometry/exact/soft_extended.h"

namespace xnewell::THIS_FILE {

/// The same number, as the sum of two doubles, which has no rounding.
SoftExtended softly(const Extended& n) {
  const auto first = static_cast<double>(n);
  return std::isfinite(first) ? first + SoftExtended{static_cast<double>(n - first)} : SoftExtended{first};
}

// Sums, products, quotients, roots and doubles made of them have the same bits in the processor's numbers and
// in those that stand for them elsewhere. So judges judge the same on all processors.
TEST(Extended, BothHaveTheSameBits) {
  const auto same = [](const Extended& own, const SoftExtended& soft) {
    ASSERT_EQ(softly(own), soft);
    ASSERT_EQ(static_cast<double>(own), static_cast<double>(soft));
  };
  int rounded = 0;
  for (unsigned seed = 0; seed < 50'000; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 rng{seed};
    // A product of two doubles fills the mantissa. Some are close to each other, so that a difference loses
    // most of it.
    const auto any = [&] {
      const double m = std::ldexp(static_cast<double>(static_cast<std::int64_t>(rng() >> 11)), -52);
      return std::ldexp(rng() % 2 ? m : -m, static_cast<int>(rng() % (rng() % 2 ? 9 : 200)) - 4);
    };
    const double p = any(), q = any(), r = rng() % 4 ? any() : p,
                 s = rng() % 4 ? any() : std::nextafter(q, 2 * q);
    const Extended a = Extended{p} * q, b = Extended{r} * s;
    const SoftExtended c = SoftExtended{p} * q, d = SoftExtended{r} * s;
    same(a, c), same(b, d);
    same(a + b, c + d), same(a - b, c - d), same(a * b, c * d);
    if (b != 0) same(a / b, c / d);
    using std::abs, std::sqrt;
    same(sqrt(Extended{abs(a)}), sqrt(SoftExtended{abs(c)}));
    ASSERT_EQ(a < b, c < d);
    rounded += static_cast<double>(a) != a;
  }
  EXPECT_GT(rounded, 40'000);
}

// Infinities, zeros and what is no number come out of each operation alike.
TEST(Extended, BothHaveTheSameInfinities) {
  const double infinity = std::numeric_limits<double>::infinity();
  const std::array values{
      0.0,      -0.0,      1.0,         -3.0, 0x1p-1074, 0x1.8p-1050, 0x1.fffffffffffffp1023,
      infinity, -infinity, std::nan("")};
  const auto same = [](const Extended& own, const SoftExtended& soft) {
    const auto a = static_cast<double>(own), b = static_cast<double>(soft);
    EXPECT_EQ(std::isnan(a), std::isnan(b));
    if (std::isnan(a)) return;
    EXPECT_EQ(a, b);
    EXPECT_EQ(std::signbit(a), std::signbit(b));
  };
  for (const double a : values)
    for (const double b : values) {
      SCOPED_TRACE(testing::Message() << a << ' ' << b);
      const Extended c = a, d = b;
      const SoftExtended e = a, f = b;
      same(c, e), same(-c, -e), same(c + d, e + f), same(c - d, e - f), same(c * d, e * f),
          same(c / d, e / f);
      using std::abs, std::sqrt, std::isfinite;
      same(sqrt(c), sqrt(e)), same(abs(c), abs(e));
      EXPECT_EQ(isfinite(c), isfinite(e));
      EXPECT_EQ(c < d, e < f);
      EXPECT_EQ(c <= d, e <= f);
      EXPECT_EQ(c == d, e == f);
    }
}

// The rounding is at most 2^-64: a third has 64 bits.
TEST(Extended, HasSixtyFourBits) {
  const Extended third = Extended{1} / 3;
  EXPECT_EQ(3 * third, 1);
  EXPECT_EQ(static_cast<double>((third - static_cast<double>(third)) * 0x1p65), 0x2ab);
}

}  // namespace xnewell::THIS_FILE
