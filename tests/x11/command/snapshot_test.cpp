#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <set>

#include "x11/window/panel.h"

#include "tests/support/seeds.h"
#include "tests/x11/support/program_picture.h"
#include "tests/x11/support/watched_window.h"
#include "tests/x11/support/x_server.h"

namespace xnewell::THIS_FILE {

namespace {

/// The three tables, hues, orders, projections, sizes up to more than the screen (640 x 480), and scenes.
constexpr std::array kPictures{
    "teapot --divisions 8",
    "teapot --divisions 4 --table brief --hue 1,1,1 --order zmean --parallel 6",
    "teapot --divisions 4 --table corrected --hue 0.3,0.5,1 --order none",
    "teapot --divisions 3 --table corrected --i0 0.001 --shades 64 --pick search --size 1023x777",
    "teapot --divisions 3 --table corrected --bits 8 --hue 0,1,0 --size 333x250 --cull back",
    "teapot --divisions 3 --table brief --shades 2 --size 1x1",
    "teapot --divisions 3 --size 1300x900 --fov 12 --ia 0 --ip 1 --ks 1 --n 200",
    "teapot --divisions 5 --oblique cabinet:30 --size 401x203 --shade none",
    "teapot --divisions 5 --oblique cavalier --size 64x300 --order zmean --table linear --hue 1,0.7,0",
    "cycle --table corrected --size 255x257",
    "penetrate --table brief --parallel 5 --size 100x700",
    "nested-cycles --size 301x299",
};

}  // namespace

// A picture is the same to the last bit whether it is drawn without a server, through the real colormap of an
// 8-bit server, or emulated at depth 24. What the server fills is the same on both servers.
TEST(Snapshot, EqualsDrawOnEveryKindOfServer) {
  const XServer eight = XServer::xvfb(8), deep = XServer::xvfb(24);
  for (const std::string line : someOf(kPictures, 3)) {
    SCOPED_TRACE(line);
    const RgbImage drawn = pictureOf("draw " + line);
    EXPECT_EQ(pictureOf("snapshot --visual PseudoColor8 " + line, eight.name()), drawn);
    EXPECT_EQ(pictureOf("snapshot --visual TrueColor24 " + line, deep.name()), drawn);
    const RgbImage filled = pictureOf("snapshot --fill x11 " + line, eight.name());
    EXPECT_EQ(pictureOf("snapshot --fill x11 " + line, deep.name()), filled);
    EXPECT_EQ(filled.width, drawn.width);
    if (drawn.width < 100) continue;
    // The server does paint. It snaps corners to pixels, so only outlines may differ.
    int differ = 0, painted = 0;
    for (std::size_t i = 0; i < drawn.rgb.size(); i += 3) {
      differ += !std::equal(&drawn.rgb[i], &drawn.rgb[i] + 3, &filled.rgb[i]);
      painted += !std::equal(&drawn.rgb[i], &drawn.rgb[i] + 3, &drawn.rgb[0]);
    }
    EXPECT_GT(painted, 1000);
    EXPECT_LT(differ, painted / 2);
  }
}

// A view of the numbers behind a picture is the same too, with the tool's own colours in cells where each
// server has them.
TEST(Snapshot, ViewsEqualDrawnOnesOnEveryKindOfServer) {
  const XServer eight = XServer::xvfb(8), deep = XServer::xvfb(24);
  const XServer host = XServer::xvfb(24, 1400, 1000);
  const XServer nested = XServer::xephyr(host, 8, 320, 240);
  for (const std::string line :
       {"teapot --divisions 3 --shade gouraud --view machbands --scanline 100 --table brief",
        "penetrate --view normals --shade phong --size 640x400", "cycle --view difference --order none"}) {
    SCOPED_TRACE(line);
    const RgbImage drawn = pictureOf("draw " + line);
    EXPECT_GT(drawn.width, 600);
    EXPECT_EQ(pictureOf("snapshot --visual PseudoColor8 " + line, eight.name()), drawn);
    EXPECT_EQ(pictureOf("snapshot --visual TrueColor24 " + line, deep.name()), drawn);
    EXPECT_EQ(pictureOf("snapshot " + line, nested.name()), drawn);
  }
}

// The picture is the same in a nested server, whose black is cell 1 and white cell 0: the program puts black
// and white where the server has them.
TEST(Snapshot, EqualsDrawWhereBlackIsOneAndWhiteZero) {
  const XServer host = XServer::xvfb(24, 1400, 1000);
  const XServer nested = XServer::xephyr(host, 8, 320, 240);
  {
    const OwnedDisplay display = openDisplay(nested.name());
    ASSERT_EQ(BlackPixel(display.get(), 0), 1u);
    ASSERT_EQ(WhitePixel(display.get(), 0), 0u);
  }
  for (const std::string line : {kPictures[1], kPictures[2], kPictures[3], kPictures[9]}) {
    SCOPED_TRACE(line);
    EXPECT_EQ(pictureOf("snapshot " + line, nested.name()), pictureOf("draw " + line));
  }
}

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

// A place that the view does not have is refused in one line, and no picture is written: a window would move
// it without a word.
TEST(Snapshot, RefusesOtherPlaces) {
  const XServer server = XServer::xvfb(24);
  const TemporaryFolder folder;
  const std::string file = folder.file("picture.png");
  for (const auto& [place, why] :
       {std::pair{"pixel --pixel 900,900", "pixel 900,900 lies outside the picture of 654x436"},
        {"viewing --step 9", "--step 9 is not in --view viewing: the nearest is 7"},
        {"viewing --viewing 99999", "--viewing: the scene has no vertex 99999: it has "},
        {"scanline --scanline 99999", "--scanline: the picture of teapot has no face 99999"},
        {"scanline --step 99999", "--step 99999 is not in --view scanline: the nearest is "}}) {
    SCOPED_TRACE(place);
    std::vector<std::string> line =
        words("snapshot teapot --divisions 3 --whole-window --size 1024x768 --view " + std::string{place});
    line.insert(line.end(), {"-o", file});
    const Finished done = runProgram(line, server.name());
    EXPECT_EQ(done.status, 2);
    EXPECT_TRUE(done.err.starts_with("xnewell: " + std::string{why})) << done.err;
    EXPECT_EQ(std::ranges::count(done.err, '\n'), 1) << done.err;
    EXPECT_FALSE(std::filesystem::exists(file));
  }
}

// A trade has no server, so it computes what a first picture sends. A snapshot measures the same: on an 8-bit
// server without shared memory, with a colormap of its own.
TEST(Snapshot, SendsWhatATradeComputes) {
  const XServer server = XServer::xvfb(8, 1024, 768, {"-extension", "MIT-SHM"});
  for (const char* line :
       someOf({"cycle --size 800x600", "teapot --size 162x120", "teapot --size 162x120 --shades 8"}, 1)) {
    SCOPED_TRACE(line);
    const TemporaryFolder folder;
    const auto told = [&](const std::string& command, const std::vector<std::string>& more) {
      std::vector<std::string> all = words(command + ' ' + line);
      all.insert(all.end(), more.begin(), more.end());
      const Finished done = runProgram(all, server.name());
      EXPECT_EQ(done.status, 0) << done.err;
      return nlohmann::json::parse(done.out);
    };
    const auto sent = told("snapshot", {"--stats", "-o", folder.file("picture.png")}).at("sent");
    const auto computed =
        told("trade", {"--json", "--axes", "bits", "--budget", "1"}).at("as_it_is").at("x_server");
    EXPECT_EQ(computed.at("requests"), sent.at("requests"));
    EXPECT_EQ(computed.at("bytes"), sent.at("bytes"));
  }
}

// --stats of a snapshot has what the server got. The pixels are among the bytes if they go through the
// connection, and not if they go through shared memory. A server that fills polygons gets more requests.
TEST(Snapshot, SaysWhatItSent) {
  struct Case {
    int depth;
    std::vector<std::string> server;
    std::int64_t bytesPerPixel;
    bool shared;
  };
  for (const Case& c : {Case{24, {}, 4, true}, Case{24, {"-extension", "MIT-SHM"}, 4, false},
                        Case{8, {}, 1, true}, Case{8, {"-extension", "MIT-SHM"}, 1, false}}) {
    const XServer server = XServer::xvfb(c.depth, 640, 480, c.server);
    const auto sent = [&](const std::string& more) {
      const TemporaryFolder folder;
      std::vector<std::string> line = words("snapshot teapot --divisions 3 --size 162x120 --stats" + more);
      line.insert(line.end(), {"-o", folder.file("picture.png")});
      const Finished done = runProgram(line, server.name());
      EXPECT_EQ(done.status, 0) << done.err;
      return nlohmann::json::parse(done.out).at("sent");
    };
    const nlohmann::json painted = sent(""), filled = sent(" --fill x11");
    SCOPED_TRACE(painted.dump() + filled.dump());
    const std::int64_t row = (162 * c.bytesPerPixel + 3) / 4 * 4;  // padded to 32 bits
    for (const nlohmann::json& s : {painted, filled}) {
      ASSERT_EQ(s.at("image_bytes"), 120 * row);
      ASSERT_EQ(s.at("bits_per_pixel"), 8 * c.bytesPerPixel);
      ASSERT_EQ(s.at("shared_memory"), c.shared);
      const auto bytes = s.at("bytes").get<std::int64_t>(), requests = s.at("requests").get<std::int64_t>();
      ASSERT_GE(bytes, 4 * requests);  // no request is shorter
      ASSERT_GT(requests, 0);
    }
    const auto bytes = painted.at("bytes").get<std::int64_t>();
    const std::int64_t pixels = c.shared ? 0 : 120 * row;
    EXPECT_GE(bytes, pixels);
    EXPECT_LT(bytes, pixels + 8'192);  // 256 colours of 12 bytes, and a few requests
    EXPECT_GT(filled.at("requests").get<int>(), painted.at("requests").get<int>() + 100);
  }
}

}  // namespace xnewell::THIS_FILE
