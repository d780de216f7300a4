#include "shading/fill/environment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "geometry/exact/power.h"
#include "geometry/exact/trig.h"
#include "geometry/model/solids.h"

namespace xnewell::THIS_FILE {

namespace {

/// One light of the given direction as the eye sees it, on a plain white surface.
struct Lit {
  Lighting lighting;
  explicit Lit(glm::dvec3 L, double kd = 1, double ks = 0, int n = 1)
      : lighting{resolve(cube(), {}, {.Ia = 0, .Ip = 1, .ka = 1, .kd = kd, .ks = ks, .n = n, .light = L},
                         Channels::Luminance, {0, 0, 5}, {0, 0, 0})} {}
  [[nodiscard]] Environment map(EnvironmentForm form) const {
    return makeEnvironment(form, lighting, lighting.materials[0], 0, glm::dmat3{1.0}, {0, 0, 0});
  }
};

/// The normal that a place of a map stands for, on the near or the far side. There is none if x and y lie
/// outside the circle.
std::optional<glm::dvec3> normalAt(int column, int row, double side) {
  const double x = (column + 0.5 - kMapCentre) / kMapScale, y = (row + 0.5 - kMapCentre) / kMapScale;
  const double square = 1 - x * x - y * y;
  if (square < 0) return std::nullopt;
  return glm::dvec3{x, y, side * std::sqrt(square)};
}

double tutorialPhong(const glm::dvec3& N, const glm::dvec3& L, double kd, double ks, int n) {
  const double cosine = std::max(0.0, glm::dot(N, L));
  return std::min(1.0, cosine > 0 ? kd * cosine + ks * power(cosine, n) : 0.0);
}

/// Root mean square error of the published look-up over all normals that face the eye, with the places of the
/// map taken as evenly spread, for a light that many degrees off the view axis.
double publishedError(double degrees) {
  const SinCos angle = sinCosDegrees(degrees);
  const glm::dvec3 L{angle.sin, 0, angle.cos};
  const Environment map = Lit{L}.map(EnvironmentForm::Published);
  double squares = 0;
  int count = 0;
  for (int row = 0; row < 256; ++row)
    for (int column = 0; column < 256; ++column)
      if (const auto N = normalAt(column, row, 1)) {
        const double error = map.front[256 * row + column] - tutorialPhong(*N, L, 1, 0, 1);
        squares += error * error;
        ++count;
      }
  return std::sqrt(squares / count);
}

}  // namespace

// At every place of the map the value is that of the equation, for every direction of the light and any
// sharpness of the highlight. In a frame where L is (0, 0, 1), the normal's x, y and side are enough.
TEST(Environment, RotatedIsExactAtEveryPlace) {
  for (const glm::dvec3 along : {glm::dvec3{0, 0, 1}, {1, 0, 0}, {0, 0, -1}, {-0.4, 0.7, 0.2}, {1, 1, -1}})
    for (const int n : {0, 1, 20, 100'000}) {
      const glm::dvec3 L = glm::normalize(along);
      const Environment map = Lit{L, 0.5, 0.4, n}.map(EnvironmentForm::Rotated);
      ASSERT_TRUE(map.twoMaps);
      int places = 0;
      for (int k = 0; k < 65'536; ++k)
        for (const double side : {1.0, -1.0}) {
          const auto turned = normalAt(k % 256, k / 256, side);
          if (!turned) continue;
          const glm::dvec3 N = glm::transpose(map.frame) * *turned;  // back to the world
          ASSERT_NEAR((side > 0 ? map.front : map.away)[k], tutorialPhong(N, L, 0.5, 0.4, n),
                      1e-6 + n * 1e-14);
          ++places;
        }
      EXPECT_GT(places, 100'000);
    }
}

// The frame of the look-up is a rotation that takes L to (0, 0, 1).
TEST(Environment, RotatedTurnsTheLightToTheAxis) {
  for (const glm::dvec3 along : {glm::dvec3{0, 0, 1}, {1, 0, 0}, {0, -1, 0}, {-3, 2, 1}}) {
    const glm::dmat3 frame = Lit{along}.map(EnvironmentForm::Rotated).frame;
    const glm::dvec3 axis = frame * glm::normalize(along);
    EXPECT_NEAR(glm::length(axis - glm::dvec3(0, 0, 1)), 0, 1e-15);
    EXPECT_NEAR(glm::determinant(frame), 1, 1e-15);
  }
}

// The published look-up is exact for a light on the view axis. The farther off the axis the light is, the
// larger the error. The test has a white surface, diffuse light alone and all normals that face the eye.
TEST(Environment, PublishedIsExactOnTheViewAxisAlone) {
  EXPECT_LT(publishedError(0), 1e-7);
  for (const double degrees : {15.0, 30.0, 45.0, 60.0}) {
    SCOPED_TRACE(degrees);
    EXPECT_GT(publishedError(degrees), 0.13);
    EXPECT_LT(publishedError(degrees), 0.18);
  }
}

}  // namespace xnewell::THIS_FILE
