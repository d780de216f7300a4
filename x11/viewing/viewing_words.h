#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "shading/explain/viewing_story.h"
#include "shading/scene/scene.h"

namespace xnewell {

/// The words and numbers of the viewing transformation, for `explain --viewing` and for view 9.

/// The length that the words take for 1, in the scene's units: one of the file's. Where that would need very
/// long numbers, it is the scene's own.
[[nodiscard]] double lengthUnit(const Scene& scene);

/// "lengths are multiples of 2^41 of the file's" where that is another one than the file's; else "".
[[nodiscard]] std::string lengthsInWords(const Scene& scene);

/// The vertex of --viewing; "" is one in the middle of the picture. @throws UsageError if there is none
[[nodiscard]] FaceCorner vertexOf(const Picture& picture, const std::string& text);

/// "upper body": the group of the vertex's face; "face 495" where it has no name.
[[nodiscard]] std::string partOf(const Scene& scene, const FaceCorner& vertex);

/// A place at a stage, with lengths in the unit.
[[nodiscard]] glm::dvec4 shownAt(const ViewingStory& story, ViewStage stage, double unit);

/// Which matrix is shown of a stage.
enum class ShownMatrix { ThisStage, AllSoFar, ToTheScreen };
struct ShownMatrixRow {
  ShownMatrix id;
  std::string_view name;
};
inline constexpr std::array kShownMatrices{
    ShownMatrixRow{ShownMatrix::ThisStage, "this stage"},
    ShownMatrixRow{ShownMatrix::AllSoFar, "all so far"},
    ShownMatrixRow{ShownMatrix::ToTheScreen, "to the screen"},
};
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
/// What clipping does to the vertex and its face: "inside all six planes: nothing is cut, the numbers stay".
[[nodiscard]] std::string clippedWords(const ViewingStory& story);
/// "18,344,551  24,581,568  23,474,405 steps of 1/65,536 pixel"
[[nodiscard]] std::string snappedWords(const ViewingStory& story);
/// "z = 0.1234 x - 0.5678 y + 12.34": the plane from the snap on, in pixels.
[[nodiscard]] std::string planeWords(const ViewingStory& story);

/// What a stage does to the light: a sentence in bold, and why.
struct ViewingFinding {
  bool keeps = true;  ///< nothing differs from the world
  std::string heading, why;
};
[[nodiscard]] ViewingFinding findingOf(const ViewingStory& story, ViewStage stage);

}  // namespace xnewell
