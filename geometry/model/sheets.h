#pragma once

#include <array>
#include <cmath>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "geometry/exact/overlap.h"
#include "geometry/exact/plane.h"
#include "geometry/model/divide.h"
#include "geometry/model/mesh.h"
#include "geometry/model/rounding.h"

namespace xnewell {

/// What coplanar.cpp asks about the faces of a model, two by two: whether they may lie in one plane, and
/// whether they overlap in area.

/// A mesh's points, moved and scaled by a power of two into [0, 1]^3. The longest side of their box is in
/// [1/2, 1).
struct UnitBox {
  std::vector<glm::dvec3> points;
  glm::dvec3 low{0.0};  ///< the box's corner, scaled by 2^-first
  int first = 0, second = 0;
  double side = 0.0;       ///< length of the box's longest side
  double magnitude = 0.0;  ///< largest absolute coordinate before the move, at this scale
  int exponent = 0;        ///< length in the mesh = length here * 2^exponent

  explicit UnitBox(const std::vector<glm::dvec3>& meshPoints);
  [[nodiscard]] glm::dvec3 inWorld(const glm::dvec3& p) const;
};

/// The parts of one planar face, or one part of a bent face.
struct ModelSheet {
  int firstPart = 0, partCount = 0;
  Plane plane;
  glm::dvec3 centroid{0.0};
  double area = 0.0;       ///< twice the area
  double u = 0.0;          ///< the rounding of its coordinates
  double steepness = 0.0;  ///< the perimeter / the area
};

/// The sheets of a model, in the unit box. ModelSheet s consists of the parts with ConvexParts::plane s.
struct Sheets {
  Sheets(const Mesh& mesh, const ConvexParts& convexParts);

  [[nodiscard]] std::span<const int> corners(const ModelSheet& sheet) const;

  /// Calls visit(i, j) for all parts i and j of some sheets that may lie in one plane and overlap, by their
  /// places; twice for some.
  template <class Visit>
  void forNear(const std::vector<int>& open, const Visit& visit) const {
    Places near = places(open);
    for (std::vector<ItemBox>* boxes : {&near.among, &near.dust})
      forOverlapping(std::span{*boxes}, visit, [&](std::span<ItemBox> many) { return refine(many); });
  }

  /// True if the sheets of parts i and j are certainly explained by no plane: a corner of one is further from
  /// the other's plane than Rounding::mostOff().
  [[nodiscard]] bool tooFar(int i, int j) const { return oneTooFar(i, j) || oneTooFar(j, i); }

  /// True if an edge of one part separates it from the other, seen along the axis nearest to N. Seen so,
  /// rounding moves a point by at most sqrt 2 u. So where the two only touch, the other part may reach across
  /// the edge by twice that, and by more beyond the ends of the edge (up to twice as much counts: a short
  /// edge has no direction).
  [[nodiscard]] bool parted(int i, int j, const glm::dvec3& N) const;

  const ConvexParts& parts;
  UnitBox box;
  Rounding rounding;
  std::vector<ModelSheet> sheets;

 private:
  /// The places of the parts of some sheets: boxes in six dimensions. They overlap if one plane can explain
  /// two parts. Three dimensions are the part's own box. The other three are the places where the
  /// perpendicular from a fixed point near the middle can meet the plane that explains the part. If every
  /// corner of a polygon of area A is within tol of a plane, the sine of the angle between them is at most
  /// tol * perimeter / A, because the polygon's vector area changes by no more. The foot of the perpendicular
  /// then moves by at most that sine times the distance, plus tol. The bound doubles for a part that may lie
  /// tol off its face's plane.
  ///
  /// Dust is apart, because no two parts of it are joined: parted() asks each edge for a corner of the other
  /// part that lies 2 delta inside it. If the two overlap at all, a corner is no farther from an edge than
  /// the two parts are long together. So parts shorter than 0.9 delta are dust. All corners of one lie
  /// within 0.9 delta of each other. So dust is joined only to a part that is wide: inside each of its edges,
  /// it reaches farther than 1.1 delta. Without this rule, a model of dust and needles has a pair for each of
  /// both.
  struct Places {
    std::vector<ItemBox> among;  ///< the parts that are not dust
    std::vector<ItemBox> dust;   ///< the dust in one group, the wide parts in another
  };
  [[nodiscard]] Places places(const std::vector<int>& open) const;
  /// True if, for each edge of the part, a corner is farther than `least` from the edge's line.
  [[nodiscard]] bool isWide(int part, double least) const;

  /// Measures places anew in finer units, if they are many and only single precision keeps them together.
  /// One far corner is enough: at its scale, all other faces lie in one point. The new places are seen from
  /// their middle; each dimension has a unit of its own, by the middle half of the places. Each part counts
  /// with its own rounding, twice. Returns false, and changes nothing, if that would not separate them.
  [[nodiscard]] bool refine(std::span<ItemBox> boxes) const;

  /// A place in double precision: it reaches from low - play to high + play.
  struct Place {
    std::array<double, 6> low, high, play;
  };
  /// Twice the area of a part, and the perimeter / the area.
  struct Shape {
    double area, steepness;
  };
  [[nodiscard]] Shape shapeOf(int part) const;
  [[nodiscard]] Place placeOf(int part, double steepness, const glm::dvec3& from, double r) const;
  [[nodiscard]] double delta(double u) const { return std::sqrt(2.0) * u + rounding.arithmetic(); }
  [[nodiscard]] const ModelSheet& of(int part) const { return sheets[parts.plane[part]]; }
  [[nodiscard]] double perimeter(std::span<const int> outline) const;
  [[nodiscard]] bool oneTooFar(int i, int j) const;
  [[nodiscard]] bool partedByEdgesOf(int i, int j, int dropped) const;

  double mostRounding_ = 0.0;  ///< the largest r of all
};

}  // namespace xnewell
