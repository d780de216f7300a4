#include "shading/trade/trade.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/exact/box.h"
#include "geometry/exact/give_up.h"
#include "shading/trade/choice.h"
#include "shading/trade/combine.h"
#include "shading/trade/constant_l_bound.h"
#include "shading/trade/measure.h"
#include "shading/trade/search.h"
#include "shading/trade/trade_sentences.h"

namespace xnewell {

namespace {

/// The shares of the time after which the parts end: errors of rows, their times, the search of combinations,
/// their errors, and their times. A closer look at the front has the rest.
constexpr double kRowErrors = 0.3, kRowTimes = 0.5, kSearch = 0.65, kCombinationErrors = 0.75,
                 kCombinationTimes = 0.9;
/// The same for a choice within a limit, which has no rows: the search, and the errors on all views.
constexpr double kChoiceSearch = 0.8, kChoiceErrors = 0.9;

/// So many combinations are timed, or more, as many as can run so many rounds in their time.
constexpr std::size_t kLeastCombinations = 8;
constexpr int kRounds = 9;

/// What keeps a limit and is near the fastest is timed again in turn; but no more than so many, the fastest
/// by their first times, and only as many as take this share of the time for the first rounds.
constexpr std::size_t kFinalists = 96;
constexpr double kFirstShare = 0.1;
/// After so many rounds, what takes so many times as long as the fastest of them is out.
constexpr int kFirstRounds = 7;
constexpr double kLast = 1.4;
static_assert(kLast > kTimeFar);
/// And so is what has changes without which it is at most so many times as slow (usefulOf()). First times are
/// less sure, so more is timed.
constexpr double kSaves = 1.1, kMaySave = 1.05;
/// How narrow the intervals of the last times shall be, so that chance seldom decides what is a tie.
constexpr double kNarrow = 0.02;

/// What has begun may take this share of the time more than its part has left, and the last part kOver. Then
/// it is given up. So one picture that takes very long cannot take more.
constexpr double kBeyond = 0.2, kOver = 0.05;

/// The trade while it is made.
class Trader {
 public:
  Trader(Measure& measure, const TradeRequest& request, const TradeProgress& progress, double start)
      : request_{request}, progress_{progress}, start_{start}, measure_{measure} {}

  Trade make() {
    // Who names axes may mean some that have an effect only beside another.
    trade_.axes = requestedAxes(
        request_.axes.empty() ? axesOf(measure_.asked()) : axesInReach(measure_.asked()), request_);
    trade_.referenceDivisions = measure_.referenceDivisions();
    if (!request_.brief) trade_.referenceOff = measure_.referenceOff();
    trade_.views = measure_.otherViews();
    const Illumination& light = measure_.asked().settings().light;
    if (light.mistake == Mistake::None)  // the bound is that of the course's equation
      trade_.constantL = boundOfConstantL(measure_.asked().scene(), light);
    trade_.asked = closely(measure_.askedConfiguration());
    if (trade_.asked.here.samples == 0) throw ViewError{"nothing shows, so there is nothing to measure"};
    if (request_.within) {
      choices();
    } else {
      rows();
      if (!trade_.stopped) combinations();
    }
    return std::move(trade_);
  }

 private:
  bool goOn(const std::string& doing) {
    if (progress_ && !progress_(doing, trade_)) trade_.stopped = true;
    return !trade_.stopped;
  }
  /// The time of the processor counts, so that on a busy machine as much is measured as on an idle one.
  [[nodiscard]] double seconds() const { return (processorMs() - start_) / 1e3; }
  [[nodiscard]] bool isLate(double share) const { return seconds() > share * request_.seconds; }
  [[nodiscard]] double secondsTo(double share) const {
    return std::max(0.0, share * request_.seconds - seconds());
  }

  /// While it lives, what belongs to a part that ends at `share` of the time can be given up.
  [[nodiscard]] MayGiveUp limitOf(double share) const {
    const double last = std::min(std::max(seconds(), share * request_.seconds) + kBeyond * request_.seconds,
                                 (1 + kOver) * request_.seconds);
    return MayGiveUp{[this, last] { return seconds() > last; }};
  }
  /// Returns false if the work was given up.
  template <class Work>
  bool inTime(double share, Work&& work) try {
    const MayGiveUp limit = limitOf(share);
    work();
    return true;
  } catch (const GivenUp&) {
    return false;
  }

  [[nodiscard]] Measured closely(const Configuration& one) {
    return request_.brief ? measure_.brief(one) : measure_.whole(one);
  }

  void rows() {
    std::vector<std::string> left;
    for (std::size_t k = 0; k < trade_.axes.size(); ++k)
      for (const double value : trade_.axes[k].others) {
        const Axis& axis = trade_.axes[k];
        if (!goOn("looking at --" + std::string{axis.name()} + ' ' + axis.text(value))) return;
        if (isLate(kRowErrors)) {
          left.push_back("--" + std::string{axis.name()} + ' ' + axis.text(value));
          continue;
        }
        const Configuration one = changed(measure_.askedConfiguration(), axis, value);
        if (!allHaveEffect(one, measure_.asked())) continue;
        const bool known = inTime(kRowErrors, [&] {
          if (const std::string why = measure_.refusal(one); !why.empty())
            trade_.notes.push_back(one.name() + " was left out: " + why);
          else
            trade_.rows.push_back({static_cast<int>(k), value, closely(one), ""});
        });
        if (!known) left.push_back("--" + std::string{axis.name()} + ' ' + axis.text(value));
      }
    if (!left.empty()) {
      std::string note = "the time did not suffice (--budget) for " + left.front();
      for (std::size_t k = 1; k < left.size(); ++k) note += ", " + left[k];
      trade_.notes.push_back(std::move(note));
    }
    std::vector<Measured*> timed{&trade_.asked};
    for (TradeRow& row : trade_.rows) timed.push_back(&row.measured);
    trade_.ofRows = time(timed, kRowTimes, "timing short cuts", request_.mostRounds);
    for (TradeRow& row : trade_.rows)
      row.sentence = sentenceOf(row, trade_.axes[row.axis], trade_.asked, measure_.asked());
  }

  /// Searches as long as there is time. Returns false if it was stopped.
  bool searched(Search& search, double share) {
    bool more = true;
    do {
      if (!goOn("looking at combinations: " + std::to_string(search.tried().size()))) return false;
      const bool known = !isLate(share) && inTime(share, [&] { more = search.step(); });
      if (!known) {
        trade_.notes.emplace_back("the time did not suffice for all combinations with promise (--budget)");
        break;
      }
    } while (more);
    trade_.neverTried = search.neverTried();
    return true;
  }

  void combinations() {
    Search search{measure_, trade_.axes, {}};
    search.know(trade_.asked);
    for (const TradeRow& row : trade_.rows) search.know(row.measured);
    if (!searched(search, kSearch)) return;
    double round = 2 * trade_.asked.cost.time.ms;  // the base and its twin
    for (const int k : search.nearFront(kMostCombinations)) {
      const Measured& one = search.tried()[k];
      round += one.cost.time.ms;
      if (trade_.combinations.size() >= kLeastCombinations &&
          (isLate(kCombinationErrors) || kRounds * round > 1e3 * secondsTo(kCombinationTimes)))
        break;
      if (!goOn("looking at " + one.configuration.name())) return;
      if (!inTime(kCombinationErrors,
                  [&] { trade_.combinations.push_back(measure_.brief(one.configuration)); }))
        return noTimeForCombinations();
    }
    Measured base = trade_.asked;  // so that all times are compared with the same set-up
    std::vector<Measured*> timed{&base};
    for (Measured& one : trade_.combinations) timed.push_back(&one);
    trade_.ofCombinations = time(timed, kCombinationTimes, "timing combinations", request_.mostRounds);
    if (trade_.ofCombinations.rounds == 0) return noTimeForCombinations();
    if (request_.brief) return;
    for (const int k : trade_.front) {
      Measured& one = trade_.combinations[k];
      if (!goOn("looking closer at " + one.configuration.name())) return;
      const Cost cost = one.cost;
      if (isLate(1) || !inTime(1, [&] { one = measure_.whole(one.configuration); })) {
        trade_.notes.emplace_back(
            "the time did not suffice for a closer look at all of the front (--budget)");
        return;
      }
      one.cost.time = cost.time, one.cost.stages = cost.stages;
    }
  }

  void noTimeForCombinations() {
    trade_.combinations.clear();
    trade_.front.clear();
    if (!trade_.stopped)
      trade_.notes.emplace_back("the time did not suffice to time combinations (--budget)");
  }

  /// The combinations near the limit. Those that may be the choice are timed again, in turn. If none keeps
  /// the limit, they are seen on all views until none that is left can be the most accurate.
  void choices() {
    Search search{measure_, trade_.axes, request_.within};
    if (!searched(search, kChoiceSearch)) return;
    const std::vector<int> within = search.within(kNearFastest, kMaySave);
    trade_.combinations = search.tried();
    std::vector<Measured*> timed;
    double ms = 0, leastError = std::numeric_limits<double>::infinity();
    for (const int k : within.empty() ? search.byError() : within) {
      Measured& one = trade_.combinations[k];
      ms += kFirstRounds * one.cost.time.ms;
      if (!timed.empty() && within.empty() && (errorOnAllViews(one) > leastError || isLate(kChoiceErrors)))
        break;
      if (!timed.empty() && !within.empty() &&
          (timed.size() == kFinalists || ms > 1e3 * kFirstShare * request_.seconds))
        break;
      const Cost rough = one.cost;
      const std::int64_t wrong = one.wrongElsewhere;
      if (!inTime(kChoiceErrors, [&] { one = measure_.brief(one.configuration); })) break;
      one.wrongElsewhere = wrong;
      one.cost.time = rough.time, one.cost.stages = rough.stages, one.cost.rough = true;
      leastError = std::min(leastError, errorOnAllViews(one));
      timed.push_back(&one);
    }
    if (timed.empty()) return;
    if (within.empty())
      std::erase_if(timed, [&](Measured* one) { return errorOnAllViews(*one) > leastError; });
    for (Measured* const one : timed) one->cost.rough = false;
    // A few rounds leave those that may be the fastest; these have the rest of the time.
    (void)time(timed, 1, "timing the fastest", kFirstRounds);
    const auto ratioOf = [](const Measured* one) { return one->cost.time.ratio; };
    const double least = ratioOf(*std::ranges::min_element(timed, {}, ratioOf));
    const std::vector<const Measured*> useful = usefulOf({timed.begin(), timed.end()}, kSaves);
    std::erase_if(timed, [&](Measured* one) {
      one->cost.rough = ratioOf(one) > kLast * least || std::ranges::find(useful, one) == useful.end();
      return one->cost.rough;
    });
    if (!trade_.stopped)
      trade_.ofCombinations = time(timed, 1, "timing the fastest again", request_.mostRounds, kNarrow);
    if (trade_.ofCombinations.rounds == 0)
      for (Measured* one : timed) one->cost.rough = true;
  }

  /// `ways` are in Trade or beside it; the first is the base.
  Timings time(const std::vector<Measured*>& ways, double share, const std::string& doing, int mostRounds,
               double narrow = TimingLimits{}.narrow) {
    std::vector<Stages> stages(ways.size());
    std::vector<Timed> timed;
    for (std::size_t k = 0; k < ways.size(); ++k)
      timed.emplace_back(
          [this, way = ways[k], &stage = stages[k]] { return measure_.run(way->configuration, stage); });
    const TimingLimits limits{.seconds = secondsTo(share),
                              .leastRounds = std::min(TimingLimits{}.leastRounds, mostRounds),
                              .mostRounds = mostRounds,
                              .narrow = narrow,
                              .seed = request_.seed};
    int kept = 0;
    const auto keep = [&](const Timings& timings) {
      for (std::size_t k = 0; k < ways.size(); ++k) ways[k]->cost.time = timings.of[k];
      if (!request_.within) trade_.front = frontOf(trade_.combinations);
    };
    const MayGiveUp limit = limitOf(share);
    Timings timings = timeAll(timed, limits, [&](int rounds, const Timings& known) {
      if (known.rounds != kept) keep(known), kept = known.rounds;
      return goOn(doing + ": round " + std::to_string(rounds + 1));
    });
    keep(timings);
    for (std::size_t k = 0; k < ways.size(); ++k) ways[k]->cost.stages = stages[k].medians();
    return timings;
  }

  TradeRequest request_;
  TradeProgress progress_;
  double start_;
  Measure& measure_;
  Trade trade_;
};

}  // namespace

std::string savingOf(const Timing& time) {
  if (time.tie) return "takes as long";
  if (time.ratio < 1)
    return "saves " + std::to_string(std::lround(100 * (1 - time.ratio))) + " % of the time";
  const double tenths = std::round(10 * time.ratio) / 10;
  if (tenths < 1.1) return "takes " + std::to_string(std::lround(100 * (time.ratio - 1))) + " % longer";
  if (tenths == 2) return "takes twice as long";
  return "takes " + textOf(tenths >= 10 ? std::round(tenths) : tenths) + " times as long";
}

Trade tradeOf(const Shared<Scene>& scene, const PictureSettings& settings, const TradeRequest& request,
              const TradeProgress& progress) {
  if (boxOf(scene->mesh.points).side() == 0) throw ViewError{"the scene has no extent"};
  const double start = processorMs();
  Measure measure{scene, settings};
  return Trader{measure, request, progress, start}.make();
}

Trade tradeOf(Measure& measure, const TradeRequest& request, const TradeProgress& progress) {
  return Trader{measure, request, progress, processorMs()}.make();
}

}  // namespace xnewell
