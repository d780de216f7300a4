#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace xnewell {

/// How wrong a picture may be.
struct AccuracyLimit {
  double rms = 0.03;  ///< of the intensity after the table
  /// Samples of the user's view that may show a wrong face; any number if nothing is said. The RMS error
  /// alone is small where wrong faces have nearly the right intensity.
  std::optional<std::int64_t> wrong = {};
  bool operator==(const AccuracyLimit&) const = default;
};

/// How long a choice within a limit may take, in seconds of the processor's time.
inline constexpr double kAccuracySeconds = 8;

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
