#include "geometry/exact/int128.h"

#include <gtest/gtest.h>

#include <random>

#include "geometry/exact/wide_int128.h"

namespace xnewell::THIS_FILE {

using Unbounded = boost::multiprecision::cpp_int;

/// A number of up to `bits` bits, often near a power of two, in all three types at once.
struct Number {
  Int128 own;
  WideInt128 wide;
  Unbounded exact;
};
Number randomNumber(std::mt19937& rng, unsigned bits) {
  const auto length = static_cast<unsigned>(rng() % (bits + 1));
  Number n{};
  for (unsigned at = 0; at < length; at += 16) {
    const unsigned digits = std::min(16U, length - at);
    const int kind = static_cast<int>(rng() % 3);
    const int digit = static_cast<int>(kind ? kind == 1 ? 0 : (1U << digits) - 1 : rng() % (1U << digits));
    n.own = (n.own << digits) + digit;
    n.wide = (n.wide << digits) + digit;
    n.exact = (n.exact << digits) + digit;
  }
  if (rng() % 2) n = {Int128{-n.own}, WideInt128{-n.wide}, Unbounded{-n.exact}};
  return n;
}

/// The bits of an integer as words of 32 bits, by division alone.
template <class Integer>
Unbounded exactly(Integer n) {
  const bool negative = n < 0;
  Unbounded sum = 0, unit = 1;
  for (; n != 0; n /= std::int64_t{1} << 32, unit <<= 32)
    sum += unit * static_cast<std::int64_t>(n % (std::int64_t{1} << 32));
  EXPECT_EQ(sum < 0, negative);
  return sum;
}

/// Whether what both types made of the same numbers is the exact result.
void same(const Int128& own, const WideInt128& wide, const Unbounded& exact) {
  ASSERT_EQ(exactly(own), exact);
  ASSERT_EQ(exactly(wide), exact);
  ASSERT_EQ(approximately(own), approximately(wide));
  ASSERT_LE(abs(Unbounded{approximately(own)} - exact), abs(exact) >> 52);
}

// The compiler's integer and the one for compilers without any give the exact results of sums, products,
// quotients, shifts and masks, wherever these fit. So do their casts.
TEST(Int128, BothAreExact) {
  int below = 0;
  for (unsigned seed = 0; seed < 20'000; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 rng{seed};
    const Number a = randomNumber(rng, 126), b = randomNumber(rng, 126), c = randomNumber(rng, 63);
    same(a.own, a.wide, a.exact);
    same(a.own + b.own, a.wide + b.wide, a.exact + b.exact);
    same(a.own - b.own, a.wide - b.wide, a.exact - b.exact);
    const auto narrow = static_cast<std::int64_t>(c.own);
    ASSERT_EQ(narrow, static_cast<std::int64_t>(c.wide));
    ASSERT_EQ(narrow, static_cast<std::int64_t>(c.exact));
    const Number d = randomNumber(rng, 63);
    same(d.own * narrow, d.wide * narrow, d.exact * c.exact);
    same(Int128{narrow} * d.own, WideInt128{narrow} * d.wide, c.exact * d.exact);
    if (narrow != 0) {
      same(a.own / narrow, a.wide / narrow, a.exact / narrow);
      same(a.own % narrow, a.wide % narrow, a.exact % narrow);
    }
    const int shift = static_cast<int>(rng() % 100);
    const Unbounded unit = Unbounded{1} << shift, down = a.exact / unit - (a.exact % unit < 0 ? 1 : 0);
    same(a.own >> shift, a.wide >> shift, down);
    below += a.exact % unit < 0;
    const int up = static_cast<int>(rng() % 63);
    same(c.own << up, c.wide << up, c.exact * (Unbounded{1} << up));
    const Unbounded whole = Unbounded{1} << 64;
    const Unbounded masked = a.exact % whole + (a.exact % whole < 0 ? whole : Unbounded{0});
    same(a.own & ((Int128{1} << 64) - 1), a.wide & ((WideInt128{1} << 64) - 1), masked);
    ASSERT_EQ(a.own < b.own, a.exact < b.exact);
    ASSERT_EQ(a.wide < b.wide, a.exact < b.exact);
    ASSERT_EQ(a.own == b.own, a.wide == b.wide);
  }
  EXPECT_GT(below, 5'000);  // shifts of negative numbers that are no multiples
}

}  // namespace xnewell::THIS_FILE
