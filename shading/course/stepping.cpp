#include "shading/course/stepping.h"

#include <cmath>

#include "geometry/exact/int128.h"
#include "geometry/view/screen_grid.h"

namespace xnewell {

namespace {

/// a / b, rounded to the nearest whole number, of two the even one; b > 0.
Int128 nearestQuotient(Int128 a, Int128 b) {
  Int128 whole = a / b, rest = a % b;
  if (rest < 0) rest += b, --whole;
  const Int128 twice = 2 * rest;
  return whole + ((twice > b || (twice == b && whole % 2 != 0)) ? 1 : 0);
}

}  // namespace

SteppedPlane steppedOver(const std::array<glm::ivec3, 3>& p, const std::array<double, 3>& v, int bits) {
  const auto steps = [bits](double value) {
    return static_cast<std::int64_t>(std::nearbyint(std::ldexp(value, bits)));
  };
  const std::int64_t V0 = steps(v[0]), V1 = steps(v[1]) - V0, V2 = steps(v[2]) - V0;
  const std::int64_t x1 = p[1].x - p[0].x, y1 = p[1].y - p[0].y, x2 = p[2].x - p[0].x, y2 = p[2].y - p[0].y;
  // Cramer's rule: V1 = gx x1 + gy y1 and V2 = gx x2 + gy y2, with gx and gy for each step of the grid.
  Int128 area = Int128{x1} * y2 - Int128{x2} * y1;
  Int128 alongX = (Int128{V1} * y2 - Int128{V2} * y1) * kGrid;
  Int128 alongY = (Int128{V2} * x1 - Int128{V1} * x2) * kGrid;
  if (area < 0) area = -area, alongX = -alongX, alongY = -alongY;

  const Int128 steepest = area * (Int128{1} << (20 + bits));
  const auto isSteep = [&](Int128 along) { return along > steepest || -along > steepest; };
  if (isSteep(alongX) || isSteep(alongY)) return {bits, V0 + (V1 + V2) / 3, 0, 0};
  const Int128 gx = nearestQuotient(alongX, area), gy = nearestQuotient(alongY, area);
  // Back from vertex 0 to the centre of pixel (0, 0). `>>` rounds down, so this rounds to the nearest.
  const Int128 toVertex = gx * (p[0].x - kGrid / 2) + gy * (p[0].y - kGrid / 2);
  const Int128 c = V0 - ((toVertex + kGrid / 2) >> kGridBits);
  return {bits, static_cast<std::int64_t>(c), static_cast<std::int64_t>(gx), static_cast<std::int64_t>(gy)};
}

}  // namespace xnewell
