#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <set>
#include <stdexcept>

#include "tests/support/seeds.h"
#include "tests/x11/support/watched_viewer.h"

#include <X11/XWDFile.h>

#include "x11/window/panel.h"

namespace xnewell::THIS_FILE {

// Pictures that a server fills, the window as an independent client, xwd, sees it, and what is sent. That
// snapshots are the files that `draw` writes: tests/stories/snapshots.txt.

namespace {

/// A number in the file. All numbers but the pixels have their most significant byte first.
std::uint32_t numberAt(const std::string& file, std::size_t at, int bytes, bool lowFirst = false) {
  std::uint32_t n = 0;
  for (int i = 0; i < bytes; ++i)
    n = n << 8 | static_cast<unsigned char>(file.at(at + (lowFirst ? bytes - 1 - i : i)));
  return n;
}

/// A screenshot as xwd writes it: header, the window's name, the entries of the colormap, rows of pixels.
/// @see X11/XWDFile.h
RgbImage readXwd(const std::string& file) {
  const auto field = [&](std::size_t at) { return numberAt(file, at, 4); };
  if (field(offsetof(XWDFileHeader, file_version)) != XWD_FILE_VERSION)
    throw std::runtime_error("no screenshot");
  const auto kind = field(offsetof(XWDFileHeader, visual_class));
  const bool channels =
      kind == 4 || kind == 5;  // TrueColor, DirectColor: one entry for each value of a channel
  std::array<std::uint32_t, 3> masks{field(offsetof(XWDFileHeader, red_mask)),
                                     field(offsetof(XWDFileHeader, green_mask)),
                                     field(offsetof(XWDFileHeader, blue_mask))};
  if (!channels) masks.fill(~0u);

  const std::size_t entries = field(offsetof(XWDFileHeader, header_size));
  const std::uint32_t count = field(offsetof(XWDFileHeader, ncolors));
  std::array<std::map<std::uint32_t, std::uint8_t>, 3> shown;  // by the bits of the channel
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::size_t entry = entries + i * std::size_t{sz_XWDColor};
    const std::uint32_t pixel = numberAt(file, entry, 4);
    for (int c = 0; c < 3; ++c)
      shown[c][pixel & masks[c]] = static_cast<std::uint8_t>(numberAt(file, entry + 4 + 2 * c, 2) >> 8);
  }

  RgbImage image{static_cast<int>(field(offsetof(XWDFileHeader, pixmap_width))),
                 static_cast<int>(field(offsetof(XWDFileHeader, pixmap_height)))};
  const std::uint32_t rowBytes = field(offsetof(XWDFileHeader, bytes_per_line));
  const int bytes = static_cast<int>(field(offsetof(XWDFileHeader, bits_per_pixel))) / 8;
  const bool lowFirst = field(offsetof(XWDFileHeader, byte_order)) == 0;
  const std::size_t rows = entries + count * std::size_t{sz_XWDColor};
  std::uint8_t* out = image.rgb.data();
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const std::uint32_t pixel =
          numberAt(file, rows + y * std::size_t{rowBytes} + x * std::size_t(bytes), bytes, lowFirst);
      for (int c = 0; c < 3; ++c) *out++ = shown[c].at(pixel & masks[c]);
    }
  return image;
}

RgbImage screenshot(const XServer& server, const std::string& options) {
  const Finished done = RunningProgram{"xwd", words("-silent " + options), server.name()}.wait();
  EXPECT_EQ(done.status, 0) << "the tests need the program xwd. " << done.err;
  EXPECT_EQ(done.err, "");
  return readXwd(done.out);
}

}  // namespace

// When polygons are split, no background shows between the pieces: the server paints the same
// pixels as for whole polygons in any other order.
TEST(Snapshot, PiecesLeaveNoGap) {
  const XServer server = XServer::xvfb(8);
  const TemporaryFolder folder;
  std::vector<std::string> scenes{"crossing-sheets", "nested-cycles", "tori", "teapot"};
  for (unsigned seed = 0; seed < Seeds{8}.end;
       ++seed) {  // triangles that cross, so that the picture is divided
    std::ofstream obj{scenes.emplace_back(folder.file("crossing" + std::to_string(seed) + ".obj"))};
    std::mt19937 random{seed};
    const auto below = [&random](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    for (int k = 0; k < 60; ++k) {
      const glm::ivec3 center{below(2000), below(2000), below(2000)};
      for (int i = 0; i < 3; ++i)
        obj << "v " << center.x + below(2000) << ' ' << center.y + below(2000) << ' '
            << center.z + below(2000) << '\n';
      obj << "f -3 -2 -1\n";
    }
  }
  for (const std::string& scene : scenes) {
    SCOPED_TRACE(scene);
    const RgbImage whole = pictureOf("snapshot --fill x11 --order none " + scene, server.name());
    const auto ground = [](const RgbImage& image, std::size_t i) {
      return std::equal(&image.rgb[i], &image.rgb[i] + 3, &image.rgb[0]);
    };
    for (const std::string order : {"newell", "bsp"}) {
      const RgbImage pieces = pictureOf("snapshot --fill x11 --order " + order + ' ' + scene, server.name());
      int covered = 0, gained = 0;
      ASSERT_EQ(whole.rgb.size(), pieces.rgb.size());
      for (std::size_t i = 0; i < whole.rgb.size(); i += 3) {
        covered += !ground(whole, i);
        gained += ground(whole, i) != ground(pieces, i);
      }
      EXPECT_GT(covered, 10'000);
      EXPECT_EQ(gained, 0);
      EXPECT_NE(whole, pieces);
    }
  }
}

// The X server confirms the sample rule: left and top edges are in, right and bottom edges are out. With
// corners exactly on pixel centres, our filler and XFillPolygon fill the same samples, for triangles (its
// convex filler) and for quads (its general one).
TEST(Snapshot, OwnsTheSamplesThatTheServerOwns) {
  const XServer server = XServer::xvfb(8);
  const TemporaryFolder folder;
  constexpr int kSize = 128;  // one world unit is one pixel: x = i + 1/2 is the centre of pixel i
  for (unsigned seed = 0; seed < Seeds{6}.end; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 rng{seed};
    const auto below = [&rng](int n) { return static_cast<int>(rng() % n); };
    const std::string name = folder.file("corners.obj");
    {
      std::ofstream obj{name};
      int vertices = 0;
      for (int face = 0; face < 250; ++face) {
        // A parallelogram or half of one, on a plane with its own slope, so that colours differ. Planes meet
        // between two columns of pixels: at a centre, either of the two may show.
        const int reach = seed % 2 ? 12 : 60, slope = -below(9);
        const std::array<int, 2> a{below(kSize), below(kSize)};
        const std::array<int, 2> u{below(2 * reach + 1) - reach, below(2 * reach + 1) - reach};
        const std::array<int, 2> v{below(2 * reach + 1) - reach, below(2 * reach + 1) - reach};
        const int corners = 3 + below(2);
        for (const auto& [p, q] : {std::array{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
          if (corners == 3 && p == 1 && q == 1) continue;
          const int i = a[0] + p * u[0] + q * v[0], j = a[1] + p * u[1] + q * v[1];
          obj << "v " << i + 0.5 << ' ' << kSize - (j + 0.5) << ' ' << slope * (i - 63.75) << '\n';
        }
        obj << 'f';
        for (int k = 0; k < corners; ++k) obj << ' ' << ++vertices;
        obj << '\n';
      }
    }
    const std::string line = name + " --eye 64,64,5000 --look-at 64,64,0 --up 0,1,0 --parallel 128" +
                             " --light 1,0,1 --size 128x128 --order ";
    RgbImage ours;
    for (const std::string order : {"none", "newell", "bsp"}) {  // whole polygons, and pieces with clip lists
      ours = pictureOf("snapshot --fill scanline " + line + order, server.name());
      EXPECT_EQ(pictureOf("snapshot --fill x11 " + line + order, server.name()), ours);
    }
    std::set<std::array<int, 3>> colors;
    for (int i = 0; i < kSize * kSize; ++i)
      colors.insert({ours.rgb[3 * i], ours.rgb[3 * i + 1], ours.rgb[3 * i + 2]});
    EXPECT_GE(colors.size(), 6u);  // the faces have different colours
  }
}

// The whole window is the same at depth 8 and 24, also where there is no room for the controls. Only the
// status line differs: it tells the visual and the time.
TEST(Snapshot, WholeWindowIsTheSameAtBothDepths) {
  const XServer eight = XServer::xvfb(8), deep = XServer::xvfb(24);
  for (const auto& [w, h] :
       {std::pair{1024, 768}, {800, 540}, {1601, 1201}, {640, 480}, {799, 600}, {1, 1}}) {
    SCOPED_TRACE(testing::Message() << w << " x " << h);
    const std::string line = "teapot --divisions 4 --table corrected --whole-window --size " +
                             std::to_string(w) + "x" + std::to_string(h);
    const Layout at = layoutOf(w, h);
    const Rect part{0, 0, w, at.roomy ? at.status.y : h};
    const RgbImage one = pictureOf("snapshot " + line, eight.name()),
                   two = pictureOf("snapshot " + line, deep.name());
    ASSERT_EQ(std::pair(one.width, one.height), std::pair(w, h));
    EXPECT_EQ(cropped(one, part), cropped(two, part));
  }
}

// What the server filled is read back as cells too. On a real colormap, shades that look the same are told
// apart: inside the outlines each sample has the cell that our own filler gives it. Decoded, the file is the
// picture that the other server shows.
TEST(ReadCells, TellEqualColorsApart) {
  const XServer eight = XServer::xvfb(8), deep = XServer::xvfb(24);
  const TemporaryFolder folder;
  const std::string line = "teapot --divisions 8 --table corrected --bits 8 --ia 0.02 --ip 0.15";
  const auto made = [&](const std::string& name, const std::string& command, const std::string& display) {
    const Finished done = runProgram(words(command + line + " -o " + folder.file(name)), display);
    EXPECT_EQ(done.status, 0) << done.err;
    return folder.file(name);
  };
  const std::string filled = made("x.png", "snapshot --fill x11 ", eight.name());
  const IndexedPng ours = readIndexedPng(made("d.png", "draw ", "")).value(),
                   served = readIndexedPng(filled).value();
  const std::vector<std::uint8_t>&cells = ours.image.pixels, &theirs = served.image.pixels;
  ASSERT_EQ(theirs.size(), cells.size());
  EXPECT_EQ(served.held, ours.held);
  int painted = 0, same = 0, twins = 0;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const std::uint8_t cell = cells[k];
    if (cell < 11) continue;
    ++painted;
    same += theirs[k] == cell;
    twins += cell > 11 && ours.held[cell] == ours.held[cell - 1];
  }
  EXPECT_GT(painted, 30'000);
  EXPECT_GT(same, painted * 9 / 10);
  EXPECT_LT(same, painted);        // outlines have the cells of the server
  EXPECT_GT(twins, painted / 20);  // here the first cell of that colour would be wrong
  EXPECT_EQ(readPng(made("y.png", "snapshot --fill x11 ", deep.name())), readPng(filled));
}

class Screenshot : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Depths, Screenshot, testing::Values(8, 24), testing::PrintToStringParamName());

// A screenshot of the window equals the snapshot of the whole window, and the picture in it equals the plain
// snapshot. So does a screenshot of the screen with each window in its own colours.
TEST_P(Screenshot, OfAnotherClientAgreesWithOurs) {
  const XServer server = XServer::xvfb(GetParam(), 1100, 800);
  for (const auto& [w, h] : {std::pair{1024, 768}, {800, 600}, {320, 240}}) {
    SCOPED_TRACE(testing::Message() << w << " x " << h);
    const std::string line = "teapot --divisions 4 --table corrected --hue 0.3,0.5,1 --shade gouraud";
    const std::string size = " --size " + std::to_string(w) + "x" + std::to_string(h);
    const Rect seen = aboveStatus(w, h);
    const RgbImage expected = freshWindow(server, line, w, h);
    const WatchedViewer viewer{server, line + size};
    const WatchedWindow& window = viewer.window;
    ASSERT_TRUE(window.comesToShow(expected, seen));

    const RgbImage taken = screenshot(server, "-id " + std::to_string(window.id()));
    EXPECT_EQ(std::pair(taken.width, taken.height), std::pair(w, h));
    EXPECT_EQ(cropped(taken, seen), expected);
    const RgbImage screen = screenshot(server, "-root");
    EXPECT_EQ(screen.width, 1100);
    EXPECT_EQ(cropped(screen, seen), expected);

    const Rect at = layoutOf(w, h).picture;
    if (!layoutOf(w, h).roomy) continue;  // words lie over the picture
    const std::string pictureSize = " --size " + std::to_string(at.width) + "x" + std::to_string(at.height);
    EXPECT_EQ(cropped(taken, at), pictureOf("snapshot " + line + pictureSize, server.name()));
  }
}

}  // namespace xnewell::THIS_FILE
