#include "geometry/exact/scale.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace xnewell {

glm::dvec3 unit(glm::dvec3 v) {
  // In this range no square that matters overflows or underflows. Scaling by a power of two, as below, would
  // not change a bit.
  const double square = glm::dot(v, v);
  if (square > 0x1p-900 && square < 0x1p900) return v / std::sqrt(square);
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (!(largest > 0.0) || v - v != glm::dvec3{0.0}) return glm::dvec3{0.0};
  int exponent = 0;
  std::frexp(largest, &exponent);
  const glm::dvec3 w{std::ldexp(v.x, -exponent), std::ldexp(v.y, -exponent), std::ldexp(v.z, -exponent)};
  return w / std::sqrt(glm::dot(w, w));
}

}  // namespace xnewell
