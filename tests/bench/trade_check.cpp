// trade_check accuracy [SCENES [SEED]]: is --accuracy honoured on other samples of random scenes?
// trade_check ranks [SCENE...]: do two runs of a trade rank the configurations alike, also beside a busy
// process?

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string>
#include <vector>

#include "shading/picture/picture_cache.h"
#include "shading/scene/units.h"
#include "shading/trade/measure.h"
#include "shading/trade/trade.h"
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

struct Honour {
  int asked = 0, kept = 0, none = 0;
  double worst = 0;  ///< error / limit
};

int checkAccuracy(int scenes, int firstSeed) {
  Honour honour;
  constexpr double kLimits[]{0.2, 0.1, 0.05, 0.03};
  for (int seed = firstSeed; seed < firstSeed + scenes; ++seed) {
    const LitScene lit = randomLitScene(static_cast<unsigned>(seed));
    const double limit = kLimits[seed % 4];
    const PictureSettings settings = lit.settings;
    TradeRequest request{.brief = true, .seconds = 8};
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
  return honour.kept == honour.asked ? 0 : 1;
}

/// How alike two rows of times rank. A pair whose intervals meet is a tie.
struct Likeness {
  double tauB = 0;         ///< Kendall's tau-b: 1 if they rank all pairs alike
  int contradictions = 0;  ///< pairs that one ranks one way and the other the other way
};
Likeness likeness(std::span<const Measured> a, std::span<const Measured> b) {
  const auto order = [](const Timing& x, const Timing& y) {
    return x.interval.meets(y.interval) ? 0 : x.ratio < y.ratio ? -1 : 1;
  };
  double alike = 0, pairsA = 0, pairsB = 0;
  Likeness found;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const int p = order(a[i].cost.time, a[j].cost.time), q = order(b[i].cost.time, b[j].cost.time);
      alike += p * q, pairsA += p != 0, pairsB += q != 0, found.contradictions += p * q < 0;
    }
  found.tauB = alike / std::sqrt(pairsA * pairsB);
  return found;
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
    const Likeness again = likeness(first, second), busier = likeness(first, beside);
    std::printf(
        "%s: %zu configurations; errors %s; tau-b %.4f, %d pairs contradict; beside 4 busy processes "
        "%.4f, %d\n",
        name.c_str(), first.size(), same ? "equal to the bit" : "DIFFER", again.tauB, again.contradictions,
        busier.tauB, busier.contradictions);
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
  if (!words.empty() && words[0] == "accuracy") return xnewell::checkAccuracy(number(1, 200), number(2, 0));
  if (!words.empty() && words[0] == "ranks") return xnewell::checkRanks({words.begin() + 1, words.end()});
  std::fprintf(stderr, "usage: trade_check accuracy [SCENES [SEED]] | ranks [SCENE...]\n");
  return 2;
}
