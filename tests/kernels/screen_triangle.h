#pragma once

#include "geometry/exact/int128.h"
#include "geometry/view/project.h"
#include "tests/kernels/big.h"
#include "tests/kernels/kernel.h"

namespace xnewell {

/// |x|, |y| on the grid.
inline constexpr double kGridReach = 0x1p29;

/// A triangle on the screen, then where in it: two shares of its edges. Prepared: the triangle, turned
/// counter-clockwise, then the pixel whose centre is in it.
inline constexpr std::size_t kPlace = 6, kPixel = 6, kOthers = 8;
inline std::vector<Coordinate> triangleInput() {
  std::vector<Coordinate> input(6, integers(-kGridReach, kGridReach));
  input.push_back(doubles(0, 1));
  input.push_back(doubles(0, 1));
  return input;
}
inline std::array<glm::ivec3, 3> triangleOf(const Numbers& in) {
  std::array<glm::ivec3, 3> p;
  for (int k = 0; k < 3; ++k) p[k] = {static_cast<int>(in[2 * k]), static_cast<int>(in[2 * k + 1]), 0};
  return p;
}
inline Numbers preparedTriangle(const Numbers& in) {
  Numbers v = in;
  std::array<glm::ivec3, 3> p = triangleOf(v);
  const std::int64_t area = doubleArea(p.data(), 3);
  if (area == 0) return {};
  if (area < 0) {
    std::swap(v[2], v[4]), std::swap(v[3], v[5]);
    p = triangleOf(v);
  }
  double a = in[kPlace], b = in[kPlace + 1];
  if (a + b > 1) a = 1 - a, b = 1 - b;
  const auto pixel = [&](int axis) {
    const double from = v[axis], at = from + a * (v[2 + axis] - from) + b * (v[4 + axis] - from);
    return std::clamp(std::floor(at / kGrid), 0.0, kMaxPicture - 1.0);
  };
  v[kPixel] = pixel(0), v[kPixel + 1] = pixel(1);
  for (int k = 0; k < 3; ++k) {
    const glm::ivec3 &from = p[k], &to = p[(k + 1) % 3];
    const Int128 x = Int128{static_cast<int>(v[kPixel])} * kGrid + kGrid / 2,
                 y = Int128{static_cast<int>(v[kPixel + 1])} * kGrid + kGrid / 2;
    if ((to.y - from.y) * (x - from.x) - (to.x - from.x) * (y - from.y) < 0) return {};
  }
  return v;
}
inline Numbers randomTriangle(Random& random) {
  Numbers in;
  const double size = random.oneIn(3) ? 0x1p29 : random.power(10, 29);
  const double x = random.uniform(0, 0x1p29), y = random.uniform(0, 0x1p29);
  for (int k = 0; k < 3; ++k) {
    in.push_back(std::clamp(std::round(x + size * random.uniform(-1, 1)), -kGridReach, kGridReach));
    in.push_back(std::clamp(std::round(y + size * random.uniform(-1, 1)), -kGridReach, kGridReach));
  }
  if (random.oneIn(3)) {  // a needle: a corner near the line through the others
    const double t = random.uniform(0, 1), off = random.power(0, 20);
    for (int axis = 0; axis < 2; ++axis)
      in[4 + axis] =
          std::clamp(std::round(in[axis] + t * (in[2 + axis] - in[axis]) + off * random.uniform(-1, 1)),
                     -kGridReach, kGridReach);
  }
  for (int k = 0; k < 2; ++k) in.push_back(random.oneIn(3) ? random.power(-40, 0) : random.uniform(0, 1));
  return in;
}
/// The exact weights of the corners at the centre of the pixel.
inline std::array<Big, 3> weightsAt(const Numbers& in) {
  const Big x = big(in[kPixel]) * kGrid + kGrid / 2, y = big(in[kPixel + 1]) * kGrid + kGrid / 2;
  std::array<Big, 3> w;
  Big sum = 0;
  for (int k = 0; k < 3; ++k) {
    const std::size_t a = 2 * ((k + 1) % 3), b = 2 * ((k + 2) % 3);
    w[k] = (big(in[b]) - x) * (big(in[a + 1]) - y) - (big(in[a]) - x) * (big(in[b + 1]) - y);
    sum += w[k];
  }
  for (Big& weight : w) weight /= sum;
  return w;
}
inline Big mean(const std::array<Big, 3>& weights, const double* v) {
  return weights[0] * big(v[0]) + weights[1] * big(v[1]) + weights[2] * big(v[2]);
}
/// (largest x - least x, largest y - least y), in pixels.
inline std::array<double, 2> extentOf(const Numbers& in) {
  const auto [left, right] = std::minmax({in[0], in[2], in[4]});
  const auto [top, bottom] = std::minmax({in[1], in[3], in[5]});
  return {(right - left) / kGrid, (bottom - top) / kGrid};
}

}  // namespace xnewell
