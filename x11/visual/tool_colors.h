#pragma once

#include <array>
#include <optional>

#include "shading/color/palette.h"
#include "x11/visual/emulation.h"

namespace xnewell {

/// Chooses which of the server's colours stand for the sixteen interface colours where these cannot be
/// stored.
///
/// No interface colour is mixed, because text must be legible. Nearness is CIEDE2000: by 8-bit values, a dark
/// gray would become navy where blue has few levels. A colour that is drawn on another, or that follows
/// another in a legend of differences, stays darker or lighter than the other as long as the server's colours
/// allow it. If no colour is near enough, words become black, or white on the dark well.

using ToolColors = std::array<OfferedColor, kCells>;

/// `wanted` holds the 8-bit values of the interface colours; `has` holds the choices that are already
/// settled.
[[nodiscard]] ToolColors chooseToolColors(const OfferedColors& offered,
                                          const std::array<glm::ivec3, kCells>& wanted,
                                          const std::array<std::optional<OfferedColor>, kCells>& has = {});

}  // namespace xnewell
