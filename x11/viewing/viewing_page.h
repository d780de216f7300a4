#pragma once

#include <array>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <string>
#include <string_view>

#include "shading/explain/viewing_story.h"
#include "shading/scene/scene.h"
#include "x11/kit/page.h"

namespace xnewell {

/// What there is to say about the viewing transformation, for `explain --viewing` and for view 9.

/// The length that the words take for 1, in the scene's units: one of the file's. Where that would need very
/// long numbers, it is the scene's own.
[[nodiscard]] double lengthUnit(const Scene& scene);
/// "lengths are multiples of 2^41 of the file's" where that is another one than the file's; else "".
[[nodiscard]] std::string lengthsText(const Scene& scene);
/// The vertex of --viewing; "" is one in the middle of the picture. @throws UsageError if there is none
[[nodiscard]] FaceCorner vertexOf(const Picture& picture, const std::string& text);
/// "upper body": the group of the vertex's face; "face 495" where it has no name.
[[nodiscard]] std::string partOf(const Scene& scene, const FaceCorner& vertex);
/// A place at a stage, with lengths in the unit.
[[nodiscard]] glm::dvec4 shownAt(const ViewingStory& story, ViewStage stage, double unit);

/// Which matrix is shown of a stage.
enum class ShownMatrix { ThisStage, AllSoFar, ToTheScreen };
inline constexpr std::array<std::string_view, 3> kShownMatrices{"this stage", "all so far", "to the screen"};
/// A matrix with the vertex before and after it, with lengths in the unit. What it makes of the vertex is
/// homogeneous.
struct MatrixWithVertex {
  glm::dmat4 matrix{1.0};
  glm::dvec4 from{0}, to{0};
};
[[nodiscard]] MatrixWithVertex matrixOf(const ViewingStory& story, ViewStage stage, ShownMatrix shown,
                                        double unit);

/// "3 sheared: the eye is the origin, the pyramid stands upright"
[[nodiscard]] std::string stageTitle(const ViewingStory& story, ViewStage stage);
/// What a stage does to the light.
[[nodiscard]] page::Finding findingOf(const ViewingStory& story, ViewStage stage);
/// N straight up and L at its true angle at a stage; if it is `lit`, with I and its cell.
void drawAngle(Pen& pen, const Rect& box, const ViewingStory& story, ViewStage stage, bool lit = true);

/// What can be pressed: a row of the table.
inline constexpr int kPressStage = 1;

namespace page {

struct OfViewing {
  std::shared_ptr<const ViewingStory> story;
  const Picture& picture;
};
/// All stages, for a text and JSON.
[[nodiscard]] Page ofViewing(const OfViewing& of);
/// The table of the vertex and its plane, with a stage chosen.
[[nodiscard]] Page stagesOf(const OfViewing& of, ViewStage stage);
/// A matrix, and the light at the stage and in the world.
[[nodiscard]] Page matrixAndLight(const OfViewing& of, ViewStage stage, ShownMatrix shown);

}  // namespace page

}  // namespace xnewell
