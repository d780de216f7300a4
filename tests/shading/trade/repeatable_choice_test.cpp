#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <string>

#include "shading/picture/picture_cache.h"
#include "shading/trade/choice.h"
#include "shading/trade/measure.h"
#include "tests/support/seeds.h"
#include "tests/support/small_picture.h"

namespace xnewell::THIS_FILE {

// A choice within a limit does not depend on chance. Here the times are not those of this machine: each piece
// of work has a price, and each time is off by chance.

namespace {

/// What does not depend on chance, by the name of the configuration.
struct Known {
  std::map<std::string, Measured> briefs;
  std::map<std::string, Glance> elsewhere;
};

class NoisyMeasure : public Measure {
 public:
  NoisyMeasure(const Scene& scene, Known& known, unsigned seed)
      : Measure{scene, small()}, known_{known}, random_{seed} {}

  Measured brief(const Configuration& one) override {
    const auto [at, isNew] = known_.briefs.try_emplace(one.options());
    if (isNew) at->second = Measure::brief(one);
    return at->second;
  }
  Glance glance(const Configuration& one, bool) override {
    const Measured known = brief(one);
    Glance glance{.stages = paid(one), .rms = known.here.afterTable.rootMeanSquare};
    glance.ms = glance.stages.total();
    return glance;
  }
  Glance glanceElsewhere(const Configuration& one, bool countsWrong) override {
    const auto [at, isNew] = known_.elsewhere.try_emplace(one.options());
    if (isNew) at->second = Measure::glanceElsewhere(one, countsWrong);
    return at->second;
  }
  double run(const Configuration& one, Stages& stages) override {
    const StageTimes times = paid(one);
    stages.add(times);
    return times.total();
  }

 private:
  /// The price of each stage, off by chance: by 8 % usually.
  [[nodiscard]] StageTimes paid(const Configuration& one) {
    const PictureSettings& s = one.settings;
    const ShadingRow& method = kShadings[static_cast<std::size_t>(s.shading)];
    const OrderRow& order = rowOf(s.order);
    const double n = static_cast<double>(brief(one).cost.polygons);
    std::normal_distribution<double> chance{0, 0.08};
    const auto off = [&](double price) { return price * std::exp(chance(random_)); };
    const bool bySample = order.bySample || s.order == Order::Oracle;
    return {.shade = off(2e-3 * n * (method.interpolates ? 1.5 : 1)),
            .transform = off((s.cull == Cull::Keep ? 4e-3 : 2e-3) * n),
            .sort = off(bySample                                            ? 0.5
                        : s.order == Order::Newell || s.order == Order::Bsp ? 3e-3 * n * std::sqrt(n)
                                                                            : 1e-4 * n * std::log2(n + 1)),
            .fill = off(0.02 + (1e-3 / 240) * s.table.shades +
                        (s.shading == Shading::Phong || s.shading == Shading::Environment ? 0.2 : 0.0))};
  }

  Known& known_;
  std::mt19937 random_;
};

/// How often each configuration is chosen.
std::map<std::string, int> choicesOf(const char* name, double limit, unsigned seeds) {
  const Scene scene = readScene(name);
  Known known;
  std::map<std::string, int> chosen;
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    NoisyMeasure measure{scene, known, seed};
    TradeRequest request{.brief = true, .within = AccuracyLimit{limit}, .seconds = 6'000, .mostRounds = 28};
    request.axes = choosableAxes(measure.asked());
    const Trade trade = tradeOf(measure, request);
    const Chosen choice = chooseWithin(trade, *request.within);
    EXPECT_TRUE(choice.accurate);
    ++chosen[choice.accurate ? trade.combinations[choice.combination].configuration.name() : "nothing"];
  }
  return chosen;
}

}  // namespace

TEST(RepeatableChoice, DoesNotDependOnChance) {
  struct Case {
    const char* scene;
    double limit;
  };
  for (const Case& c : someOf({Case{"makie-4693", 0.02}, {"cubes", 0.05}, {"room", 0.01}}, 1)) {
    const std::map<std::string, int> chosen = choicesOf(c.scene, c.limit, 50);
    std::string all;
    for (const auto& [name, times] : chosen) all += std::to_string(times) + " times " + name + "; ";
    EXPECT_EQ(chosen.size(), 1u) << c.scene << ": " << all;
  }
}

}  // namespace xnewell::THIS_FILE
