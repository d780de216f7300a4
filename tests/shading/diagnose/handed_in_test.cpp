#include "shading/diagnose/handed_in.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <random>
#include <string>

#include "geometry/files/parse_error.h"
#include "shading/color/png.h"
#include "tests/support/temporary_folder.h"

namespace xnewell::THIS_FILE {

namespace {

class HandedInFile : public ::testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& bytes) {
    const std::string file = (folder_.path() / name).string();
    std::ofstream{file, std::ios::binary} << bytes;
    return file;
  }
  void refused(const std::string& bytes, const std::string& why) {
    const std::string file = write("bad", bytes);
    try {
      (void)readHandedIn(file);
      ADD_FAILURE() << "was read: " << why;
    } catch (const ParseError& e) {
      EXPECT_THAT(e.what(), ::testing::HasSubstr(why));
    }
  }
  TemporaryFolder folder_;
};

std::string big(std::initializer_list<std::uint32_t> numbers) {
  std::string bytes;
  for (const std::uint32_t n : numbers)
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(n >> shift & 255);
  return bytes;
}

/// The head of a window dump of 2 x 1 pixels.
std::string xwdHead(std::uint32_t bits, std::uint32_t line, std::uint32_t visual, std::uint32_t colors,
                    std::uint32_t lowFirst) {
  return big({100,    7,      2,    bits, 2,      1,        0,        lowFirst ? 0u : 1u, 32,
              0,      32,     bits, line, visual, 0xFF0000, 0x00FF00, 0x0000FF,           8,
              colors, colors, 2,    1,    0,      0,        0});
}

std::string little(std::initializer_list<std::int64_t> numbers) {
  std::string bytes;
  for (const std::int64_t n : numbers)
    for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(n >> shift & 255);
  return bytes;
}

/// A BMP file: its head, what follows it, and its rows.
std::string bmp(int width, int height, int bits, int packing, const std::string& more = "",
                const std::string& rows = std::string(8, 'a')) {
  return "BM" +
         little({0, 0, 54 + int(more.size()), 40, width, height, bits << 16 | 1, packing, 0, 0, 0,
                 bits == 8 ? 2 : 0, 0}) +
         more + rows;
}

}  // namespace

// One picture of two pixels, as each kind of file.
TEST_F(HandedInFile, IsReadByWhatIsInIt) {
  RgbImage image{2, 1};
  image.rgb = {200, 10, 0, 1, 2, 3};
  EXPECT_EQ(readHandedIn(write("a.txt", encodePng(image))).picture, image);
  const std::string samples{"\xC8\x0A\x00\x01\x02\x03", 6};
  EXPECT_EQ(readHandedIn(write("a.ppm", "P6 # a comment\n2 1\n255\n" + samples)).picture, image);
  const std::string wide{"\xC8\xC8\x0A\x0A\x00\x00\x01\x01\x02\x02\x03\x03", 12};
  EXPECT_EQ(readHandedIn(write("a.ppm", "P6 2 1 65535\n" + wide)).picture, image);
  EXPECT_EQ(readHandedIn(write("a.ppm", "P3\n2 1 255\r\n200 10 0\t1 # end\n2 3")).picture, image);
  const std::string low{"\x00\x0A\xC8\x00\x03\x02\x01\x00", 8}, high{"\x00\xC8\x0A\x00\x00\x01\x02\x03", 8};
  EXPECT_EQ(readHandedIn(write("a.xwd", xwdHead(32, 8, 4, 0, 1) + low)).picture, image);
  EXPECT_EQ(readHandedIn(write("a.xwd", xwdHead(32, 8, 4, 0, 0) + high)).picture, image);
}

// A picture of two rows as BMP files have it: rows from below or from above, with what fills them up.
TEST_F(HandedInFile, ReadsBmp) {
  RgbImage image{1, 2};
  image.rgb = {255, 0, 0, 0, 255, 255};
  const std::string red{"\0\0\xFF\0", 4}, cyan{"\xFF\xFF\0\0", 4};
  EXPECT_EQ(readHandedIn(write("a", bmp(1, 2, 24, 0, "", cyan + red))).picture, image);
  EXPECT_EQ(readHandedIn(write("a", bmp(1, -2, 32, 0, "", red + cyan))).picture, image);
  const std::string red555{"\0\x7C\0\0", 4}, cyan555{"\xFF\x03\0\0", 4};
  EXPECT_EQ(readHandedIn(write("a", bmp(1, 2, 16, 0, "", cyan555 + red555))).picture, image);
  const std::string masks = little({0xF, 0xF0, 0xF00}), red444{"\x0F\0\0\0", 4}, cyan444{"\xF0\x0F\0\0", 4};
  EXPECT_EQ(readHandedIn(write("a", bmp(1, 2, 16, 3, masks, cyan444 + red444))).picture, image);
  const HandedIn in =
      readHandedIn(write("a", bmp(1, 2, 8, 0, cyan + red, std::string{"\0\0\0\0\1\0\0\0", 8})));
  EXPECT_EQ(in.picture, image);
  ASSERT_TRUE(in.cells);
  EXPECT_EQ(in.cells->pixels, (std::vector<std::uint8_t>{1, 0}));
}

// A palette keeps its indices, also with few bits a pixel.
TEST_F(HandedInFile, KeepsCells) {
  IndexImage cells{2, 1, 0};
  cells.pixels = {11, 250};
  Palette palette{};
  palette[11] = {0x1200, 0, 0}, palette[250] = {0xF000, 0x100, 0};
  const HandedIn in = readHandedIn(write("a.png", encodePng(cells, palette)));
  ASSERT_TRUE(in.cells);
  EXPECT_EQ(*in.cells, cells);
  EXPECT_EQ(in.held[250], (std::array<std::uint8_t, 3>{0xF0, 1, 0}));
  EXPECT_EQ(in.picture.pixel(0, 0)[0], 0x12);

  std::string dump = xwdHead(8, 4, 3, 2, 1);
  dump.replace(4 * 14, 12, big({0, 0, 0}));  // no masks
  dump += big({11, 0x12000000, 0, 250, 0xF0000100, 0});
  dump += std::string{"\x0B\xFA\x00\x00", 4};
  const HandedIn window = readHandedIn(write("a.xwd", dump));
  ASSERT_TRUE(window.cells);
  EXPECT_EQ(*window.cells, cells);
  EXPECT_EQ(window.picture.pixel(1, 0)[0], 0xF0);
}

// A file that is not whole, not what it says, or too large is refused in one line, before memory is taken
// for it.
TEST_F(HandedInFile, RefusesBrokenFiles) {
  refused("", "not a PNG, PPM, BMP or XWD picture");
  refused("hello", "not a PNG, PPM, BMP or XWD picture");
  refused("\x89PNG", "not a PNG file");
  refused("P6 2 1 255\nabc", "the file ends early");
  refused("P6 2", "the file ends early");
  refused("P6 99999 99999 255\nabc", "larger than 8192 pixels");
  refused("P6 2 1 70000\nabc", "65535");
  refused("P6 -2 1 255\nabc", "no whole number");
  refused("P3 2 1 255 1 2 3 4 5 x", "no whole number");
  refused("P3 8000 8000 255 1 2 3", "the file ends early");
  refused("\xFF\xD8\xFF\xE0", "a JPEG picture; its compression changes the colours");
  refused(bmp(2, 1, 24, 0).substr(0, 60), "the file ends early");
  refused(bmp(-2, 1, 24, 0), "larger than 8192");
  refused(bmp(2, 1, 4, 0), "no 8, 16, 24 or 32 bits");
  refused(bmp(2, 1, 8, 1), "compressed");
  refused(xwdHead(32, 8, 4, 0, 1) + "abc", "the file ends early");
  refused(xwdHead(32, 4, 4, 0, 1) + "abcdefgh", "the rows of the window dump do not fit");
  refused(xwdHead(1, 4, 4, 0, 1) + "abcdefgh", "no 8, 16, 24 or 32 bits");
  refused(xwdHead(32, 8, 4, 0xFFFFFFFF, 1), "too many colours");
  std::string huge = xwdHead(32, 0x7FFFFFF0, 4, 0, 1);
  huge.replace(4 * 4, 8, big({8192, 8192}));
  refused(huge, "do not fit");
  EXPECT_THROW((void)readHandedIn((folder_.path() / "none").string()), std::system_error);
  EXPECT_THROW((void)readHandedIn(folder_.path().string()), std::system_error);
  EXPECT_THROW((void)readHandedIn("/dev/zero"), ParseError);
}

// Files with changed bytes are read or refused; nothing else happens.
TEST_F(HandedInFile, SurvivesChangedBytes) {
  IndexImage cells{20, 10, 3};
  Palette palette{};
  const std::vector<std::string> whole{encodePng(cells, palette),
                                       "P3 2 1 255 1 2 3 4 5 6",
                                       bmp(1, 2, 8, 0, std::string(8, 'b')),
                                       bmp(2, 1, 24, 0),
                                       "P6 4 2 255\n" + std::string(24, 'a'),
                                       xwdHead(32, 8, 4, 0, 1) + "abcdefgh"};
  for (unsigned seed = 0; seed < 300; ++seed) {
    std::mt19937 rng{seed};
    std::string bytes = whole[seed % whole.size()];
    for (int k = 0; k < 3; ++k) bytes[rng() % bytes.size()] = static_cast<char>(rng());
    if (seed % 5 == 0) bytes.resize(rng() % bytes.size());
    const std::string file = write("changed", bytes);
    try {
      const HandedIn in = readHandedIn(file);
      EXPECT_LE(in.picture.width, 8192);
    } catch (const ParseError&) {
    }
  }
}

}  // namespace xnewell::THIS_FILE
