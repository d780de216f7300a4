#include "geometry/model/divide.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>
#include <tuple>
#include <utility>

#include "geometry/exact/box.h"
#include "geometry/exact/plane.h"
#include "geometry/exact/scale.h"
#include "geometry/model/coplanar.h"
#include "geometry/model/ear_clip.h"

namespace xnewell {

namespace {

constexpr int kDivisionGridBits = 50;

/// One face, prepared for the decisions. Its memory serves the next face, too.
struct Outline {
  std::vector<int> turns;          ///< the corners that are not in the middle of a straight side
  std::vector<LatticePoint> grid;  ///< these, counter-clockwise
  bool planar = false;
  bool hasArea = false;
  std::vector<glm::dvec3> p;  ///< buffers of outlineOf()
  std::vector<int> all;
  std::vector<RoundedPoint> points;
};

/// Sets `corners` to a face's corners, as indices into Mesh::corners. A corner at the same place as the one
/// before it is left out.
void collapse(const Mesh& mesh, int face, std::vector<int>& corners) {
  const auto at = [&](int corner) { return mesh.points[mesh.corners[corner]]; };
  corners.clear();
  for (int c = mesh.firstCorner[face]; c < mesh.firstCorner[face + 1]; ++c)
    if (corners.empty() || at(c) != at(corners.back())) corners.push_back(c);
  while (corners.size() > 1 && at(corners.back()) == at(corners.front())) corners.pop_back();
}

/// True if the way from a over b to c is straight, or runs back on itself, within `width`.
bool inLine(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, double width) {
  const glm::dvec3 out = b - a, on = c - b;
  return glm::length(glm::cross(out, on)) <= width * std::max(glm::length(out), glm::length(on));
}

/// Leaves out the corners from which the outline runs back on itself, within `width`: the edges there cover
/// nothing. Where it is back at the same place, the later corner goes, too.
void dropSpikes(std::vector<glm::dvec3>& p, std::vector<int>& corners, double width) {
  const auto isTip = [&](std::size_t a, std::size_t b, std::size_t c) {
    if (glm::dot(p[b] - p[a], p[c] - p[b]) >= 0.0) return p[b] == p[c];
    return inLine(p[a], p[b], p[c], width);
  };
  std::size_t first = 0, end = 0;  // what is left
  for (std::size_t k = 0; k < p.size(); ++k) {
    p[end] = p[k], corners[end++] = corners[k];
    while (end > 2 && isTip(end - 3, end - 2, end - 1)) {
      p[end - 2] = p[end - 1], corners[end - 2] = corners[end - 1];
      end -= p[end - 3] == p[end - 1] ? 2 : 1;
    }
  }
  while (end - first > 2 && (isTip(end - 2, end - 1, first) || isTip(end - 1, first, first + 1)))
    isTip(end - 2, end - 1, first) ? --end : ++first;
  const auto keep = [&](auto& list) {
    list.resize(end);
    list.erase(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(first));
  };
  keep(p), keep(corners);
}

/// Finds Outline::turns; all corners if fewer than three turn. Each edge is compared with the last corner
/// that turns, so what a round side turns adds up.
void findTurns(const std::vector<glm::dvec3>& p, double width, std::vector<int>& turns) {
  const auto leftmost = std::ranges::min_element(p, [](const glm::dvec3& a, const glm::dvec3& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  });
  const auto first = static_cast<int>(leftmost - p.begin()), n = static_cast<int>(p.size());
  turns.assign(1, first);
  for (int k = first + 1; k < first + n; ++k)
    if (!inLine(p[turns.back()], p[k % n], p[(k + 1) % n], width)) turns.push_back(k % n);
  if (turns.size() < 3) {
    turns.resize(p.size());
    std::iota(turns.begin(), turns.end(), 0);
  }
  std::ranges::sort(turns);
}

/// The perimeter / the area; infinite without area.
double steepnessOf(std::span<const glm::dvec3> p) {
  glm::dvec3 area{0.0};  // doubled
  double perimeter = 0.0;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const glm::dvec3 a = p[k] - p[0], b = p[k + 1 == p.size() ? 0 : k + 1] - p[0];
    area += glm::cross(a, b);
    perimeter += glm::length(b - a);
  }
  return 2.0 * perimeter / glm::length(area);
}

/// Takes the spikes from the corners, too.
void outlineOf(const Mesh& mesh, std::vector<int>& corners, double rounding, Outline& outline) {
  const auto at = [&](int corner) { return mesh.points[mesh.corners[corner]]; };
  // Scale by a power of two first, so that differences do not overflow. Then move the box to the origin and
  // scale again, so that the box is 2^49 to 2^50 steps long.
  double magnitude = 0.0;
  for (const int c : corners) magnitude = std::max(magnitude, largest(glm::abs(at(c))));
  int exponent = 0, boxExponent = 0;
  magnitude = std::frexp(magnitude, &exponent);
  auto& [turns, grid, planar, hasArea, p, all, points] = outline;
  planar = hasArea = false;
  p.clear(), points.clear(), grid.clear();
  for (const int c : corners) p.push_back(scaled(at(c), -exponent));
  const Box box = boxOf(p);
  const double extent = std::frexp(box.side(), &boxExponent);
  const int steps = kDivisionGridBits - boxExponent;
  for (glm::dvec3& q : p) q = scaled(q - box.low, steps);

  const double e = std::ldexp(extent, kDivisionGridBits), u = std::ldexp(rounding, steps - exponent);
  const Rounding bound{e, std::ldexp(magnitude, steps)};
  dropSpikes(p, corners, bound.arithmetic());

  if (p.size() < 3) return;
  all.resize(p.size());
  std::iota(all.begin(), all.end(), 0);
  const Plane plane = newellPlane(p, all);
  for (const glm::dvec3& q : p) points.push_back({q, u});
  // Most bent faces are known without a fit: a corner is further off than any rounding can explain.
  const double rho = bound.most(u), steepness = steepnessOf(p);
  const glm::dvec3 mean =
      std::accumulate(p.begin(), p.end(), glm::dvec3{0.0}) / static_cast<double>(p.size());
  const bool bent = std::ranges::any_of(p, [&](const glm::dvec3& q) {
    return std::abs(glm::dot(plane.N, q) - plane.d) >
           Rounding::mostOff(rho, steepness, glm::length(q - mean));
  });
  planar = !bent && fitPlane(points, plane, bound, FitGoal::Explain).explains();

  const glm::dvec3 N = glm::abs(plane.N);
  const int dropped = N.z >= N.x && N.z >= N.y ? 2 : N.y >= N.x ? 1 : 0;
  const auto nearest = [](double x) { return static_cast<std::int64_t>(x + 0.5); };
  findTurns(p, bound.arithmetic(), turns);
  for (const int k : turns)
    grid.push_back({nearest(p[k][(dropped + 1) % 3]), nearest(p[k][(dropped + 2) % 3])});
  Int128 area = 0;
  for (std::size_t i = 2; i < grid.size(); ++i) area += turn(grid[0], grid[i - 1], grid[i]);
  if (area < 0)
    for (LatticePoint& q : grid) std::swap(q.x, q.y);
  hasArea = area != 0;
}

/// True if the polygon is weakly convex: it has no right turn and goes round once. It goes round once if its
/// edges form only one run that points to the right (or straight up) and one run to the left.
bool isConvex(std::span<const LatticePoint> p) {
  const std::size_t n = p.size();
  const auto pointsRight = [&](std::size_t i) {
    const LatticePoint &a = p[i % n], &b = p[(i + 1) % n];
    return b.x > a.x || (b.x == a.x && b.y > a.y);
  };
  int runs = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (turn(p[i], p[(i + 1) % n], p[(i + 2) % n]) < 0) return false;
    runs += pointsRight(i) != pointsRight(i + 1);
  }
  return runs == 2;
}

/// Cuts a quadrilateral into two triangles: along 0-2 if both turn left there, or if 1-3 is no better.
std::array<std::array<int, 3>, 2> cutQuad(std::span<const LatticePoint> p) {
  const auto worst = [&](int a, int b, int c, int d) {
    return std::min(turn(p[a], p[b], p[c]), turn(p[a], p[c], p[d]));
  };
  if (worst(0, 1, 2, 3) <= 0 && worst(1, 2, 3, 0) > 0) return {{{1, 2, 3}, {1, 3, 0}}};
  return {{{0, 1, 2}, {0, 2, 3}}};
}

void addPart(ConvexParts& parts, const Mesh& mesh, std::span<const int> corners, int face,
             bool planeOfTheLast = false) {
  const int planes = parts.plane.empty() ? 0 : parts.plane.back() + 1;
  parts.plane.push_back(planeOfTheLast ? planes - 1 : planes);
  for (const int c : corners) parts.corners.push_back(mesh.corners[c]);
  parts.from.insert(parts.from.end(), corners.begin(), corners.end());
  parts.firstCorner.push_back(static_cast<int>(parts.corners.size()));
  parts.face.push_back(face);
}

}  // namespace

ConvexParts divideFaces(const Mesh& mesh) {
  ConvexParts parts;
  parts.corners.reserve(mesh.corners.size());
  parts.from.reserve(mesh.corners.size());
  parts.firstCorner.reserve(mesh.firstCorner.size());
  parts.face.reserve(mesh.firstCorner.size());
  parts.plane.reserve(mesh.firstCorner.size());
  std::vector<int> corners, part;
  Outline outline;
  for (int f = 0; f < mesh.faceCount(); ++f) {
    collapse(mesh, f, corners);
    outline.hasArea = false;
    if (corners.size() > 3) outlineOf(mesh, corners, mesh.roundingOf(f), outline);
    if (corners.size() < 3) {
      corners.resize(mesh.face(f).size());
      std::iota(corners.begin(), corners.end(), mesh.firstCorner[f]);
    }
    if (!outline.hasArea || (outline.planar && isConvex(outline.grid))) {
      addPart(parts, mesh, corners, f);
      continue;
    }
    bool later = false;
    const auto addTriangles = [&](const auto& triangles) {
      for (const std::array<int, 3>& triangle : triangles) {
        part.clear();
        for (int k = 0; k < 3; ++k) {
          const int from = triangle[k], next = (from + 1) % static_cast<int>(outline.turns.size());
          part.push_back(corners[outline.turns[from]]);
          if (triangle[(k + 1) % 3] != next) continue;
          // A side of the face keeps the corners in the middle of it.
          const auto n = static_cast<int>(corners.size());
          for (int c = (outline.turns[from] + 1) % n; c != outline.turns[next]; c = (c + 1) % n)
            part.push_back(corners[c]);
        }
        addPart(parts, mesh, part, f, std::exchange(later, true) && outline.planar);
      }
    };
    if (outline.grid.size() == 4)
      addTriangles(cutQuad(outline.grid));
    else
      addTriangles(clipEars(outline.grid));
  }
  return parts;
}

bool crossesItself(const Mesh& mesh, int face) {
  constexpr std::size_t kMost = 100;
  constexpr double kRounded = 0x1p-40;
  const std::span<const int> corners = mesh.face(face);
  const std::size_t n = corners.size();
  if (n < 4 || n > kMost) return false;
  std::vector<glm::dvec3> p;
  for (const int corner : corners) p.push_back(mesh.points[corner] - mesh.points[corners[0]]);
  glm::dvec3 area{0.0};
  double longest = 0.0;
  for (std::size_t k = 1; k < n; ++k) {
    area += glm::cross(p[k - 1], p[k]);
    longest = std::max(longest, glm::dot(p[k], p[k]));
  }
  const double least = kRounded * longest;
  const glm::dvec3 N = glm::abs(area);
  for (int axis = 0; axis < 3; ++axis) {
    if (largest(N) > least && N[axis] < largest(N)) continue;
    const auto side = [&](std::size_t a, std::size_t b, std::size_t c) {
      const glm::dvec3 along = p[b] - p[a], to = p[c] - p[a];
      const int x = (axis + 1) % 3, y = (axis + 2) % 3;
      const double turn = along[x] * to[y] - along[y] * to[x];
      return turn > least ? 1 : turn < -least ? -1 : 0;
    };
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t k = i + 2; k < n; ++k) {
        const std::size_t next = (k + 1) % n;
        if (side(i, i + 1, k) * side(i, i + 1, next) < 0 && side(k, next, i) * side(k, next, i + 1) < 0)
          return true;
      }
  }
  return false;
}

}  // namespace xnewell
