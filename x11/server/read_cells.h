#pragma once

#include <optional>
#include <string>

#include "shading/color/images.h"
#include "x11/server/canvas.h"
#include "x11/server/colormap.h"

namespace xnewell {

/// Reads what a canvas shows as an index image: the pixel values from the server, each with its index.
///
/// With a colormap of our own, each pixel value belongs to one cell, so the index is read and not assumed.
/// Where cells are emulated, several indices may share a pixel value. The result is then the index of `sent`,
/// if it has that pixel value; if the server has painted something else since, it is the lowest index that
/// has it. The colours are those that the server says these pixels show.
/// Returns nothing if some pixel value belongs to no index, as for a dithered colour. `sent` must be as large
/// as the canvas.
/// @throws X11Error if the server does not deliver the picture
[[nodiscard]] std::optional<ColoredImage> readCells(const Canvas& canvas, const ServerColormap& colormap,
                                                    const IndexImage& sent);

/// What a canvas shows as the bytes of a PNG file that carries `note`: in cells, if its colours are few.
/// @throws X11Error
[[nodiscard]] std::string pngOf(const Canvas& canvas, const ServerColormap& colormap, const IndexImage& sent,
                                const std::string& note);

}  // namespace xnewell
