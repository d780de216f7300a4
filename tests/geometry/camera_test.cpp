#include "geometry/view/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>
#include <vector>

namespace xnewell {

namespace {

/// The bounding box of the projected points in the canonical square.
struct Reach {
  glm::dvec2 low{2}, high{-2};
};
Reach reach(const Camera& camera, const std::vector<glm::dvec3>& points) {
  const glm::dmat4 m = canonicalFromVrc(camera.view) * vrcFromWorld(camera.view);
  Reach r;
  for (const glm::dvec3& p : points) {
    const glm::dvec4 h = m * glm::dvec4{p, 1};
    EXPECT_GT(h.w, 0);
    EXPECT_TRUE(h.z / h.w <= 0 && h.z / h.w >= -1) << h.z / h.w;
    r.low = glm::min(r.low, glm::dvec2{h} / h.w);
    r.high = glm::max(r.high, glm::dvec2{h} / h.w);
  }
  return r;
}

std::vector<glm::dvec3> cloud(unsigned seed, double scale, glm::dvec3 centre) {
  std::mt19937 rng{seed};
  std::uniform_real_distribution<double> around{-scale, scale};
  std::vector<glm::dvec3> points;
  for (int i = 0; i < 50; ++i)
    points.push_back(centre + glm::dvec3{around(rng), around(rng) / 3, around(rng) / 2});
  return points;
}

}  // namespace

// Without camera options the picture shows the whole scene, centred. The tighter side is filled up to the
// margin of 6 %. This holds for perspective, parallel and oblique views, for small scenes and for scenes far
// away.
TEST(Camera, FramesTheSceneWhole) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    const auto points =
        cloud(seed, seed % 2 ? 1.0 : 1e-3, seed % 3 ? glm::dvec3{0} : glm::dvec3{0.9, -0.5, 0.3});
    CameraSettings settings;
    settings.fov = 10 + seed;
    settings.parallel = seed % 4 == 1;
    if (seed % 4 == 2) settings.oblique = Oblique{0.5, 30};
    const Reach r = reach(placeCamera(settings, points, seed % 2 ? UpAxis::Y : UpAxis::Z, 4.0 / 3), points);
    EXPECT_NEAR(r.low.x, -r.high.x, 0.01);
    EXPECT_NEAR(r.low.y, -r.high.y, 0.01);
    EXPECT_NEAR(std::max(r.high.x, r.high.y), 0.94, 1e-9);
    EXPECT_NEAR(std::min(r.low.x, r.low.y), -0.94, 1e-9);
  }
}

// Given settings are used as they are: the eye, the look-at point, the up vector, the angle.
TEST(Camera, TakesWhatWasSaid) {
  CameraSettings s;
  s.eye = glm::dvec3{3, 4, 5};
  s.lookAt = glm::dvec3{1, 0, 0};
  s.up = glm::dvec3{0, 0, 1};
  s.fov = 90;
  const auto points = cloud(1, 1, {0, 0, 0});
  const Camera c = placeCamera(s, points, UpAxis::Y, 2.0);
  EXPECT_EQ(c.eye, *s.eye);
  EXPECT_EQ(c.lookAt, *s.lookAt);
  const double D = std::sqrt(4 + 16 + 25.0);
  EXPECT_NEAR(c.view.prp.z, D, 1e-14);
  EXPECT_NEAR(c.view.windowMax.y, D, 1e-13);  // tan 45 = 1
  EXPECT_NEAR(c.view.windowMax.x, 2 * D, 1e-13);
}

// The textbook's specification is used unchanged. The eye that shading sees is PRP in world coordinates.
TEST(Camera, TextbookSpecification) {
  CameraSettings s;
  s.vrp = glm::dvec3{16, 0, 54};
  s.vpn = glm::dvec3{1, 0, 1};
  s.vup = glm::dvec3{0, 1, 0};
  s.prp = glm::dvec3{0, 25, 20 * std::sqrt(2.0)};
  s.window = glm::dvec4{-20, 20, -5, 35};
  s.front = 1;
  s.back = -30;
  const auto points = cloud(2, 1, {16, 10, 50});
  const Camera c = placeCamera(s, points, UpAxis::Y, 1.0);
  EXPECT_EQ(c.view.front, 1);
  EXPECT_EQ(c.view.back, -30);
  EXPECT_EQ(c.view.windowMin, glm::dvec2(-20, -5));
  EXPECT_NEAR(glm::length(c.eye - glm::dvec3{36, 25, 74}), 0, 1e-12);
}

// Oblique views do not move the eye. So V, and with it the specular term, is that of the upright view.
TEST(Camera, ObliqueKeepsTheEye) {
  const auto points = cloud(3, 1, {0, 0, 0});
  CameraSettings s;
  s.eye = glm::dvec3{1, 2, 6};
  s.height = 3;
  s.parallel = true;
  const Camera upright = placeCamera(s, points, UpAxis::Y, 1.5);
  s.oblique = Oblique{1.0, 45};
  const Camera oblique = placeCamera(s, points, UpAxis::Y, 1.5);
  EXPECT_EQ(upright.eye, oblique.eye);
  EXPECT_EQ(upright.lookAt, oblique.lookAt);
  EXPECT_NE(upright.view.prp, oblique.view.prp);
}

// Four quarter turns lead back to the start, and so do a turn up and down. The eye stops one degree short of
// the poles. Zooming in by two halves the distance.
TEST(Camera, MovesOnASphere) {
  const auto points = cloud(4, 1, {0.2, 0.1, 0});
  CameraSettings s;
  const auto place = [&] { return placeCamera(s, points, UpAxis::Z, 1.5); };
  const Camera start = place();
  const double D = glm::length(start.eye - start.lookAt);
  for (int i = 0; i < 4; ++i) s = moved(s, place(), 90, 0, 1);
  EXPECT_NEAR(glm::length(place().eye - start.eye), 0, 1e-14 * 100);
  s = moved(s, place(), 0, 20, 1);
  s = moved(s, place(), 0, -20, 1);
  EXPECT_NEAR(glm::length(place().eye - start.eye), 0, 1e-14 * 100);
  s = moved(s, place(), 0, 500, 2);
  const glm::dvec3 arm = place().eye - place().lookAt;
  EXPECT_NEAR(glm::length(arm), D / 2, 1e-14 * 100);
  s = moved(s, place(), 0, 80, 1);
  s = moved(s, place(), 0, 80, 1);
  EXPECT_NEAR(std::asin(glm::normalize(place().eye - place().lookAt).z), 89 * 3.14159265358979 / 180, 1e-9);
}

// A view straight down with the default up vector picks another up vector instead of failing.
TEST(Camera, LooksStraightDown) {
  CameraSettings s;
  s.eye = glm::dvec3{0, 0, 9};
  s.lookAt = glm::dvec3{0};
  EXPECT_NO_THROW((void)placeCamera(s, cloud(5, 1, {0, 0, 0}), UpAxis::Z, 1));
  s.up = glm::dvec3{0, 0, 1};
  EXPECT_THROW((void)vrcFromWorld(placeCamera(s, cloud(5, 1, {0, 0, 0}), UpAxis::Z, 1).view), ViewError);
}

}  // namespace xnewell
