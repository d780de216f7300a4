#pragma once

#include <array>
#include <random>

#include "geometry/project.h"

/// Triangles of one kind: anywhere, on a lattice of pixel centres and corners with few depths, at the limits
/// of the grid, needles, near-coplanar by one step, exactly coplanar, and planes that
/// meet in a row of samples.
inline SnappedScene randomScene(unsigned seed, int count, int size) {
  std::mt19937 rng{seed};
  const auto uniform = [&](int low, int high) { return std::uniform_int_distribution{low, high}(rng); };
  SnappedScene scene;
  const unsigned kind = seed % 7;
  int slope = 0;  // of this triangle, kind 6
  const auto vertex = [&]() -> glm::ivec3 {
    switch (kind) {
      case 0:
        return {uniform(0, size * kGrid), uniform(0, size * kGrid), uniform(0, 1 << 24)};
      case 1:
        return {uniform(0, 2 * size) * kGrid / 2, uniform(0, 2 * size) * kGrid / 2, uniform(0, 3)};
      case 2:
        return {uniform(-(1 << 29), 1 << 29), uniform(-(1 << 29), 1 << 29), uniform(0, 1 << 30)};
      case 3:
        return {uniform(0, size * kGrid), size * kGrid / 2 + uniform(-kGrid, kGrid), uniform(0, 1 << 20)};
      case 6: {  // all these planes meet in one row of pixel centres, where only the slope along y differs
        const int row = uniform(0, size);
        return {uniform(0, size * kGrid), row * kGrid + kGrid / 2, (1 << 20) + slope * (row - size / 2)};
      }
      default: {
        const int x = uniform(0, size) * kGrid + kGrid / 2, y = uniform(0, size) * kGrid + kGrid / 2;
        return {x, y, (x + y) / 4 + (1 << 20) + (kind == 4 ? uniform(-1, 1) : 0)};
      }
    }
  };
  while (static_cast<int>(scene.faces.size()) < count) {
    slope = uniform(-2, 2);
    std::array<glm::ivec3, 3> t{vertex(), vertex(), vertex()};
    const std::int64_t area = doubleArea(t.data(), 3);
    if (area == 0) continue;
    if (area < 0) std::swap(t[1], t[2]);
    scene.faces.push_back({static_cast<int>(scene.vertices.size()), 3, static_cast<int>(scene.faces.size()),
                           false, static_cast<int>(scene.faces.size()), 0});
    scene.planes.push_back(planeThrough(t.data(), 3));
    scene.vertices.insert(scene.vertices.end(), t.begin(), t.end());
  }
  return scene;
}
