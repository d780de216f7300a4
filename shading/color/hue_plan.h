#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "shading/color/color_table.h"

namespace xnewell {

/// Several hues share the cells of the scene: each has a ramp of its own, of as many shades as it needs.

/// What a picture shows of one hue.
struct HueNeed {
  glm::dvec3 hue{1, 0, 0};   ///< each in [0, 1], the largest 1
  double low = 0, high = 1;  ///< the least and the greatest intensity, in [0, 1]
  std::int64_t samples = 0;  ///< how many show it
};

/// The ramp of each hue, one after the other from the table's first cell: `table` with its shades divided,
/// each hue's at least two. Precondition: 2 <= 2 #needs <= table.shades; more hues than that are a picture
/// for quantize().
///
/// The sum over all samples of the step between neighbouring shades is least: of the intensity in `brief` and
/// `linear`, (high - low) / (N - 1), in `corrected` of the ratio, (high / low)^(1 / (N - 1)) - 1; a step
/// below 1/255, which no 8-bit value shows, counts as 1/255. As steps are convex in N, giving one shade after
/// the other to the hue that gains most by it is best (Fox 1966); among equals it goes to the first. Intensities
/// that nobody gains by are not given: their cells stay free.
[[nodiscard]] std::vector<TableSettings> planHues(std::span<const HueNeed> needs, const TableSettings& table);

/// The step that counts for a hue of N shades.
[[nodiscard]] double stepOf(const HueNeed& need, const TableSettings& table, int N);

}  // namespace xnewell
