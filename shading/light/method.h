#pragma once

#include <array>
#include <string_view>

namespace xnewell {

/// The shading methods, one row each. @see Foley & van Dam 2e §16.2

enum class Shading { Full, Depth, Flat, Gouraud, Phong, Environment };
struct ShadingRow {
  Shading id;
  std::string_view name, label, words;
  bool lit;           ///< whether it needs the illumination
  bool interpolates;  ///< whether it needs normals at vertices
  std::string_view evaluates;
};
inline constexpr std::array kShadings{
    ShadingRow{Shading::Full, "none", "none", "full intensity", false, false,
               "nothing: every face at full intensity"},
    ShadingRow{Shading::Depth, "depth", "depth", "depth", false, false,
               "color = max - (z1 + z2 + z3) / a: the nearer, the brighter"},
    ShadingRow{Shading::Flat, "flat", "flat", "flat", true, false,
               "the illumination once a face, at its centroid"},
    ShadingRow{Shading::Gouraud, "gouraud", "Gouraud", "Gouraud", true, true,
               "the illumination at vertices; intensities are interpolated (Gouraud 1971)"},
    ShadingRow{Shading::Phong, "phong", "Phong", "Phong", true, true,
               "the illumination at every pixel; normals are interpolated (Phong 1975)"},
    ShadingRow{Shading::Environment, "envmap", "env", "environment map", true, true,
               "nothing at a pixel: a map is looked up by x and y of the interpolated normal"},
};
[[nodiscard]] constexpr const ShadingRow& rowOf(Shading shading) {
  return kShadings[static_cast<std::size_t>(shading)];
}

/// How values are interpolated over a polygon with more than three corners. The default divides it into
/// triangles, because a plane over the screen passes through three values. The first programs stepped along
/// the edges, then along each row. That uses every corner, but a value inside depends on how the polygon is
/// turned.
enum class Polygons { Triangles, Rows };
struct PolygonsRow {
  Polygons id;
  std::string_view name, interpolates;
};
inline constexpr std::array kPolygons{
    PolygonsRow{Polygons::Triangles, "triangles", "a fan of triangles, the same in every view"},
    PolygonsRow{Polygons::Rows, "rows", "along the edges, then along each row: turns with the view"},
};

/// What Gouraud shading interpolates. The default finds the cell of the intensity at each pixel. The short
/// cut finds the cells at the vertices and interpolates their numbers, so no pixel looks up a table. In an
/// even table it is off by less than a cell: each vertex is rounded by half a cell, and each pixel again.
/// Where the cells are not even (corrected), it is another picture: between two vertices the numbers are
/// even, and so the intensities are not.
enum class Interpolated { Intensity, Cell };
struct InterpolatedRow {
  Interpolated id;
  std::string_view name, label, words;
};
inline constexpr std::array kInterpolated{
    InterpolatedRow{Interpolated::Intensity, "intensity", "intensity", "intensities interpolated"},
    InterpolatedRow{Interpolated::Cell, "cell", "cell number", "cell numbers interpolated"},
};

}  // namespace xnewell
