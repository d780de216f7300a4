#pragma once

#include "shading/fill/lanes.h"
#include "tests/kernels/kernel.h"

namespace xnewell {

/// Adds a unit vector along three numbers of an input, in doubles. False if they are too short or too long
/// for the square of their length.
inline bool addUnit(Numbers& to, const double* v) {
  const double square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
  if (!(square > 1e-200 && square < 1e200)) return false;
  for (int k = 0; k < 3; ++k) to.push_back(v[k] / std::sqrt(square));
  return true;
}
inline void addUnit(Numbers& to, Random& random) {
  Numbers v;
  do {
    v = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
  } while (v[0] * v[0] + v[1] * v[1] + v[2] * v[2] < 0.01);
  addUnit(to, v.data());
}
/// A unit vector near another, or near its opposite.
inline void addNear(Numbers& to, const double* other, Random& random) {
  const double sign = random.sign(), off = random.power(-60, 0);
  double v[3];
  for (int k = 0; k < 3; ++k) v[k] = sign * other[k] + off * random.uniform(-1, 1);
  if (!addUnit(to, v)) addUnit(to, random);
}

inline std::vector<Coordinate> threeVectors() { return std::vector<Coordinate>(9, doubles(-1, 1)); }

template <class Real>
Vec<Real> vecOf(const double* v) {
  return {static_cast<Real>(v[0]), static_cast<Real>(v[1]), static_cast<Real>(v[2])};
}
inline glm::dvec3 glmOf(const double* v) { return {v[0], v[1], v[2]}; }

}  // namespace xnewell
