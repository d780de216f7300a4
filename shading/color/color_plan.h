#pragma once

#include <array>
#include <string_view>

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

}  // namespace xnewell
