#pragma once

#include <array>
#include <cmath>
#include <glm/vec3.hpp>
#include <span>
#include <unordered_map>
#include <vector>

#include "geometry/exact/box.h"
#include "geometry/exact/overlap.h"
#include "geometry/exact/plane.h"
#include "geometry/model/coplanar.h"
#include "geometry/model/divide.h"
#include "geometry/model/mesh.h"

namespace xnewell {

/// What coplanar.cpp asks about the faces of a model, two by two: whether they may lie in one plane, and
/// whether they overlap in area.

/// A mesh's points in its UnitFrame, and the box of them.
struct UnitBox {
  UnitFrame frame;
  std::vector<glm::dvec3> points;
  double side = 0.0;       ///< length of the box's longest side
  double magnitude = 0.0;  ///< largest absolute coordinate before the move, at this scale
  int exponent = 0;        ///< length in the mesh = length here * 2^exponent

  explicit UnitBox(const std::vector<glm::dvec3>& meshPoints);
};

/// The parts of one planar face, or one part of a bent face.
struct ModelSheet {
  int partCount = 0;
  Plane plane;
  glm::dvec3 centroid{0.0};
  double area = 0.0;       ///< twice the area
  double u = 0.0;          ///< the rounding of its coordinates
  double steepness = 0.0;  ///< the perimeter / the area
};

/// A part of a model, and the sheet to which it belongs.
struct SheetPart {
  int part;
  const ModelSheet& sheet;
};

/// The sheets of a model, in the unit box. Sheet s consists of the parts with ConvexParts::plane s. Few
/// sheets are ever compared, so they are made where they are needed.
class Sheets {
 public:
  Sheets(const Mesh& mesh, const ConvexParts& convexParts);

  [[nodiscard]] int count() const { return static_cast<int>(firstPart_.size()) - 1; }
  [[nodiscard]] int firstPart(int s) const { return firstPart_[s]; }
  [[nodiscard]] int partCount(int s) const { return firstPart_[s + 1] - firstPart_[s]; }
  [[nodiscard]] std::span<const int> corners(int s) const;
  /// The rounding of the coordinates of a sheet.
  [[nodiscard]] double roundingOf(int s) const;
  [[nodiscard]] ModelSheet sheet(int s) const;

  /// Calls visit(P, Q) for all SheetParts of some sheets that may lie in one plane and overlap, by their
  /// places; twice for some.
  template <class Visit>
  void forNear(std::span<const int> open, const Visit& visit) const {
    std::vector<int> all;
    for (const int s : open)
      for (int k = firstPart(s); k < firstPart(s + 1); ++k) all.push_back(k);
    Places near;
    forNearParts(all, near, visit);
  }
  /// The same for all sheets. It goes through the model cell by cell, as most parts have nothing near them.
  template <class Visit>
  void forAllNear(const Visit& visit) const {
    const BoxCells::Lists lists = cells();
    Places near;
    for (int c = 0; c < lists.cells(); ++c)
      if (lists[c].size() > 1) forNearParts(lists[c], near, visit);
  }

  /// True if the sheets of two parts are certainly explained by no plane: a corner of one is further from
  /// the other's plane than Rounding::mostOff().
  [[nodiscard]] bool tooFar(const SheetPart& P, const SheetPart& Q) const {
    return oneTooFar(P, Q) || oneTooFar(Q, P);
  }

  /// True if an edge of one part separates it from the other, seen along the axis nearest to N. Seen so,
  /// rounding moves a point by at most sqrt 2 u. So where the two only touch, the other part may reach across
  /// the edge by twice that, and by more beyond the ends of the edge (up to twice as much counts: a short
  /// edge has no direction).
  [[nodiscard]] bool parted(const SheetPart& P, const SheetPart& Q, const glm::dvec3& N) const;

  const ConvexParts& parts;
  UnitBox box;
  Rounding rounding;

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
    struct Item {
      int part, sheet;  ///< the sheet is an index into `sheets`
    };
    std::vector<ModelSheet> sheets;
    std::vector<Item> items;     ///< what ItemBox::item counts
    std::vector<ItemBox> among;  ///< the parts that are not dust
    std::vector<ItemBox> dust;   ///< the dust in one group, the wide parts in another

    [[nodiscard]] SheetPart operator[](int item) const {
      return {items[item].part, sheets[items[item].sheet]};
    }
  };
  /// Sets `result` to the places of some parts, in ascending order for each sheet.
  void findPlaces(std::span<const int> some, Places& result) const;
  template <class Visit>
  void forNearParts(std::span<const int> some, Places& near, const Visit& visit) const {
    findPlaces(some, near);
    for (std::vector<ItemBox>* boxes : {&near.among, &near.dust})
      forOverlapping(
          std::span{*boxes}, [&](int i, int j) { visit(near[i], near[j]); },
          [&](std::span<ItemBox> many) { return refine(near, many); });
  }

  /// The parts, cell by cell of a grid. Two whose places overlap are both in one of the cells.
  [[nodiscard]] BoxCells::Lists cells() const;

  /// True if, for each edge of the part, a corner is farther than `least` from the edge's line.
  [[nodiscard]] bool isWide(int part, double least) const;

  /// Measures places anew in finer units, if they are many and only single precision keeps them together.
  /// One far corner is enough: at its scale, all other faces lie in one point. The new places are seen from
  /// their middle; each dimension has a unit of its own, by the middle half of the places. Each part counts
  /// with its own rounding, twice. Returns false, and changes nothing, if that would not separate them.
  [[nodiscard]] bool refine(const Places& near, std::span<ItemBox> boxes) const;

  /// A place in double precision: it reaches from low - play to high + play.
  struct Place {
    std::array<double, 6> low, high, play;
  };
  /// Twice the area of a part, and the perimeter / the area.
  struct Shape {
    double area, steepness;
  };
  [[nodiscard]] Shape shapeOf(const SheetPart& P) const;
  [[nodiscard]] Place placeOf(const SheetPart& P, double steepness, const glm::dvec3& from, double r) const;
  [[nodiscard]] double delta(double u) const { return std::sqrt(2.0) * u + rounding.arithmetic(); }
  [[nodiscard]] Box boxOf(int part) const;
  [[nodiscard]] double perimeter(std::span<const int> outline) const;
  [[nodiscard]] bool oneTooFar(const SheetPart& P, const SheetPart& Q) const;
  [[nodiscard]] bool partedByEdgesOf(const SheetPart& first, const SheetPart& second, int dropped) const;
  [[nodiscard]] ModelSheet madeSheet(int s) const;

  const Mesh& mesh_;
  std::vector<double> roundings_;                ///< Mesh::rounding, in the unit box
  std::vector<int> firstPart_;                   ///< #sheets + 1
  std::unordered_map<int, ModelSheet> divided_;  ///< the sheets of several parts, made once
  double mostRounding_ = 0.0;                    ///< the largest r of all
};

}  // namespace xnewell
