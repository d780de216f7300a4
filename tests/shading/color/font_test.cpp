#include "shading/color/font.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string_view>

namespace xnewell::THIS_FILE {

namespace {

bool on(const Glyph& g, int i, int j) { return g[j] >> (5 - i) & 1; }
bool on(const DoubledGlyph& g, int i, int j) { return g[j] >> (11 - i) & 1; }

Glyph randomGlyph(unsigned seed) {
  std::mt19937 rng{seed};
  Glyph g;
  for (auto& row : g) row = static_cast<std::uint8_t>(rng() & 63);
  return g;
}

/// The rule as its authors state it, on colours: E is the pixel, B is above it, D left, F right and H below.
bool asPublished(const Glyph& g, int i, int j) {
  const auto at = [&](int x, int y) { return x >= 0 && x < 6 && y >= 0 && y < 13 && on(g, x, y); };
  const int x = i / 2, y = j / 2;
  const bool B = at(x, y - 1), D = at(x - 1, y), E = at(x, y), F = at(x + 1, y), H = at(x, y + 1);
  if (i % 2 == 0 && j % 2 == 0) return D == B && B != F && D != H ? D : E;
  if (j % 2 == 0) return B == F && B != D && F != H ? F : E;
  if (i % 2 == 0) return D == H && D != B && H != F ? D : E;
  return H == F && D != H && B != F ? F : E;
}

}  // namespace

// The A of misc-fixed 6x13, as its source draws it: nine rows above the baseline, five columns wide.
TEST(Font, AHasItsRows) {
  const Glyph A{0,        0,        0b001000, 0b010100, 0b100010, 0b100010, 0b100010,
                0b111110, 0b100010, 0b100010, 0b100010, 0,        0};
  EXPECT_EQ(*glyphOf('A'), A);
}

// Every printable character of Latin-1 but the two spaces has ink, and no two ASCII ones look alike.
TEST(Font, IsComplete) {
  for (const auto& [code, g] : kFont6x13) {
    EXPECT_EQ(glyphOf(code), &g);
    if (code > 0xFF) continue;
    const bool blank = std::all_of(g.begin(), g.end(), [](int row) { return row == 0; });
    EXPECT_EQ(blank, code == 0x20 || code == 0xA0) << static_cast<int>(code);
    for (const int row : g) EXPECT_LT(row, 64) << static_cast<int>(code);
    for (char32_t other = 0x20; other < code && code < 0x7F; ++other)
      EXPECT_NE(*glyphOf(other), g) << static_cast<int>(code);
  }
  for (const char32_t code : std::u32string_view{U"\u03B1\u03B8\u03C9\u2192\u2264\u221E\u2082"})
    EXPECT_NE(glyphOf(code), nullptr) << static_cast<int>(code);
  EXPECT_EQ(glyphOf(0x7F), nullptr);
}

// Doubling follows the published rule. The test uses glyphs of noise, in which every neighbourhood occurs.
TEST(Font, Scale2xAsPublished) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    const Glyph g = randomGlyph(seed);
    const DoubledGlyph d = scale2x(g);
    for (int j = 0; j < 26; ++j)
      for (int i = 0; i < 12; ++i) ASSERT_EQ(on(d, i, j), asPublished(g, i, j)) << i << ' ' << j;
  }
}

// Doubling and turning a glyph by half a turn can change places. The edges of a full rectangle stay straight.
TEST(Font, Scale2xHasNoHandedness) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    const Glyph g = randomGlyph(seed);
    Glyph turned{};
    for (int j = 0; j < 13; ++j)
      for (int i = 0; i < 6; ++i)
        if (on(g, i, j)) turned[12 - j] = static_cast<std::uint8_t>(turned[12 - j] | 1 << i);
    const DoubledGlyph a = scale2x(g), b = scale2x(turned);
    for (int j = 0; j < 26; ++j)
      for (int i = 0; i < 12; ++i) ASSERT_EQ(on(a, i, j), on(b, 11 - i, 25 - j));
  }
  const Glyph bar{0, 0, 0b111111, 0b111111, 0, 0, 0, 0, 0, 0, 0, 0, 0};
  const DoubledGlyph doubled = scale2x(bar);
  for (int j = 0; j < 26; ++j) EXPECT_EQ(doubled[j] != 0, j >= 4 && j < 8) << j;
}

// UTF-8 becomes Latin-1. A character that the font lacks becomes one question mark, and so does broken UTF-8.
TEST(Font, Latin1FromUtf8) {
  EXPECT_EQ(latin1("teapot \u00B7 33\u00B0 \u00E9\u00FF"), "teapot \xB7 33\xB0 \xE9\xFF");
  EXPECT_EQ(latin1("a\u2192b\U0001FAD6c"), "a?b?c");
  EXPECT_EQ(codesOf("\u03B8 = 1\xC0\xA0"), U"\u03B8 = 1?");
  EXPECT_EQ(latin1("tab\tnew\nend"), "tab?new?end");
  EXPECT_EQ(latin1("\x7F\u0080\u009F"), "???");
  EXPECT_EQ(latin1("x\xC2"), "x?");
  EXPECT_EQ(latin1("\xC2x"), "?x");
  EXPECT_EQ(latin1("\xC0\x80"), "?");
  EXPECT_EQ(latin1("\x80\xFF\xFEz"), "???z");
  EXPECT_EQ(latin1("\xE2\x86z"), "?z");
  EXPECT_EQ(latin1(""), "");
}

}  // namespace xnewell::THIS_FILE
