#pragma once

#include <functional>
#include <optional>

#include "geometry/view/camera.h"
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

}  // namespace xnewell
