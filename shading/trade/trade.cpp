#include "shading/trade/trade.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <numeric>

#include "geometry/exact/box.h"
#include "geometry/exact/give_up.h"
#include "shading/scene/units.h"
#include "shading/trade/choice.h"
#include "shading/trade/measure.h"

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

/// ---- What a row says

/// Two digits: 0.0012, 2.5, 12, 790.
std::string twoDigits(double v) {
  char text[32];
  if (v >= 100) {
    const double unit = std::pow(10.0, std::floor(std::log10(v)) - 1);
    std::snprintf(text, sizeof text, "%.0f", unit * std::round(v / unit));
  } else {
    std::snprintf(text, sizeof text, "%.2g", v);
  }
  return text;
}

std::string times(double ratio, const std::string& what) { return twoDigits(ratio) + " times " + what; }

/// How far the nearest lamp is from the scene's centre, in sides of the scene.
std::string whereTheLampIs(const Picture& picture) {
  const Scene& scene = picture.scene();
  const Box box = boxOf(scene.mesh.points);
  double nearest = std::numeric_limits<double>::infinity();
  for (const Light& light : lightsOf(scene, picture.settings().light))
    if (light.kind != LightKind::Directional) {
      const glm::dvec3 to = light.position - box.centre();
      nearest = std::min(nearest, std::hypot(to.x, to.y, to.z));
    }
  return "The nearest lamp is " + times(nearest / box.side(), "the scene's side away.");
}

std::string whereTheEyeIs(const Picture& picture) {
  const Camera& camera = picture.camera();
  return "The eye is " +
         times(glm::length(camera.eye - camera.lookAt) / boxOf(picture.scene().mesh.points).side(),
               "the scene's side away.");
}

/// A sentence about the reason, if the numbers give one.
std::string reasonOf(const TradeRow& row, const Axis& axis, const Picture& picture) {
  const Errors& errors = row.measured.here;
  if (!axis.setting)
    return errors.patches ? "Its polygons are up to " + twoDigits(errors.patches->largestPixels) +
                                " pixels off the patches."
                          : "";
  if (axis.setting->key == "constant_l") return whereTheLampIs(picture);
  if (axis.setting->key == "constant_v") return whereTheEyeIs(picture);
  if (axis.setting->key == "method" && row.value == static_cast<double>(Shading::Flat) &&
      row.measured.cost.polygons > 0)
    return "A polygon covers about " +
           twoDigits(static_cast<double>(errors.samples) / static_cast<double>(row.measured.cost.polygons)) +
           " samples.";
  return "";
}

/// "4 more samples show a wrong face", "no sample shows a wrong face".
std::string facesOf(std::int64_t wrong, std::int64_t before) {
  const std::int64_t more = wrong - before;
  if (wrong == 0 && more != 0) return "no sample shows a wrong face";
  const std::int64_t count = std::abs(more);
  return std::to_string(count) + (more > 0 ? " more" : " fewer") +
         (count == 1 ? " sample shows" : " samples show") + " a wrong face";
}

/// What one short cut saves and what error it has, and the reason where the numbers give one: "With L
/// constant it saves 3 % of the time and is off by 0.0012 instead of 0.001, at most by 0.01. The nearest lamp
/// is 12 times the scene's side away."
std::string sentenceOf(const TradeRow& row, const Axis& axis, const Measured& asked, const Picture& picture) {
  const Measured& one = row.measured;
  std::string text = "With " + one.configuration.name() + " it " +
                     (one.cost.time.ms > 0 ? savingOf(one.cost.time) : "was not timed");
  if (one.samePixels) return text + " and shows the same picture.";
  const double rms = one.here.afterTable.rootMeanSquare, before = asked.here.afterTable.rootMeanSquare;
  const bool alike = twoDigits(rms) == twoDigits(before);
  text += " and is off by " + twoDigits(rms) + (alike ? " as before" : " instead of " + twoDigits(before)) +
          ", at most by " + twoDigits(one.here.afterTable.largest);
  if (one.here.wrongFaces != asked.here.wrongFaces)
    text += "; " + facesOf(one.here.wrongFaces, asked.here.wrongFaces);
  const std::string reason = reasonOf(row, axis, picture);
  return text + '.' + (reason.empty() ? "" : ' ' + reason);
}

/// ---- Which combinations are worth a look?
///
/// There are far too many to try all. The search looks at one after the other: it paints it once, which tells
/// the error, and roughly the time. What comes next is one change away from a combination that was tried. Its
/// time and error are predicted from what the same change did when it was last tried: it multiplied the time,
/// and it added to the square of the error, or left a share of it. A change that was never tried is expected
/// to help. What it shows corrects the predictions. Promise is the time, in times of the fastest that is as
/// accurate.

class Search {
 public:
  /// `measure` must outlive it.
  Search(Measure& measure, const std::vector<Axis>& axes) : measure_{measure}, axes_{axes} {
    for (const Axis& axis : axes) effects_.emplace_back(axis.others.size() + 1);
  }

  /// Takes over what is known of a configuration.
  void know(const Measured& measured) {
    Key key(axes_.size(), 0);
    for (const Change& change : measured.configuration.changes)
      for (std::size_t k = 0; k < axes_.size(); ++k)
        if (axes_[k].setting == change.setting)
          key[k] = static_cast<std::int8_t>(
              1 + (std::ranges::find(axes_[k].others, change.value) - axes_[k].others.begin()));
    const double rms = std::max(measured.here.afterTable.rootMeanSquare, measured.elsewhere);
    const StageTimes& t = measured.cost.stages;
    take(key, {t.shade + t.transform + t.sort + t.fill, rms * rms}, measured);
  }

  /// Tries the most promising candidate. Returns false if nothing is left to try.
  bool step() {
    constexpr double kHopeless = 2;  // candidates that promise less are left
    for (;;) {
      auto best = candidates_.end();
      double least = kHopeless;
      for (auto at = candidates_.begin(); at != candidates_.end(); ++at)
        if (!tried_[at->second.from].idle)
          if (const double value = promise(at->second.to); value < least) least = value, best = at;
      if (best == candidates_.end()) return false;
      const Key key = best->first;
      candidates_.erase(best);
      seen_.emplace(key, -1);
      Measured one;
      one.configuration = configurationOf(key);
      if (!allHaveEffect(one.configuration, measure_.asked())) continue;
      const Glance glance = measure_.glance(one.configuration);
      if (std::isinf(glance.rms)) return true;
      one.here.afterTable.rootMeanSquare = glance.rms;
      one.cost.time = {.ms = glance.ms};
      one.cost.stages = glance.stages;
      take(key, {glance.ms, glance.rms * glance.rms}, std::move(one));
      return true;
    }
  }

  [[nodiscard]] std::size_t count() const { return tried_.size(); }
  /// The `most` that are nearest to the front, the nearest first. Changes that bring nothing are left out.
  [[nodiscard]] std::vector<Measured> nearFront(std::size_t most) const {
    std::vector<const Tried*> all;
    for (const Tried& one : tried_)
      if (!one.idle) all.push_back(&one);
    std::ranges::stable_sort(all, {}, [&](const Tried* one) { return promise(one->look); });
    std::vector<Measured> near;
    for (const Tried* one : all)
      if (near.size() < most) near.push_back(one->measured);
    return near;
  }
  /// The values that no combination tried had: "--order bsp, oracle; --divisions 64"; "" if all were tried.
  [[nodiscard]] std::string neverTried() const {
    std::string all;
    for (std::size_t k = 0; k < axes_.size(); ++k) {
      std::string values;
      for (std::size_t v = 1; v <= axes_[k].others.size(); ++v)
        if (std::ranges::none_of(tried_, [&](const Tried& one) { return one.key[k] == static_cast<int>(v); }))
          values += (values.empty() ? " " : ", ") + axes_[k].text(axes_[k].others[v - 1]);
      if (!values.empty()) all += (all.empty() ? "--" : "; --") + std::string{axes_[k].name()} + values;
    }
    return all;
  }

 private:
  /// For each axis the value: 0 as it is, otherwise 1 + the index of another.
  using Key = std::vector<std::int8_t>;
  struct Look {
    double ms = 0, square = 0;  ///< of the RMS error
  };
  struct Tried {
    Key key;
    Look look;
    Measured measured;
    bool idle = false;  ///< some of its changes bring nothing
  };
  struct Candidate {
    std::size_t from;  ///< index into tried_
    Look to;
  };
  /// What a value does beside the value as it is.
  struct Effect {
    bool known = false;
    double ratio = 1;              ///< of the time
    double square = 0, share = 1;  ///< of the error: what is added, and what of it is left
  };

  [[nodiscard]] Configuration configurationOf(const Key& key) const {
    Configuration one = measure_.askedConfiguration();
    for (std::size_t k = 0; k < axes_.size(); ++k)
      if (key[k] > 0) one = changed(one, axes_[k], axes_[k].others[key[k] - 1]);
    return one;
  }
  /// Its time in times of the fastest tried that is as accurate. What would be more accurate than anything
  /// comes first, the cheap before the dear.
  [[nodiscard]] double promise(const Look& look) const {
    double least = std::numeric_limits<double>::infinity();
    for (const Tried& one : tried_)
      if (one.look.square <= look.square) least = std::min(least, one.look.ms);
    return std::isinf(least) ? 1e-3 * look.ms / tried_.front().look.ms : look.ms / least;
  }
  /// True if `other` is as fast and as accurate with some of its changes alone: those of `simple`.
  [[nodiscard]] static bool makesIdle(const Tried& simple, const Tried& other) {
    constexpr double kIdle = 1.1;  // a change brings nothing if it is at most so many times as slow without
    bool part = simple.look.ms <= kIdle * other.look.ms &&
                simple.look.square <= kErrorTie * kErrorTie * other.look.square;
    for (std::size_t k = 0; k < simple.key.size(); ++k)
      part = part && (simple.key[k] == 0 || simple.key[k] == other.key[k]);
    return part;
  }

  void take(const Key& key, const Look& look, Measured measured) {
    const auto [at, isNew] = seen_.emplace(key, -1);
    if (!isNew && at->second >= 0) return;
    at->second = static_cast<int>(tried_.size());
    Tried one{key, look, std::move(measured)};
    for (Tried& other : tried_) {
      one.idle = one.idle || makesIdle(other, one);
      other.idle = other.idle || makesIdle(one, other);
    }
    learn(one);
    tried_.push_back(std::move(one));
    candidates_.erase(key);
    expand(tried_.back());
  }
  /// From a combination that differs in one value.
  void learn(const Tried& one) {
    for (const Tried& from : tried_) {
      const auto [a, b] = std::ranges::mismatch(from.key, one.key);
      if (!std::equal(a + 1, from.key.end(), b + 1)) continue;
      std::vector<Effect>& values = effects_[static_cast<std::size_t>(a - from.key.begin())];
      if (*b > 0)
        values[*b] = {true, values[*a].ratio * one.look.ms / from.look.ms,
                      values[*a].square + one.look.square - from.look.square,
                      from.look.square > 0 ? values[*a].share * one.look.square / from.look.square : 1.0};
    }
  }
  /// All that is one change away, and is expected to be faster or more accurate, by more than chance.
  void expand(const Tried& from) {
    constexpr double kLeast = 0.02;  // of the square: an error does not vanish
    for (std::size_t k = 0; k < axes_.size() && !from.idle; ++k)
      for (std::size_t v = 0; v < effects_[k].size(); ++v) {
        Key key = from.key;
        key[k] = static_cast<std::int8_t>(v);
        if (seen_.contains(key)) continue;
        const Effect &before = effects_[k][from.key[k]], &after = effects_[k][v];
        const Look& now = from.look;
        const double added = after.square - before.square;
        Look to{now.ms * after.ratio / before.ratio,
                added > 0          ? now.square + added
                : before.share > 0 ? now.square * std::max(kLeast, after.share / before.share)
                                   : now.square};
        if (v > 0 && !after.known) to = {now.ms, now.square / 2};
        if (kErrorTie * to.ms < now.ms || kErrorTie * kErrorTie * to.square < now.square)
          candidates_[key] = {tried_.size() - 1, to};
      }
  }

  Measure& measure_;
  const std::vector<Axis>& axes_;
  std::vector<std::vector<Effect>> effects_;  ///< by axis and value
  std::vector<Tried> tried_;
  std::map<Key, int> seen_;  ///< indices into tried_; -1 for what has no picture
  std::map<Key, Candidate> candidates_;
};

/// The trade while it is made.
class Trader {
 public:
  Trader(Measure& measure, const TradeRequest& request, const TradeProgress& progress, double start)
      : request_{request}, progress_{progress}, start_{start}, measure_{measure} {}

  Trade make() {
    // Who names axes may mean some that have an effect only beside another.
    trade_.axes = requestedAxes(
        axesOf(measure_.asked(), request_.axes.empty() ? Reach::Alone : Reach::BesideOthers), request_);
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
      if (!goOn("looking at combinations: " + std::to_string(search.count()))) return;
      if (isLate(kSearch) || !inTime(kSearch, [&] { more = search.step(); })) {
        trade_.notes.emplace_back("the time did not suffice for all combinations with promise (--budget)");
        break;
      }
    }
    trade_.neverTried = search.neverTried();
    double round = 2 * trade_.asked.cost.time.ms;  // the base and its twin
    for (const Measured& one : search.nearFront(kMostCombinations)) {
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
