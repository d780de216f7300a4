#include "geometry/files/number.h"

#include <gtest/gtest.h>

#include <bit>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <random>

#include "tests/support/reader_fixture.h"

namespace xnewell::THIS_FILE {

namespace {

double numberIn(const std::string& word) {
  Words words{word, "n.obj"};
  words.nextLine();
  return toNumber(words, words.next());
}

}  // namespace

// Seventeen significant digits identify every double, so numbers printed with them are read back bit for bit:
// all exponents, subnormals and the sign of 0 included.
TEST(ToNumber, ReturnsEveryDoubleFromSeventeenDigits) {
  std::mt19937_64 rng{17};
  for (int i = 0; i < 100'000; ++i) {
    const auto x =
        std::bit_cast<double>(i % 4 ? rng() : rng() & 0x800f'ffff'ffff'ffff);  // a quarter subnormal
    if (!(std::abs(x) <= DBL_MAX)) continue;
    char text[40];
    std::snprintf(text, sizeof text, "%.17g", x);
    ASSERT_EQ(std::bit_cast<std::uint64_t>(numberIn(text)), std::bit_cast<std::uint64_t>(x)) << text;
  }
}

// Decimal texts longer than any double are rounded to the nearest double, as the C library does.
TEST(ToNumber, RoundsLongDecimalsToNearest) {
  std::mt19937 rng{40};
  for (int i = 0; i < 20'000; ++i) {
    std::string text;
    for (auto digits = 1 + rng() % 40; digits > 0; --digits) text += static_cast<char>('0' + rng() % 10);
    text.insert(text.begin() + static_cast<int>(rng() % text.size()), '.');
    text += 'e';
    text += std::to_string(static_cast<int>(rng() % 720) - 380);
    const double expected = std::strtod(text.c_str(), nullptr);
    if (expected > DBL_MAX) {
      EXPECT_EQ(complaint([&] { return numberIn(text); }),
                "n.obj:1: number " + inQuotes(text) + " is too large");
    } else {
      ASSERT_EQ(numberIn(text), expected) << text;
    }
  }
}

// The spellings that modellers use. from_chars alone does not accept them all.
TEST(ToNumber, TakesTheUsualSpellings) {
  EXPECT_EQ(numberIn("+2"), 2.0);
  EXPECT_EQ(numberIn("1."), 1.0);
  EXPECT_EQ(numberIn(".5"), 0.5);
  EXPECT_EQ(numberIn("-.5"), -0.5);
  EXPECT_EQ(numberIn("+.5E+1"), 5.0);
  EXPECT_EQ(numberIn("1e3"), 1000.0);
  EXPECT_EQ(numberIn("007"), 7.0);
  EXPECT_TRUE(std::signbit(numberIn("-0")));
}

// The smallest subnormal is 2^-1074 = 4.94...e-324. Numbers below half of it are read as 0, with their sign.
TEST(ToNumber, UnderflowsGradually) {
  EXPECT_EQ(numberIn("5e-324"), DBL_TRUE_MIN);
  EXPECT_EQ(numberIn("2.4703282292062328e-324"), DBL_TRUE_MIN);
  EXPECT_EQ(numberIn("2.4703282292062327e-324"), 0.0);
  EXPECT_EQ(numberIn("1e-320"), 1e-320);
  EXPECT_EQ(numberIn("1e-99999999999999999999999"), 0.0);
  EXPECT_EQ(numberIn("0." + std::string(400, '0') + "1"), 0.0);
  EXPECT_EQ(numberIn("0." + std::string(400, '0') + "1e10"), 0.0) << "a large exponent, yet too small";
  EXPECT_EQ(numberIn("1" + std::string(400, '0') + "e-800"), 0.0) << "a large mantissa, yet too small";
  EXPECT_EQ(numberIn("0e99999999999999999999999"), 0.0);
  EXPECT_TRUE(std::signbit(numberIn("-1e-400")));
  EXPECT_EQ(numberIn("1" + std::string(400, '0') + "e-400"), 1.0);
}

// The first decimal that would round beyond the largest double, 2^1024 - 2^970, is an error, and so are all
// above it.
TEST(ToNumber, RefusesOverflow) {
  EXPECT_EQ(numberIn("1.7976931348623158e308"), DBL_MAX);
  const std::string small = "0." + std::string(400, '0') + "1e800";  // a small mantissa, but too large
  for (const std::string& word :
       {std::string{"1.7976931348623159e308"}, std::string{"-1e309"}, std::string{"+1e400"},
        std::string{"1e99999999999999999999"}, "1" + std::string(309, '0'), small,
        "1." + std::string(800, '0') + "e400"}) {
    EXPECT_EQ(complaint([&] { return numberIn(word); }),
              "n.obj:1: number " + inQuotes(word) + " is too large");
  }
}

TEST(ToNumber, RefusesWhatIsNoFiniteNumber) {
  for (const std::string word : {"nan", "-nan", "inf", "-inf", "+inf", "INFINITY", "nan(0)", "-nan(ind)"}) {
    EXPECT_EQ(complaint([&] { return numberIn(word); }), "n.obj:1: number '" + word + "' is not finite");
  }
  for (const std::string word : {"x", "1x", "+-1", "-+1", "++1", "--1", "+", "-", ".", "e3", "1e", "1e+",
                                 "0x10", "1,5", "1.2.3", "1.#INF", "1e400x", "1d3"}) {
    EXPECT_EQ(complaint([&] { return numberIn(word); }), "n.obj:1: malformed number '" + word + "'");
  }
}

// Decimals are counted in the text, trailing zeros included. The exponent moves the decimal point.
TEST(Decimals, AreThoseOfTheText) {
  EXPECT_EQ(decimals("-1.250"), 3);
  EXPECT_EQ(decimals("1.5e-3"), 4);
  EXPECT_EQ(decimals("1.5E+0"), 1);
  EXPECT_EQ(decimals("1.25e1"), 1);
  EXPECT_EQ(decimals("1.25e7"), -5);
  EXPECT_EQ(decimals("1e3"), -3);
  EXPECT_EQ(decimals("1000"), 0);
  EXPECT_EQ(decimals("1e-3"), 3);
  EXPECT_EQ(decimals("+.5"), 1);
  EXPECT_EQ(decimals("7."), 0);
  EXPECT_EQ(decimals("7"), 0);
  EXPECT_EQ(decimals("1e-99999999999999999999"), kMaxDecimals);
  EXPECT_EQ(decimals("1e99999999999999999999"), -kMaxDecimals);
}

// A file that is written with more decimals than it holds is told, in the three ways in which it can be seen.
TEST(RoundingOfNumbers, TellsOfDecimalsThatHoldNothing) {
  const auto told = [](const char* format, const auto& value) {
    RoundingOfNumbers r;
    std::mt19937 rng{1};
    for (int k = 0; k < 60; ++k) {
      const double v = value(static_cast<double>(rng()) * 0x1p-32 + 1);
      char text[64];
      std::snprintf(text, sizeof text, format, v);
      r.add(text, std::strtod(text, nullptr));
    }
    return r.doubtful();
  };
  const auto as = [](double v) { return v; };
  const auto single = [](double v) { return static_cast<double>(static_cast<float>(v)); };
  const auto sixDecimals = [](double v) { return std::round(1e6 * v) / 1e6; };
  const auto far = [&](double v) { return single(1e7 + v); };
  const auto quarters = [](double v) { return std::round(4 * v) / 4; };
  EXPECT_NE(told("%.12f", single).find("written with 12 decimals but are numbers of single precision"),
            std::string::npos);
  EXPECT_NE(told("%.9f", sixDecimals).find("9 decimals but have no more than 6 that are not 0"),
            std::string::npos);
  EXPECT_NE(told("%.6f", far), "");
  const auto moved = [](double v) { return 1e7 + v; };
  for (const char* honest : {"%.3f", "%.8f", "%.15f", "%.17g"}) EXPECT_EQ(told(honest, moved), "") << honest;
  for (const char* honest : {"%.3f", "%.6f", "%.12f", "%.17g"}) EXPECT_EQ(told(honest, as), "") << honest;
  for (const char* honest : {"%.4f", "%.6f"}) EXPECT_EQ(told(honest, single), "") << honest;
  EXPECT_EQ(told("%.6f", quarters), "");  // a model of round numbers
}

// The most decimals give the rounding, for any exponent. A few numbers with more decimals, zeros and integers
// do not count.
TEST(RoundingOfNumbers, IsThatOfMost) {
  const auto rounding = [](const std::vector<std::string>& numbers) {
    RoundingOfNumbers r;
    for (const std::string& n : numbers) r.add(n, std::stod(n));
    return r.rounding();
  };
  EXPECT_EQ(rounding({}), 0.5);
  EXPECT_EQ(rounding({"1", "0.0000", "250"}), 0.5);
  EXPECT_EQ(rounding({"1.5", "0.25", "7"}), 0.005);
  EXPECT_EQ(rounding({"1.234567e200", "1e0", "0"}), 0.5);
  EXPECT_EQ(rounding({"1.234567e9", "-2.5e8", "0.000"}), 500.0);
  std::vector<std::string> many(18, "0.125");
  many.insert(many.end(), {"1", "0", "2.3123456789012345", "0.12345678901234567"});
  EXPECT_EQ(rounding(many), 0.0005);  // two of twenty
  many.push_back("0.34567890123456784");
  EXPECT_LT(rounding(many), 1e-15);
  EXPECT_EQ(rounding({"446522.05700000003", "0.10000000000000001", "5.0000000000000000001"}), 0.0005);
  EXPECT_EQ(rounding({"0.30000000000000004", "12.000000000000002"}), 0.05);
}

}  // namespace xnewell::THIS_FILE
