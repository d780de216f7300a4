#pragma once

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <vector>

#include "depthsort/depth_sort.h"

namespace xnewell {

/// Convex regions of the screen as polygons with rational corners, computed in the plain way. Nothing is
/// filtered or rounded, and no line of depthsort/region.h is used. It is slow; it checks the quick way.

using Rational = boost::multiprecision::cpp_rational;

/// The line a x + b y + c = 0, in grid steps.
struct ExactLine {
  Rational a, b, c;
};
struct ExactPoint {
  Rational x, y;
};
[[nodiscard]] Rational valueAt(const ExactLine& line, const ExactPoint& p);

/// The line of the outline's edge from p to q. It is positive inside.
[[nodiscard]] ExactLine exactEdge(const glm::ivec3& p, const glm::ivec3& q);
/// zP - zQ, in depth steps.
[[nodiscard]] ExactLine exactDifference(const ScreenPlane& P, const ScreenPlane& Q);
[[nodiscard]] bool samePlane(const ScreenPlane& P, const ScreenPlane& Q);

/// Counter-clockwise as seen on the screen; empty if there is no area.
using ExactRegion = std::vector<ExactPoint>;

[[nodiscard]] ExactRegion exactOutline(const SnappedScene& scene, const SnappedFace& face);
/// The part of the face's outline inside all cuts of its piece.
[[nodiscard]] ExactRegion exactFragment(const SnappedScene& scene, const SortedScene& sorted,
                                        const Fragment& fragment);
/// The part of the region where the line is positive.
[[nodiscard]] ExactRegion clipped(const ExactRegion& region, const ExactLine& line);
[[nodiscard]] ExactRegion common(ExactRegion region, const ExactRegion& other);
/// The part of the region inside an area.
[[nodiscard]] ExactRegion within(ExactRegion region, const PixelArea& area);

[[nodiscard]] Rational exactDoubleArea(const ExactRegion& region);
/// The greatest value of a line in the region.
[[nodiscard]] Rational greatest(const ExactLine& line, const ExactRegion& region);
/// True if the region owns the sample of pixel (i, j), which is its centre moved by an infinitely small (e,
/// e^2).
[[nodiscard]] bool exactlyCovers(const ExactRegion& region, int i, int j);
/// True if the region owns a sample of the picture.
[[nodiscard]] bool exactlyOwnsSample(const ExactRegion& region, int width, int height);
/// Twice the area over the diameter, from the corners as doubles.
[[nodiscard]] double thickness(const ExactRegion& region);

/// A number plus infinitely small parts: value + first e + second e^2.
struct Perturbed {
  Rational value, first, second;
  [[nodiscard]] int sign() const {
    for (const Rational* part : {&value, &first, &second})
      if (*part != 0) return *part > 0 ? 1 : -1;
    return 0;
  }
};

/// A triangle in pixels and depth steps, known by its vertices alone. The sample of pixel (i, j) is its
/// centre moved by (e, e^2).
struct RationalFace {
  std::array<std::array<Rational, 3>, 3> v;

  RationalFace(const SnappedScene& scene, const SnappedFace& face) {
    for (int k = 0; k < 3; ++k) {
      const glm::ivec3& p = scene.vertices[face.first + k];
      v[k] = {Rational{p.x, kGrid}, Rational{p.y, kGrid}, Rational{p.z}};
    }
  }
  static Rational area(const Rational& ux, const Rational& uy, const Rational& vx, const Rational& vy) {
    return ux * vy - uy * vx;
  }
  [[nodiscard]] bool covers(int i, int j) const {
    for (int k = 0; k < 3; ++k) {
      const auto &a = v[k], &b = v[(k + 1) % 3];
      const Rational dx = b[0] - a[0], dy = b[1] - a[1];
      const Rational side = dy * (Rational{2 * i + 1, 2} - a[0]) - dx * (Rational{2 * j + 1, 2} - a[1]);
      if (Perturbed{side, dy, -dx}.sign() < 0) return false;
    }
    return true;
  }
  /// At the pixel's centre, from its barycentric coordinates.
  [[nodiscard]] Rational z(int i, int j) const {
    const Rational x{2 * i + 1, 2}, y{2 * j + 1, 2};
    const auto &a = v[0], &b = v[1], &c = v[2];
    const Rational whole = area(b[0] - a[0], b[1] - a[1], c[0] - a[0], c[1] - a[1]);
    const Rational s = area(x - a[0], y - a[1], c[0] - a[0], c[1] - a[1]) / whole;
    const Rational t = area(b[0] - a[0], b[1] - a[1], x - a[0], y - a[1]) / whole;
    return a[2] + s * (b[2] - a[2]) + t * (c[2] - a[2]);
  }
  /// At the sample.
  [[nodiscard]] Perturbed depth(int i, int j) const {
    const Rational here = z(i, j);
    return {here, z(i + 1, j) - here, z(i, j + 1) - here};
  }
};

}  // namespace xnewell
