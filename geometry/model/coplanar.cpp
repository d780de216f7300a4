#include "geometry/model/coplanar.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numeric>

#include "geometry/exact/box.h"
#include "geometry/exact/overlap.h"
#include "geometry/exact/plane.h"
#include "geometry/exact/scale.h"

namespace xnewell {

namespace {

/// A mesh's points moved and scaled by a power of two into [0, 1]^3, the longest side of their box in
/// [1/2, 1).
struct UnitBox {
  std::vector<glm::dvec3> points;
  double side = 0.0;       ///< the longest
  double magnitude = 0.0;  ///< of the largest coordinate before the move
  int exponent = 0;        ///< length in the mesh = length here * 2^exponent

  explicit UnitBox(const std::vector<glm::dvec3>& meshPoints) {
    // Scaled first, so that differences do not overflow.
    Box box = boxOf(meshPoints);
    int first = 0, second = 0;
    std::frexp(box.magnitude(), &first);
    box = {scaled(box.low, -first), scaled(box.high, -first)};
    side = std::frexp(box.side(), &second);
    magnitude = std::ldexp(box.magnitude(), -second);
    exponent = first + second;
    points.reserve(meshPoints.size());
    for (const glm::dvec3& p : meshPoints) points.push_back(scaled(scaled(p, -first) - box.low, -second));
  }
};

/// Disjoint sets of numbers. @see Tarjan 1975
class DisjointSets {
 public:
  explicit DisjointSets(int count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
  [[nodiscard]] int of(int i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void unite(int i, int j) { parent_[of(j)] = of(i); }

 private:
  std::vector<int> parent_;
};

/// The pieces of one planar face, or a piece of a bent one.
struct Sheet {
  int firstPiece = 0, pieceCount = 0;
  Plane plane;
  double area = 0.0;  ///< twice the area
  double rounding = 0.0;
};

class Coplanarity {
 public:
  Coplanarity(const Mesh& mesh, const ConvexParts& pieces) : pieces_{pieces}, box_{mesh.points} {
    double coarsest = 0.0;
    for (const double u : mesh.rounding) coarsest = std::max(coarsest, rounding(u));
    mostTolerance_ = tolerance(coarsest);
    for (int k = 0; k < pieces.count(); ++k) {
      if (k > 0 && pieces.plane[k] == pieces.plane[k - 1]) {
        ++sheets_.back().pieceCount;
        continue;
      }
      sheets_.push_back({k, 1, {}, 0.0, rounding(mesh.roundingOf(pieces.face[k]))});
    }
    for (Sheet& sheet : sheets_) {
      const int k = sheet.firstPiece;
      const auto outline = sheet.pieceCount == 1 ? pieces.piece(k) : mesh.face(pieces.face[k]);
      const glm::dvec3 v = newellVector(box_.points, outline);
      sheet.area = glm::length(v);
      if (sheet.area > 0.0) sheet.plane.N = v / sheet.area;
      sheet.plane.d = glm::dot(sheet.plane.N, centroid(box_.points, outline));
    }
  }

  [[nodiscard]] std::vector<int> classes() {
    DisjointSets sets{static_cast<int>(sheets_.size())};
    std::vector<ItemBox> boxes = places();
    forOverlapping(std::span{boxes}, [&](int i, int j) {
      const int P = pieces_.plane[i], Q = pieces_.plane[j];
      if (sets.of(P) != sets.of(Q) && inOnePlane(i, j)) sets.unite(P, Q);
    });

    std::vector<int> largestOf(sheets_.size(), -1);
    const int count = static_cast<int>(sheets_.size());
    for (int s = 0; s < count; ++s) {
      int& most = largestOf[sets.of(s)];
      if (most < 0 || sheets_[s].area > sheets_[most].area) most = s;
    }
    // The number of a class is known from its first sheet on, that of one who leaves is new.
    std::vector<int> number(sheets_.size(), -1), planes(pieces_.count());
    int next = 0;
    for (int s = 0; s < count; ++s) {
      const int seed = largestOf[sets.of(s)];
      const bool stays = s == seed || within(corners(sheets_[s]), sheets_[seed],
                                             3.0 * toleranceOf(sheets_[s], sheets_[seed]));
      int alone = -1;
      int& mine = stays ? number[seed] : alone;
      if (mine < 0) mine = next++;
      std::fill_n(planes.begin() + sheets_[s].firstPiece, sheets_[s].pieceCount, mine);
    }
    return planes;
  }

 private:
  [[nodiscard]] double rounding(double u) const { return std::ldexp(u, -box_.exponent); }
  [[nodiscard]] double tolerance(double u) const {
    return std::min(7.0 * u, 3e-5 * box_.side) + 0x1p-46 * box_.side + 0x1p-50 * box_.magnitude;
  }
  [[nodiscard]] double toleranceOf(const Sheet& P, const Sheet& Q) const {
    return tolerance(std::max(P.rounding, Q.rounding));
  }
  [[nodiscard]] std::span<const int> corners(const Sheet& sheet) const {
    const auto at = [&](int k) { return pieces_.corners.data() + pieces_.firstCorner[k]; };
    return {at(sheet.firstPiece), at(sheet.firstPiece + sheet.pieceCount)};
  }
  [[nodiscard]] bool within(std::span<const int> corners, const Sheet& sheet, double tol) const {
    return std::all_of(corners.begin(), corners.end(), [&](int c) {
      return std::abs(glm::dot(sheet.plane.N, box_.points[c]) - sheet.plane.d) <= tol;
    });
  }

  /// Boxes in six dimensions that overlap if two pieces can share a plane: the piece's own box, and the
  /// places where the perpendicular onto its plane from a point amid all may end. If every corner of a
  /// polygon of area A is within tol of a plane, the sine of the angle between both is at most
  /// tol * perimeter / A (its vector area changes by no more); the end of the perpendicular then moves by
  /// that times the distance, and tol. Twice all that where a piece may lie tol off its face's plane.
  [[nodiscard]] std::vector<ItemBox> places() const {
    const glm::dvec3 from{0.43, 0.56, 0.47};
    std::vector<ItemBox> boxes;
    boxes.reserve(pieces_.count());
    for (const Sheet& sheet : sheets_) {
      const glm::dvec3 foot = sheet.plane.N * (sheet.plane.d - glm::dot(sheet.plane.N, from));
      for (int k = sheet.firstPiece; k < sheet.firstPiece + sheet.pieceCount; ++k) {
        const double area =
            sheet.pieceCount == 1 ? sheet.area : glm::length(newellVector(box_.points, pieces_.piece(k)));
        if (area == 0.0 || sheet.area == 0.0) continue;
        Box around;
        glm::dvec3 last = box_.points[pieces_.piece(k).back()];
        double perimeter = 0.0;
        for (const int c : pieces_.piece(k)) {
          const glm::dvec3& p = box_.points[c];
          around.add(p);
          perimeter += glm::length(p - last);
          last = p;
        }
        const double distance =
            glm::length(glm::max(glm::abs(around.low - from), glm::abs(around.high - from)));
        const double sine = 2.0 * mostTolerance_ * perimeter / area;
        const double play = (sheet.pieceCount == 1 ? 1.0 : 2.0) * (sine * distance + mostTolerance_);
        // No two feet are further than 4 apart, and to float a number up to 8 is rounded by 2^-22.
        const double nearFoot = std::min(play, 4.0) + 0x1p-22, nearby = mostTolerance_ + 0x1p-22;
        ItemBox& box = boxes.emplace_back(ItemBox{k, pieces_.plane[k], {}, {}});
        for (int axis = 0; axis < 3; ++axis) {
          box.low[axis] = static_cast<float>(foot[axis] - nearFoot);
          box.high[axis] = static_cast<float>(foot[axis] + nearFoot);
          box.low[axis + 3] = static_cast<float>(around.low[axis] - nearby);
          box.high[axis + 3] = static_cast<float>(around.high[axis] + nearby);
        }
      }
    }
    return boxes;
  }

  [[nodiscard]] bool inOnePlane(int i, int j) const {
    const Sheet &P = sheets_[pieces_.plane[i]], &Q = sheets_[pieces_.plane[j]];
    const double tol = toleranceOf(P, Q);
    const bool first = P.area > Q.area || (P.area == Q.area && i < j);
    const Sheet& larger = first ? P : Q;
    if (!within(pieces_.piece(first ? j : i), larger, tol)) return false;
    const glm::dvec3 N = glm::abs(larger.plane.N);
    const int dropped = N.z >= N.x && N.z >= N.y ? 2 : N.y >= N.x ? 1 : 0;
    return !parted(i, j, dropped, tol) && !parted(j, i, dropped, tol);
  }

  /// Whether an edge of piece i parts it from piece j, seen along an axis.
  [[nodiscard]] bool parted(int i, int j, int dropped, double tol) const {
    const auto P = pieces_.piece(i), Q = pieces_.piece(j);
    const auto seen = [&](int c) {
      return glm::dvec2{box_.points[c][(dropped + 1) % 3], box_.points[c][(dropped + 2) % 3]};
    };
    const auto cross = [](const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; };
    double area = 0.0;
    const glm::dvec2 origin = seen(P[0]);
    for (std::size_t c = 2; c < P.size(); ++c) area += cross(seen(P[c - 1]) - origin, seen(P[c]) - origin);
    std::size_t inside = 0;  // the corner of Q inside the last edge is probably inside the next
    glm::dvec2 a = seen(P.back());
    for (const int c : P) {
      const glm::dvec2 b = seen(c), edge = area < 0.0 ? a - b : b - a;
      const double reach = tol * glm::length(edge);
      std::size_t tried = 0;
      while (tried < Q.size() && cross(edge, seen(Q[inside]) - a) <= reach) {
        inside = inside + 1 == Q.size() ? 0 : inside + 1;
        ++tried;
      }
      if (tried == Q.size() && edge != glm::dvec2{0.0}) return true;
      a = b;
    }
    return false;
  }

  const ConvexParts& pieces_;
  UnitBox box_;
  std::vector<Sheet> sheets_;
  double mostTolerance_ = 0.0;
};

}  // namespace

std::vector<int> coplanarClasses(const Mesh& mesh, const ConvexParts& pieces) {
  if (pieces.count() == 0) return {};
  return Coplanarity{mesh, pieces}.classes();
}

}  // namespace xnewell
