#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace xnewell {

/// Which of several ways is faster? Times that can be trusted on a machine that also does other work.
///
/// All ways run in turn, once a round, in a new random order each round. So a slow minute is slow for all of
/// them. A way is compared with the first one, the base, round by round: its ratio is the median over all
/// rounds of its time / the base's time in the same round. The interval of a ratio reaches from one of the
/// sorted ratios to another, between which the true median lies in 95 % of all cases, however ratios spread.
///
/// The base runs a second time in each round, as its own twin. The two differ by chance alone. A way whose
/// interval meets that of the twin is as fast as the base: a tie.

struct Interval {
  double low = 1, high = 1;
  [[nodiscard]] bool meets(const Interval& other) const { return low <= other.high && other.low <= high; }
};

/// The times of one way.
struct Timing {
  double ms = 0;     ///< the median
  double ratio = 1;  ///< to the base
  Interval interval = {};
  bool tie = false;  ///< its interval meets that of the twin
};

/// Why the rounds ended: all intervals are narrow, the time is over, or the caller stopped them.
enum class Ended { Sure, OutOfTime, Stopped };

struct Timings {
  std::vector<Timing> of;  ///< in the order of the ways; the first is the base
  Timing twin;
  int rounds = 0;
  Ended ended = Ended::Stopped;
};

struct TimingLimits {
  double seconds = 10;
  int leastRounds = 7;  ///< also beyond the time, unless it is stopped or a way is given up
  int mostRounds = 200;
  /// An interval is narrow if high / low is at most 1 + this.
  double narrow = 0.04;
  unsigned seed = 1;
};

/// Runs one way and returns its time in milliseconds, above 0.
using Timed = std::function<double()>;

/// Is called before each run with what is known so far, which is renewed from time to time. Returns false to
/// end the rounds.
using TimingProgress = std::function<bool(int rounds, const Timings& known)>;

/// If `goOn` returns false or a way throws GivenUp, no more runs, and a round that is not whole does not
/// count. Without a whole round, all times are 0. Precondition: there is a way.
[[nodiscard]] Timings timeAll(std::span<const Timed> ways, const TimingLimits& limits = {},
                              const TimingProgress& goOn = {});

/// The median of the values, the mean of the middle two of an even number; 0 of none.
[[nodiscard]] double medianOf(std::vector<double> values);
/// Where the median of what the values are drawn from lies, with 95 %: how many values are below it is a
/// binomial number, about n / 2 with a standard deviation of sqrt(n) / 2.
[[nodiscard]] Interval intervalOfMedian(std::vector<double> values);

/// The time that this thread has had a processor, in milliseconds. The time of other programs does not count.
[[nodiscard]] double processorMs();

}  // namespace xnewell
