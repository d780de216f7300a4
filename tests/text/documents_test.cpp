#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "depthsort/depth_sort.h"
#include "depthsort/oracle.h"
#include "depthsort/order.h"
#include "shading/color/png.h"
#include "shading/picture/picture_cache.h"
#include "shading/scene/settings.h"
#include "tests/support/painted.h"
#include "tests/support/seeds.h"
#include "tests/support/temporary_folder.h"
#include "tests/x11/support/program.h"
#include "x11/views/difference.h"
#include "x11/views/plot.h"

namespace xnewell::THIS_FILE {

// What the documents say of the program: figures, each computed again, and the table of rooms. Plain words:
// plain.sh. Where a figure has changed, the message has the words as they should be.

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

std::string onOneLine(const std::string& text) { return std::regex_replace(text, std::regex{R"(\s+)"}, " "); }

/// The words with each {} replaced by the next of these.
std::string filled(std::string_view words, const std::vector<std::string>& by) {
  std::string text;
  std::size_t k = 0;
  for (std::size_t at; (at = words.find("{}")) != std::string_view::npos; words.remove_prefix(at + 2))
    text += std::string{words.substr(0, at)} + by.at(k++);
  EXPECT_EQ(k, by.size()) << "a number without a {}";
  return text + std::string{words};
}

/// The text of a file, by its path in the project.
std::string documentOf(const std::string& path) {
  std::ifstream in{fs::path{XNEWELL_DATA_DIR}.parent_path() / path};
  EXPECT_TRUE(in) << path;
  return {std::istreambuf_iterator<char>{in}, {}};
}

/// The lines below a heading, up to the next one.
std::vector<std::string> linesOf(const std::string& document, std::string_view heading) {
  std::vector<std::string> lines;
  bool below = false;
  std::istringstream in{document};
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with('#')) below = line == heading;
    if (below && line != heading) lines.push_back(line);
  }
  EXPECT_FALSE(lines.empty()) << heading;
  return lines;
}

/// The cells of a line of a table, without the blanks around them; none if it is no such line.
std::vector<std::string> cellsOf(const std::string& line) {
  std::vector<std::string> cells;
  if (!line.starts_with('|')) return cells;
  std::istringstream in{line.substr(1)};
  for (std::string cell; std::getline(in, cell, '|');) {
    const std::size_t first = cell.find_first_not_of(' '), last = cell.find_last_not_of(' ');
    cells.push_back(first == std::string::npos ? "" : cell.substr(first, last - first + 1));
  }
  return cells;
}

/// Checks that a document has these words, with the numbers in place of each {}. It may break its lines
/// anywhere. If its numbers are others, the message has the right words, ready to be copied.
testing::AssertionResult says(const std::string& path, std::string_view words,
                              const std::vector<std::string>& numbers) {
  const std::string text = onOneLine(documentOf(path)), right = filled(words, numbers);
  std::string pattern = std::regex_replace(std::string{words}, std::regex{R"([.*+?^$|()\[\]\\])"}, R"(\$&)");
  pattern = std::regex_replace(pattern, std::regex{R"(\{\})"}, "[-0-9.,]*[0-9]");
  const std::regex wanted{pattern};
  int found = 0;
  for (std::sregex_iterator at{text.begin(), text.end(), wanted}, end; at != end; ++at, ++found)
    if (at->str() != right)
      return testing::AssertionFailure() << path << " says\n  " << at->str() << "\nbut it is\n  " << right;
  if (found == 1) return testing::AssertionSuccess();
  return testing::AssertionFailure() << path << " has these words " << found << " times, not once:\n  "
                                     << right;
}

/// "12,703", and "0.0567" with four decimals.
std::string number(long long value) {
  std::string text = std::to_string(value);
  for (int at = static_cast<int>(text.size()) - 3; at > 0; at -= 3) text.insert(at, ",");
  return text;
}

std::string number(double value, int decimals) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  return text.data();
}

/// ---- Figures.

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

/// ---- Rooms.

using Names = std::set<std::string>;
using Rooms = std::map<std::string, Names>;  ///< a room, "shading/color", and the rooms that it names as used

std::vector<std::string> matches(const std::string& text, const std::string& pattern) {
  const std::regex wanted{pattern};
  std::vector<std::string> found;
  for (std::sregex_iterator at{text.begin(), text.end(), wanted}, end; at != end; ++at)
    found.push_back(at->str());
  return found;
}

/// The rooms as the CMakeLists.txt of the floors have them.
Rooms built() {
  Rooms rooms;
  for (const std::string floor : {"geometry", "depthsort", "shading", "x11"}) {
    const std::string text = documentOf(floor + "/CMakeLists.txt");
    const std::regex room{R"(\nroom\((\w+)\s+(?:USES ([\w\s]*?))?\s*FILES)"};
    for (std::sregex_iterator at{text.begin(), text.end(), room}, end; at != end; ++at) {
      Names& uses = rooms[floor + '/' + at->str(1)];
      for (std::string name : matches(at->str(2), R"(\w+)")) {
        std::replace(name.begin(), name.end(), '_', '/');
        uses.insert(name);
      }
    }
  }
  for (std::string name : matches(documentOf("depthsort/CMakeLists.txt"), R"(geometry_\w+)")) {
    std::replace(name.begin(), name.end(), '_', '/');
    rooms["depthsort"].insert(name);
  }
  return rooms;
}

/// The rooms as the table of the README has them. A name without a floor is on the floor of the row's first
/// name. Libraries of others, such as GLM, are in capitals.
Rooms told() {
  Rooms rooms;
  for (std::string line : linesOf(documentOf("README.md"), "## The rooms")) {
    line = std::regex_replace(line, std::regex{R"(\*\*\[(\w+)\]\([^)]*\)\*\*)"}, "$1");
    const std::vector<std::string> cells = cellsOf(line);
    if (cells.size() != 3 || cells[0] == "room" || cells[0] == "---") continue;
    const std::string floor = matches(cells[0], R"(\w+)").front();
    const auto full = [&](const std::string& name) {
      return name.find('/') != std::string::npos || name == "depthsort" ? name : floor + '/' + name;
    };
    Names uses;
    for (const std::string& name : matches(cells[2], R"([a-z][\w/]*)")) uses.insert(full(name));
    for (const std::string& name : matches(cells[0], R"([a-z][\w/]*)")) rooms[full(name)] = uses;
  }
  return rooms;
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

// The README's table of rooms says what the build does.
TEST(Rooms, UseWhatTheReadmeSays) {
  const Rooms actual = built(), stated = told();
  EXPECT_GT(actual.size(), 20u);
  for (const auto& [room, uses] : actual) {
    ASSERT_TRUE(stated.contains(room)) << room << " is missing";
    EXPECT_EQ(stated.at(room), uses) << room;
  }
  EXPECT_EQ(stated.size(), actual.size());
}

}  // namespace xnewell::THIS_FILE
