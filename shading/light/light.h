#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <string_view>

namespace xnewell {

/// Light sources. @see Foley & van Dam 2e §16.1

/// A directional light is so far away that L is the same everywhere. A spot is a point light that shines into
/// a cone.
enum class LightKind { Directional, Point, Spot };
struct LightRow {
  LightKind id;
  std::string_view name;
};
inline constexpr std::array kLights{
    LightRow{LightKind::Directional, "directional"},
    LightRow{LightKind::Point, "point"},
    LightRow{LightKind::Spot, "spot"},
};

/// What the distance d leaves of a point light or a spot. d is in units of the world, so 1/d has a meaning.
enum class Attenuation { None, Inverse, InverseSquare, Linear, Textbook };
struct AttenuationRow {
  Attenuation id;
  std::string_view name, f;
};
inline constexpr std::array kAttenuations{
    AttenuationRow{Attenuation::None, "none", "1"},
    AttenuationRow{Attenuation::Inverse, "inverse", "min(1, 1/d)"},
    AttenuationRow{Attenuation::InverseSquare, "inverse-square", "min(1, 1/d^2)"},
    AttenuationRow{Attenuation::Linear, "linear", "max(0, 1 - d/range)"},
    AttenuationRow{Attenuation::Textbook, "textbook", "min(1, 1/(c1 + c2 d + c3 d^2))"},
};

struct Light {
  LightKind kind = LightKind::Directional;
  glm::dvec3 Ip{0};               ///< RGB, each in [0, 1]
  glm::dvec3 direction{0, 0, 1};  ///< directional: towards the light; spot: its axis, away from it. Not 0
  glm::dvec3 position{0};         ///< of a point light or a spot, world coordinates
  Attenuation attenuation = Attenuation::None;
  double range = 1;               ///< dmax of `linear`, > 0
  glm::dvec3 c{1, 0, 0};          ///< c1, c2, c3 of `textbook`, >= 0
  double inner = 15, outer = 20;  ///< degrees from the spot's axis, 0 <= inner <= outer <= 180
  int falloff = 1;                ///< the exponent between the two cones, 0..1,000,000
  bool operator==(const Light&) const = default;
};

/// Ia + the sum of all Ip must not exceed 1 in any channel. The rounding of decimal numbers is allowed for.
inline constexpr double kMostLight = 1.0 + 0x1p-40;

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
