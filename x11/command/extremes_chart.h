#pragma once

#include <string>

#include "shading/color/colored_image.h"
#include "shading/extremes/extremes.h"

namespace xnewell {

/// What becomes wrong first, as a chart: a line for each way to an extreme, with a bar for each picture on
/// it. A bar is as high as the share of samples that are wrong, on a logarithmic scale. It is amber where
/// samples are only doubtful, and grey where no face shows.
[[nodiscard]] ColoredImage drawExtremes(const Extremes& extremes, const std::string& title);

}  // namespace xnewell
