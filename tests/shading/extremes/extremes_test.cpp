#include "shading/extremes/extremes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "shading/picture/picture_cache.h"

namespace xnewell {

namespace {

/// A square of side 2 that faces the viewer at height z.
void addCard(Mesh& mesh, double z) {
  const int first = static_cast<int>(mesh.points.size());
  for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) mesh.points.emplace_back(x, y, z);
  const int corners[]{first, first + 1, first + 2, first + 3};
  mesh.addFace(corners, 0);
}

/// Cards at these heights, in this order; the camera is 5 above the origin.
Scene cards(const std::vector<double>& heights) {
  Mesh mesh;
  mesh.groupNames = {"cards"};
  for (const double z : heights) addCard(mesh, z);
  return makeScene("cards", std::move(mesh), UpAxis::Y);
}

PictureSettings fromAbove(const Scene& scene) {
  PictureSettings settings;
  settings.width = 40, settings.height = 30;
  CameraSettings camera;
  camera.eye = {0, 0, 5}, camera.lookAt = {0, 0, 0}, camera.up = {0, 1, 0};
  settings.camera = inSceneUnits(camera, scene);
  return settings;
}

const Extreme& named(const std::vector<Extreme>& extremes, std::string_view name) {
  return *std::ranges::find(extremes, name, &Extreme::name);
}

}  // namespace

// A ray through the middle of the picture meets the nearest card at the distance that one reckons by hand.
TEST(Rays, MeetTheNearestCard) {
  const Scene scene = cards({0.5, -1, 0.25});
  const PictureSettings settings = fromAbove(scene);
  const Rays rays{scene, makePicture(scene, settings).camera(), settings};
  const double unit = std::ldexp(1.0, -scene.exponent);
  const auto nearest = rays.nearest(20, 15);
  ASSERT_TRUE(nearest);
  EXPECT_EQ(nearest->face, 0);
  EXPECT_DOUBLE_EQ(static_cast<double>(nearest->t), 4.5 * unit);
  const auto last = rays.hit(1, 20, 15);
  ASSERT_TRUE(last);
  EXPECT_DOUBLE_EQ(static_cast<double>(last->t), 6 * unit);
  EXPECT_FALSE(rays.nearest(0, 0));
  EXPECT_FALSE(rays.hit(0, 0, 0));
}

// The depth sort is right. Painting the cards as they come is wrong wherever they overlap, by the share of
// the distance that one reckons by hand.
TEST(Rays, JudgeTheOrder) {
  const Scene scene = cards({1, 0});
  PictureSettings settings = fromAbove(scene);
  const JudgedByRays sorted = judgedByRays(makePicture(scene, settings));
  EXPECT_GT(sorted.samples, 100);
  EXPECT_EQ(sorted.wrong, 0);
  settings.order = Order::Unsorted;
  const JudgedByRays unsorted = judgedByRays(makePicture(scene, settings));
  EXPECT_GT(unsorted.wrong, 100);
  EXPECT_LT(unsorted.wrong, unsorted.samples + 1);
  EXPECT_NEAR(unsorted.behind, 1.0 / 4.0, 1e-12);  // 5 - 4 of 4
}

// What is cut away by a plane of the user's is not missing. What is cut away by a plane that the program
// chose would be.
TEST(Rays, EndAtTheUsersPlanes) {
  const Scene scene = cards({1, 0});
  PictureSettings settings = fromAbove(scene);
  settings.camera.front = inSceneUnits(0.5, scene);
  const Camera camera = makePicture(scene, settings).camera();
  EXPECT_EQ((Rays{scene, camera, settings}.nearest(20, 15)->face), 1);
  settings.camera.front.reset();
  EXPECT_EQ((Rays{scene, camera, settings}.nearest(20, 15)->face), 0);
}

// The pictures of built-in scenes are right by the rays, in parallel and in perspective.
TEST(Rays, AgreeWithTheDepthSort) {
  for (const char* name : {"room", "cycle", "penetrate", "decals", "sheets", "coarse-teapot"})
    for (const bool parallel : {false, true}) {
      SCOPED_TRACE(name);
      const Scene scene = readScene(name);
      PictureSettings settings = scene.settings;
      settings.width = 120, settings.height = 90;
      settings.camera.parallel = parallel;
      const JudgedByRays judged = judgedByRays(makePicture(scene, settings));
      EXPECT_GT(judged.samples, 1'000);
      EXPECT_EQ(judged.wrong, 0) << judged.behind;
    }
}

// Powers of two change nothing. A move so far that doubles are as coarse as the scene changes everything.
// Fewer than 16 bits cannot hold a table that begins at 1e-6.
TEST(Extremes, FindWhatBecomesWrong) {
  const Scene scene = readScene("cycle");
  PictureSettings settings = scene.settings;
  settings.width = 60, settings.height = 45;
  std::vector<std::string> announced;
  const std::vector<Extreme> extremes =
      extremesOf(scene, settings, [&](std::string_view way) { announced.emplace_back(way); });
  ASSERT_EQ(announced.size(), extremes.size());
  for (const Extreme& extreme : extremes) {
    SCOPED_TRACE(extreme.name);
    ASSERT_GE(extreme.steps.size(), 6u);
    EXPECT_FALSE(extreme.steps.front().isWrong()) << findingOf(extreme);
    for (const ExtremeStep& step : extreme.steps) EXPECT_FALSE(step.why.empty());
  }
  const Extreme& powers = extremes[0];
  EXPECT_EQ(powers.unit, "(powers of two)");
  EXPECT_TRUE(std::ranges::none_of(powers.steps, &ExtremeStep::isWrong)) << findingOf(powers);
  EXPECT_TRUE(findingOf(powers).starts_with("right up to "));

  const Extreme& moved = named(extremes, "moved by");
  for (const ExtremeStep& step : moved.steps) EXPECT_FALSE(step.value <= 1e6 && step.isWrong()) << step.value;
  EXPECT_TRUE(moved.steps.back().isWrong());
  EXPECT_GT(moved.steps.back().changed, 0);
  EXPECT_TRUE(findingOf(moved).starts_with("from 1e+1")) << findingOf(moved);

  const ExtremeStep& darkest = named(extremes, "I0 down to").steps.back();
  EXPECT_EQ(darkest.value, 1e-6);
  EXPECT_GT(darkest.merged, 10);
}

}  // namespace xnewell
