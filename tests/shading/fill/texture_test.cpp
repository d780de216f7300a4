#include "shading/fill/evaluated.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <type_traits>

#include "geometry/model/solids.h"
#include "geometry/view/scanline.h"
#include "shading/fill/evaluate_pixels.h"
#include "tests/support/random_triangles.h"

namespace xnewell::THIS_FILE {

// A texture in perspective lies on its surface: the texel at a sample is that of the place seen there,
// found by a ray. Interpolated by a plane it is another, and the same where 1/w is the same at all corners.
TEST(Evaluated, PerspectiveFollowsTheSurface) {
  RandomTriangles random{2};
  int compared = 0, apart = 0;
  for (int trial = 0; trial < 200; ++trial) {
    SCOPED_TRACE(trial);
    const auto p = random.outline(200);
    TermsTriangle e = random.terms(p, true);
    const PixelPlanes planes{p};
    const std::array<double, 3> w{random.uniform(1, 4), random.uniform(1, 4), random.uniform(1, 4)};
    std::array<double, 3> u, v;
    for (int k = 0; k < 3; ++k) u[k] = random.uniform(0, 1), v[k] = random.uniform(0, 1);
    const auto over = [&](const std::array<double, 3>& c) {
      return planes({c[0] / w[0], c[1] / w[1], c[2] / w[2]});
    };
    e.u = over(u), e.v = over(v), e.q = planes({1 / w[0], 1 / w[1], 1 / w[2]});
    e.diffuse = {1, 0, 0}, e.rest = {0, 0, 0};
    TermsTriangle once = e, affine = e;
    once.repeats = false;
    affine.u = planes(u), affine.v = planes(v), affine.q = {1, 0, 0};
    forEachSpan(p.data(), 3, 8192, 8192, [&](int j, int from, int to) {
      for (int i = from; i < to; i += 9) {
        // Barycentric coordinates on the screen, then on the surface.
        const double x = (i + 0.5) * kGrid, y = (j + 0.5) * kGrid;
        const auto side = [&](const glm::ivec3& a, const glm::ivec3& b) {
          return (b.x - x) * (a.y - y) - (a.x - x) * (b.y - y);
        };
        std::array b{side(p[1], p[2]) / w[0], side(p[2], p[0]) / w[1], side(p[0], p[1]) / w[2]};
        const double sum = b[0] + b[1] + b[2];
        const double s = (b[0] * u[0] + b[1] * u[1] + b[2] * u[2]) / sum * 5;
        const double t = (1 - (b[0] * v[0] + b[1] * v[1] + b[2] * v[2]) / sum) * 3;
        if (std::abs(s - std::round(s)) < 1e-3 || std::abs(t - std::round(t)) < 1e-3) continue;
        const double texel = 17 * (static_cast<int>(t) * 5 + static_cast<int>(s)) / 255.0;
        ASSERT_NEAR(e.intensity(i, j), texel, 1e-9) << i << ", " << j;
        ASSERT_NEAR(once.intensity(i, j), texel, 1e-9) << i << ", " << j;
        apart += std::abs(affine.intensity(i, j) - texel) > 1e-9;
        ++compared;
      }
    });
  }
  EXPECT_GT(compared, 50'000);
  EXPECT_GT(apart, compared / 6);
}

// A texture that does not repeat ends with its last texels, where coordinates are 1 to the last bit or a
// rounding beyond; one that repeats begins again there. v = 0 is the lowest row in both.
TEST(Evaluated, TexturesEndOrRepeat) {
  RandomTriangles random{2};
  const auto p = random.outline(50);
  TermsTriangle e = random.terms(p, true);  // 5 x 3 texels, the k-th is 17 k
  e.diffuse = {1, 0, 0}, e.rest = {0, 0, 0}, e.q = {1, 0, 0};
  const auto texel = [&](double u, double v, bool repeats) {
    e.u = {u, 0, 0}, e.v = {v, 0, 0}, e.repeats = repeats;
    return std::lrint(e.intensity(e.i0, e.j0) * 255) / 17;
  };
  for (const double beyond : {0.0, 1e-15, 1e-9}) {
    EXPECT_EQ(texel(1 + beyond, 0.5, false), 9);
    EXPECT_EQ(texel(1 + beyond, 0.5, true), 5);
    EXPECT_EQ(texel(0.5, 1 + beyond, false), 2);
    EXPECT_EQ(texel(0.5, 1 + beyond, true), 12);
    EXPECT_EQ(texel(0 - beyond, 0.5, false), 5);
    EXPECT_EQ(texel(0.5, 0 - beyond, false), 12);
  }
  EXPECT_EQ(texel(0.5, 0, true), 12);
  EXPECT_EQ(texel(-1.5, 7.5, true), 7);
}

}  // namespace xnewell::THIS_FILE
