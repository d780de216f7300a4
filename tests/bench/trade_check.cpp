// trade_check accuracy [SCENES [EXHAUSTIVE [SEED]]]: is --accuracy honoured on other samples of random
// scenes, and how much more does the choice cost than the cheapest configuration of all that honours it?
// trade_check ranks [SCENE...]: do two runs of a trade rank the configurations alike, also beside a busy
// process?

#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <unordered_set>
#include <utility>
#include <vector>

#include "shading/picture/picture_cache.h"
#include "shading/scene/units.h"
#include "shading/trade/choice.h"
#include "shading/trade/measure.h"
#include "tests/support/random_lit_scenes.h"

namespace xnewell {

namespace {

/// The same configuration on other samples: the camera is turned by less than a degree.
PictureSettings turned(const LitScene& lit, double azimuth, double elevation) {
  PictureSettings settings = lit.settings;
  settings.camera =
      moved(settings.camera, makePicture(lit.scene, settings).camera(), lit.scene, azimuth, elevation, 1.0);
  return settings;
}

/// The axes that cost no time: what the cells hold. The exhaustive search leaves them as they are.
constexpr std::array<std::string_view, 5> kOfCells{"table", "shades", "bits", "i0", "pick"};

/// A combination: the index of its value on each axis. There may be millions, so they are kept in this form.
using Combination = std::string;

/// All combinations of the axes on which --accuracy chooses. On each axis a value comes before those that
/// take longer in any case: beside the same other values
/// - more divisions,
/// - a finer tolerance, and any beside none,
/// - an order beside the first of its kind, which is not sorting, or the smallest z-buffer.
class AllCombinations {
 public:
  explicit AllCombinations(const Measure& measure) : asked_{measure.askedConfiguration()} {
    const std::vector<std::string> names = choosableAxes(measure.asked());
    for (const Axis& axis : axesInReach(measure.asked())) {
      if (std::ranges::find(names, axis.name()) == names.end() ||
          std::ranges::find(kOfCells, axis.name()) != kOfCells.end())
        continue;
      std::vector<double> values = axis.others;
      values.push_back(axis.now);
      std::ranges::sort(values);
      if (axis.name() == "adapt") std::reverse(values.begin() + 1, values.end());  // the first is none
      std::vector<Combination> next;
      for (const Combination& one : all_)
        for (std::size_t v = 0; v < values.size(); ++v) next.push_back(one + static_cast<char>(v));
      all_ = std::move(next);
      std::vector<int> faster;  // the index of one that takes no longer
      for (int v = 0; v < static_cast<int>(values.size()); ++v) {
        const bool zBuffer = axis.name() == "order" && kOrders[v].bySample;
        const int first = zBuffer ? static_cast<int>(Order::ZBuffer16) : 0;
        faster.push_back(axis.name() == "order"                                 ? (v == first ? -1 : first)
                         : axis.name() == "adapt" || axis.name() == "divisions" ? v - 1
                                                                                : -1);
      }
      faster_.push_back(std::move(faster));
      axes_.push_back({axis, std::move(values)});
    }
    std::erase_if(
        all_, [&](const Combination& one) { return !allHaveEffect(configurationOf(one), measure.asked()); });
    all_.shrink_to_fit();
  }

  [[nodiscard]] const std::vector<Combination>& all() const { return all_; }
  [[nodiscard]] Configuration configurationOf(const Combination& one) const {
    Configuration configuration = asked_;
    for (std::size_t k = 0; k < axes_.size(); ++k) {
      const auto& [axis, values] = axes_[k];
      const double value = values[static_cast<std::size_t>(one[k])];
      if (value != axis.now) configuration = changed(std::move(configuration), axis, value);
    }
    return configuration;
  }
  /// True if one that takes no longer was too slow.
  [[nodiscard]] bool isTooSlow(const Combination& one) {
    for (std::size_t k = 0; k < faster_.size(); ++k) {
      const int faster = faster_[k][static_cast<std::size_t>(one[k])];
      if (faster < 0) continue;
      Combination other = one;
      other[k] = static_cast<char>(faster);
      if (slow_.contains(other)) return setTooSlow(one), true;
    }
    return false;
  }
  void setTooSlow(const Combination& one) { slow_.insert(one); }

 private:
  Configuration asked_;
  std::vector<std::pair<Axis, std::vector<double>>> axes_;  ///< with all their values
  std::vector<Combination> all_{""};
  std::vector<std::vector<int>> faster_;
  std::unordered_set<Combination> slow_;
};

struct Honour {
  int asked = 0, kept = 0, none = 0;
  double worst = 0;  ///< error / limit
};

bool keepsEverywhere(const Configuration& one, double limit, Measure& measure) {
  return measure.glance(one, false).rms <= limit && measure.glanceElsewhere(one, false).rms <= limit;
}

/// The least time of some runs, in ms; infinite if there is no picture.
double leastMs(const Configuration& one, Measure& measure, int runs) try {
  Stages stages;
  double least = measure.run(one, stages);
  for (int k = 1; k < runs; ++k) least = std::min(least, measure.run(one, stages));
  return least;
} catch (const std::runtime_error&) {
  return std::numeric_limits<double>::infinity();
}

/// Leaves the faster half again and again, until few are left. The first stays.
void halve(std::vector<Configuration>& some, Measure& measure) {
  constexpr std::size_t kFew = 8;
  for (int runs = 3; some.size() > kFew; runs *= 2) {
    std::vector<std::pair<double, std::size_t>> times;
    for (std::size_t k = 1; k < some.size(); ++k) times.emplace_back(leastMs(some[k], measure, runs), k);
    std::ranges::sort(times);
    std::vector<Configuration> left{some.front()};
    for (std::size_t k = 0; k < times.size() / 2; ++k) left.push_back(some[times[k].second]);
    some = std::move(left);
  }
}

/// The time of the choice / that of the cheapest of all combinations that honour the limit: in the view that
/// was asked for, in a turned one, and in three that are turned from each. One run tells which combinations
/// may be faster than the choice; what isTooSlow() is not even painted. Errors are looked at only for what is
/// faster, and times in turn only for the fastest of these.
double overCheapest(const Configuration& chosen, double limit, Measure& asked, Measure& fresh) {
  constexpr double kSlower = 1.15;  // what one run may be off by
  const double start = processorMs(), mine = leastMs(chosen, asked, 15);
  std::vector<Configuration> within{chosen};
  AllCombinations combinations{asked};
  int painted = 0;
  for (const Combination& combination : combinations.all()) {
    if (combinations.isTooSlow(combination)) continue;
    const Configuration one = combinations.configurationOf(combination);
    ++painted;
    double ms = leastMs(one, asked, 1);
    if (ms > kSlower * mine && ms < 3 * mine) ms = std::min(ms, leastMs(one, asked, 2));
    if (ms > kSlower * mine)
      combinations.setTooSlow(combination);
    else if (one.changes != chosen.changes && keepsEverywhere(one, limit, asked) &&
             keepsEverywhere(one, limit, fresh))
      within.push_back(one);
  }
  const std::size_t count = within.size();
  halve(within, asked);
  std::vector<Stages> stages(within.size());
  std::vector<Timed> timed;
  for (std::size_t k = 0; k < within.size(); ++k)
    timed.emplace_back([&, k] { return asked.run(within[k], stages[k]); });
  const Timings timings = timeAll(timed, {.seconds = 10, .leastRounds = 9, .mostRounds = 49});
  const auto least = std::ranges::min_element(timings.of, {}, &Timing::ratio);
  std::printf(
      "  of %zu combinations %d were painted, %zu may be as fast within the limit; the cheapest takes "
      "%.3f of the choice, %.3g ms: %s (%.0f s)\n",
      combinations.all().size(), painted, count, least->ratio, least->ms,
      within[least - timings.of.begin()].name().c_str(), (processorMs() - start) / 1e3);
  return 1 / least->ratio;
}

int checkAccuracy(int scenes, int exhaustive, int firstSeed) {
  Honour honour;
  std::vector<double> over;
  constexpr double kLimits[]{0.2, 0.1, 0.05, 0.03};
  for (int seed = firstSeed; seed < firstSeed + scenes; ++seed) {
    const LitScene lit = randomLitScene(static_cast<unsigned>(seed));
    const double limit = kLimits[seed % 4];
    const PictureSettings settings = lit.settings;
    TradeRequest request{.brief = true, .within = AccuracyLimit{limit}, .seconds = 8};
    request.axes = choosableAxes(makePicture(lit.scene, settings));
    const double start = processorMs();
    const Trade trade = tradeOf(lit.scene, settings, request);
    const double seconds = (processorMs() - start) / 1e3;
    const Chosen choice = chooseWithin(trade, {limit});
    if (!choice.accurate) {
      ++honour.none;
      std::printf("seed %d, limit %.2f: none: %s\n", seed, limit, choice.why.back().c_str());
      continue;
    }
    const Configuration& chosen = trade.combinations[choice.combination].configuration;
    double worst = 0;
    for (const auto& [azimuth, elevation] : {std::pair{0.37, -0.23}, {-0.61, 0.42}, {0.05, 0.71}}) {
      Measure fresh{lit.scene, turned(lit, azimuth, elevation)};
      worst = std::max(worst, fresh.brief(chosen).here.afterTable.rootMeanSquare / limit);
      if (azimuth == 0.37 && static_cast<int>(over.size()) < exhaustive) {
        Measure asked{lit.scene, settings};
        over.push_back(overCheapest(chosen, limit, asked, fresh));
      }
    }
    ++honour.asked;
    honour.kept += worst <= 1;
    honour.worst = std::max(honour.worst, worst);
    std::printf("seed %d, limit %.2f: %s, %.3g ms, error %.3f of the limit%s (%zu tried, %.1f s)\n", seed,
                limit, chosen.name().c_str(), trade.combinations[choice.combination].cost.time.ms, worst,
                worst > 1 ? "  BROKEN" : "", trade.combinations.size(), seconds);
    std::fflush(stdout);
  }
  std::printf("%d promises, %d kept, worst error %.3f of the limit; %d scenes without a choice\n",
              honour.asked, honour.kept, honour.worst, honour.none);
  if (!over.empty()) {
    std::ranges::sort(over);
    std::printf("cost over the cheapest of all: median %.3f, largest %.3f, of %zu\n", over[over.size() / 2],
                over.back(), over.size());
  }
  return honour.kept == honour.asked ? 0 : 1;
}

/// Kendall's tau-b of two rows of times: 1 if they rank all pairs alike. A pair whose intervals meet is a
/// tie.
double tauB(std::span<const Measured> a, std::span<const Measured> b) {
  const auto order = [](const Timing& x, const Timing& y) {
    return x.interval.meets(y.interval) ? 0 : x.ratio < y.ratio ? -1 : 1;
  };
  double alike = 0, pairsA = 0, pairsB = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const int p = order(a[i].cost.time, a[j].cost.time), q = order(b[i].cost.time, b[j].cost.time);
      alike += p * q, pairsA += p != 0, pairsB += q != 0;
    }
  return alike / std::sqrt(pairsA * pairsB);
}

/// Pairs that one run ranks one way and the other the other way.
int contradictions(std::span<const Measured> a, std::span<const Measured> b) {
  int count = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Timing &ai = a[i].cost.time, &aj = a[j].cost.time, &bi = b[i].cost.time, &bj = b[j].cost.time;
      if (ai.interval.meets(aj.interval) || bi.interval.meets(bj.interval)) continue;
      count += (ai.ratio < aj.ratio) != (bi.ratio < bj.ratio);
    }
  return count;
}

std::vector<Measured> rowsOf(const Trade& trade) {
  std::vector<Measured> rows{trade.asked};
  for (const TradeRow& row : trade.rows) rows.push_back(row.measured);
  return rows;
}

bool sameErrors(std::span<const Measured> a, std::span<const Measured> b) {
  return std::ranges::equal(a, b, [](const Measured& x, const Measured& y) {
    const Spread &p = x.here.afterTable, &q = y.here.afterTable;
    return x.configuration.changes == y.configuration.changes && x.here.wrongFaces == y.here.wrongFaces &&
           p.rootMeanSquare == q.rootMeanSquare && p.largest == q.largest && p.p99 == q.p99 &&
           x.here.color.mean == y.here.color.mean && x.elsewhere == y.elsewhere;
  });
}

int checkRanks(std::vector<std::string> scenes) {
  if (scenes.empty()) scenes = {"teapot", "room", "lamp"};
  bool all = true;
  for (const std::string& name : scenes) {
    const Scene scene = readScene(name);
    PictureSettings settings = scene.settings;
    settings.camera = scene.camera;
    settings.width = 800, settings.height = 600;
    const auto run = [&](unsigned seed) {
      return rowsOf(tradeOf(scene, settings, {.seconds = 30, .seed = seed}));
    };
    const std::vector<Measured> first = run(1), second = run(2);
    std::vector<pid_t> busy;
    for (int k = 0; k < 4; ++k)
      if (const pid_t child = ::fork(); child == 0)
        for (std::atomic<unsigned> spin = 0;;) ++spin;
      else
        busy.push_back(child);
    const std::vector<Measured> beside = run(3);
    for (const pid_t child : busy) ::kill(child, SIGTERM);
    const bool same = sameErrors(first, second) && sameErrors(first, beside);
    all = all && same;
    std::printf(
        "%s: %zu configurations; errors %s; tau-b %.4f, %d pairs contradict; beside 4 busy processes "
        "%.4f, %d\n",
        name.c_str(), first.size(), same ? "equal to the bit" : "DIFFER", tauB(first, second),
        contradictions(first, second), tauB(first, beside), contradictions(first, beside));
    std::fflush(stdout);
  }
  return all ? 0 : 1;
}

}  // namespace

}  // namespace xnewell

int main(int argc, char** argv) {
  const std::vector<std::string> words{argv + 1, argv + argc};
  const auto number = [&](std::size_t k, int otherwise) {
    return words.size() > k ? std::atoi(words[k].c_str()) : otherwise;
  };
  if (!words.empty() && words[0] == "accuracy")
    return xnewell::checkAccuracy(number(1, 200), number(2, 20), number(3, 0));
  if (!words.empty() && words[0] == "ranks") return xnewell::checkRanks({words.begin() + 1, words.end()});
  std::fprintf(stderr, "usage: trade_check accuracy [SCENES [EXHAUSTIVE [SEED]]] | ranks [SCENE...]\n");
  return 2;
}
