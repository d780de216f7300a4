#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "geometry/view/camera.h"
#include "geometry/view/stages.h"
#include "shading/fill/ramp.h"
#include "shading/picture/picture.h"
#include "x11/window/setting_controls.h"

namespace xnewell {

/// The textbook's viewing specification as controls: P the projection, O and a an oblique one, v VRP, n VPN,
/// y VUP, p PRP, o the window, f and b the front and the back plane.
///
/// A change of one number keeps all others. So the first one says the whole view in the textbook's terms;
/// front and back alone are settings of their own. A number with which there is no view is refused.

/// The direction of projection of a parallel view, as a shear of so many units for each unit along n.
[[nodiscard]] Oblique leanOf(const ViewSpec& view);

/// `camera` is that of the setup. `angle` is that of an oblique view when it had one last.
[[nodiscard]] Controls viewControls(const Subject& subject, const Camera& camera, double angle,
                                    const ChangeSetup& change, Prompt& prompt);

/// The light on a scene as it is in the world: no stage of the viewing transformation changes it. It is
/// evaluated at vertices where the picture's method interpolates, and else once for each face, for both
/// sides.
class LitParts {
 public:
  explicit LitParts(const Picture& picture, const Palette& palette)
      : LitParts{picture, palette, nullptr, ViewStage::World} {}
  /// The light as a program would have it that shades at another stage: N, L and V are carried there
  /// (EquationAt::behind()).
  LitParts(const Picture& picture, const Palette& palette, const ViewStages* stages, ViewStage shadedIn);

  /// The intensity at a corner of the scene's own mesh.
  [[nodiscard]] double at(int corner, bool back) const {
    return intensities_[static_cast<std::size_t>(pointOf_[static_cast<std::size_t>(corner)])].seen(back);
  }
  /// The ramp of a face; null where the cells hold single colours: then cell() has it.
  [[nodiscard]] const CellOnRamp* ramp(int face) const {
    return colored_ ? nullptr : &ramps_[static_cast<std::size_t>(material_[face] + 1)];
  }
  [[nodiscard]] std::uint8_t cell(int face, bool back) const {
    return cells_[2 * static_cast<std::size_t>(face) + (back ? 1 : 0)];
  }

 private:
  const std::vector<int>& material_;
  std::vector<int> pointOf_;  ///< by corner of the mesh
  std::vector<FrontBack<double>> intensities_;
  std::vector<Ramp> of_;
  std::vector<CellOnRamp> ramps_;  ///< by material; the first is for faces without one
  bool colored_ = false;
  std::vector<std::uint8_t> cells_;  ///< two for each face, if the cells hold single colours
};

}  // namespace xnewell
