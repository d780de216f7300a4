#pragma once

#include <string>

#include "x11/window/controls.h"

namespace xnewell {

/// The settings of a picture in words.

/// One line that says how a picture is made: "flat; sorted by farthest z; own scanline; perspective".
[[nodiscard]] std::string captionOf(const Setup& setup);
/// The mistake in the equation of a picture, "R reversed"; "" if it has none or shows none.
[[nodiscard]] std::string mistakeIn(const Setup& setup);
/// "sorted by farthest z"
[[nodiscard]] std::string orderText(Order order);
/// "Gouraud", "full intensity"
[[nodiscard]] std::string shadingText(Shading shading);

}  // namespace xnewell
