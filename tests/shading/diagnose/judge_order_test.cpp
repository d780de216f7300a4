#include "shading/diagnose/judge_order.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <string>

#include "depthsort/order.h"
#include "geometry/files/parse_error.h"
#include "shading/diagnose/pair_scene.h"
#include "shading/laboratory/exactness.h"
#include "shading/picture/picture_cache.h"
#include "shading/scene/scene_file.h"
#include "tests/support/seeds.h"
#include "tests/support/temporary_folder.h"

namespace xnewell::THIS_FILE {

namespace {

Picture pictureOf(const Scene& scene, int width = 160, int height = 120) {
  PictureSettings s = scene.settings;
  s.camera = scene.camera, s.order = Order::Unsorted, s.shading = Shading::Full;
  s.width = width, s.height = height;
  return makePicture(scene, s, std::uint8_t{0}).withPlanes();
}

std::vector<PaintStep> stepsOf(const std::vector<int>& faces) {
  std::vector<PaintStep> steps;
  for (std::size_t k = 0; k < faces.size(); ++k) steps.push_back({faces[k], {}, static_cast<int>(k) + 1});
  return steps;
}

/// The distance from the eye to the plane of a polygon, along the ray of the sample of pixel (i, j). It
/// starts from the camera's numbers and shares nothing with the sort.
double depthAlongRay(const Picture& picture, const std::vector<glm::dvec3>& polygon, int i, int j) {
  const ViewSpec& view = picture.camera().view;
  const PictureSettings& s = picture.settings();
  const glm::dvec3 n = glm::normalize(view.vpn), u = glm::normalize(glm::cross(view.vup, n)),
                   v = glm::cross(n, u);
  const glm::dvec2 size = view.windowMax - view.windowMin;
  const double x = view.windowMin.x + size.x * (i + 0.5) / s.width,
               y = view.windowMax.y - size.y * (j + 0.5) / s.height;
  const glm::dvec3 eye = view.vrp + view.prp.x * u + view.prp.y * v + view.prp.z * n;
  const glm::dvec3 through = view.vrp + x * u + y * v;
  const double unit = std::ldexp(1.0, picture.scene().exponent);
  const glm::dvec3 a = polygon[0] / unit, N = glm::cross(polygon[1] - polygon[0], polygon[2] - polygon[0]);
  return glm::dot(a - eye, N) / glm::dot(through - eye, N);
}

}  // namespace

// The faces in the order of an exact sort without cuts are right, and so is any order of faces that the
// picture shows right.
TEST(JudgeOrder, FindsRightOrdersRight) {
  for (const std::string name : someOf({"room", "three-cards", "shingles", "decals", "makie-4693"}, 2)) {
    const Scene scene = readScene(name);
    const Picture unsorted = pictureOf(scene);
    PictureSettings s = unsorted.settings();
    s.order = Order::Newell;
    PictureSettings said = scene.settings;
    said.camera = scene.camera, said.order = Order::Newell, said.width = s.width, said.height = s.height;
    const Picture sorted = makePicture(scene, said);
    std::vector<int> faces;
    for (const Fragment& f : sorted.sorted().fragments) {
      ASSERT_LT(f.piece, 0) << name;
      faces.push_back(sorted.snapped().faces[f.face].number);
    }
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    const OrderReport report = judgeOrder(unsorted, stepsOf(faces));
    EXPECT_TRUE(report.isRight()) << name;
  }
}

// Sixty wrong orders: the pair that is named is wrong by rays, what it says of a test or a cut is so, and the
// two polygons alone show it again at the same pixel.
TEST(JudgeOrder, ShowsTheFirstWrongPairAlone) {
  int wrong = 0, cuts = 0, told = 0;
  const std::array<std::string, 6> names{"room", "crossing-sheets", "cycle", "slivers", "tori", "penetrate"};
  for (unsigned seed = 0; seed < (kSanitized ? 6u : 60u); ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 rng{seed};
    const Scene scene = readScene(names[seed % names.size()]);
    const Picture picture = pictureOf(scene);
    std::vector<int> faces(static_cast<std::size_t>(scene.mesh.faceCount()));
    std::iota(faces.begin(), faces.end(), 0);
    std::shuffle(faces.begin(), faces.end(), rng);
    const std::vector<PaintStep> steps = stepsOf(faces);
    const OrderReport report = judgeOrder(picture, steps);
    if (report.wrongSamples == 0) continue;
    ++wrong;
    ASSERT_TRUE(report.first);
    const WrongPair& pair = *report.first;
    EXPECT_GT(pair.shown, pair.hidden);  // it is painted later
    const auto shown = stepInWorld(picture, steps[pair.shown]),
               hidden = stepInWorld(picture, steps[pair.hidden]);
    EXPECT_LT(depthAlongRay(picture, hidden, pair.i, pair.j), depthAlongRay(picture, shown, pair.i, pair.j));

    const Scene alone = parseSceneFile(pairAsScene(picture, pair, steps), "pair", ".");
    const Picture again = pictureOf(alone);
    const std::size_t at = static_cast<std::size_t>(pair.j) * 160 + pair.i;
    EXPECT_EQ(again.faceImage()[at], 2u);  // the second face, which should be hidden
    const std::vector<SampleCheck> checks = checkedSamples(again);
    EXPECT_TRUE(isWrong(checks[at]));
    cuts += pair.needsCut, told += pair.told.has_value() && !pair.needsCut;
    // Only a cut helps if the two cross: then the other order is wrong somewhere, too.
    if (pair.cycle.size() != 3) continue;
    const OrderReport other = judgeOrder(picture, stepsOf({steps[pair.shown].face, steps[pair.hidden].face}));
    EXPECT_GT(
        other.wrongSamples +
            judgeOrder(picture, stepsOf({steps[pair.hidden].face, steps[pair.shown].face})).wrongSamples,
        0);
  }
  if (kSanitized) return;
  EXPECT_EQ(wrong, 60);
  EXPECT_GT(cuts, 5);
  EXPECT_GT(told, 5);
}

// A face that shows and is not painted, one that is painted twice, and pieces that overlap or leave a gap.
TEST(JudgeOrder, CountsFacesAndPieces) {
  const Scene scene = readScene("three-cards");
  const Picture picture = pictureOf(scene);
  OrderReport report = judgeOrder(picture, stepsOf({0, 1}));
  EXPECT_EQ(report.missing, std::vector{2});
  report = judgeOrder(picture, stepsOf({0, 1, 2, 1}));
  EXPECT_EQ(report.repeated, std::vector{1});

  std::vector<PaintStep> steps = stepsOf({0, 1, 2});
  const OrderReport whole = judgeOrder(picture, steps);
  steps.push_back({2, {{0, 0}, {80, 0}, {80, 120}}, 4});
  EXPECT_EQ(judgeOrder(picture, steps).repeated, std::vector{2}) << "whole and in a piece";
  steps.pop_back();
  steps[0].piece = {{0, 0}, {80, 0}, {80, 120}, {0, 120}};
  steps.insert(steps.begin() + 1, PaintStep{0, {{80, 0}, {160, 0}, {160, 120}, {80, 120}}, 9});
  report = judgeOrder(picture, steps);
  EXPECT_TRUE(report.covers.empty());
  EXPECT_EQ(report.wrongSamples, whole.wrongSamples);
  ASSERT_EQ(report.outside.size(), 2u) << "halves of the screen are no pieces";
  EXPECT_EQ(report.outside[1].step, 1);
  EXPECT_FALSE(report.isRight());
  steps[1].piece[0].x = steps[1].piece[3].x = 70;
  report = judgeOrder(picture, steps);
  ASSERT_EQ(report.covers.size(), 1u);
  EXPECT_EQ(report.covers[0].times, 2);
  steps[1].piece[0].x = steps[1].piece[3].x = 90;
  report = judgeOrder(picture, steps);
  ASSERT_EQ(report.covers.size(), 1u);
  EXPECT_EQ(report.covers[0].times, 0);
}

// Three bars, each over the next: whatever the order, only a cut helps, and the cycle is named.
TEST(JudgeOrder, NamesACycle) {
  const Scene scene = readScene("cycle");
  const Picture picture = pictureOf(scene);
  std::vector<int> order{0, 1, 2};
  do {
    const OrderReport report = judgeOrder(picture, stepsOf(order));
    ASSERT_TRUE(report.first);
    EXPECT_TRUE(report.first->needsCut);
    ASSERT_EQ(report.first->cycle.size(), 4u);
    EXPECT_EQ(report.first->cycle.front(), report.first->cycle.back());
  } while (std::ranges::next_permutation(order).found);
}

// Lines that are no steps are refused with their number.
TEST(PaintSteps, AreReadOrRefused) {
  const TemporaryFolder folder;
  const auto [steps, size] = readPaintOrder(
      folder.write("a", "{\"face\": 2}\n\n{\"face\": 0, \"piece\": [[1, 2], [3.5, 4], [5, 6]]}\n"), 3);
  EXPECT_FALSE(size);
  ASSERT_EQ(steps.size(), 2u);
  EXPECT_EQ(steps[0].face, 2);
  EXPECT_EQ(steps[1].line, 3);
  EXPECT_EQ(steps[1].piece[1], (glm::dvec2{3.5, 4}));
  const auto refused = [&](const std::string& text, const std::string& why) {
    try {
      (void)readPaintOrder(folder.write("a", text), 3);
      ADD_FAILURE() << text;
    } catch (const ParseError& e) {
      EXPECT_THAT(e.what(), ::testing::HasSubstr(why));
    }
  };
  refused("", "no line paints a face");
  refused("{\"face\": 1}\n{\"face\": 3}", "a:2: the scene has no face 3: its faces are 0 to 2");
  refused("{\"face\": -1}", "no face -1");
  refused("{\"face\": 1e99}", "\"face\" is the number of a face");
  refused("[1]", "not a JSON object");
  refused("{\"face\": 1, \"pece\": 1}", "unknown key 'pece'");
  refused("{\"face\": 1, \"piece\": [[1, 2], [3, 4]]}", "3 to 1000 corners");
  refused("{\"face\": 1, \"piece\": [[1, 2], [3, 4], [5, 1e9]]}", "a million pixels");
  refused("{\"face\": 1, \"piece\": [[1, 2], [3, 4], [5]]}", "[x, y]");
  refused("{\"face\": 1, \"face\": 2}", "a:1: the key 'face' appears twice in an object");
  refused("{\"face\": 1}\n{\"face\": 0, \"face\": 2}", "a:2: the key 'face' appears twice in an object");

  // The size, and the same text again.
  const std::string sized =
      "{\"size\":[572,284]}\n{\"face\":2}\n{\"face\":0,\"piece\":[[1.0,2.0],[3.5,4.0],[5.0,6.0]]}\n";
  const PaintOrder order = readPaintOrder(folder.write("a", sized), 3);
  EXPECT_EQ(order.size, (glm::ivec2{572, 284}));
  EXPECT_EQ(order.steps.front().line, 2);
  EXPECT_EQ(paintOrderText(order.steps, order.size), sized);
  EXPECT_EQ(paintOrderText(order.steps, {}), sized.substr(sized.find('\n') + 1));
  const std::string bounds = "a:1: the size is {\"size\": [width, height]}, each from 64 to 4096 pixels";
  for (const char* const wrong : {"[572]", "[572, 284.0]", "[63, 284]", "[572, 4097]", "\"572x284\"",
                                  "[572, 284], \"face\": 1", "[18446744073709551615, 284]"})
    refused("{\"size\": " + std::string{wrong} + "}\n{\"face\": 1}", bounds);
  refused("{\"size\": [572, 284]}", "no line paints a face");
  refused("{\"size\": [572, 284]}\n{\"size\": [572, 284]}\n{\"face\": 1}",
          "a:2: the size stands once, before all faces");
  refused("{\"face\": 1}\n{\"size\": [572, 284]}", "a:2: the size stands once, before all faces");
}

}  // namespace xnewell::THIS_FILE
