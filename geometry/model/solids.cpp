#include "geometry/model/solids.h"

#include <array>

#include "geometry/exact/scale.h"
#include "geometry/exact/trig.h"

namespace xnewell {

namespace {

Mesh emptyMesh(const char* name) {
  Mesh mesh;
  mesh.groupNames = {name};
  return mesh;
}

}  // namespace

Mesh cube() {
  Mesh mesh = emptyMesh("cube");
  for (int i = 0; i < 8; ++i) mesh.points.push_back({i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1});
  mesh.uv = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  // The face's first or last corner has the texture coordinates (0, 0).
  constexpr std::array kFromFirst{0, 1, 2, 3}, kFromLast{1, 2, 3, 0};
  mesh.addFace(std::array{0, 4, 6, 2}, 0, -1, kFromLast);
  mesh.addFace(std::array{1, 3, 7, 5}, 0, -1, kFromFirst);
  mesh.addFace(std::array{0, 1, 5, 4}, 0, -1, kFromFirst);
  mesh.addFace(std::array{2, 6, 7, 3}, 0, -1, kFromLast);
  mesh.addFace(std::array{0, 2, 3, 1}, 0, -1, kFromLast);
  mesh.addFace(std::array{4, 5, 7, 6}, 0, -1, kFromFirst);
  return mesh;
}

Mesh sphere(int around, int down) {
  Mesh mesh = emptyMesh("sphere");
  mesh.points.push_back({0, 0, 1});
  for (int j = 1; j < down; ++j)
    for (int i = 0; i < around; ++i) {
      const auto [r, z] = sinCosDegrees(180.0 * j / down);
      const auto [y, x] = sinCosDegrees(360.0 * i / around);
      mesh.points.push_back({r * x, r * y, z});
    }
  mesh.points.push_back({0, 0, -1});
  const int south = static_cast<int>(mesh.points.size()) - 1;
  for (int j = 0; j <= down; ++j)
    for (int i = 0; i <= around; ++i) {
      const double u = j == 0 || j == down ? i + 0.5 : i;
      mesh.uv.emplace_back(u / around, static_cast<double>(down - j) / down);
    }
  const auto at = [&](int i, int j) { return 1 + (j - 1) * around + i % around; };
  const auto uv = [&](int i, int j) { return j * (around + 1) + i; };
  for (int j = 0; j < down; ++j)
    for (int i = 0; i < around; ++i) {
      if (j == 0)
        mesh.addFace(std::array{0, at(i, 1), at(i + 1, 1)}, 0, -1,
                     std::array{uv(i, 0), uv(i, 1), uv(i + 1, 1)});
      else if (j == down - 1)
        mesh.addFace(std::array{at(i, j), south, at(i + 1, j)}, 0, -1,
                     std::array{uv(i, j), uv(i, down), uv(i + 1, j)});
      else
        mesh.addFace(std::array{at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)}, 0, -1,
                     std::array{uv(i, j), uv(i, j + 1), uv(i + 1, j + 1), uv(i + 1, j)});
    }
  return mesh;
}

Mesh torus(int around, int across) {
  Mesh mesh = emptyMesh("torus");
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const auto [y, x] = sinCosDegrees(360.0 * i / around);
      const auto [up, out] = sinCosDegrees(360.0 * j / across);
      const double r = 1.0 + 0.4 * out;
      mesh.points.push_back({r * x, r * y, 0.4 * up});
    }
  for (int i = 0; i <= around; ++i)
    for (int j = 0; j <= across; ++j)
      mesh.uv.emplace_back(static_cast<double>(i) / around, static_cast<double>(j) / across);
  const auto at = [&](int i, int j) { return i % around * across + j % across; };
  const auto uv = [&](int i, int j) { return i * (across + 1) + j; };
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j)
      mesh.addFace(std::array{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}, 0, -1,
                   std::array{uv(i, j), uv(i + 1, j), uv(i + 1, j + 1), uv(i, j + 1)});
  return mesh;
}

glm::dvec3 outward(RoundSolid solid, const glm::dvec3& p) {
  if (solid == RoundSolid::Sphere) return p;
  const glm::dvec3 towards = unit({p.x, p.y, 0.0});
  return towards == glm::dvec3{0.0} ? towards : p - towards;
}

}  // namespace xnewell
