#pragma once

#include <iosfwd>

#include "shading/picture/picture.h"

namespace xnewell {

/// Why a pixel has its colour, as text and as JSON: its history, the surface, the equation, the table. The
/// last line says whether the chain ends in the cell that the picture has there.

/// The picture is painted. 0 <= i < width, 0 <= j < height.
void printPixel(const Picture& picture, int i, int j, std::ostream& out);
/// One JSON object: `verdict`, `cell`, `I`, `terms`, and the numbers of each link.
void printPixelAsJson(const Picture& picture, int i, int j, std::ostream& out);

}  // namespace xnewell
