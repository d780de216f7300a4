#pragma once

#include <vector>

#include "x11/server/display.h"
#include "x11/visual/visual.h"

namespace xnewell {

/// Asks a server what it has.

/// Free cells are counted only if asked for: by taking them and giving them back, some fifteen round trips in
/// which all other programs wait.
[[nodiscard]] ServerVisuals readVisuals(Display* display, bool countsCells = false);

/// Takes cells of the map for ourselves, as many as it gives but at most `most`, in falling powers of two.
/// Nobody else is to free or change them; give them back with XFreeColors.
[[nodiscard]] std::vector<unsigned long> takeCells(Display* display, unsigned long map, int most);

}  // namespace xnewell
