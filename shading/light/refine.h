#pragma once

#include <array>
#include <string_view>

#include "geometry/model/divide.h"
#include "geometry/model/mesh.h"
#include "geometry/model/vertex_normals.h"
#include "shading/light/illumination.h"
#include "shading/light/intensities.h"

namespace xnewell {

/// Adaptive subdivision: polygons over which flat or Gouraud shading misses the illumination by more than a
/// tolerance (misfit.h) are divided until they do not, the others are left as they are. The rim of a spot's
/// cone and highlights inside large polygons appear where they are.
///
/// A polygon is divided as the fan that shading interpolates over (face_triangles.h), and a triangle is
/// halved across its longest edge. Whoever else has that edge, with other normals or of another surface, is
/// cut there too, across its own longest edge first: so no crack opens, and no angle ever becomes less
/// than half the least that its triangle had. @see Rivara 1984; Rosenberg & Stenger 1975
///
/// Edges are the same if their ends are at the same places, whatever the file's indices. All in world
/// coordinates: of the camera only what the specular term asks for matters, the eye.
///
/// Steps of the illumination end at a limit, for no interpolation follows them: a cone without a soft rim, a
/// highlight where N.L = 0 cuts it off.

/// What ended it.
enum class RefineLimit {
  None,      ///< all is within the tolerance
  Halvings,  ///< some pieces are not, and are as small as they get
  ConvexParts,    ///< the next round would have made too many
};
struct RefineLimitRow {
  RefineLimit id;
  std::string_view name;
};
inline constexpr std::array kRefineLimits{
    RefineLimitRow{RefineLimit::None, "none"},
    RefineLimitRow{RefineLimit::Halvings, "halvings"},
    RefineLimitRow{RefineLimit::ConvexParts, "pieces"},
};

struct RefineSettings {
  double tolerance = 0.02;  ///< in intensity, (0, 1]
  int halvings = 20;        ///< of a triangle for its own sake: then its edges are a thousandth
  int pieces = 1'000'000;   ///< never more, polygons left whole counted by the triangles of their fans
};

/// A scene's polygons, divided. Nothing is renumbered: what is new comes after what is old.
struct Refined {
  Mesh mesh;      ///< with new points; new corners, after those of its faces; and their texture coordinates
  ConvexParts pieces;  ///< coplanar as those they came from; those left whole have the outlines they had
  Vertices vertices;     ///< Gouraud: new ones last, their normals as Phong interpolates them; else empty
  ShadingPoints points;  ///< one a vertex; flat: one a piece, its centroid and its face's normal
  RefineLimit limit = RefineLimit::None;
};

/// For Gouraud shading.
[[nodiscard]] Refined refineSmooth(const Mesh& mesh, const ConvexParts& pieces, const Vertices& vertices,
                                   const Lighting& lighting, const RefineSettings& settings);
/// For flat shading. `faces` as facePoints() has them: a piece that is left whole keeps the place of its
/// face.
[[nodiscard]] Refined refineFlat(const Mesh& mesh, const ConvexParts& pieces, const ShadingPoints& faces,
                                 const Lighting& lighting, const RefineSettings& settings);

}  // namespace xnewell
