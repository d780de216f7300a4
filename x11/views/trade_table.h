#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "shading/trade/trade.h"
#include "x11/kit/page.h"

namespace xnewell {

/// The numbers of a trade as a table.

/// What an X server gets for the first picture of a window, on an 8-bit visual with a colormap of its own and
/// without shared memory: the cells in XStoreColors, the pixels in one XPutImage or more, and XCopyArea from
/// the pixmap to the window. It is computed, since a trade has no server. The image is the same size whatever
/// the short cuts are; only cells can be saved. `snapshot --stats` measures it.
struct ServerCost {
  std::int64_t requests = 0, bytes = 0;
};
[[nodiscard]] ServerCost serverCostOf(const Measured& one);

/// A table without rows. `what` names its first column.
[[nodiscard]] page::Table tradeTable(std::string what);
/// Adds a row: the times, the errors of the intensity, the samples with wrong faces, the errors of the
/// colour, the memory. What was not measured is a dash. `below` are lines under it.
void addNumbers(page::Table& table, std::string name, const Measured& one,
                const std::vector<std::string>& below = {});

/// All combinations, the fastest first. Those on the front have a star, and the options that make them.
[[nodiscard]] std::string tableOfCombinations(const Trade& trade);

/// "230 %": a ratio of two times.
[[nodiscard]] std::string percentOf(double ratio);

}  // namespace xnewell
