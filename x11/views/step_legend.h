#pragma once

#include <array>
#include <span>
#include <string_view>

#include "shading/color/palette.h"
#include "x11/drawing/painter.h"

namespace xnewell {

/// What the steps of a map mean, in one line on the map's own ground.

struct LegendStep {
  Cell cell;
  std::string_view label;
};
/// Of differences in steps that double from a unit on.
inline constexpr std::array kDoublingSteps{
    LegendStep{Cell::WellLine, "below 1"}, LegendStep{Cell::Soft, "1"},  LegendStep{Cell::Faint, "2"},
    LegendStep{Cell::WellText, "4"},       LegendStep{Cell::White, "8"}, LegendStep{Cell::Q, "16"},
};
/// Which of them a difference belongs to: below the unit, below twice the unit, four times, ...; the last has
/// all that is beyond. Difference and unit in the same measure, unit > 0.
[[nodiscard]] const LegendStep& doublingStep(double difference, double unit);
/// From the upper left corner; `unit` stands behind the steps.
void drawStepLegend(Painter painter, const CellPlan& plan, int x, int y, std::span<const LegendStep> steps,
                    std::string_view unit);

}  // namespace xnewell
