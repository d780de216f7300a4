#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <sstream>

#include "shading/color/png.h"
#include "tests/x11/install/installed.h"

namespace xnewell::THIS_FILE {

namespace {

/// Two plates through each other, and three bars of which each is over the next one. The last is a
/// hexagon with a dent behind all of them.
constexpr const char* kCrossing = R"(v -2 -1 0.3000
v 0.1000 -1 -0.7000
v 0.1000 1 -0.7000
v -2 1 0.3000
v -2 -0.8000 -0.7000
v 0.1000 -0.9000 0.3000
v 0.1000 0.8000 0.3000
v -2 0.9000 -0.7000
f 1 2 3 4
f 5 6 7 8
v 0.5000 -1 0.4000
v 0.9000 -1 0.4000
v 2.5000 1 -0.4000
v 2.1000 1 -0.4000
f 9 10 11 12
v 2.4000 -0.9000 0.4000
v 2.8000 -0.9000 0.4000
v 0.9000 1.1000 -0.5000
v 0.5000 1.1000 -0.4000
f 13 14 15 16
v 3 0.5000 0.4500
v 3 0.9000 0.4000
v 0.3000 0.1000 -0.4000
v 0.3000 -0.3000 -0.3500
f 17 18 19 20
v -3 -2 -2
v 3.5000 -2 -2
v 0.3000 -0.1000 -2
v 3.5000 2 -2
v -3 2 -2
f 21 22 23 24 25
)";

/// Paints the pieces over each other: at each centre of a pixel, the last one whose outline is around it.
/// Returns face number + 1, 0 where there is none.
std::vector<int> painted(const std::string& lines, int width, int height) {
  std::vector<int> shown(static_cast<std::size_t>(width) * height, 0);
  std::istringstream in{lines};
  for (std::string line; std::getline(in, line);) {
    const auto piece = nlohmann::json::parse(line);
    const auto corners = piece.at("piece").get<std::vector<std::array<double, 2>>>();
    for (int j = 0; j < height; ++j)
      for (int i = 0; i < width; ++i) {
        const double x = i + 0.5, y = j + 0.5;
        bool left = true, right = true;
        for (std::size_t k = 0; k < corners.size(); ++k) {
          const auto &a = corners[k], &b = corners[(k + 1) % corners.size()];
          const double side = (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
          left = left && side >= 0;
          right = right && side <= 0;
        }
        if (left || right) shown[static_cast<std::size_t>(j) * width + i] = piece.at("face").get<int>() + 1;
      }
  }
  return shown;
}

}  // namespace

class ExampleTest : public InstalledTest {
 protected:
  static std::string quoted(const std::filesystem::path& path) { return "'" + path.string() + "'"; }
  static std::string source() { return XNEWELL_DATA_DIR "/../x11/example"; }
};

// The example is built against the installed package with CMake. It finds an order of painting that shows, at
// every sample, the face that `xnewell draw` finds without any order, and it draws the same picture.
TEST_F(ExampleTest, PaintsWhatTheProgramShows) {
  const Finished configured =
      inFolder("/", XNEWELL_CMAKE " -G Ninja -S '" + source() + "' -B " + quoted(file("example")) +
                        " -DCMAKE_PREFIX_PATH=" + quoted(installed("")) +
                        " -DCMAKE_CXX_COMPILER='" XNEWELL_CXX "' -DCMAKE_CXX_FLAGS='" XNEWELL_CXX_FLAGS "'");
  ASSERT_EQ(configured.status, 0) << configured.err;
  const Finished built = inFolder("/", XNEWELL_CMAKE " --build " + quoted(file("example")));
  ASSERT_EQ(built.status, 0) << built.out;

  const std::string program = quoted(file("example/painted")) + ' ';
  const std::filesystem::path model = file("crossing.obj"), a = file("a.png"), b = file("b.png"),
                              ids = file("ids.png");
  std::ofstream{model} << kCrossing;
  const Finished order = inFolder("/", program + quoted(model) + ' ' + quoted(a));
  ASSERT_EQ(order.status, 0) << order.err;
  ASSERT_EQ(run("draw " + quoted(model) + " --size 400x300 --bare -o " + quoted(b)).status, 0);
  EXPECT_EQ(textOfFile(a), textOfFile(b));

  ASSERT_EQ(run("draw " + quoted(model) + " --size 400x300 --order oracle -o " + quoted(b) + " --ids " +
                quoted(ids))
                .status,
            0);
  const RgbImage faces = readPng(ids.string());
  const std::vector<int> shown = painted(order.out, 400, 300);
  int wrong = 0, seen = 0;
  for (std::size_t k = 0; k < shown.size(); ++k) {
    const int right = faces.rgb[3 * k] * 65536 + faces.rgb[3 * k + 1] * 256 + faces.rgb[3 * k + 2];
    wrong += shown[k] != right;
    seen += right != 0;
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(seen, 20'000);
  EXPECT_GT(std::ranges::count(order.out, '\n'), 7) << "two crossings, and two parts of the dented face";

  const Finished refused = inFolder("/", program + "/nowhere.obj " + quoted(a));
  EXPECT_EQ(refused.status, 1);
  EXPECT_EQ(refused.err, "painted: /nowhere.obj: No such file or directory\n");
}

// pkg-config gives what a compiler needs.
TEST_F(ExampleTest, BuildsWithPkgConfig) {
  std::string folder;
  for (const auto& entry : std::filesystem::recursive_directory_iterator{installed("")})
    if (entry.path().filename() == "xnewell.pc") folder = entry.path().parent_path().string();
  ASSERT_NE(folder, "");
  if (inFolder("/", "command -v pkg-config").status != 0) GTEST_SKIP() << "pkg-config is not installed";
  // pkg-config writes blanks in paths as "\ ".
  const Finished done = inFolder("/", "export PKG_CONFIG_PATH='" + folder +
                                          "' && eval \"'" XNEWELL_CXX "' " XNEWELL_CXX_FLAGS " -std=c++20 '" +
                                          source() + "/painted.cpp' -o " + quoted(file("painted")) +
                                          " $(pkg-config --cflags --libs xnewell)\"");
  ASSERT_EQ(done.status, 0) << done.err;
  EXPECT_EQ(inFolder("/", quoted(file("painted"))).status, 2);
}

}  // namespace xnewell::THIS_FILE
