#include "geometry/model/bezier.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <vector>

namespace xnewell {

namespace {

/// A parameter t with its complement s = 1 - t. The pairs (s, t) and (t, s) are the same place on a curve and
/// on the reversed curve.
struct Parameter {
  double s, t;
};

Parameter parameter(double t) { return {1.0 - t, t}; }

/// i / n together with (n - i) / n, which is rounded by itself: 1 - i / n may differ from it in the last bit.
Parameter fraction(int i, int n) { return {static_cast<double>(n - i) / n, static_cast<double>(i) / n}; }

/// A point of a cubic curve. Each term treats both ends alike, and the sum pairs the terms that reversal
/// exchanges, so reversal changes no bit. A coordinate that all control points share is kept exactly, because
/// the rounded weights need not sum to 1: a pole stays one point and a level ring stays level.
glm::dvec3 curvePoint(const glm::dvec3& p0, const glm::dvec3& p1, const glm::dvec3& p2, const glm::dvec3& p3,
                      Parameter at) {
  const auto [s, t] = at;
  const double b0 = s * s * s, b1 = 3.0 * (s * s * t);
  const double b2 = 3.0 * (t * t * s), b3 = t * t * t;
  glm::dvec3 sum = (b0 * p0 + b3 * p3) + (b1 * p1 + b2 * p2);
  for (int axis = 0; axis < 3; ++axis)
    if (p0[axis] == p1[axis] && p0[axis] == p2[axis] && p0[axis] == p3[axis]) sum[axis] = p0[axis];
  return sum;
}

glm::dvec3 surfacePoint(const BezierPatch& patch, Parameter u, Parameter v) {
  const auto& p = patch.p;
  const auto row = [&](int i) { return curvePoint(p[4 * i], p[4 * i + 1], p[4 * i + 2], p[4 * i + 3], v); };
  return curvePoint(row(0), row(1), row(2), row(3), u);
}

/// Polynomials in h, the distance from the given place; the constant term comes first.
using Scalars = std::array<double, 6>;
using Vectors = std::array<glm::dvec3, 6>;

Scalars product(const Scalars& a, const Scalars& b) {
  Scalars c{};
  for (int i = 0; i < 6; ++i)
    for (int j = 0; i + j < 6; ++j) c[i + j] += a[i] * b[j];
  return c;
}

/// The Bernstein polynomials of degree n <= 3 at t + direction h.
std::array<Scalars, 4> bernstein(int n, double t, double direction) {
  constexpr double kBinomial[4][4] = {{1}, {1, 1}, {1, 2, 1}, {1, 3, 3, 1}};
  const Scalars rising{t, direction}, falling{1.0 - t, -direction};
  std::array<Scalars, 4> b{};
  for (int i = 0; i <= n; ++i) {
    b[i] = {kBinomial[n][i]};
    for (int k = 0; k < n; ++k) b[i] = product(b[i], k < i ? rising : falling);
  }
  return b;
}

/// The differences of neighbouring control points, 3 by 4 along u and 4 by 3 along v, scaled by a power of
/// two.
struct Hodograph {
  /// u[4 * i + j] = p(i+1, j) - p(i, j); v[3 * i + j] = p(i, j+1) - p(i, j)
  std::array<glm::dvec3, 12> u, v;
  double smallest;  ///< du x dv / 9 vanishes if it is no longer than this
};

double largestLength(std::span<const glm::dvec3> vectors) {
  double square = 0.0;
  for (const glm::dvec3& v : vectors) square = std::max(square, glm::dot(v, v));
  return std::sqrt(square);
}

Hodograph hodograph(const BezierPatch& patch) {
  double largest = 0.0;
  for (const glm::dvec3& p : patch.p)
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  int exponent = 0;
  std::frexp(largest, &exponent);
  std::array<glm::dvec3, 16> p;  // |coordinates| <= 1, so that no product overflows
  for (int i = 0; i < 16; ++i)
    for (int axis = 0; axis < 3; ++axis) p[i][axis] = std::ldexp(patch.p[i][axis], -exponent);
  Hodograph d;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 4; ++j) {
      d.u[4 * i + j] = p[4 * (i + 1) + j] - p[4 * i + j];
      d.v[3 * j + i] = p[4 * j + i + 1] - p[4 * j + i];
    }
  d.smallest = 0x1p-40 * (largestLength(d.u) * largestLength(d.v));
  return d;
}

/// du x dv / 9 at (u, v). This is the first coefficient of productAlong(), at a fraction of its cost.
glm::dvec3 productAt(const Hodograph& d, Parameter u, Parameter v) {
  const auto quadratic = [](Parameter p) { return std::array{p.s * p.s, 2.0 * (p.s * p.t), p.t * p.t}; };
  const std::array u2 = quadratic(u), v2 = quadratic(v);
  glm::dvec3 du{0.0}, dv{0.0};
  for (int i = 0; i < 3; ++i) {
    du += u2[i] * curvePoint(d.u[4 * i], d.u[4 * i + 1], d.u[4 * i + 2], d.u[4 * i + 3], v);
    dv += v2[i] * curvePoint(d.v[i], d.v[3 + i], d.v[6 + i], d.v[9 + i], u);
  }
  return glm::cross(du, dv);
}

/// du x dv / 9 at (u, v) + direction h: the coefficients of h^0, h^1, ... up to h^10.
std::array<glm::dvec3, 11> productAlong(const Hodograph& d, glm::dvec2 at, glm::dvec2 direction) {
  const auto u2 = bernstein(2, at.x, direction.x), u3 = bernstein(3, at.x, direction.x);
  const auto v2 = bernstein(2, at.y, direction.y), v3 = bernstein(3, at.y, direction.y);
  Vectors du{}, dv{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 4; ++j) {
      const Scalars bu = product(u2[i], v3[j]), bv = product(u3[j], v2[i]);
      for (int k = 0; k < 6; ++k) {
        du[k] += bu[k] * d.u[4 * i + j];
        dv[k] += bv[k] * d.v[3 * j + i];
      }
    }
  std::array<glm::dvec3, 11> n{};
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) n[i + j] += glm::cross(du[i], dv[j]);
  return n;
}

/// Numbers points in the order in which they arrive; equal points get one number. It is a hash table with
/// linear probing, at most half full.
class PointTable {
 public:
  PointTable(std::vector<glm::dvec3>& points, std::size_t atMost)
      : points_{points}, slots_(std::bit_ceil(2 * atMost + 1), -1) {}

  int add(glm::dvec3 p) {
    p += 0.0;  // turns -0 into 0: they are equal but differ in their bits
    std::size_t slot = hash(p);
    for (;; ++slot) {
      int& number = slots_[slot & (slots_.size() - 1)];
      if (number < 0) {
        number = static_cast<int>(points_.size());
        points_.push_back(p);
      }
      if (points_[number] == p) return number;
    }
  }

 private:
  static std::size_t hash(const glm::dvec3& p) {
    constexpr std::uint64_t kGolden = 0x9E3779B97F4A7C15u;  // 2^64 / golden ratio
    std::uint64_t h = 0;
    for (int axis = 0; axis < 3; ++axis) {
      h = (h ^ std::bit_cast<std::uint64_t>(p[axis])) * kGolden;
      h ^= h >> 32;
    }
    return static_cast<std::size_t>((h * kGolden) >> 32);
  }

  std::vector<glm::dvec3>& points_;
  std::vector<int> slots_;
};

/// The corners of a quad that its face lists, as indices 0 to 3. It omits repeated neighbours, unless fewer
/// than three corners would be left; then it lists all.
struct Listed {
  std::array<int, 4> corners;
  int count;
};

/// A Place is a point or the number of a point.
template <typename Place>
Listed listedCorners(const std::array<Place, 4>& quad) {
  Listed listed{{}, 0};
  for (int i = 0; i < 4; ++i)
    if (quad[i] != quad[(i + 1) % 4]) listed.corners[listed.count++] = i;
  return listed.count >= 3 ? listed : Listed{{0, 1, 2, 3}, 4};
}

/// The places of a face's corners among the (n + 1)^2 points of a patch, row by row.
std::array<int, 4> quadOf(int row, int column, int n) {
  const int first = row * (n + 1) + column;
  return {first, first + n + 1, first + n + 2, first + 1};
}

glm::dvec3 normalAt(const Hodograph& d, Parameter u, Parameter v) {
  const auto lengthOf = [](const glm::dvec3& n) { return std::sqrt(glm::dot(n, n)); };
  const glm::dvec3 here = productAt(d, u, v);
  if (const double length = lengthOf(here); length > d.smallest) return here / length;
  glm::dvec2 inwards{0.5 - u.t, 0.5 - v.t};
  if (inwards == glm::dvec2{0.0}) inwards = glm::dvec2{0.5};
  const std::array along = productAlong(d, {u.t, v.t}, inwards);
  for (std::size_t k = 1; k < along.size(); ++k)
    if (const double length = lengthOf(along[k]); length > d.smallest) return along[k] / length;
  return glm::dvec3{0.0};
}

/// The cubic Bernstein polynomials at t, and their derivatives.
struct Weights {
  std::array<double, 4> value, slope;
};
Weights weights(double t) {
  const double s = 1.0 - t;
  return {{s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t},
          {-3.0 * s * s, 3.0 * s * (s - 2.0 * t), 3.0 * t * (2.0 * s - t), 3.0 * t * t}};
}

/// The way from a point of the surface to p, and the surface's derivatives there.
struct Way {
  glm::dvec3 to{0}, alongU{0}, alongV{0};
  [[nodiscard]] double square() const { return glm::dot(to, to); }
};
Way wayFrom(const BezierPatch& patch, glm::dvec2 uv, const glm::dvec3& p) {
  const Weights u = weights(uv.x), v = weights(uv.y);
  Way way;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      const glm::dvec3& control = patch.p[4 * i + j];
      way.to += u.value[i] * v.value[j] * (p - control);  // the weights sum to 1
      way.alongU += u.slope[i] * v.value[j] * control;
      way.alongV += u.value[i] * v.slope[j] * control;
    }
  return way;
}

}  // namespace

glm::dvec3 point(const BezierPatch& patch, double u, double v) {
  return surfacePoint(patch, parameter(u), parameter(v));
}

glm::dvec3 normal(const BezierPatch& patch, double u, double v) {
  return normalAt(hodograph(patch), parameter(u), parameter(v));
}

Mesh tessellate(std::span<const BezierPatch> patches, int divisions, std::span<const PatchPart> parts) {
  assert(1 <= divisions && divisions <= kMaxDivisions);
  assert(patches.size() <= static_cast<std::size_t>(INT32_MAX / (divisions * divisions)));
  const int n = divisions;
  Mesh mesh;
  PointTable table{mesh.points, patches.size() * (n + 1) * (n + 1)};
  std::vector<int> partOf;
  for (const PatchPart& part : parts) {
    partOf.insert(partOf.end(), part.patches, static_cast<int>(mesh.groupNames.size()));
    mesh.groupNames.emplace_back(part.name);
  }
  if (parts.empty()) {
    partOf.assign(patches.size(), 0);
    mesh.groupNames.emplace_back();
  }
  assert(partOf.size() == patches.size());
  const std::size_t faces = patches.size() * n * n;
  mesh.corners.reserve(4 * faces);
  mesh.uvOfCorner.reserve(4 * faces);
  mesh.firstCorner.reserve(faces + 1);
  mesh.group.reserve(faces);
  mesh.material.reserve(faces);
  std::vector<int> grid;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) mesh.uv.emplace_back(fraction(i, n).t, fraction(j, n).t);
  for (std::size_t k = 0; k < patches.size(); ++k) {
    grid.clear();
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n; ++j)
        grid.push_back(table.add(surfacePoint(patches[k], fraction(i, n), fraction(j, n))));
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const std::array quad = quadOf(i, j, n);
        const auto [listed, count] =
            listedCorners(std::array{grid[quad[0]], grid[quad[1]], grid[quad[2]], grid[quad[3]]});
        std::array<int, 4> corners, uv;
        for (int c = 0; c < count; ++c) {
          uv[c] = quad[listed[c]];
          corners[c] = grid[uv[c]];
        }
        const auto size = static_cast<std::size_t>(count);
        mesh.addFace({corners.data(), size}, partOf[k], -1, {uv.data(), size});
      }
  }
  return mesh;
}

std::vector<glm::dvec3> cornerNormals(std::span<const BezierPatch> patches, int divisions) {
  assert(1 <= divisions && divisions <= kMaxDivisions);
  const int n = divisions;
  std::vector<glm::dvec3> normals, points, grid;
  normals.reserve(patches.size() * 4 * n * n);
  for (const BezierPatch& patch : patches) {
    points.clear(), grid.clear();
    const Hodograph d = hodograph(patch);
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n; ++j) {
        points.push_back(surfacePoint(patch, fraction(i, n), fraction(j, n)));
        grid.push_back(normalAt(d, fraction(i, n), fraction(j, n)));
      }
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const std::array quad = quadOf(i, j, n);
        const auto [listed, count] =
            listedCorners(std::array{points[quad[0]], points[quad[1]], points[quad[2]], points[quad[3]]});
        for (int c = 0; c < count; ++c) normals.push_back(grid[quad[listed[c]]]);
      }
  }
  return normals;
}

double distanceFrom(const BezierPatch& patch, const glm::dvec3& p, glm::dvec2 uv) {
  constexpr int kSteps = 20, kHalvings = 10;
  Way way = wayFrom(patch, uv, p);
  for (int step = 0; step < kSteps; ++step) {
    const double uu = glm::dot(way.alongU, way.alongU), vv = glm::dot(way.alongV, way.alongV);
    const double uvs = glm::dot(way.alongU, way.alongV);
    const double damping = 0x1p-40 * (uu + vv);  // where a derivative vanishes
    const double a = uu + damping, b = vv + damping, determinant = a * b - uvs * uvs;
    if (!(determinant > 0.0)) break;
    const double byU = glm::dot(way.alongU, way.to), byV = glm::dot(way.alongV, way.to);
    glm::dvec2 move{(b * byU - uvs * byV) / determinant, (a * byV - uvs * byU) / determinant};
    bool nearer = false;
    for (int half = 0; half < kHalvings && !nearer; ++half, move *= 0.5) {
      const glm::dvec2 next = glm::clamp(uv + move, 0.0, 1.0);
      const Way there = wayFrom(patch, next, p);
      if (!(there.square() < way.square())) continue;
      nearer = true;
      uv = next, way = there;
    }
    if (!nearer || std::max(std::abs(move.x), std::abs(move.y)) < 0x1p-40) break;
  }
  return std::sqrt(way.square());
}

}  // namespace xnewell
