#pragma once

#include <iosfwd>
#include <string>

#include "shading/picture/picture.h"

namespace xnewell {

/// `trace --scanline`: how a polygon is filled, one JSON object a line. The first, "event": "polygon", says
/// what is filled; then "edge" for each edge of a part, "row" for each of its rows and "pixel" for each
/// sample; the last, "summary", has the largest drift. Places are in pixels. Each line has a sentence,
/// "says". `oneHue`: the picture has one hue in place of the scene's colours.
/// @throws std::invalid_argument if the picture has no such polygon, or if it has too many samples
/// @throws std::system_error if `out` accepts no more
void printScanline(const std::string& scene, const std::string& polygon, const Picture& picture, bool oneHue,
                   std::ostream& out);

}  // namespace xnewell
