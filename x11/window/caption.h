#pragma once

#include <string>

#include "x11/window/controls.h"

namespace xnewell {

/// The settings of a picture in words.

/// How a picture is made, in one line: "flat; sorted by farthest z; own scanline; perspective".
[[nodiscard]] std::string captionOf(const Setup& setup);
/// "sorted by farthest z"
[[nodiscard]] std::string orderInWords(Order order);
/// "Gouraud", "full intensity"
[[nodiscard]] std::string shadingInWords(Shading shading);

}  // namespace xnewell
