#pragma once

#include <string>

#include "x11/window/controls.h"

namespace xnewell {

/// A setup in words.

/// The picture's making in a line: "flat; sorted by farthest z; own scanline; perspective".
[[nodiscard]] std::string captionOf(const Setup& setup);
/// "sorted by farthest z"
[[nodiscard]] std::string orderInWords(Order order);

}  // namespace xnewell
