#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "shading/color/color_table.h"

namespace xnewell {

/// Divides the scene's cells among several hues: each hue gets its own ramp, with as many shades as it needs.

/// What a picture needs of one hue.
struct HueNeed {
  glm::dvec3 hue{1, 0, 0};   ///< each in [0, 1], the largest is 1
  double low = 0, high = 1;  ///< the least and the greatest intensity shown, in [0, 1]
  std::int64_t samples = 0;  ///< how many samples show the hue
};

/// The ramp of each hue, one after the other from the table's first cell. Each is `table` with a part of its
/// shades, at least two. Precondition: 2 <= 2 #needs <= table.shades; a picture with more hues is a task for
/// quantize().
///
/// The plan minimizes the sum, over all samples, of the step between neighbouring shades. In `brief` and
/// `linear` the step is a difference of intensities, (high - low) / (N - 1). In `corrected` it is a ratio
/// minus 1, (high / low)^(1 / (N - 1)) - 1, with low at least I0. No 8-bit value shows a step below 1/255, so
/// such a step counts as 1/255. Each further shade lowers a step by less than the one before. So the best
/// plan gives the shades one by one, each to the hue that gains most by it (Fox 1966), or to the first of
/// several. A shade that no hue gains by is not given: its cell stays free.
[[nodiscard]] std::vector<TableSettings> planHues(std::span<const HueNeed> needs, const TableSettings& table);

/// The step between neighbouring shades, as planHues() counts it, for a ramp of N >= 2 shades.
[[nodiscard]] double stepOf(const HueNeed& need, const TableSettings& table, int N);

}  // namespace xnewell
