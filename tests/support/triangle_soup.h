#pragma once

#include <array>
#include <cstdint>

#include "geometry/model/mesh.h"

namespace xnewell {

/// The generator splitmix64. The standard generators are portable, but the standard distributions are not.
/// @see Steele, Lea & Flood 2014
class SplitMix {
 public:
  explicit SplitMix(std::uint64_t seed) : state_{seed} {}
  /// A multiple of 2^-52 in [-1, 1).
  double next() {
    std::uint64_t z = state_ += 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-52 - 1.0;
  }
  glm::dvec3 nextVector() {
    // separate statements: the evaluation order of arguments is not fixed
    const double x = next(), y = next();
    return {x, y, next()};
  }

 private:
  std::uint64_t state_;
};

/// `count` triangles, scattered. Their centres are in the cube |x|, |y|, |z| <= 1, and each coordinate of a
/// corner is within `size` of its centre's. A seed gives the same triangles on every machine.
[[nodiscard]] inline Mesh triangleSoup(int count, double size, std::uint64_t seed) {
  Mesh mesh;
  mesh.groupNames = {"soup"};
  SplitMix random{seed};
  for (int f = 0; f < count; ++f) {
    const glm::dvec3 centre = random.nextVector();
    for (int i = 0; i < 3; ++i) mesh.points.push_back(centre + size * random.nextVector());
    mesh.addFace(std::array{3 * f, 3 * f + 1, 3 * f + 2}, 0);
  }
  return mesh;
}

}  // namespace xnewell
