#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <fstream>
#include <random>
#include <set>

#include "tests/support/seeds.h"
#include "tests/x11/support/watched_viewer.h"

#include "x11/window/panel.h"

namespace xnewell::THIS_FILE {

// Pictures that a server fills, and what is sent. That snapshots are the files that `draw` writes:
// tests/stories/snapshots.txt.

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
// status line differs: it tells the visual and the time. The picture in it is that of a plain snapshot.
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
    if (!at.roomy) continue;  // words lie over the picture
    const std::string plain =
        " --size " + std::to_string(at.picture.width) + "x" + std::to_string(at.picture.height);
    EXPECT_EQ(cropped(one, at.picture),
              pictureOf("snapshot teapot --divisions 4 --table corrected" + plain, eight.name()));
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

}  // namespace xnewell::THIS_FILE
