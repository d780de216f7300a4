#include "shading/trade/timing.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <ctime>
#include <numeric>
#include <random>

#include "geometry/exact/give_up.h"
#include "shading/picture/shared.h"

namespace xnewell {

namespace {

/// The times of all ways, one row a round. The last way is the twin of the first.
using Rounds = std::vector<std::vector<double>>;

Timing timingOf(const Rounds& rounds, std::size_t way) {
  std::vector<double> times, ratios;
  for (const std::vector<double>& round : rounds) {
    times.push_back(round[way]);
    ratios.push_back(round[way] / round[0]);
  }
  return {.ms = medianOf(times), .ratio = medianOf(ratios), .interval = intervalOfMedian(ratios)};
}

void summarize(Timings& timings, const Rounds& rounds, std::size_t ways) {
  timings.rounds = static_cast<int>(rounds.size());
  timings.of.assign(ways, {});
  if (rounds.empty()) return;
  timings.twin = timingOf(rounds, ways);
  // Both are the same way, so a ratio of 1 is among what chance explains.
  timings.twin.interval.low = std::min(timings.twin.interval.low, 1.0);
  timings.twin.interval.high = std::max(timings.twin.interval.high, 1.0);
  timings.twin.tie = true;
  for (std::size_t way = 0; way < ways; ++way) {
    timings.of[way] = timingOf(rounds, way);
    timings.of[way].tie = timings.of[way].interval.meets(timings.twin.interval);
  }
}

bool isSure(const Timings& timings, double narrow) {
  const auto is = [&](const Timing& t) { return t.interval.high <= t.interval.low * (1.0 + narrow); };
  return is(timings.twin) && std::ranges::all_of(timings.of, is);
}

}  // namespace

double medianOf(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  if (values.size() % 2 == 1) return *middle;
  return (*std::max_element(values.begin(), middle) + *middle) / 2.0;
}

Interval intervalOfMedian(std::vector<double> values) {
  if (values.empty()) return {};
  std::ranges::sort(values);
  const auto n = static_cast<double>(values.size());
  const auto first = static_cast<std::size_t>(std::max(0.0, n / 2 - 0.98 * std::sqrt(n) - 0.5));
  return {values[first], values[values.size() - 1 - first]};
}

double processorMs() {
  std::timespec t{};
  if (::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t) != 0) ::clock_gettime(CLOCK_MONOTONIC, &t);  // in a page
  return 1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec);
}

Timings timeAll(std::span<const Timed> ways, const TimingLimits& limits, const TimingProgress& goOn) {
  assert(!ways.empty());
  const Stopwatch watch;
  std::mt19937 random{limits.seed};
  std::vector<std::size_t> order(ways.size() + 1);
  std::iota(order.begin(), order.end(), 0);
  Rounds rounds;
  Timings timings;
  timings.of.assign(ways.size(), {});
  const auto ended = [&](Ended why) {
    summarize(timings, rounds, ways.size());
    timings.ended = why;
    return timings;
  };
  for (;;) {
    std::ranges::shuffle(order, random);
    std::vector<double> round(order.size());
    for (const std::size_t way : order) {
      if (goOn && !goOn(static_cast<int>(rounds.size()), timings)) return ended(Ended::Stopped);
      try {
        round[way] = ways[way % ways.size()]();
      } catch (const GivenUp&) {
        return ended(Ended::OutOfTime);
      }
    }
    rounds.push_back(std::move(round));
    const int count = static_cast<int>(rounds.size());
    if (count == 1 && goOn) summarize(timings, rounds, ways.size());
    if (count < limits.leastRounds) continue;
    if (watch.ms() > 1e3 * limits.seconds || count == limits.mostRounds) return ended(Ended::OutOfTime);
    // The intervals take time themselves, so we do not look at them every round.
    if (count % limits.leastRounds != 0) continue;
    summarize(timings, rounds, ways.size());
    if (isSure(timings, limits.narrow)) return ended(Ended::Sure);
  }
}

}  // namespace xnewell
