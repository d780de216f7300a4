#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <string_view>

#include "geometry/view/project.h"
#include "geometry/view/view.h"

namespace xnewell {

/// The viewing transformation as seven stages, for people who want to see what each of them does. snap()
/// multiplies the same matrices (viewMatrices()) into one, because a picture needs only their product.

/// Clipped: snap() clips at the front plane, at the back plane, and far outside the picture (clip.h).
/// Viewport: in pixels, divided by w. Snapped: whole steps of the grid, where no matrix follows.
enum class ViewStage { World, Vrc, Sheared, Warped, Clipped, Viewport, Snapped };
struct ViewStageRow {
  ViewStage id;
  std::string_view name;
  std::string_view parallel, perspective;  ///< the stage's matrix in the textbook's letters; "": none
};
inline constexpr std::array kViewStages{
    ViewStageRow{ViewStage::World, "world", "", ""},
    ViewStageRow{ViewStage::Vrc, "VRC", "R T(-VRP)", "R T(-VRP)"},
    ViewStageRow{ViewStage::Sheared, "sheared", "SH", "SH T(-PRP)"},
    ViewStageRow{ViewStage::Warped, "warped", "S T", "M S"},  // a parallel view is only scaled here
    ViewStageRow{ViewStage::Clipped, "clipped", "", ""},
    ViewStageRow{ViewStage::Viewport, "viewport", "S T", "S T"},
    ViewStageRow{ViewStage::Snapped, "snapped", "", ""},
};
[[nodiscard]] constexpr const ViewStageRow& rowOf(ViewStage stage) {
  return kViewStages[static_cast<std::size_t>(stage)];
}

/// The stages of one view. All lengths have the units of the view's.
class ViewStages {
 public:
  /// @throws ViewError
  ViewStages(const ViewSpec& view, int width, int height);

  /// The matrix of a stage alone; 1 for those that have none.
  [[nodiscard]] const glm::dmat4& matrix(ViewStage stage) const { return matrix_[index(stage)]; }
  /// In the textbook's letters.
  [[nodiscard]] std::string_view letters(ViewStage stage) const;
  /// The product of the matrices up to this stage: from the world.
  [[nodiscard]] const glm::dmat4& soFar(ViewStage stage) const { return soFar_[index(stage)]; }
  /// The product of the matrices after this stage: to the screen.
  [[nodiscard]] glm::dmat4 toScreen(ViewStage stage) const;

  /// A place of the world at a stage, each matrix applied to the result of the one before. Up to Clipped it
  /// is homogeneous: w is 1 before the warp. From Viewport on it is divided by w, and Snapped is Viewport
  /// before it is rounded by snapToGrid().
  [[nodiscard]] glm::dvec4 at(ViewStage stage, const glm::dvec3& place) const;

  /// The map from the world to a stage near a place: its derivative, after the division by w. Its columns are
  /// where steps along x, y and z go. Precondition: w of the place is not 0.
  [[nodiscard]] glm::dmat3 derivative(ViewStage stage, const glm::dvec3& place) const;

  /// The planes that snap() clips at which a place, not yet divided by w, lies outside: bit k for plane k of
  /// clipPlanes().
  [[nodiscard]] unsigned outside(const glm::dvec3& place) const;

 private:
  static std::size_t index(ViewStage stage) { return static_cast<std::size_t>(stage); }

  Projection projection_;
  glm::dvec3 vrp_;
  glm::dmat3 rotation_;
  std::array<glm::dmat4, kViewStages.size()> matrix_, soFar_;
  std::array<ClipPlane, 6> planes_;
};

/// A direction after such a map, as a unit vector.
[[nodiscard]] glm::dvec3 carried(const glm::dmat3& derivative, const glm::dvec3& direction);
/// A plane's normal after such a map: the normal of where the plane goes, on the same side of it. It is not
/// where the direction N goes, unless the map keeps angles. 0 if the map is singular.
[[nodiscard]] glm::dvec3 carriedNormal(const glm::dmat3& derivative, const glm::dvec3& N);
/// True if the map keeps the angles between all directions: it turns, moves, mirrors and scales alike in all
/// of them. A relative error of 2^-30 is put down to rounding.
[[nodiscard]] bool keepsAngles(const glm::dmat3& derivative);

}  // namespace xnewell
