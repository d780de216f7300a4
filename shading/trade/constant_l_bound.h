#pragma once

#include <optional>

#include "shading/scene/scene.h"

namespace xnewell {

/// By how much L constant (--constant-l) may change an intensity anywhere in the box around the scene, in any
/// channel, whatever the normals are and wherever the eye is. Nothing if a lamp is inside the sphere around
/// that box, or if there is no lamp at a place.
///
/// A lamp at distance d from the centre of a sphere of radius r is seen from all places of the sphere within
/// an angle asin(r / d) of L at the centre. So unit vectors differ by delta = 2 sin(asin(r / d) / 2) at most,
/// N.L differs by delta, and the tutorial's cos^n by n delta. The other highlights begin abruptly where N.L
/// is 0, so for them nothing less than 1 is sure. fatt lies between its values at d - r and d + r.
[[nodiscard]] std::optional<double> boundOfConstantL(const Scene& scene, const Illumination& user);

}  // namespace xnewell
