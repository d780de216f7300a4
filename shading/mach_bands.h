#pragma once

#include "shading/profile.h"
#include "shading/views.h"

/// Where does the eye see stripes that the picture does not hold? The picture with a scanline marked, and
/// under it for each method, exactly under the picture's columns: the scanline repeated as a strip, its
/// intensity, and the change from pixel to pixel; beside them the findings.
///
/// The picture is as wide as the profiles, of the view's own proportions, and cut off above and below where
/// there is no room. A plan of colours becomes one hue: a profile has one channel.
[[nodiscard]] ColoredImage drawMachBands(Picture& picture, const ViewSettings& settings);
