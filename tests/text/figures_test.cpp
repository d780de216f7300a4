#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "depthsort/depth_sort.h"
#include "depthsort/oracle.h"
#include "depthsort/order.h"
#include "shading/color/png.h"
#include "shading/picture/picture_cache.h"
#include "shading/scene/scene_file.h"
#include "shading/scene/settings.h"
#include "tests/support/painted.h"
#include "tests/support/seeds.h"
#include "tests/support/temporary_folder.h"
#include "tests/text/document.h"
#include "tests/x11/support/program.h"
#include "x11/views/difference.h"
#include "x11/views/table_curves.h"

namespace xnewell::THIS_FILE {

// Figures that documents state about the program, each computed again. Where one has changed, the message has
// the words as they should be.

namespace {

using Json = nlohmann::json;

constexpr const char* kExercises = "x11/EXERCISES.md";

/// The last line that a command prints, as JSON.
Json lastLine(const std::string& command) {
  std::istringstream in{command};
  std::vector<std::string> arguments;
  for (std::string word; in >> word;) arguments.push_back(word);
  const Finished done = runProgram(arguments);
  EXPECT_EQ(done.status, 0) << command << '\n' << done.err;
  std::string last;
  std::istringstream lines{done.out};
  for (std::string line; std::getline(lines, line);) last = line;
  return Json::parse(last, nullptr, false);
}

PictureSettings settingsOf(const Scene& scene, int width, int height) {
  PictureSettings settings = scene.settings;
  settings.width = width, settings.height = height;
  settings.camera = completed({}, scene.camera);
  return settings;
}

/// The settings of the picture in `--view difference --size 1024x768`.
PictureSettings onThePage(const Scene& scene) {
  return pictureForDifference({.view = View::Difference, .picture = settingsOf(scene, 1024, 768)});
}

/// What the page calls "wrong face", counted in another way: each face is painted whole, in this order, and
/// compared with the nearest face at each sample.
int wrongFaces(const Picture& picture, const std::vector<int>& order) {
  const SnappedScene& scene = picture.snapped();
  const int width = picture.settings().width, height = picture.settings().height;
  SortedScene sorted;
  for (const int face : order) sorted.fragments.push_back(Fragment{face});
  const std::vector<int> shown = painted(scene, sorted, width, height),
                         right = visibleFaces(scene, width, height);
  int wrong = 0;
  for (int k = 0; k < std::ssize(shown); ++k)
    wrong += shown[k] != right[k] && !mayTouch(scene, shown[k], right[k], k, width);
  return wrong;
}

/// Exercise 9 asks for this order.
std::vector<int> byNearest(const SnappedScene& scene) {
  std::vector<int> order(scene.faces.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](int f) {
    const auto* const first = &scene.vertices[scene.faces[f].first];
    return std::max_element(first, first + scene.faces[f].count, [](auto& a, auto& b) { return a.z < b.z; })
        ->z;
  });
  return order;
}

Picture exact(const std::string& name) {
  const Scene scene = readScene(name, 8);
  PictureSettings settings = onThePage(scene);
  settings.order = Order::Oracle;
  return makePicture(scene, settings);
}

}  // namespace

// The linear table's cell i holds i - 10 of 255 in red.
TEST(Exercises, TwoCardsByHand) {
  const TemporaryFolder folder;
  const auto cells = [&](const std::string& options) {
    (void)lastLine("draw turned-cards --stats --size 400x300 -o " + folder.file("cards.png") + " --ids " +
                   folder.file("ids.png") + options);
    const RgbImage picture = readPng(folder.file("cards.png")), ids = readPng(folder.file("ids.png"));
    std::map<int, int> cellOf;  // by the number of the face
    for (std::size_t k = 0; k < ids.rgb.size(); k += 3)
      if (ids.rgb[k + 2] > 0) cellOf[ids.rgb[k + 2]] = picture.rgb[k] + 10;
    EXPECT_EQ(cellOf.size(), 2u);
    return cellOf;
  };
  std::map<int, int> first = cells(""), second = cells(" --ia 0.2 --ip 0.6");
  EXPECT_TRUE(says(kExercises, "has cells {} and {}, then {} and {}.",
                   {number(first[1]), number(first[2]), number(second[1]), number(second[2])}));
}

TEST(Exercises, EqualSteps) {
  const auto needed = [](double I0) {
    return 1 + static_cast<int>(std::ceil(std::log(1 / I0) / std::log(1.01)));
  };
  EXPECT_TRUE(says(kExercises, "finds {} shades. For I0 = 0.02 it finds {}; a table has at most {}.",
                   {number(needed(0.1)), number(needed(0.02)), number(kMaxShades)}));
  const auto r = [](int shades) {
    return number(ratioOf(ColorTable{{.kind = TableKind::Corrected, .shades = shades, .I0 = 0.1}}), 8);
  };
  EXPECT_TRUE(says(kExercises, "says r = {} with 233 shades and r = {} with 232.", {r(233), r(232)}));
}

// The scene stands in the document.
TEST(Exercises, TheLostHighlight) {
  const std::string document = documentOf(kExercises), path = std::string{XNEWELL_DATA_DIR} + "/square.bpt";
  const std::size_t begin = document.find("```json\n") + 8;
  std::string text = document.substr(begin, document.find("```", begin) - begin);
  const std::string relative = "../data/square.bpt";
  ASSERT_NE(text.find(relative), std::string::npos);
  text.replace(text.find(relative), relative.size(), path);
  const TemporaryFolder folder;
  std::ofstream{folder.file("square.json")} << text;
  const auto largest = [&](int N) {
    const Scene scene = readScene(folder.file("square.json"), N);
    const Picture picture = makePicture(scene, onThePage(scene), 0);
    return comparedWithReference(picture, GroundTruth{picture}).difference.errors.largest;
  };
  std::vector<std::string> errors;
  for (const int N : {1, 2, 4, 8, 16, 32, 64}) errors.push_back(number(largest(N), 4));
  EXPECT_TRUE(says(
      kExercises,
      "The largest errors for N = 1, 2, 4, 8, 16, 32, 64 are {}, {}, {}, {}, {}, {}, {}. From 8 on", errors));
  int least = 8;
  while (largest(least) > 4.0 / 240) ++least;
  EXPECT_TRUE(says(kExercises, "finds N = {}.", {number(least)}));
}

// The runs are those of `trace` and `trace --quick`, without a line for each pair.
TEST(Exercises, HowTheWorkGrows) {
  for (const int divisions : {2, 4, 8}) {
    const Scene scene = readScene("teapot", divisions);
    const Picture picture = makePicture(scene, settingsOf(scene, 800, 600)).withPlanes();
    const auto run = [&](bool textbook) {
      return depthSort(picture.snapped(),
                       {.width = 800, .height = 600, .textbook = textbook, .areas = false});
    };
    const SortedScene textbook = run(true), quick = run(false);
    EXPECT_TRUE(says(kExercises, "| " + std::to_string(divisions) + " | {} | {} | {} |",
                     {number(std::ssize(textbook.fragments)), number(textbook.statistics.pairs()),
                      number(quick.statistics.pairs())}));
  }
}

TEST(Exercises, APaintingOrder) {
  for (const std::string name : {"teapot", "room"}) {
    const Picture picture = exact(name);
    const auto wrong = [&](Order order) {
      return number(wrongFaces(picture, paintingOrder(picture.snapped(), order)));
    };
    EXPECT_TRUE(says(kExercises, "| " + name + " | {} | {} | {} |",
                     {wrong(Order::ZSort), wrong(Order::ZMean),
                      number(wrongFaces(picture, byNearest(picture.snapped())))}));
  }
}

// The broken line would show the first of the faces in a plane, not the last: wherever there are several.
TEST(Exercises, BreakIt) {
  const Picture picture = exact("decals");
  const int width = picture.settings().width, height = picture.settings().height;
  const SnappedScene& scene = picture.snapped();
  const std::vector<int> right = visibleFaces(scene, width, height);
  std::vector<char> several(right.size(), 0);
  forEachSample(scene, width, height, [&](int k, int face) {
    several[k] |= face != right[k] && scene.faces[face].plane == scene.faces[right[k]].plane;
  });
  EXPECT_TRUE(says(kExercises, "vanish behind the wall ({} samples show another face)",
                   {number(std::ranges::count(several, 1))}));
}

TEST(DepthSortReadme, CountsTheSamplesOfTwoCards) {
  const Picture picture = exact("two-cards");
  const std::vector<int> right =
      visibleFaces(picture.snapped(), picture.settings().width, picture.settings().height);
  const auto samples = std::ranges::count_if(right, [](int face) { return face != kNothing; });
  EXPECT_TRUE(
      says("depthsort/README.md", "Here {} of {} samples show the wrong card.",
           {number(wrongFaces(picture, paintingOrder(picture.snapped(), Order::ZSort))), number(samples)}));
}

TEST(ShadingReadme, HasTheErrorsOfPhong) {
  const TemporaryFolder folder;
  for (const std::string scene : someOf({"spotlight", "highlight", "lamp", "teapot"}, 1)) {
    std::vector<std::string> errors;
    for (const std::string options : {"", " --constant-l --constant-v"}) {
      const Json stats =
          lastLine("draw " + scene + " --shade phong --errors -o " + folder.file("x.png") + options);
      const Json& intensity = stats["errors"]["intensity"]["before_table"];
      errors.push_back(number(intensity["rms"].get<double>(), 3));
      errors.push_back(number(intensity["largest"].get<double>(), 3));
    }
    EXPECT_TRUE(says("shading/README.md", "| `" + scene + "` | {} / {} | {} / {} |", errors));
  }
}

// The example of a scene file is one.
TEST(ScenesPage, ShowsAScene) {
  const std::string page = documentOf("data/SCENES.md");
  const std::size_t begin = page.find("```json\n") + 8, end = page.find("```", begin);
  ASSERT_LT(begin, end);
  const Scene scene = parseSceneFile(page.substr(begin, end - begin), "SCENES.md", "");
  EXPECT_EQ(scene.mesh.faceCount(), 7);
}

// From the default order, so many presses lead to the sort by farthest z.
TEST(Readme, LeadsToTheSortByFarthestZ) {
  const auto n = static_cast<int>(kOrders.size());
  const int presses = (static_cast<int>(Order::ZSort) - static_cast<int>(PictureSettings{}.order) + n) % n;
  EXPECT_EQ(rowOf(Order::ZSort).label, "z far");
  EXPECT_TRUE(says("README.md", "At `z far` (click it, or press `O` {} times)", {number(presses)}));
}

}  // namespace xnewell::THIS_FILE
