#pragma once

#include <optional>

#include "shading/color/colored_image.h"
#include "x11/server/canvas.h"
#include "x11/server/colormap.h"

namespace xnewell {

/// What a canvas shows as cells, not as colours: pixel values from the server, and the index of each.
///
/// With a colormap of our own a pixel value is one cell's, so its number is read and not assumed. Where cells
/// are emulated several may share a pixel value: then it is the one that was sent there, or where the server
/// has painted since, the first of them. Colours are those that the server says these pixels show.
/// Nothing where some pixel value is no cell's, as where a colour is dithered.
/// @throws X11Error if the server cannot
[[nodiscard]] std::optional<ColoredImage> readCells(const Canvas& canvas, const ServerColormap& colormap,
                                                    const IndexImage& sent);

}  // namespace xnewell
