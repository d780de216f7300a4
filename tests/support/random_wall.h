#pragma once

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <random>
#include <vector>

#include "geometry/exact/scale.h"
#include "geometry/model/mesh.h"

namespace xnewell {

/// The numbers of decimals with which scenes about 1 in size are written; 0 for exactly.
inline constexpr std::array kDecimals{6, 9, 0};

/// A rectangle somewhere in space. A point of its plane is corner + s a + t b, with s and t from 0 to 1 in
/// the rectangle.
struct Frame {
  glm::dvec3 corner, a, b, N;
  [[nodiscard]] glm::dvec3 at(double s, double t) const { return corner + s * a + t * b; }
};

/// A rectangle about 1 long and half to once as high, within 2 of the origin.
inline Frame randomFrame(std::mt19937& rng) {
  std::uniform_real_distribution<double> component{-1.0, 1.0};
  const auto direction = [&] {
    for (;;) {
      const glm::dvec3 v{component(rng), component(rng), component(rng)};
      const double length = glm::length(v);
      if (length > 0.1 && length < 1.0) return v / length;
    }
  };
  const glm::dvec3 a = direction(), N = glm::normalize(glm::cross(a, direction()));
  return {0.5 * direction(), a, (0.75 + 0.25 * component(rng)) * glm::cross(N, a), N};
}

/// Adds a face of group 0 with its own corners, rounded to `decimals` decimals as in a file.
inline void addRounded(Mesh& mesh, const std::vector<glm::dvec3>& corners, int decimals) {
  const double unit = std::pow(10.0, decimals);
  std::vector<int> face;
  for (glm::dvec3 p : corners) {
    if (decimals > 0)
      for (int axis = 0; axis < 3; ++axis) p[axis] = std::nearbyint(p[axis] * unit) / unit;
    face.push_back(static_cast<int>(mesh.points.size()));
    mesh.points.push_back(p);
  }
  mesh.addFace(face, 0);
  if (decimals > 0) mesh.rounding = {0.5 / unit};
}

/// A wall, then four decals in its plane. The decals are 1/8 to 1/2 of its length and turned any way. Each
/// lies partly over the one before it, and the last reaches over the wall's edge. Some are listed clockwise.
/// seed % 3 selects the decimals.
inline Mesh wallWithDecals(unsigned seed) {
  std::mt19937 rng{seed};
  std::uniform_real_distribution<double> unit{0.0, 1.0};
  const Frame wall = randomFrame(rng);
  const int decimals = kDecimals[seed % kDecimals.size()];
  Mesh mesh;
  mesh.groupNames = {""};
  addRounded(mesh, {wall.at(0, 0), wall.at(1, 0), wall.at(1, 1), wall.at(0, 1)}, decimals);
  glm::dvec3 centre = wall.at(0.4 + 0.2 * unit(rng), 0.4 + 0.2 * unit(rng));
  for (int k = 0; k < 4; ++k) {
    const double angle = 6.3 * unit(rng), size = k == 0 ? 0.25 : 0.08 + 0.1 * unit(rng);
    const glm::dvec3 up = glm::cross(wall.N, wall.a);
    const glm::dvec3 e = std::cos(angle) * wall.a + std::sin(angle) * up, f = glm::cross(wall.N, e);
    std::vector<glm::dvec3> corners{centre - size * e, centre + size * f, centre + size * e,
                                    centre - size * f};
    if (unit(rng) < 0.5) corners = {corners[3], corners[2], corners[1], corners[0]};
    addRounded(mesh, corners, decimals);
    centre = k == 2 ? wall.at(1.0, 0.3 + 0.4 * unit(rng)) : centre + 0.6 * size * e;
  }
  return mesh;
}

}  // namespace xnewell
