#pragma once

#include <span>
#include <vector>

#include "geometry/model/mesh.h"

namespace xnewell {

/// The faces of a mesh as convex planar polygons. A face keeps its number: piece k belongs to face[k].
/// ConvexParts are in face order and every face has at least one.
struct ConvexParts {
  std::vector<int> corners;            ///< vertex indices of all pieces, one piece after the other
  std::vector<int> from;               ///< as many: the corner of the mesh, an index into Mesh::corners
  std::vector<int> firstCorner = {0};  ///< #pieces + 1, as in Mesh
  std::vector<int> face;               ///< #pieces, the number of the face it came from
  /// #pieces, 0 to n - 1 in order of the first piece of each: pieces with the same number are in one plane of
  /// the model. divideFaces() knows it of the pieces of one planar face, coplanarClasses() of all.
  std::vector<int> plane;

  [[nodiscard]] int count() const { return static_cast<int>(face.size()); }
  [[nodiscard]] std::span<const int> piece(int k) const {
    return {corners.data() + firstCorner[k], corners.data() + firstCorner[k + 1]};
  }
};

/// Divides the faces that are bent or concave, by a rule that knows the model only, never a camera:
/// - of successive corners at one place the first is kept;
/// - a triangle, or a planar and convex polygon, is one piece, with the corners on its straight sides,
///   for neighbours may use them;
/// - another quadrilateral is cut from corner 0 to 2, or from 1 to 3 if only that gives two triangles that
///   turn as the face does;
/// - any other face is cut into triangles by clipEars(), all its corners used.
/// A face whose corners are all in line, or that has no vector area, covers nothing and is one piece as
/// it stands. A face that crosses itself becomes triangles that may overlap.
///
/// Planar: every corner within min(7 u, 3e-5 e) + 2^-46 e + 2^-50 m of the Newell plane; u the face's
/// rounding, e the longest side of the face's box, m the largest coordinate. The first term is the
/// rounding of the file, capped for coarse files; the second our own arithmetic; the third the rounding of
/// coordinates to double: 2^-53 m an axis, sqrt 3 times that a corner, four corners' worth.
/// Convex, and every choice of a cut: exact on a grid of 2^49 to 2^50 steps across the box, seen along
/// the axis nearest to the face's normal. Any finite coordinates, up to the largest double.
[[nodiscard]] ConvexParts divideFaces(const Mesh& mesh);

}  // namespace xnewell
