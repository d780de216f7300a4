#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "shading/color/color_table.h"
#include "shading/color/images.h"

namespace xnewell {

/// The plans for the colours that the scene's cells hold.

enum class ColorPlan { Needed, OneHue, Hues, Cube, Chosen };
struct ColorPlanRow {
  ColorPlan id;
  std::string_view name, holds;
};
inline constexpr std::array kColorPlans{
    ColorPlanRow{ColorPlan::Needed, "needed", "the first of the other plans that can show the scene"},
    ColorPlanRow{ColorPlan::OneHue, "one", "one hue: colours count by their gray"},
    ColorPlanRow{ColorPlan::Hues, "hues", "a ramp for the hue of each surface, as long as it needs"},
    ColorPlanRow{ColorPlan::Cube, "cube", "full colour: 6 reds x 8 greens x 5 blues"},
    ColorPlanRow{ColorPlan::Chosen, "chosen", "full colour: 240 colours chosen from the picture"},
};

/// Converts a picture of at most 256 colours to an index image. Its colours fill cells 0 and up, in ascending
/// order of red, then green, then blue; the other cells are black. Returns nothing if the picture has more
/// than 256 colours.
[[nodiscard]] std::optional<ColoredImage> inFewColors(const RgbImage& picture);

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
