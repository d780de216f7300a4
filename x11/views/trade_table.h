#pragma once

#include <iosfwd>
#include <string>

#include "shading/trade/trade.h"

namespace xnewell {

/// The numbers of a trade as a table of plain text.

/// The head of the table. `what` names its first column.
void printTradeHead(std::ostream& out, const std::string& what);
/// One row: the times, the errors of the intensity, the samples with wrong faces, the errors of the colour,
/// the memory. What was not measured is a dash.
void printTradeNumbers(std::ostream& out, const std::string& name, const Measured& one);

/// All combinations, the fastest first. Those on the front have a star, and the options that make them.
[[nodiscard]] std::string tableOfCombinations(const Trade& trade);

/// "230 %": a ratio of two times.
[[nodiscard]] std::string percentOf(double ratio);

}  // namespace xnewell
