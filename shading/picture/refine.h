#pragma once

#include <array>
#include <string_view>

#include "geometry/model/divide.h"
#include "geometry/model/mesh.h"
#include "geometry/model/vertex_normals.h"
#include "shading/fill/intensities.h"
#include "shading/light/illumination.h"

namespace xnewell {

/// Adaptive subdivision. Where flat or Gouraud shading misses the illumination by more than a tolerance at a
/// sample, the polygon is divided until it does not. All other polygons stay as they are. So the rim of a
/// spot's cone, and a highlight inside a large polygon, appear in the right place. The samples are a grid of
/// eight steps along each edge. Light that falls between all samples of a triangle is missed.
///
/// A polygon is divided into the fan of triangles that shading interpolates over (face_triangles.h). A
/// triangle is halved across its longest edge. Every other triangle with that edge is cut there too, even if
/// it has other normals or belongs to another surface; it is first cut across its own longest edge. So no
/// crack opens, and no angle becomes less than half the smallest angle of the first triangle.
/// @see M. C. Rivara, "Mesh Refinement Processes Based on the Generalized Bisection of Simplices", SIAM J.
/// Numer. Anal. 21 (3), 1984; I. G. Rosenberg, F. Stenger, "A Lower Bound on the Angles of Triangles
/// Constructed by Bisecting the Longest Side", Math. Comp. 29 (130), 1975
///
/// Two edges are the same if their ends have the same coordinates, whatever their indices in the file. All of
/// this is in world coordinates. Of the camera only the eye matters, because of the specular term.
///
/// Where the illumination jumps, no interpolation can follow it, and the division ends at a limit: at the
/// border of a cone without a soft rim, and where a highlight ends at N.L = 0.

/// Why the division ended.
enum class RefineLimit {
  None,      ///< every part is within the tolerance, at every sample
  Halvings,  ///< some parts are not, but are as small as they may become
  Parts,     ///< the next round would have made too many parts
};
struct RefineLimitRow {
  RefineLimit id;
  std::string_view name;
};
inline constexpr std::array kRefineLimits{
    RefineLimitRow{RefineLimit::None, "none"},
    RefineLimitRow{RefineLimit::Halvings, "halvings"},
    RefineLimitRow{RefineLimit::Parts, "parts"},
};

struct RefineSettings {
  double tolerance = 0.02;  ///< an intensity, in (0, 1]
  int halvings = 20;        ///< of one triangle: after 20 its edges are a thousandth as long
  int parts = 1'000'000;  ///< the most there may be; a polygon left whole counts as the triangles of its fan
};

/// A scene's polygons, divided. No number changes: new points, corners and vertices come after the old ones.
struct Refined {
  Mesh mesh;          ///< also the new points, and the new corners with their texture coordinates
  ConvexParts parts;  ///< in the planes of their polygons; a polygon left whole keeps its outline
  Vertices vertices;  ///< Gouraud: a new vertex has the normal that Phong shading interpolates; flat: empty
  ShadingPoints points;  ///< one for each vertex; flat: one for each part, with its face's normal
  RefineLimit limit = RefineLimit::None;
};

/// For Gouraud shading.
[[nodiscard]] Refined refineSmooth(const Mesh& mesh, const ConvexParts& parts, const Vertices& vertices,
                                   const Lighting& lighting, const RefineSettings& settings);
/// For flat shading. `faces` are those of facePoints(): a part that is left whole keeps the place of its
/// face.
[[nodiscard]] Refined refineFlat(const Mesh& mesh, const ConvexParts& parts, const ShadingPoints& faces,
                                 const Lighting& lighting, const RefineSettings& settings);

}  // namespace xnewell
