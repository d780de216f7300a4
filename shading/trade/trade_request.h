#pragma once

#include <string>
#include <vector>

namespace xnewell {

/// What a trade (trade.h) is asked to look at.
struct TradeRequest {
  std::vector<std::string> axes = {};     ///< names of axes; empty for all
  std::vector<std::string> without = {};  ///< "order=none": values to leave out
  /// Leaves out what a choice does not need: colours, and the distance from patches.
  bool brief = false;
  double seconds = 30;   ///< of the processor's time, about; above 0
  int mostRounds = 200;  ///< of timing
  unsigned seed = 1;
};

}  // namespace xnewell
