#include "shading/trade/timing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

namespace xnewell::THIS_FILE {

namespace {

/// A machine whose speed changes: each run takes the way's own time, times what the moment costs.
class Machine {
 public:
  explicit Machine(unsigned seed) : random_{seed} {}

  Timed way(double ms) {
    return [this, ms] {
      // It slows down and speeds up by a factor of 3 over forty runs, and some runs are interrupted.
      const double moment = std::exp(std::log(3.0) / 2 * std::sin(2 * M_PI * ++runs_ / 40.0));
      const double noise = 1 + 0.03 * std::uniform_real_distribution<>{-1, 1}(random_);
      const double interrupted = std::uniform_int_distribution<>{0, 19}(random_) == 0 ? 5 : 1;
      return ms * moment * noise * interrupted;
    };
  }
  [[nodiscard]] int runs() const { return runs_; }

 private:
  std::mt19937 random_;
  int runs_ = 0;
};

}  // namespace

TEST(Timing, FindsRatiosOnAMachineWhoseSpeedChanges) {
  Machine machine{1};
  const std::vector<Timed> ways{machine.way(10), machine.way(5), machine.way(10), machine.way(12)};
  const Timings timings = timeAll(ways, {.seconds = 1000, .mostRounds = 150});
  EXPECT_NEAR(timings.of[1].ratio, 0.5, 0.02);
  EXPECT_NEAR(timings.of[3].ratio, 1.2, 0.05);
  EXPECT_EQ(timings.of[0].ratio, 1.0);
  EXPECT_TRUE(timings.of[0].tie);
  EXPECT_FALSE(timings.of[1].tie);
  EXPECT_TRUE(timings.of[2].tie);
  EXPECT_FALSE(timings.of[3].tie);
  EXPECT_EQ(machine.runs(), timings.rounds * 5);
}

// Ways that are equally fast are called a tie nearly always, on many such machines.
TEST(Timing, CallsEqualWaysATie) {
  int ties = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    Machine machine{seed};
    const std::vector<Timed> ways{machine.way(10), machine.way(10)};
    ties += timeAll(ways, {.seconds = 1000, .mostRounds = 21, .seed = seed}).of[1].tie;
  }
  EXPECT_GE(ties, 194);
}

// In each round every way runs once and the base twice, and the order changes.
TEST(Timing, RunsInTurn) {
  std::vector<int> ran;
  const auto way = [&](int k) { return Timed{[&ran, k] { return ran.push_back(k), 1.0 + k; }}; };
  const std::vector<Timed> ways{way(0), way(1), way(2)};
  const Timings timings = timeAll(ways, {.seconds = 1000, .leastRounds = 10, .mostRounds = 10});
  ASSERT_EQ(timings.rounds, 10);
  ASSERT_EQ(ran.size(), 40u);
  std::set<std::vector<int>> orders;
  for (std::size_t k = 0; k < ran.size(); k += 4) {
    std::vector<int> round{ran.begin() + static_cast<std::ptrdiff_t>(k),
                           ran.begin() + static_cast<std::ptrdiff_t>(k + 4)};
    orders.insert(round);
    std::ranges::sort(round);
    EXPECT_EQ(round, (std::vector{0, 0, 1, 2}));
  }
  EXPECT_GT(orders.size(), 3u);
}

TEST(Timing, EndsAsItSays) {
  const std::vector<Timed> constant{[] { return 2.0; }, [] { return 3.0; }};
  const Timings sure = timeAll(constant);
  EXPECT_EQ(sure.ended, Ended::Sure);
  EXPECT_EQ(sure.rounds, TimingLimits{}.leastRounds);
  EXPECT_EQ(sure.of[1].ms, 3.0);
  EXPECT_EQ(sure.of[1].interval.low, 1.5);
  EXPECT_EQ(sure.of[1].interval.high, 1.5);

  Machine machine{3};
  const std::vector<Timed> noisy{machine.way(10), machine.way(11)};
  EXPECT_EQ(timeAll(noisy, {.seconds = 0}).ended, Ended::OutOfTime);
  EXPECT_EQ(timeAll(noisy, {.seconds = 0}).rounds, TimingLimits{}.leastRounds);
  EXPECT_EQ(timeAll(noisy, {.seconds = 1000, .mostRounds = 8}).ended, Ended::OutOfTime);

  // A round that was not finished does not count.
  int calls = 0;
  const Timings stopped = timeAll(constant, {}, [&](int, const Timings&) { return ++calls <= 7; });
  EXPECT_EQ(stopped.ended, Ended::Stopped);
  EXPECT_EQ(stopped.rounds, 2);
  EXPECT_EQ(stopped.of[1].ms, 3.0);
  const Timings none = timeAll(constant, {}, [](int, const Timings&) { return false; });
  EXPECT_EQ(none.rounds, 0);
  EXPECT_EQ(none.of[1].ms, 0.0);
}

TEST(Timing, MediansAreThoseOfSortedValues) {
  EXPECT_EQ(medianOf({}), 0.0);
  EXPECT_EQ(medianOf({3}), 3.0);
  EXPECT_EQ(medianOf({9, 1, 5}), 5.0);
  EXPECT_EQ(medianOf({9, 1, 5, 2}), 3.5);
}

// Of many samples of a distribution whose median is 1, about 95 % have an interval that contains it.
TEST(Timing, IntervalsContainTheMedian) {
  std::mt19937 random{5};
  std::lognormal_distribution<double> skewed{0, 0.5};  // its median is 1
  int contain = 0;
  constexpr int kTrials = 400;
  for (int trial = 0; trial < kTrials; ++trial) {
    std::vector<double> values(25);
    for (double& v : values) v = skewed(random);
    const Interval interval = intervalOfMedian(values);
    contain += interval.low <= 1 && 1 <= interval.high;
  }
  EXPECT_GT(contain, 0.91 * kTrials);
  EXPECT_LT(contain, 0.99 * kTrials);
}

}  // namespace xnewell::THIS_FILE
