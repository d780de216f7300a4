#include "shading/course/stepping.h"

#include <gtest/gtest.h>

#include <cmath>

#include "shading/fill/affine.h"
#include "tests/support/affine_over.h"
#include "tests/support/random_triangles.h"
#include "tests/support/seeds.h"

namespace xnewell::THIS_FILE {

// With 24 bits the textbook's increments are the filler's, bit by bit, from slivers to the largest triangles
// and also where a rounding is a tie.
TEST(Stepping, IsTheFillersPlane) {
  RandomTriangles random{11};
  const int kRounds = kSanitized ? 500 : 4'000;
  int ties = 0;
  for (const double size : {0.001, 0.5, 3.0, 40.0, 2000.0, 8000.0})
    for (int k = 0; k < kRounds; ++k) {
      auto p = random.outline(size);
      std::array v{random.uniform(1, 255), random.uniform(1, 255), random.uniform(1, 255)};
      if (k % 3 == 0) {  // a right angle, sides that are powers of two, and odd differences of values
        const int side = kGrid << (k % 9);
        p[1] = p[0] + glm::ivec3{0, side, 0}, p[2] = p[0] + glm::ivec3{side, 0, 0};
        v[1] = v[0] + (k % 2) * 0x1p-24;
        ++ties;
      }
      if (doubleArea(p.data(), 3) <= 0) continue;
      const SteppedPlane plane = steppedOver(p, v, 24);
      const AffineValue fast = affineOver(p.data(), v);
      ASSERT_EQ(static_cast<std::uint32_t>(plane.c), fast.c) << size << ' ' << k;
      ASSERT_EQ(static_cast<std::uint32_t>(plane.perColumn), fast.gx) << size << ' ' << k;
      ASSERT_EQ(static_cast<std::uint32_t>(plane.perRow), fast.gy) << size << ' ' << k;
    }
  EXPECT_GT(ties, kRounds);
}

// By hand, with 8 bits: from 10 to 11 over 3 pixels grows by a third a pixel, which is 85 of 256 steps. After
// three pixels a whole step is missing.
TEST(Stepping, DriftsByHand) {
  constexpr int kAt = kGrid / 2;  // the centre of pixel 0
  const SteppedPlane plane =
      steppedOver({{{kAt, kAt, 0}, {kAt, kAt + 3 * kGrid, 0}, {kAt + 3 * kGrid, kAt, 0}}}, {10, 10, 11}, 8);
  EXPECT_EQ(plane.perColumn, 85);
  EXPECT_EQ(plane.perRow, 0);
  EXPECT_EQ(plane.number(plane.at(0, 0)), 10.0);
  EXPECT_EQ(plane.at(3, 0), 11 * 256 - 1);
}

}  // namespace xnewell::THIS_FILE
