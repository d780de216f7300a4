#pragma once

#include "shading/color/rgb_image.h"
#include "x11/views/views.h"

namespace xnewell {

/// The normals that the light is computed with as colours, those of the faces or interpolated ones: red,
/// green and blue are (N + 1) / 2 of x to the right, y up and z towards the viewer. On a coarse grid they are
/// needles too, as long as they are seen.

/// (N + 1) / 2 for each sample that shows something, black elsewhere.
[[nodiscard]] RgbImage normalColors(const Picture& picture);

/// They as an image of the picture's size on the plan's well, with needles, in colours of its own: the
/// scene's cells hold those, and the palette is `palette` but for them.
[[nodiscard]] ColoredImage normalsImage(const Picture& picture, const CellPlan& plan, const Palette& palette);

/// The picture of normals, a ball as the key to its colours, and what they mean in words.
[[nodiscard]] ColoredImage drawNormals(const Picture& picture, const ViewSettings& settings);
[[nodiscard]] PictureSettings pictureForNormals(const ViewSettings& settings);

}  // namespace xnewell
