#pragma once

#include <span>
#include <vector>

#include "geometry/model/mesh.h"

namespace xnewell {

/// A plane of the model, through the point `at`. N is a unit vector, or 0 for faces without area.
struct ModelPlane {
  glm::dvec3 N{0.0}, at{0.0};
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
  /// The planes with these numbers, found by uniteCoplanar(), and behind them more planes for `own`; empty
  /// before.
  std::vector<ModelPlane> planes;
  /// #parts, or empty before: the plane of the corners of the part, or of its planar face, alone. An index
  /// into `planes`. It is another than `plane` where the part shares that one with other faces.
  std::vector<int> own;

  [[nodiscard]] int count() const { return static_cast<int>(face.size()); }
  [[nodiscard]] std::span<const int> part(int k) const {
    return {corners.data() + firstCorner[k], corners.data() + firstCorner[k + 1]};
  }
};

/// Divides the faces that are bent or concave. The rule depends on the model only, never on a camera:
/// - Of successive corners at one place, the first is kept. A spike, where the outline runs out and back on
///   itself, is left out.
/// - A triangle, or a planar convex polygon, is one part. It keeps the corners on its straight sides, because
///   neighbours may use them.
/// - Any other quadrilateral is cut from corner 0 to 2, or from 1 to 3 if only that gives two triangles that
///   turn as the face does.
/// - Any other face is cut into triangles by clipEars(), with all its corners.
/// A face whose corners are all in line, or that has no vector area, covers nothing. It stays as it is, as
/// one part. A face that crosses itself becomes triangles that may overlap.
///
/// Planar: one plane explains all corners (rounding.h), with the side and the magnitude of the face itself.
/// If a corner is further than 7 r from the Newell plane, the face counts as bent without a search for that
/// plane. Convexity, and every choice of a cut, is exact on a grid of 2^49 to 2^50 steps across the box, seen
/// along the axis nearest to the face's normal. All finite coordinates are allowed, up to the largest double.
[[nodiscard]] ConvexParts divideFaces(const Mesh& mesh);

}  // namespace xnewell
