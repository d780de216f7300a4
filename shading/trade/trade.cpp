#include "shading/trade/trade.h"

#include <algorithm>
#include <cmath>

#include "geometry/exact/box.h"
#include "geometry/exact/give_up.h"
#include "shading/trade/choice.h"
#include "shading/trade/measure.h"
#include "shading/trade/search.h"
#include "shading/trade/trade_sentences.h"

namespace xnewell {

namespace {

/// The shares of the time after which the parts end: errors of rows, their times, what items cost, the search
/// of combinations, their errors, and their times. A closer look at the front has the rest.
constexpr double kRowErrors = 0.3, kRowTimes = 0.45, kItems = 0.5, kSearch = 0.65, kCombinationErrors = 0.75,
                 kCombinationTimes = 0.9;

/// So many combinations are timed, or more, as many as can run so many rounds in their time.
constexpr std::size_t kLeastCombinations = 8;
constexpr int kRounds = 9;

/// What has begun may take this share of the time more than its part has left, and the last part kOver. Then
/// it is given up. So one picture that takes very long cannot take more.
constexpr double kBeyond = 0.2, kOver = 0.05;

/// The axes that a request asks for, without the values that it leaves out.
std::vector<Axis> requestedAxes(std::vector<Axis> all, const TradeRequest& request) {
  const auto axisNamed = [&](const std::string& name) {
    const auto axis = std::ranges::find(all, name, &Axis::name);
    if (axis != all.end()) return axis;
    std::string names;
    for (const Axis& a : all) names += (names.empty() ? "" : ", ") + std::string{a.name()};
    throw std::invalid_argument{"'" + name + "' is no short cut of this picture: these are " + names};
  };
  for (const std::string& without : request.without) {
    const std::size_t sign = without.find('=');
    if (sign == std::string::npos)
      throw std::invalid_argument{"--without " + without + ": AXIS=VALUE is needed, such as order=none"};
    const auto axis = axisNamed(without.substr(0, sign));
    const auto value = std::ranges::find_if(
        axis->others, [&](double v) { return axis->text(v) == without.substr(sign + 1); });
    if (value == axis->others.end()) {
      std::string values;
      for (const double v : axis->others) values += (values.empty() ? "" : ", ") + axis->text(v);
      throw std::invalid_argument{"--without " + without + ": the values to try are " + values};
    }
    axis->others.erase(value);
  }
  if (request.axes.empty()) return all;
  std::vector<Axis> some;
  for (const std::string& name : request.axes) {
    const Axis& axis = *axisNamed(name);
    if (std::ranges::find(some, axis.name(), &Axis::name) == some.end()) some.push_back(axis);
  }
  return some;
}

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
    trade_.asked = closely(measure_.askedConfiguration());
    if (trade_.asked.here.samples == 0) throw ViewError{"nothing shows, so there is nothing to measure"};
    rows();
    if (!trade_.stopped && !request_.brief && request_.axes.empty()) items();
    if (!trade_.stopped) combinations();
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
    trade_.ofRows = time(timed, kRowTimes, "timing short cuts");
    for (TradeRow& row : trade_.rows)
      row.sentence = sentenceOf(row, trade_.axes[row.axis], trade_.asked, measure_.asked());
  }

  void items() {
    const TimingLimits limits{.seconds = secondsTo(kItems),
                              .leastRounds = 3,
                              .mostRounds = request_.mostRounds,
                              .seed = request_.seed};
    const bool known = inTime(kItems, [&] {
      const Picture& asked = measure_.asked();  // has no more than what it shows
      const Picture picture = PictureCache{asked.scene()}.make(asked.settings(), asked.ground());
      trade_.items = itemCostsOf(picture, limits, [&](int rounds, const Timings&) {
        return goOn("timing what is required: round " + std::to_string(rounds + 1));
      });
    });
    if (!known)
      trade_.notes.emplace_back("the time did not suffice for what each required item costs (--budget)");
  }

  void combinations() {
    Search search{measure_, trade_.axes};
    search.know(trade_.asked);
    for (const TradeRow& row : trade_.rows) search.know(row.measured);
    for (bool more = true; more;) {
      if (!goOn("looking at combinations: " + std::to_string(search.tried().size()))) return;
      if (isLate(kSearch) || !inTime(kSearch, [&] { more = search.step(); })) {
        trade_.notes.emplace_back("the time did not suffice for all combinations with promise (--budget)");
        break;
      }
    }
    trade_.neverTried = search.neverTried();
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
    trade_.ofCombinations = time(timed, kCombinationTimes, "timing combinations");
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

  /// `ways` are in Trade or beside it; the first is the base.
  Timings time(const std::vector<Measured*>& ways, double share, const std::string& doing) {
    std::vector<Stages> stages(ways.size());
    std::vector<Timed> timed;
    for (std::size_t k = 0; k < ways.size(); ++k)
      timed.emplace_back(
          [this, way = ways[k], &stage = stages[k]] { return measure_.run(way->configuration, stage); });
    const TimingLimits limits{.seconds = secondsTo(share),
                              .leastRounds = std::min(TimingLimits{}.leastRounds, request_.mostRounds),
                              .mostRounds = request_.mostRounds,
                              .seed = request_.seed};
    int kept = 0;
    const auto keep = [&](const Timings& timings) {
      for (std::size_t k = 0; k < ways.size(); ++k) ways[k]->cost.time = timings.of[k];
      trade_.front = frontOf(trade_.combinations);
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
