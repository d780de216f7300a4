#pragma once

#include <string>
#include <vector>

#include "shading/color/palette.h"
#include "shading/picture/cell_use.h"

namespace xnewell {

/// What one cell is for, in words and numbers.

struct CellFact {
  std::string label, value;
};

/// Of a cell of the scene: what it holds, what it stands for, which intensities pick it, who uses it, and how
/// far it is to the next; of any other what is true of it. `palette` is what the words are about.
[[nodiscard]] std::vector<CellFact> factsOf(int cell, const Picture& picture, const Palette& palette,
                                            const CellPlan& plan, const CellUse& use);

/// The intensities that pick shade j as `0.1868 <= I < 0.1899`. Both ends are rounded up, so that of all
/// numbers with so many decimals exactly those pick it; there are ten of them at least.
[[nodiscard]] std::string pickedText(const ColorTable& table, int j);

}  // namespace xnewell
