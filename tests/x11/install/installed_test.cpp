#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/x11/support/command_fixture.h"

namespace xnewell::THIS_FILE {

// The library that `cmake --install` puts into a folder. All else that it puts there: installed.txt and
// manual.txt, which are stories.

namespace {

/// Runs a command of the shell, without a display.
Finished shell(const std::string& command) { return RunningProgram{"bash", {"-c", command}, ""}.wait(); }

std::string quoted(const std::string& path) { return "'" + path + "'"; }

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

using InstalledExample = CommandTest;

}  // namespace

// The example is built against the installed package with CMake. It finds an order of painting that shows, at
// every sample, the face that `xnewell draw` finds without any order, and it draws the same picture.
TEST_F(InstalledExample, PaintsWhatTheProgramShows) {
  const auto does = [](const std::string& command) {
    const Finished done = shell(command);
    EXPECT_EQ(done.status, 0) << command << '\n' << done.err;
    return done.out;
  };
  const std::string usr = quoted(file("a place")), built = quoted(file("example")),
                    painter = built + "/painted ",
                    model = XNEWELL_DATA_DIR "/../tests/x11/install/crossing.obj";
  does(XNEWELL_CMAKE " --install '" XNEWELL_BUILD "' --prefix " + usr);
  does(XNEWELL_CMAKE " -G Ninja -S '" XNEWELL_DATA_DIR "/../x11/example' -B " + built +
       " -DCMAKE_PREFIX_PATH=" + usr +
       " -DCMAKE_CXX_COMPILER='" XNEWELL_CXX "' -DCMAKE_CXX_FLAGS='" XNEWELL_CXX_FLAGS "'");
  does(XNEWELL_CMAKE " --build " + built);
  const std::string order = does(painter + quoted(model) + ' ' + quoted(file("a.png")));
  const RgbImage faces = draw(model, {"--size", "400x300", "--order", "oracle"}).ids;
  (void)draw(model, {"--size", "400x300"});
  EXPECT_EQ(contents(file("a.png")), contents(file("out.png")));
  const std::vector<int> shown = painted(order, 400, 300);
  int wrong = 0, seen = 0;
  for (std::size_t k = 0; k < shown.size(); ++k) {
    const int right = idAt(faces, static_cast<int>(k) % 400, static_cast<int>(k) / 400);
    wrong += shown[k] != right;
    seen += right != 0;
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(seen, 20'000);
  EXPECT_GT(std::ranges::count(order, '\n'), 7) << "two crossings, and two parts of the dented face";

  const Finished refused = shell(painter + "/nowhere.obj a.png");
  EXPECT_EQ(refused.status, 1);
  EXPECT_EQ(refused.err, "painted: /nowhere.obj: No such file or directory\n");
}

}  // namespace xnewell::THIS_FILE
