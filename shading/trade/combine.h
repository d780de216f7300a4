#pragma once

#include <string>
#include <vector>

#include "shading/trade/trade.h"

namespace xnewell {

class Measure;

inline constexpr int kMostCombinations = 96;

/// The axes that a request asks for, without the values that it leaves out.
/// @throws std::invalid_argument if it names an axis or a value that is not there
[[nodiscard]] std::vector<Axis> requestedAxes(std::vector<Axis> all, const TradeRequest& request);

/// The combinations of the useful values of all axes, at most `most` of them. The user's own value of an axis
/// is useful, and so is a value if no other one of that axis is both as cheap and as accurate. The method,
/// the divisions and the order come first, then the axes by what their values save at most. An axis for which
/// there is no more room is left out, and `left` says so. A change that would have no effect beside the
/// others is left out in silence.
[[nodiscard]] std::vector<Configuration> combinationsOf(const Trade& trade, const Measure& measure, int most,
                                                        std::vector<std::string>& left);

/// The indices of those for which no other is cheaper and more accurate (by Measured::elsewhere), the
/// cheapest first. Of two that are equally fast, as far as their times tell, the more accurate counts.
[[nodiscard]] std::vector<int> frontOf(const std::vector<Measured>& measured);

/// True if any of them has a time.
[[nodiscard]] bool areTimed(const std::vector<Measured>& some);

/// A trade that is not far enough for combinations, with the single short cuts in their place; without any
/// if these have no times either.
[[nodiscard]] Trade withSingles(Trade trade);

}  // namespace xnewell
