#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "geometry/divide.h"
#include "geometry/mesh.h"

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

/// The corners of a mesh, those that agree in place, material and normal as one vertex.
struct Vertices {
  std::vector<Vertex> vertices;
  std::vector<int> ofCorner;  ///< as many as Mesh::corners, index into vertices
};
