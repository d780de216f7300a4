#include "shading/color/png.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <random>
#include <system_error>

#include "geometry/files/output_file.h"
#include "geometry/files/parse_error.h"
#include "tests/support/scattered_palette.h"
#include "tests/support/temporary_folder.h"

namespace xnewell::THIS_FILE {

namespace {

/// Noise, which uses every filter and every code length of zlib.
IndexImage noise(int width, int height, unsigned seed) {
  std::mt19937 rng{seed};
  IndexImage image{width, height, 0};
  for (auto& p : image.pixels) p = static_cast<std::uint8_t>(rng());
  return image;
}

std::string contents(const std::string& file) {
  std::ifstream in{file, std::ios::binary};
  return {std::istreambuf_iterator<char>{in}, {}};
}

}  // namespace

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

// The palette of the file is the colormap. The header says 8 bits a pixel with a palette, and all 256 colours
// are there, used or not.
TEST(Png, KeepsTheWholeColormap) {
  const TemporaryFolder folder;
  const Palette palette = scattered(1);
  writePng(folder.file("a.png"), IndexImage{3, 2, 7}, palette);
  const std::string bytes = contents(folder.file("a.png"));
  EXPECT_EQ(bytes[24], 8);  // IHDR: bit depth, colour type
  EXPECT_EQ(bytes[25], 3);
  const std::size_t plte = bytes.find("PLTE");
  ASSERT_NE(plte, std::string::npos);
  for (int c = 0; c < 256; ++c)
    EXPECT_EQ(static_cast<std::uint8_t>(bytes[plte + 4 + 3 * c]), palette[c].r >> 8);
  EXPECT_EQ(static_cast<std::uint8_t>(bytes[plte - 2]), 3);  // 0x300 = 768 bytes
}

// All three channels of an RGB picture come back.
TEST(Png, RgbRoundTrip) {
  const TemporaryFolder folder;
  RgbImage image{61, 43};
  std::mt19937 rng{3};
  for (auto& v : image.rgb) v = static_cast<std::uint8_t>(rng());
  writePng(folder.file("a.png"), image);
  EXPECT_EQ(readPng(folder.file("a.png")), image);
}

// The same pixels give the same bytes: the file holds no time and no counter.
TEST(Png, SamePixelsSameBytes) {
  const TemporaryFolder folder;
  const IndexImage image = noise(50, 40, 4);
  writePng(folder.file("a.png"), image, scattered(4));
  writePng(folder.file("b.png"), image, scattered(4));
  EXPECT_EQ(contents(folder.file("a.png")), contents(folder.file("b.png")));
  EXPECT_EQ(contents(folder.file("a.png")).find("tIME"), std::string::npos);
}

// A file that cannot be opened is an error of the system. A file that is no PNG or ends early is an error of
// the file.
TEST(Png, ReadingSaysWhoIsWrong) {
  const TemporaryFolder folder;
  const std::string file = folder.file("a.png");
  const auto complaint = [&]() -> std::string {
    try {
      (void)readPng(file);
    } catch (const ParseError& e) {
      return e.what();
    }
    return {};
  };
  EXPECT_THROW((void)readPng(file), std::system_error);
  EXPECT_THROW((void)readPng(folder.file("")), std::system_error);
  folder.write("a.png", "no picture at all");
  EXPECT_EQ(complaint(), file + ": not a PNG file");
  const std::string whole = encodePng(noise(64, 64, 5), scattered(5));
  for (const std::size_t length : {std::size_t{0}, std::size_t{20}, std::size_t{500}, whole.size() / 2}) {
    folder.write("a.png", whole.substr(0, length));
    EXPECT_EQ(complaint(), file + (length == 0 ? ": not a PNG file" : ": the PNG file ends early")) << length;
  }
}

// A failed write is reported in the system's words.
TEST(Png, FailsAsTheFileDoes) {
  try {
    writePng("/dev/full", IndexImage{8, 8, 1}, scattered(6));
    FAIL() << "written";
  } catch (const std::system_error& e) {
    EXPECT_STREQ(e.what(), "/dev/full: No space left on device");
  }
}

namespace {

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

}  // namespace

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

}  // namespace xnewell::THIS_FILE
