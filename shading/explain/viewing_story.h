#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <string>

#include "geometry/view/stages.h"
#include "shading/explain/equation_at.h"
#include "shading/picture/picture.h"

namespace xnewell {

/// What the viewing transformation does to a vertex, to a plane through it, and to the light on that plane,
/// stage by stage.

/// A corner of a face of the scene's own mesh. Both are counted from 0; people count corners from 1.
struct FaceCorner {
  int face = 0, corner = 0;
  bool operator==(const FaceCorner&) const = default;
};
/// "495.1": face 495, its first corner.
[[nodiscard]] std::string textOf(const FaceCorner& vertex);
/// Reads that, or the number of a vertex of the mesh: then it is a corner of the first face that has it.
/// Nothing if the mesh has no such vertex.
[[nodiscard]] std::optional<FaceCorner> cornerOf(const Mesh& mesh, const std::string& text);
/// The vertex that people look at first: a corner of the face in the middle of the picture, or if none shows
/// there, the corner that is seen nearest to the middle. It is the corner nearest to the middle.
[[nodiscard]] FaceCorner middleCorner(const Picture& picture);

/// The vertex and its plane at one stage.
struct VertexAtStage {
  glm::dvec4 at{0};  ///< as ViewStages::at()
  glm::dvec3 N{0};   ///< the plane's normal, towards the side that is lit; 0 for a face without area
  /// True if the way from the world to this stage keeps angles, near the vertex.
  bool keepsAngles = true;
  /// The equation with N, L and V carried to this stage.
  ExplainedEquation equation;
  /// N.L of the first light; none where all light is ambient, or where N is 0.
  std::optional<double> NdotL;
  double I = 0;             ///< the equation's sum, or the luminance of the three; it may exceed 1
  std::optional<int> cell;  ///< that the table has for it; none where the cells hold single colours
};

struct ViewingStory {
  /// The vertex is one of the scene's own mesh. The light is that of the vertex with the normal of the face's
  /// plane, as flat shading has it, without a texture. The story has lengths in the scene's units.
  ViewingStory(const Picture& picture, FaceCorner vertex);

  FaceCorner vertex;
  int point = 0;     ///< index of the vertex in the mesh
  glm::dvec3 place;  ///< in the world
  ViewStages stages;
  std::array<VertexAtStage, kViewStages.size()> at;

  unsigned outside = 0;   ///< the clip planes at which the vertex lies outside (ViewStages::outside())
  unsigned cut = 0;       ///< those that cut the face
  bool faceGone = false;  ///< the face lies outside one of them, so nothing of it is left
  int zShift = 0;         ///< as in SnappedScene
  /// The vertex on the grid, if no plane cuts it away. `ofPicture`: it is read from the picture's polygons,
  /// and not computed again, as where the face is culled.
  std::optional<glm::ivec3> snapped;
  bool ofPicture = false;
  /// True unless the picture's vertex is another than the stages lead to.
  bool agrees = true;
  /// From the snap on, the depth of the plane in pixels: z = x a + y b + c.
  std::optional<glm::dvec3> plane;

  [[nodiscard]] const VertexAtStage& of(ViewStage stage) const { return at[static_cast<std::size_t>(stage)]; }
  [[nodiscard]] const VertexAtStage& world() const { return at.front(); }
  /// True if N.L, or I, is another one than in the world, by more than rounding.
  [[nodiscard]] bool differsInNdotL(ViewStage stage) const;
  [[nodiscard]] bool differsInI(ViewStage stage) const;
};

/// The name of a plane of clipPlanes(): "front", "back", "left".
[[nodiscard]] std::string_view clipPlaneName(int plane);

}  // namespace xnewell
