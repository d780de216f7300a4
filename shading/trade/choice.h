#pragma once

#include <string>
#include <vector>

#include "shading/trade/trade.h"

namespace xnewell {

/// The cheapest configuration that is accurate enough, and why it is this one.
struct Chosen {
  int combination = -1;   ///< index into Trade::combinations; -1 if there are none
  bool accurate = false;  ///< its error stays within the limit; otherwise it is the most accurate of all
  std::vector<std::string> why = {};  ///< sentences, with numbers
};

/// The largest RMS error of the intensity that a combination has on any view, the user's own included.
[[nodiscard]] double errorOnAllViews(const Measured& one);

/// What is chosen stays below the limit by this share, because other samples of the same view have a slightly
/// different error.
inline constexpr double kSpare = 0.03;

/// Of times that are a tie, the slower is at most this many times the faster: wide intervals must not make a
/// choice slow.
inline constexpr double kTied = 1.1;

/// The choice among the combinations of a trade. `limit` is for the RMS error of the intensity after the
/// table, on all views of the trade. Of two that are equally fast, as far as their times tell, the more
/// accurate is chosen.
[[nodiscard]] Chosen chooseWithin(const Trade& trade, double limit);

}  // namespace xnewell
