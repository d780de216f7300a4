#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "geometry/model/mesh.h"

namespace xnewell {

/// Normals at the corners of faces, of the surface that the faces approximate. Gouraud and Phong shading
/// interpolate them. @see Gouraud 1971, Foley & van Dam 2e §16.2.2

enum class NormalRule { Sum, Distinct, Area, Angle, Exact, File };
struct NormalRow {
  NormalRule id;
  std::string_view name, takes;
};
inline constexpr std::array kNormalRules{
    NormalRow{NormalRule::Sum, "sum", "the unit normals of the faces that share the vertex"},
    NormalRow{NormalRule::Distinct, "distinct", "the same, but those of one plane count once"},
    NormalRow{NormalRule::Area, "area", "the same, each weighted by its face's area"},
    NormalRow{NormalRule::Angle, "angle", "the same, each weighted by its face's angle at the vertex"},
    NormalRow{NormalRule::Exact, "exact", "the normals of the patches; without patches as distinct"},
    NormalRow{NormalRule::File, "file", "the normals that the file has; without them as exact"},
};

/// A place where the illumination is evaluated: a point, the material of the surface and its normal.
struct Vertex {
  int point = 0;      ///< index into Mesh::points
  int material = -1;  ///< as in Mesh::material
  glm::dvec3 N{0};    ///< unit; 0 if no face at the point has an area
  bool operator==(const Vertex&) const = default;
};

/// The vertices of a mesh. Corners with the same point, the same material and the same normal, in every bit,
/// share one vertex.
struct Vertices {
  std::vector<Vertex> vertices;  ///< in order of their points; at one point, in order of its corners
  std::vector<int> ofCorner;     ///< as many as Mesh::corners, index into vertices
};

/// The unit normals at the corners of a mesh's faces. They point to the side from which the faces run
/// counter-clockwise. A face here is a face of the file, however it is divided later. A face without area
/// contributes nothing. The rules differ in the weights of the faces at a point:
///
/// Sum       Every face counts once. A flat face stored as triangles counts as often as its triangles meet
///           at the point. So a cube of 12 triangles has skewed normals where a side has two triangles.
/// Distinct  Equal normals count once. Two normals are equal if they differ by no more than the rounding of
///           the file and of doubles can explain, at most 2^-10 (about 0.06 degrees) for each. That is finer
///           than the facets of any tessellate(). Equal normals become one, weighted by area: the normal of
///           the face before it was cut. The faces need not touch each other along an edge.
/// Area      Every face counts by its area.
/// Angle     Every face counts by its interior angle at the corner, seen along the face's normal; it is more
///           than 180 degrees at a concave corner. Cutting a flat face changes neither this nor Distinct. If
///           successive corners coincide, the first has the angle. @see Thürmer & Wüthrich 1998
/// Exact, File
///           `exact` holds the normals: one unit vector for each corner of the mesh, or 0 if it is unknown.
///           There, and everywhere if `exact` is empty, Distinct applies.
///
/// At a corner of a face, only those faces take part whose normals are within `creaseDegrees` of the face's
/// own. A tie takes part (cosines are compared to 2^-40). At 180 all faces take part; at 0 only the face
/// itself and faces in its plane. At a corner of a face without area all take part. The crease does not apply
/// to exact normals.
///
/// A sum no longer than 2^-40 of the total length of its terms is all rounding (for example, two faces back
/// to back). The corner then has its own face's normal.
///
/// The error of a sum of up to 30 normals N with weights w is at most 2^-47 (W + sum of w e) / |sum of w N|.
/// W is the sum of w. e is the square of a triangle's longest edge over twice its area, at most 2^30: a
/// needle has a worse normal (plane.h).
///
/// Coordinates may be up to 2^500; faces narrower than 2^-500 count as faces without area. Well within these
/// limits, scaling the mesh and its rounding by a power of two changes no bit of the normals.
///
/// Work: linear, but n log n for n faces at one point, and n^2 there if there is a crease and the surface
/// turns by more than it.
[[nodiscard]] Vertices smoothVertices(const Mesh& mesh, NormalRule rule, double creaseDegrees = 180.0,
                                      std::span<const glm::dvec3> exact = {});

}  // namespace xnewell
