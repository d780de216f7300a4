#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <random>
#include <string_view>
#include <system_error>

#include "geometry/files/output_file.h"
#include "geometry/files/parse_error.h"
#include "shading/color/font.h"
#include "shading/color/png.h"
#include "tests/support/full_color_picture.h"
#include "tests/support/reader_fixture.h"

namespace xnewell::THIS_FILE {

namespace {

/// ---- PNG

/// Noise, which uses every filter and every code length of zlib.
IndexImage noise(int width, int height, unsigned seed) {
  std::mt19937 rng{seed};
  IndexImage image{width, height, 0};
  for (auto& p : image.pixels) p = static_cast<std::uint8_t>(rng());
  return image;
}

// Every pixel comes back as its cell's 16-bit colour >> 8, also at the smallest size and at odd sizes.
TEST(Png, PaletteRoundTrip) {
  const TemporaryFolder folder;
  const Palette palette = scattered(1975);
  for (const auto& [w, h] : {std::pair{1, 1}, {1, 7}, {37, 1}, {101, 64}, {800, 600}}) {
    const IndexImage image = noise(w, h, 1972);
    const std::string file = folder.file(std::to_string(w) + "x" + std::to_string(h) + ".png");
    writePng(file, image, palette);
    const RgbImage back = readPng(file);
    ASSERT_EQ(back.width, w);
    ASSERT_EQ(back.height, h);
    for (int j = 0; j < h; ++j)
      for (int i = 0; i < w; ++i) {
        const Rgb16 c = palette[image.row(j)[i]];
        ASSERT_EQ(back.pixel(i, j)[0], c.r >> 8);
        ASSERT_EQ(back.pixel(i, j)[1], c.g >> 8);
        ASSERT_EQ(back.pixel(i, j)[2], c.b >> 8);
      }
  }
  EXPECT_EQ(folder.entries(), 5);
}

// A file that cannot be opened is an error of the system. A file that is no PNG or ends early is an error of
// the file.
TEST(Png, ReadingSaysWhoIsWrong) {
  const TemporaryFolder folder;
  const std::string file = folder.file("a.png");
  const auto complaintOfIt = [&] { return complaint([&] { return readPng(file); }); };
  EXPECT_THROW((void)readPng(file), std::system_error);
  EXPECT_THROW((void)readPng(folder.file("")), std::system_error);
  folder.write("a.png", "no picture at all");
  EXPECT_EQ(complaintOfIt(), file + ": not a PNG file");
  const std::string whole = encodePng(noise(64, 64, 5), scattered(5));
  for (const std::size_t length : {std::size_t{0}, std::size_t{20}, std::size_t{500}, whole.size() / 2}) {
    folder.write("a.png", whole.substr(0, length));
    EXPECT_EQ(complaintOfIt(), file + (length == 0 ? ": not a PNG file" : ": the PNG file ends early"))
        << length;
  }
}

/// The chunks of a PNG file: their names, and what they hold.
std::vector<std::pair<std::string, std::string>> chunksOf(const std::string& bytes) {
  std::vector<std::pair<std::string, std::string>> chunks;
  for (std::size_t at = 8; at + 12 <= bytes.size();) {
    std::size_t length = 0;
    for (int k = 0; k < 4; ++k) length = length << 8 | static_cast<unsigned char>(bytes[at + k]);
    chunks.emplace_back(bytes.substr(at + 4, 4), bytes.substr(at + 8, length));
    at += 12 + length;
  }
  return chunks;
}

// A note comes back byte for byte. It is one chunk before the pixels; all else in the file is as without it,
// and the same picture with the same note is the same file.
TEST(Png, CarriesANote) {
  const TemporaryFolder folder;
  const Palette palette = scattered(3);
  const IndexImage image = noise(40, 30, 1973);
  const RgbImage deep{5, 4};
  const auto files = [&](const std::string& note) {
    return std::array{encodePng(image, palette, note), encodePng(deep, note)};
  };
  const auto plain = files("");
  EXPECT_EQ(plain, (std::array{encodePng(image, palette), encodePng(deep)}));
  for (const std::string& note : {std::string{"a"}, std::string{"xnewell draw W\u00FCrfel.obj --ia 0.2"},
                                  std::string(2000, 'x'), std::string{"two\nlines"}}) {
    EXPECT_EQ(files(note), files(note));
    for (int k = 0; k < 2; ++k) {
      const std::string bytes = files(note)[k];
      EXPECT_EQ(noteInPng(folder.write("noted.png", bytes)), note);
      auto chunks = chunksOf(bytes);
      const auto text = std::ranges::find(chunks, "iTXt", [](const auto& chunk) { return chunk.first; });
      ASSERT_NE(text, chunks.end());
      EXPECT_EQ(text->second, std::string("xnewell\0\0\0\0\0", 12) + note);
      EXPECT_NE(std::find_if(text, chunks.end(), [](const auto& c) { return c.first == "IDAT"; }),
                chunks.end());
      chunks.erase(text);
      EXPECT_EQ(chunks, chunksOf(plain[k]));
    }
  }
  EXPECT_EQ(noteInPng(folder.write("plain.png", plain[0])), std::nullopt);
}

// A file that ends before its pixels, or that is no PNG, has an error and no note. A damaged chunk is no
// note.
TEST(Png, ReadsNoNoteFromABrokenFile) {
  const TemporaryFolder folder;
  std::string bytes = encodePng(IndexImage{3, 2, 7}, scattered(1), "a note");
  const std::size_t pixels = bytes.find("IDAT"), note = bytes.find("a note");
  for (std::size_t length = 0; length < pixels; length += 7)
    EXPECT_THROW((void)noteInPng(folder.write("cut.png", bytes.substr(0, length))), ParseError) << length;
  EXPECT_EQ(noteInPng(folder.write("head.png", bytes.substr(0, pixels + 4))), "a note");
  bytes[note] = 'b';
  EXPECT_EQ(noteInPng(folder.write("damaged.png", bytes)), std::nullopt);
  EXPECT_THROW((void)noteInPng(folder.file("none.png")), std::system_error);
}

/// ---- The font

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

// UTF-8 becomes Latin-1. A character that the font lacks becomes one question mark, and so does broken UTF-8.
TEST(Font, Latin1FromUtf8) {
  for (const auto& [utf8, expected] :
       {std::pair{"teapot \u00B7 33\u00B0 \u00E9\u00FF", "teapot \xB7 33\xB0 \xE9\xFF"},
        {"a\u2192b\U0001FAD6c", "a?b?c"},
        {"tab\tnew\nend", "tab?new?end"},
        {"\x7F\u0080\u009F", "???"},
        {"x\xC2", "x?"},
        {"\xC2x", "?x"},
        {"\xC0\x80", "?"},
        {"\x80\xFF\xFEz", "???z"},
        {"\xE2\x86z", "?z"},
        {"", ""}})
    EXPECT_EQ(latin1(utf8), expected);
  EXPECT_EQ(codesOf("\u03B8 = 1\xC0\xA0"), U"\u03B8 = 1?");
}

}  // namespace

}  // namespace xnewell::THIS_FILE
