#pragma once

#include <string>
#include <vector>

#include "shading/color/color_table.h"
#include "shading/picture/cell_use.h"

namespace xnewell {

/// What one cell of the colormap is for, in words and numbers.

struct CellFact {
  std::string label, value;
};

/// For a cell of the scene: what it holds, what it stands for, which intensities pick it, who uses it, and
/// how far it is to the next. For any other cell: what it is for. The words describe the colours in
/// `palette`.
[[nodiscard]] std::vector<CellFact> factsOf(int cell, const Picture& picture, const Palette& palette,
                                            const CellPlan& plan, const CellUse& use);

/// The intensities that pick shade j, as `0.1868 <= I < 0.1899`. Both ends are rounded up, so that the
/// statement is exact for all numbers with that many decimals. It uses at least `least` decimals, and enough
/// that at least ten such numbers pick the shade.
[[nodiscard]] std::string pickedText(const ColorTable& table, int j, int least = 4);

/// How many shades the picture has: `240 shades`, or `28 shades for each of 8 hues`.
[[nodiscard]] std::string shadesText(const Picture& picture);

/// What the cells of a table hold: `cell 91 + j holds (1 + 239 j/27)/255 of the hue`.
[[nodiscard]] std::string holdsText(const ColorTable& table);

}  // namespace xnewell
