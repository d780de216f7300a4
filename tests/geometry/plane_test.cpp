#include "geometry/exact/plane.h"

#include <gtest/gtest.h>

#include <array>

namespace xnewell {

// The unit square in the plane z = 2, counter-clockwise from above: N = +z, d = 2, vector area 2 * 1.
TEST(Plane, OfASquareByNewellsMethod) {
  const std::array<glm::dvec3, 4> p{{{0, 0, 2}, {1, 0, 2}, {1, 1, 2}, {0, 1, 2}}};
  const std::array corners{0, 1, 2, 3};
  EXPECT_EQ(newellVector(p, corners), glm::dvec3(0, 0, 2));
  EXPECT_EQ(newellPlane(p, corners).N, glm::dvec3(0, 0, 1));
  EXPECT_EQ(newellPlane(p, corners).d, 2.0);
}

}  // namespace xnewell
