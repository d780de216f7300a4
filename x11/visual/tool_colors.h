#pragma once

#include <array>
#include <optional>

#include "shading/color/palette.h"
#include "x11/visual/emulation.h"

namespace xnewell {

/// Which of the colours that a server has stand for the tool's sixteen, where they cannot be stored.
///
/// None is mixed, for text must be read. Near is meant by CIEDE2000: by 8-bit values a dark gray would become
/// navy where blue has few levels. Who is drawn on another, or follows it in a legend of differences, stays
/// darker or brighter than that as long as there are colours to choose from; where nothing near is left,
/// words are still black, or white on the well.

using ToolColors = std::array<OfferedColor, kCells>;

/// `wanted` is what the tool's colours would be, `has` what is settled already.
[[nodiscard]] ToolColors chooseToolColors(const OfferedColors& offered,
                                          const std::array<glm::ivec3, kCells>& wanted,
                                          const std::array<std::optional<OfferedColor>, kCells>& has = {});

}  // namespace xnewell
