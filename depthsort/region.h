#pragma once

#include <cmath>
#include <vector>

#include "geometry/view/project.h"

namespace xnewell {

/// Convex regions of the screen bounded by lines, exactly. The corner of a region is where the
/// lines of two successive sides meet. Doubles with an error radius stand beside it and decide nearly every
/// question; where they cannot, integers made of the two lines do.

/// An oriented line a x + b y + c = 0 on the screen grid, positive on one side: the inner side of an
/// outline's edge, or where one plane is nearer than another.
struct Line {
  enum class Kind : std::int8_t { Edge, Cut };
  Kind kind = Kind::Edge;
  int p = 0, q = 0;  ///< Edge: from vertex p to q. Cut: positive where planes[p] is nearer than planes[q].
  /// The same in doubles, each within 2^-52 of itself, scaled so that max(|a|, |b|) = 1.
  double a = 0, b = 0, c = 0;
};

/// About where a side's line meets the next one's.
struct Corner {
  double x = 0, y = 0;
  /// The true corner is at most this far away along x and along y. 0: it is the integer point (x, y), a
  /// vertex of the scene.
  double radius = 0;
  [[nodiscard]] bool exact() const { return radius == 0.0; }
};

/// One side of a region, and the corner at its end.
struct Side {
  Line line;
  Corner corner;
};

/// Convex, counter-clockwise as seen (y down), with an area; no side is a point. Empty: no region.
using Region = std::vector<Side>;

/// Which signs a line, or the difference of two planes, has at the corners of a region; as it is
/// linear these are its signs all over the region.
struct Signs {
  bool positive = false, negative = false;
  void add(int sign) {
    positive |= sign > 0;
    negative |= sign < 0;
  }
  [[nodiscard]] bool both() const { return positive && negative; }
  [[nodiscard]] bool none() const { return !positive && !negative; }
};

/// Makes and asks regions of one scene. Every answer is exact.
class Regions {
 public:
  explicit Regions(const SnappedScene& scene) : scene_{scene} {}

  [[nodiscard]] Line edge(int from, int to) const;
  /// Where planes[over] is nearer than planes[under]. They differ; where they are parallel there is no line,
  /// a = b = 0 and c tells the sign everywhere. |a|, |b| <= 2^123 and |c| <= 2^155 before the scaling.
  [[nodiscard]] Line cut(int over, int under) const;
  /// Whether two planes are one, be it under two records.
  [[nodiscard]] bool samePlane(int p, int q) const {
    if (p == q) return true;
    const Line line = cut(p, q);
    return line.a == 0 && line.b == 0 && line.c == 0;
  }

  /// The outline of a face.
  void outline(const SnappedFace& face, Region& region) const;

  /// The sign of a line at the corner where `first` and `second` meet.
  [[nodiscard]] int sign(const Line& line, const Line& first, const Line& second, const Corner& at) const {
    const double value = line.a * at.x + line.b * at.y + line.c;
    // Coefficients within 2^-52, two roundings of products and two of sums.
    const double rounding = 0x1p-49 * (std::abs(at.x) + std::abs(at.y) + std::abs(line.c));
    if (std::abs(value) > rounding + 2.0 * at.radius) return value > 0 ? 1 : -1;
    return exactSign(line, first, second, at);
  }
  [[nodiscard]] Signs signs(const Line& line, const Region& region) const;

  /// Keeps of the region what lies on the positive side of the line; nothing with an area: empty.
  void clip(Region& region, const Line& line) const;
  /// The same line with its other side positive.
  [[nodiscard]] static Line flipped(Line line);

 private:
  [[nodiscard]] Corner meeting(const Line& first, const Line& second) const;
  [[nodiscard]] int exactSign(const Line& line, const Line& first, const Line& second,
                              const Corner& at) const;

  const SnappedScene& scene_;
  mutable Region kept_;  ///< of clip(), kept so as not to ask for memory each time
};

}  // namespace xnewell
