#include "x11/views/exactness_view.h"

#include <gtest/gtest.h>

#include "shading/picture/picture_cache.h"

namespace xnewell::THIS_FILE {

namespace {

/// A square of side 2 at z = 0, and one over it that rises from `left` to `right`, from a file whose
/// coordinates are rounded by 1e-5. Seen from above, 50 pixels to the unit.
Exactness ofSheets(double left, double right, Order order, IndexImage* map = nullptr) {
  Mesh mesh;
  mesh.groupNames = {""};
  mesh.rounding = {1e-5};
  mesh.points = {{-1, -1, 0},    {1, -1, 0},     {1, 1, 0},     {-1, 1, 0},
                 {-1, -1, left}, {1, -1, right}, {1, 1, right}, {-1, 1, left}};
  mesh.addFace(std::array{0, 1, 2, 3}, 0);
  mesh.addFace(std::array{4, 5, 6, 7}, 0);
  PictureCache pictures{makeScene("sheets", mesh, UpAxis::Y)};
  PictureSettings s;
  s.width = s.height = 100;
  s.order = order;
  s.cull = Cull::Keep;
  s.camera.eye = glm::dvec3{0, 0, 20};
  s.camera.lookAt = glm::dvec3{0, 0, 0};
  s.camera.parallel = true;
  s.camera.height = 2.0;
  pictures.make(s);
  const std::vector<SampleCheck> verdicts = checkedSamples(pictures.last());
  if (map) *map = verdictImage(verdicts, 100, CellPlan{});
  return exactnessOf(verdicts);
}

/// What a finding needs to know of a picture.
PictureSettings of(Order order, Cull cull = Cull::Keep) {
  PictureSettings s;
  s.order = order, s.cull = cull;
  s.width = 90, s.height = 50;
  return s;
}

}  // namespace

// A worked example. The upper sheet is 6e-5 behind the other at its left side and 1.9e-5 before it at its
// right side. Rounding explains 2e-5. So the order of the left side may be shown everywhere, and the right
// quarter, where the upper sheet is before the other, is doubtful. If it rises to 3e-5, rounding does not
// explain that: the depth sort cuts, and every sample is right. An order that cannot cut is wrong there.
TEST(ExactnessView, ThinLayersAreDoubtfulAndThickOnesWrong) {
  IndexImage map;
  const Exactness thin = ofSheets(-6e-5, 1.9e-5, Order::Newell, &map);
  EXPECT_EQ(thin.samples, 10'000);
  EXPECT_EQ(thin.wrong, 0);
  EXPECT_EQ(thin.doubtful, 2'400);  // x > 60 / 79 of the way: columns 76 to 99
  const CellPlan plan;
  for (int i = 0; i < 100; ++i) EXPECT_EQ(map.row(50)[i], plan[i < 76 ? Cell::WellLine : Cell::Q]) << i;

  const Exactness thick = ofSheets(-6e-5, 3e-5, Order::Newell);
  EXPECT_EQ(thick.samples, 10'000);
  EXPECT_EQ(thick.wrong + thick.doubtful, 0);

  const Exactness sorted = ofSheets(-6e-5, 3e-5, Order::Unsorted, &map);  // the upper one is painted last
  EXPECT_GT(sorted.wrong, 3'000);
  EXPECT_GT(sorted.doubtful, 1'500);
  EXPECT_EQ(sorted.wrong + sorted.doubtful, 6'700);  // x < 60 / 90 of the way: columns 0 to 66
  EXPECT_EQ(map.row(50)[0], plan[Cell::Alarm]);
  EXPECT_EQ(map.row(50)[66], plan[Cell::Q]);
  EXPECT_EQ(map.row(50)[67], plan[Cell::WellLine]);
}

// Each verdict has its cell, and samples that show nothing are background.
TEST(ExactnessView, EachVerdictHasItsCell) {
  const CellPlan plan;
  const IndexImage map = verdictImage(
      {SampleCheck::Right, SampleCheck::Nothing, SampleCheck::Wrong, SampleCheck::Doubtful}, 2, plan);
  ASSERT_EQ(map.height, 2);
  EXPECT_EQ(map.pixels[0], plan[Cell::WellLine]);
  EXPECT_EQ(map.pixels[1], plan[Cell::Well]);
  EXPECT_EQ(map.pixels[2], plan[Cell::Alarm]);
  EXPECT_EQ(map.pixels[3], plan[Cell::Q]);
}

// Two faces in one plane: the later one should show. An order that shows the earlier one is wrong, though
// none is nearer, and the finding says so.
TEST(ExactnessView, OfOnePlaneTheLaterShouldShow) {
  const Scene scene = readScene("decals");
  PictureSettings s = scene.settings;
  s.width = 768, s.height = 412;
  s.order = Order::ZBuffer32;
  const Exactness e = exactnessOf(makePicture(scene, s));
  EXPECT_GT(e.earlier, 100);
  EXPECT_LE(e.earlier, e.wrong);
  EXPECT_NE(findingOf(e, s).why.find("in the plane of the face that should show"), std::string::npos);
  s.order = Order::Newell;
  EXPECT_EQ(exactnessOf(makePicture(scene, s)).wrong, 0);
  const auto why = [](int wrong, int earlier) {
    return findingOf({.samples = 4000, .wrong = wrong, .earlier = earlier}, of(Order::ZSort)).why;
  };
  EXPECT_EQ(why(1200, 0), "The oracle, which compares all faces at each sample, sees a nearer one there.");
  EXPECT_EQ(
      why(1200, 1200),
      "There it lies in the plane of the face that should show: of faces in one plane, the later one wins.");
  EXPECT_EQ(
      why(1200, 200),
      "The oracle, which compares all faces at each sample, sees a nearer one at 1,000 of them. At 200 it "
      "lies in the plane of the face that should show: of faces in one plane, the later one wins.");
}

// Wrong samples in blocks that touch are one spot. Each small spot has a ring that keeps off it; doubtful
// samples have one only if none is wrong. A large spot needs none.
TEST(ExactnessView, RingsFindSingleSamples) {
  constexpr int kWidth = 400, kHeight = 300;
  const CellPlan plan;
  std::vector<SampleCheck> verdicts(std::size_t{kWidth} * kHeight, SampleCheck::Right);
  const auto at = [&](int i, int j) -> SampleCheck& { return verdicts[std::size_t(j) * kWidth + i]; };
  EXPECT_TRUE(spotsOf(verdicts, kWidth).empty());
  at(200, 100) = SampleCheck::Doubtful;
  EXPECT_EQ(spotsOf(verdicts, kWidth), (std::vector<Rect>{{200, 100, 1, 1}}));
  at(40, 50) = at(47, 52) = SampleCheck::Wrong;
  at(390, 290) = SampleCheck::Earlier;
  EXPECT_EQ(spotsOf(verdicts, kWidth), (std::vector<Rect>{{40, 50, 8, 3}, {390, 290, 1, 1}}));

  const auto ringed = [&] {
    IndexImage image = verdictImage(verdicts, kWidth, plan);
    ringSpots(Painter{image}, 0, 0, verdicts, kWidth, plan);
    return image;
  };
  IndexImage image = ringed();
  EXPECT_EQ(image.row(50)[40], plan[Cell::Alarm]);
  EXPECT_EQ(image.row(52)[47], plan[Cell::Alarm]);
  EXPECT_EQ(image.row(290)[390], plan[Cell::Alarm]);
  EXPECT_EQ(image.row(100)[200], plan[Cell::Q]);
  const auto whiteIn = [&](const Rect& part) {
    int white = 0;
    for (int j = part.y; j < part.y + part.height; ++j)
      for (int i = part.x; i < part.x + part.width; ++i) white += image.row(j)[i] == plan[Cell::White];
    return white;
  };
  EXPECT_GT(whiteIn({25, 35, 40, 35}), 60);
  EXPECT_GT(whiteIn({370, 270, 30, 30}), 40);
  EXPECT_EQ(whiteIn({180, 80, 40, 40}), 0);

  for (int j = 100; j < 200; ++j)
    for (int i = 100; i < 200; ++i) at(i, j) = SampleCheck::Wrong;
  at(40, 50) = at(47, 52) = at(390, 290) = SampleCheck::Right;
  image = ringed();
  EXPECT_EQ(whiteIn({0, 0, kWidth, kHeight}), 0);
}

// The finding tells what was counted: wrong samples first, then doubtful ones.
TEST(ExactnessView, FindingIsOfTheNumbers) {
  EXPECT_EQ(findingOf({}, of(Order::Newell)).bold, "Nothing shows.");
  EXPECT_EQ(findingOf({.samples = 9}, of(Order::Newell)).bold, "Every sample shows the right face.");
  EXPECT_NE(findingOf({.samples = 9}, of(Order::Newell)).why,
            findingOf({.samples = 9}, of(Order::Oracle)).why);
  // With backs culled, a face that was culled may be nearer: --errors counts that.
  const Finding culled = findingOf({.samples = 9}, of(Order::Newell, Cull::Back));
  EXPECT_EQ(culled.bold, "Every sample shows the right one of the faces that culling left.");
  EXPECT_TRUE(culled.why.ends_with(" Only the faces that culling left are compared.")) << culled.why;
  const Finding doubtful = findingOf({.samples = 4000, .doubtful = 1}, of(Order::Newell));
  EXPECT_EQ(doubtful.bold, "No face is wrong, but 1 sample may be.");
  EXPECT_EQ(doubtful.why.substr(0, 27), "At 1 sample two faces lie s");
  const Finding wrong = findingOf({.samples = 4000, .wrong = 1200, .doubtful = 2}, of(Order::ZSort));
  EXPECT_EQ(wrong.bold, "A wrong face shows at 1,200 of 4,000 samples of 90 x 50.");
  EXPECT_NE(wrong.why.find("At 2 samples two faces"), std::string::npos);
}

}  // namespace xnewell::THIS_FILE
