#pragma once

#include <array>
#include <span>
#include <string_view>

#include "shading/color/palette.h"
#include "x11/drawing/painter.h"

namespace xnewell {

/// A legend in one line: what the steps of a map mean, on the background of the map.

struct LegendStep {
  Cell cell;
  std::string_view label;
};
/// Steps of differences. Each is twice as large as the one before; the first is a unit.
inline constexpr std::array kDoublingSteps{
    LegendStep{Cell::WellLine, "below 1"}, LegendStep{Cell::Soft, "1"},  LegendStep{Cell::Faint, "2"},
    LegendStep{Cell::WellText, "4"},       LegendStep{Cell::White, "8"}, LegendStep{Cell::Q, "16"},
};
/// The step that a difference belongs to: below the unit, below twice the unit, below four times the unit,
/// and so on; the last step has no limit, and any difference has it where the unit is 0. Both have the same
/// measure.
[[nodiscard]] const LegendStep& doublingStep(double difference, double unit);
/// Draws the legend from its upper left corner on, with `unit` after the steps.
void drawStepLegend(Painter painter, const CellPlan& plan, int x, int y, std::span<const LegendStep> steps,
                    std::string_view unit);

}  // namespace xnewell
