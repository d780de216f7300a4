#include "shading/fill/ramp.h"

#include <algorithm>
#include <cmath>

namespace xnewell {

std::vector<std::uint8_t> cellsBy16Bits(const ColorTable& table) {
  constexpr int kIndices = 65536;
  std::vector<std::uint8_t> cells(kIndices);
  int from = 0;
  for (int j = 0; j < table.shades(); ++j) {
    // The first k with (k + 1/2) / 65536 >= to: no step of this rounds, unless the result is below 0.
    const double to = j + 1 < table.shades() ? std::ceil(table.picked(j).to * kIndices - 0.5) : kIndices;
    const int end = std::max(from, static_cast<int>(std::min<double>(to, kIndices)));
    std::fill(cells.begin() + from, cells.begin() + end, static_cast<std::uint8_t>(table.first() + j));
    from = end;
  }
  return cells;
}

}  // namespace xnewell
