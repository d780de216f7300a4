#pragma once

#include <string>
#include <vector>

#include "shading/trade/trade.h"

namespace xnewell {

inline constexpr int kMostCombinations = 96;

/// The axes that a request asks for, without the values that it leaves out.
/// @throws std::invalid_argument if it names an axis or a value that is not there
[[nodiscard]] std::vector<Axis> requestedAxes(std::vector<Axis> all, const TradeRequest& request);

/// The indices of those for which no other is cheaper and more accurate (by Measured::elsewhere), the
/// cheapest first. Of two that are equally fast, as far as their times tell, the more accurate counts; of two
/// that are equally accurate (kErrorTie), the faster.
[[nodiscard]] std::vector<int> frontOf(const std::vector<Measured>& measured);

/// True if any of them has a time.
[[nodiscard]] bool areTimed(const std::vector<Measured>& some);

/// A trade that is not far enough for combinations, with the single short cuts in their place; without any
/// if these have no times either.
[[nodiscard]] Trade withSingles(Trade trade);

}  // namespace xnewell
