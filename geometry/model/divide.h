#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "geometry/exact/scale.h"
#include "geometry/model/mesh.h"

namespace xnewell {

/// A plane of the model, through the point `at`. N is a unit vector, or 0 for faces without area.
struct ModelPlane {
  glm::dvec3 N{0.0}, at{0.0};
};

/// Coordinates in which the box of a mesh lies in [0, 1]^3, with its longest side in [1/2, 1): those of the
/// mesh, scaled by 2^-first, moved, and scaled by 2^-second.
struct UnitFrame {
  glm::dvec3 low{0.0};  ///< the box's corner, scaled by 2^-first
  int first = 0, second = 0;

  [[nodiscard]] glm::dvec3 inUnits(const glm::dvec3& p) const {
    return scaled(scaled(p, -first) - low, -second);
  }
  [[nodiscard]] glm::dvec3 inMesh(const glm::dvec3& p) const {
    return scaled(scaled(p, second) + low, first);
  }
};

/// Planes of the model by their numbers, which ascend.
struct NumberedPlanes {
  std::vector<int> numbers;
  std::vector<ModelPlane> planes;

  void add(int number, const ModelPlane& plane) { numbers.push_back(number), planes.push_back(plane); }
  /// The plane with a number; null if it is not among them.
  [[nodiscard]] const ModelPlane* find(int number) const {
    const auto at = std::ranges::lower_bound(numbers, number);
    return at != numbers.end() && *at == number ? &planes[at - numbers.begin()] : nullptr;
  }
};

/// The faces of a mesh as convex planar polygons. Part k belongs to face[k], and faces keep their numbers.
/// ConvexParts are in face order and every face has at least one.
struct ConvexParts {
  std::vector<int> corners;  ///< vertex indices of all parts, one part after the other
  std::vector<int> from;     ///< for each of these: its corner in the mesh, an index into Mesh::corners
  std::vector<int> firstCorner = {0};  ///< #parts + 1, as in Mesh
  std::vector<int> face;               ///< #parts, number of the part's face
  /// #parts, 0 to n - 1 in order of the first part of each plane. Parts with the same number lie in one plane
  /// of the model. divideFaces() finds this for the parts of one planar face, coplanarClasses() for all
  /// parts.
  std::vector<int> plane;
  /// What uniteCoplanar() finds. A plane that is not among `planes` is that of the corners of its only part
  /// (planeOf()). `own` has, by part, the planes of the own corners of those parts that share theirs with
  /// other faces: of the part, or of its planar face. `frame` is that of the mesh; none before.
  NumberedPlanes planes, own;
  std::optional<UnitFrame> frame;

  [[nodiscard]] int count() const { return static_cast<int>(face.size()); }
  [[nodiscard]] std::span<const int> part(int k) const {
    return {corners.data() + firstCorner[k], corners.data() + firstCorner[k + 1]};
  }
};

/// Divides the faces that are bent or concave. The rule depends on the model only, never on a camera:
/// - Of successive corners at one place, the first is kept. A spike, where the outline runs out and back on
///   itself, is left out.
/// - A triangle, or a planar convex polygon, is one part.
/// - Any other quadrilateral is cut from corner 0 to 2, or from 1 to 3 if only that gives two triangles that
///   turn as the face does.
/// - Any other face is cut into triangles by clipEars().
/// - A corner in the middle of a straight side, within the rounding of the arithmetic, decides nothing. Its
///   part keeps it, because neighbours may use it.
/// A face whose corners are all in line, or that has no vector area, covers nothing. It stays as it is, as
/// one part. A face that crosses itself becomes triangles that may overlap.
///
/// Planar: one plane explains all corners (fit_plane.h), with the side and the magnitude of the face itself.
/// If a corner is further than 7 r from the Newell plane, the face counts as bent without a search for that
/// plane. Convexity, and every choice of a cut, is exact on a grid of 2^49 to 2^50 steps across the box, seen
/// along the axis nearest to the face's normal. All finite coordinates are allowed, up to the largest double.
[[nodiscard]] ConvexParts divideFaces(const Mesh& mesh);

/// True if two edges of a face pass through each other, seen along the axis nearest to its normal; without an
/// area no axis is the one to look along. Faces of more than 100 corners are not searched: that takes the
/// square of their number.
[[nodiscard]] bool crossesItself(const Mesh& mesh, int face);

}  // namespace xnewell
