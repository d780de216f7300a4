#include "x11/visual/tool_colors.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "shading/color/color_difference.h"

namespace xnewell {

namespace {

/// One colour to choose, and the earlier choices between which its lightness must lie. The rows are in the
/// order of choice.
struct Choice {
  Cell cell;
  std::optional<Cell> above, below;
};
using enum Cell;
constexpr std::array kChoices{
    Choice{Black, {}, {}},      Choice{White, {}, {}},          Choice{Paper, {}, {}},
    Choice{WellLine, {}, {}},   Choice{Well, {}, WellLine},     Choice{Soft, WellLine, Paper},
    Choice{Faint, Soft, Paper}, Choice{WellText, Faint, White}, Choice{Rule, {}, Paper},
    Choice{Panel, Rule, Paper}, Choice{Ink, {}, Soft},          Choice{P, WellLine, Rule},
    Choice{Q, WellLine, Paper}, Choice{Good, {}, Panel},        Choice{Alarm, {}, Panel},
    Choice{Focus, Rule, Paper},
};
static_assert(kChoices.size() == kCells);

/// If words miss their colour by more than this (CIEDE2000), they had better be black. With 3:3:2 bits no
/// colour misses by more than 13. Where blue has fewer levels, the nearest to gray is an orange, which misses
/// by 28.
constexpr double kStrange = 20;

Lab labOf(const glm::ivec3& c) {
  const auto wide = [](int v) { return static_cast<std::uint16_t>(257 * v); };
  return labFromSrgb(Rgb16{wide(c.r), wide(c.g), wide(c.b)});
}

}  // namespace

ToolColors chooseToolColors(const OfferedColors& offered, const std::array<glm::ivec3, kCells>& wanted,
                            const std::array<std::optional<OfferedColor>, kCells>& has) {
  ToolColors chosen{};
  const auto of = [&](Cell cell) -> OfferedColor& { return chosen[static_cast<int>(cell)]; };
  for (const auto& [cell, above, below] : kChoices) {
    const int role = static_cast<int>(cell);
    if (has[role]) {
      chosen[role] = *has[role];
      continue;
    }
    const Lab aim = labOf(wanted[role]);
    bool within = false;  // true if the best so far lies between its two neighbours
    double least = std::numeric_limits<double>::infinity();
    for (const OfferedColor& c : offered.around(wanted[role])) {
      const Lab lab = labOf(c.color);
      const bool between =
          !(above && lab.L <= labOf(of(*above).color).L) && !(below && lab.L >= labOf(of(*below).color).L);
      const double difference = ciede2000(lab, aim);
      if (between == within ? difference >= least : within) continue;
      within = between, least = difference, chosen[role] = c;
    }
  }
  for (const Cell text : {Faint, Soft, Ink, Good, Alarm, P}) {
    const glm::ivec3 color = of(text).color;
    const double miss = ciede2000(labOf(color), labOf(wanted[static_cast<int>(text)]));
    if (miss > kStrange || color == of(Paper).color || color == of(Panel).color) of(text) = of(Black);
  }
  if (of(WellText).color == of(Well).color) of(WellText) = of(White);
  return chosen;
}

}  // namespace xnewell
