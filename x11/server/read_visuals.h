#pragma once

#include <vector>

#include "x11/server/display.h"
#include "x11/visual/visual.h"

namespace xnewell {

/// Asks a server for its visuals and cells.

/// Free cells are counted only if `countsCells` is true. They are counted by taking them and giving them
/// back: some fifteen round trips, during which all other programs wait.
[[nodiscard]] ServerVisuals readVisuals(Display* display, bool countsCells = false);

/// Takes free cells of the map for ourselves: as many as it has, but at most `most`. It asks for falling
/// powers of two. Nobody else may free or change these cells. Give them back with XFreeColors.
[[nodiscard]] std::vector<unsigned long> takeCells(Display* display, unsigned long map, int most);

}  // namespace xnewell
