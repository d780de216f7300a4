#include "shading/trade/constant_l_bound.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "geometry/exact/box.h"

namespace xnewell::THIS_FILE {

namespace {

/// The diffuse term and the tutorial's highlight at a place, written from the equation.
double intensity(const Illumination& light, const glm::dvec3& lamp, const glm::dvec3& from,
                 const glm::dvec3& N, double d) {
  const double cosine = std::max(0.0, glm::dot(N, glm::normalize(lamp - from)));
  const double f = light.attenuation == Attenuation::Inverse ? 1 / std::max(1.0, d) : 1;
  return f * light.Ip * (light.kd * cosine + light.ks * std::pow(cosine, light.n));
}

}  // namespace

// No place and no normal differ by more, and some come near.
TEST(ConstantLBound, IsNeverExceeded) {
  Scene scene;
  scene.mesh.points = {{-1, -1, -1}, {1, 1, 1}, {0.3, -0.2, 0.1}};
  const Box box = boxOf(scene.mesh.points);
  std::mt19937 random{1975};
  std::uniform_real_distribution<double> within{-1, 1};
  for (const double away : {2.0, 5.0, 40.0, 1000.0})
    for (const double ks : {0.0, 0.3})
      for (const Attenuation attenuation : {Attenuation::None, Attenuation::Inverse}) {
        SCOPED_TRACE(testing::Message() << away << ' ' << ks << ' ' << static_cast<int>(attenuation));
        Illumination light;
        light.ks = ks, light.n = 3, light.form = Form::Tutorial, light.attenuation = attenuation;
        light.lightPosition = away * glm::normalize(glm::dvec3{1, 2, 2});
        const std::optional<double> bound = boundOfConstantL(scene, light);
        ASSERT_TRUE(bound);
        double most = 0;
        for (int k = 0; k < 20'000; ++k) {
          const glm::dvec3 place{within(random), within(random), within(random)};
          const glm::dvec3 N = glm::normalize(glm::dvec3{within(random), within(random), within(random)});
          const glm::dvec3& lamp = *light.lightPosition;
          most = std::max(
              most, std::abs(intensity(light, lamp, place, N, glm::length(lamp - place)) -
                             intensity(light, lamp, box.centre(), N, glm::length(lamp - box.centre()))));
        }
        EXPECT_LE(most, *bound);
        if (ks == 0 && away > 2 && attenuation == Attenuation::None) {
          EXPECT_GE(most, 0.6 * *bound);
        }
      }
}

// A lamp inside gives no bound, and neither does a light that is far away. A highlight that may begin
// abruptly counts whole.
TEST(ConstantLBound, IsGivenOnlyWhereItHolds) {
  Scene scene;
  scene.mesh.points = {{-1, -1, -1}, {1, 1, 1}};
  Illumination light;
  EXPECT_FALSE(boundOfConstantL(scene, light));
  light.lightPosition = glm::dvec3{1.1, 0, 0};  // within the sphere around the box
  EXPECT_FALSE(boundOfConstantL(scene, light));
  light.lightPosition = glm::dvec3{1e9, 0, 0};
  ASSERT_TRUE(boundOfConstantL(scene, light));
  EXPECT_NEAR(*boundOfConstantL(scene, light), light.Ip * light.ks, 1e-6);
  light.ks = 0;
  EXPECT_LE(*boundOfConstantL(scene, light), 1e-6);
}

}  // namespace xnewell::THIS_FILE
