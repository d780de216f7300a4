#include "shading/course/interpolation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/view/screen_grid.h"
#include "tests/support/random_triangles.h"

namespace xnewell::THIS_FILE {

// The weighted sum is the plane that the fillers evaluate, at any pixel and for any size of triangle.
TEST(Interpolation, IsTheFillersPlane) {
  RandomTriangles random{7};
  for (const double size : {0.5, 3.0, 40.0, 2000.0})
    for (int k = 0; k < 500; ++k) {
      const auto p = random.outline(size);
      const std::array v{random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1)};
      const PixelPlanes planes{p};
      const PixelPlane plane = planes(v);
      const int i = (p[0].x + p[1].x + p[2].x) / 3 / kGrid, j = (p[0].y + p[1].y + p[2].y) / 3 / kGrid;
      const double filled = plane.c + plane.gx * (i - planes.i0()) + plane.gy * (j - planes.j0());
      const Weights weights = weightsOnScreen(p, i, j);
      ASSERT_NEAR(weights[0] + weights[1] + weights[2], 1.0, 1e-9 * (1 + std::abs(filled)));
      ASSERT_NEAR(interpolated(weights, v), filled, 1e-7 * (1 + std::abs(filled)));
    }
}

// By hand: half way along a side on the screen, from depth 1 to depth 3, the near end counts three quarters
// of the world's way: (1/1) : (1/3) = 3 : 1.
TEST(Interpolation, OfAPlaceInPerspectiveByHand) {
  const Weights world = weightsInWorld({0.5, 0.5, 0.0}, {1.0 / 1.0, 1.0 / 3.0, 1.0 / 2.0});
  EXPECT_NEAR(world[0], 0.75, 1e-15);
  EXPECT_NEAR(world[1], 0.25, 1e-15);
  EXPECT_EQ(world[2], 0.0);
}

}  // namespace xnewell::THIS_FILE
