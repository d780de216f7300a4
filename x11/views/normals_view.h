#pragma once

#include "shading/color/rgb_image.h"
#include "x11/views/views.h"

namespace xnewell {

/// The normals that the shading uses, shown as colours: those of the faces, or interpolated ones. Red, green
/// and blue are (N + 1) / 2 of x to the right, y up and z towards the viewer. On a coarse grid they are drawn
/// as needles too, foreshortened as seen.

/// (N + 1) / 2 for each sample that shows a face, black elsewhere.
[[nodiscard]] RgbImage normalColors(const Picture& picture);

/// The normals as an image of the picture's size, with needles, on the plan's dark background. The image has
/// colours of its own in the scene's cells; the rest of its palette is `palette`.
[[nodiscard]] ColoredImage normalsImage(const Picture& picture, const CellPlan& plan, const Palette& palette,
                                        int unit = 1);

/// The picture of normals, a ball that explains its colours, and what they mean in words.
[[nodiscard]] ColoredImage drawNormals(const Picture& picture, const ViewSettings& settings);
[[nodiscard]] PictureSettings pictureForNormals(const ViewSettings& settings);

}  // namespace xnewell
