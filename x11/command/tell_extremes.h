#pragma once

#include "shading/scene/scene.h"
#include "x11/options/options.h"

namespace xnewell {

/// `extremes`: drives a scene to its extremes and tells what becomes wrong first. An interrupt ends it, and
/// it prints the finished ways; a second interrupt ends the program. Returns the exit status.
/// @throws std::system_error before anything is drawn, if the chart cannot be written
[[nodiscard]] int tellExtremes(const Options& options, const Scene& scene);

}  // namespace xnewell
