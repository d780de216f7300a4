#pragma once

#include <cmath>
#include <vector>

#include "depthsort/box_grid.h"
#include "depthsort/depth_sort.h"
#include "geometry/exact/two_doubles.h"
#include "geometry/view/project.h"

namespace xnewell {

/// Convex regions of the screen, bounded by lines, exactly. A corner of a region is the point where the lines
/// of two successive sides meet. A corner also has doubles with an error radius, which decide nearly every
/// question. If they cannot, integers made from the lines decide.

/// An oriented line a x + b y + c = 0 on the screen grid. Its positive side is the inner side of an outline's
/// edge, or the side where one plane is nearer than another.
struct Line {
  enum class Kind : std::int8_t { Edge, Cut, Upright, Level };
  Kind kind = Kind::Edge;
  /// Edge: from vertex p to vertex q. Cut: positive where planes[p] is nearer than planes[q]. Upright: x = p,
  /// level: y = p; positive where that coordinate is larger, if q = 1, or smaller, if q = -1.
  int p = 0, q = 0;
  /// The coefficients as doubles, each with a relative error of at most 6 2^-53. The larger of |a| and |b| is
  /// scaled to 1.
  double a = 0, b = 0, c = 0;

  /// True for a side of an area.
  [[nodiscard]] bool isOfArea() const { return kind == Kind::Upright || kind == Kind::Level; }
};

/// An estimate of the point where a side's line meets the next side's.
struct Corner {
  double x = 0, y = 0;
  /// The true corner is at most this far away along x and along y. If it is 0, the corner is exactly the
  /// integer point (x, y), a vertex of the scene.
  double radius = 0;
  [[nodiscard]] bool exact() const { return radius == 0.0; }
};

/// One side of a region, and the corner at its end.
struct Side {
  Line line;
  Corner corner;
};

/// Convex, counter-clockwise as seen on the screen (y down), with an area; no side has length 0. An empty
/// vector stands for the empty region.
using Region = std::vector<Side>;

/// The signs that a line, or the difference of two planes, has at the corners of a region. It is linear, so
/// these are its signs in the whole region.
struct Signs {
  bool positive = false, negative = false;
  void add(int sign) {
    positive |= sign > 0;
    negative |= sign < 0;
  }
  [[nodiscard]] bool both() const { return positive && negative; }
  [[nodiscard]] bool none() const { return !positive && !negative; }
};

/// Makes the regions of one scene and answers questions about them. Every answer is exact.
class Regions {
 public:
  explicit Regions(const SnappedScene& scene) : scene_{scene} {}

  [[nodiscard]] Line edge(int from, int to) const;
  /// The lines x = at and y = at. `side` is 1 if larger coordinates are on the positive side, or else -1.
  [[nodiscard]] static Line upright(int at, int side);
  [[nodiscard]] static Line level(int at, int side);
  /// The line whose positive side is where planes[over] is nearer than planes[under]. The planes must differ.
  /// If they are parallel there is no line: a = b = 0, and c has the sign everywhere. |a|, |b| <= 2^123 and
  /// |c| <= 2^155 before the scaling.
  [[nodiscard]] Line cut(int over, int under) const;
  /// True if the planes coincide, even as separate records.
  [[nodiscard]] bool samePlane(int p, int q) const {
    if (p == q) return true;
    const Line line = cut(p, q);
    return line.a == 0 && line.b == 0 && line.c == 0;
  }

  /// Sets `region` to the outline of a face.
  void outline(const SnappedFace& face, Region& region) const;

  /// The sign of a line at the corner `at`, where the lines `first` and `second` meet.
  [[nodiscard]] int sign(const Line& line, const Line& first, const Line& second, const Corner& at) const {
    const int sure = estimate(line, at);
    return sure != 0 ? sure : exactSign(line, first, second, at);
  }
  [[nodiscard]] Signs signs(const Line& line, const Region& region) const;
  /// True if a part of the region is on the positive side of the line.
  [[nodiscard]] bool reaches(const Region& region, const Line& line) const;

  /// Clips the region to the positive side of the line. If no area is left, the region is empty.
  void clip(Region& region, const Line& line) const;
  /// The same edge or cut, with its sides exchanged.
  [[nodiscard]] static Line flipped(Line line);

 private:
  /// The sign of a line at a corner; 0 if doubles leave it in doubt.
  [[nodiscard]] static int estimate(const Line& line, const Corner& at) {
    const double value = line.a * at.x + line.b * at.y + line.c;
    // The coefficients are within 2^-52; two products and two sums round.
    const double rounding = 0x1p-49 * (std::abs(at.x) + std::abs(at.y) + std::abs(line.c));
    return std::abs(value) > rounding + 2.0 * at.radius ? (value > 0 ? 1 : -1) : 0;
  }
  /// The sign of a line at the end of side k.
  [[nodiscard]] int sign(const Line& line, const Region& region, std::size_t k) const {
    return sign(line, region[k].line, region[k + 1 == region.size() ? 0 : k + 1].line, region[k].corner);
  }
  [[nodiscard]] Corner meeting(const Line& first, const Line& second) const;
  [[nodiscard]] int exactSign(const Line& line, const Line& first, const Line& second,
                              const Corner& at) const;

  /// A line's coefficients, each off by at most kTwoDoubles of itself.
  struct FineLine {
    TwoDoubles a, b, c;
  };
  [[nodiscard]] FineLine fineLine(const Line& line) const;
  /// The same, kept for the next time: many corners lie on one line.
  [[nodiscard]] const FineLine& finely(const Line& line) const;
  [[nodiscard]] static int fineSign(const FineLine& line, const FineLine& first, const FineLine& second);

  struct KeptLine {
    Line::Kind kind = Line::Kind::Edge;
    int p = -1, q = -1;
    FineLine fine = {};
  };
  const SnappedScene& scene_;
  mutable std::vector<KeptLine> lines_;  ///< of finely(), each in the place that its p and q give; or empty
  mutable Region kept_;                  ///< a buffer of clip(), a member to reuse its memory
};

/// How far a fragment reaches on the screen grid and in z. The extents never fall short. They are at most a
/// step too large where a corner or a depth is not an integer.
struct Extents {
  ScreenBox box;
  int zFar = 0, zNear = 0;  ///< z steps, larger is nearer
};

/// The extents of a face, which has its plane or is throughVertices.
[[nodiscard]] Extents extentsOf(const SnappedScene& scene, const SnappedFace& face);
/// The extents of a piece of the face, from those of its parent.
[[nodiscard]] Extents extentsOf(const SnappedScene& scene, const SnappedFace& face, const Region& piece,
                                const Extents& parent);

/// Whose part a piece is.
struct PieceOf {
  int face;    ///< index into SnappedScene::faces
  int parent;  ///< fragment id of what was split
};

/// The rows of `area` that a polygon with this bounding box reaches. With its vertices rounded to pixels
/// (`inPixels`) it may reach others: then all of them.
[[nodiscard]] PixelArea rowsOf(const ScreenBox& box, const PixelArea& area, bool inPixels);

/// Appends a piece, with the cuts that bound its region, to what was sorted. `area` is where it may paint.
void enterPiece(SortedScene& sorted, const PieceOf& of, const Region& region, const PixelArea& area);

}  // namespace xnewell
