#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "geometry/model/mesh.h"

namespace xnewell {

/// Normals of the surface that the faces stand for, at their corners: what Gouraud and Phong shading
/// interpolate. @see Gouraud 1971, Foley & van Dam 2e §16.2.2

enum class NormalRule { Sum, Distinct, Area, Angle, Exact };
struct NormalRow {
  NormalRule id;
  std::string_view name, takes;
};
inline constexpr std::array kNormalRules{
    NormalRow{NormalRule::Sum, "sum", "the unit normals of the faces that share the vertex"},
    NormalRow{NormalRule::Distinct, "distinct", "the same, those of one plane once"},
    NormalRow{NormalRule::Area, "area", "the same, each by its face's area"},
    NormalRow{NormalRule::Angle, "angle", "the same, each by its face's angle at the vertex"},
    NormalRow{NormalRule::Exact, "exact", "the surface itself, where there are patches; else distinct"},
};

/// Where the illumination is evaluated for the corners of faces: a place, a surface and its normal.
struct Vertex {
  int point = 0;      ///< index into Mesh::points
  int material = -1;  ///< as Mesh::material
  glm::dvec3 N{0};    ///< unit; 0 where no face at the point has an area
  bool operator==(const Vertex&) const = default;
};

/// The corners of a mesh, those that agree in place, material and every bit of the normal as one vertex.
struct Vertices {
  std::vector<Vertex> vertices;  ///< in order of their points, those of one point as its corners come
  std::vector<int> ofCorner;     ///< as many as Mesh::corners, index into vertices
};

/// The normals at the corners of a mesh's faces, unit vectors on the side from which faces run
/// counter-clockwise. A face is what the file calls one, however it is divided later; a face without area
/// contributes nothing.
///
/// Sum       A face counts once at a point, and a flat face that the file holds in triangles as often as
///           those meet there: a cube in 12 triangles leans where a side brings two to a corner.
/// Distinct  Normals are equal if they are no further apart than the rounding of the file, and of doubles,
///           can have turned them (at most 2^-10, about 0.06 degrees, each: finer than the facets of any
///           tessellate()). Equal ones count as one, that of their areas together: of the face before it was
///           cut. Whether they touch is no matter.
/// Area      The vector areas.
/// Angle     A corner counts by its interior angle, seen along the face's normal: more than 180 degrees where
///           the face is concave. Cutting a flat face changes neither this nor Distinct. Of successive
///           corners at one place the first has the angle. @see Thürmer & Wüthrich 1998
/// Exact     `exact` has one unit normal for every corner of the mesh, 0 where it is not known, or nothing;
///           there, Distinct holds.
///
/// A corner takes part only with faces whose normal is within `creaseDegrees` of its own face's, those at the
/// very angle included (cosines are compared to 2^-40): all at 180, its own face and its plane at 0. A corner
/// of a face without area takes all. Exact normals know no crease.
///
/// A sum no longer than 2^-40 of its terms' lengths is all rounding (two faces back to back): the corner then
/// has its own face's normal.
///
/// Coordinates up to 2^500; faces narrower than 2^-500 count as without area. Well within this a mesh that is
/// scaled by a power of two, and its rounding with it, has the same normals to the bit.
///
/// Work: linear; n log n for n faces at one point, with a crease n^2 where the surface turns by more there.
[[nodiscard]] Vertices smoothVertices(const Mesh& mesh, NormalRule rule, double creaseDegrees = 180.0,
                                      std::span<const glm::dvec3> exact = {});

}  // namespace xnewell
