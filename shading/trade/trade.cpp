#include "shading/trade/trade.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>
#include <set>
#include <tuple>

#include "geometry/exact/box.h"
#include "geometry/exact/give_up.h"
#include "shading/scene/units.h"
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
/// the error, and roughly the time. What comes next is one change away from something promising that was
/// tried, and the changes that promise most alone come first. So it soon has the best changes together.
/// Promise is the time, in times of the fastest that is as accurate.

class Search {
 public:
  /// `measure` must outlive it.
  Search(Measure& measure, const std::vector<Axis>& axes) : measure_{measure}, axes_{axes} {}

  /// Takes over what is known of a configuration.
  void know(Measured measured) {
    Key key(axes_.size(), 0);
    for (const Change& change : measured.configuration.changes)
      for (std::size_t k = 0; k < axes_.size(); ++k)
        if (axes_[k].setting == change.setting)
          key[k] = 1 + static_cast<int>(std::ranges::find(axes_[k].others, change.value) -
                                        axes_[k].others.begin());
    seen_.insert(key);
    const StageTimes& t = measured.cost.stages;
    const double error = std::max(measured.here.afterTable.rootMeanSquare, measured.elsewhere);
    Tried one{std::move(key), t.shade + t.transform + t.sort + t.fill, error, std::move(measured)};
    for (Tried& other : tried_) {
      one.idle = one.idle || makesIdle(other, one);
      other.idle = other.idle || makesIdle(one, other);
    }
    tried_.push_back(std::move(one));
  }

  /// Tries the next one. Returns false if nothing is left to try.
  bool step() {
    constexpr double kHopeless = 2;  // what promises less is not changed further
    if (moves_.empty()) findMoves();
    for (;;) {
      Tried* from = nullptr;
      for (Tried& one : tried_)
        if (!one.idle && one.moves < moves_.size() && (!from || one.moves < from->moves) &&
            promise(one) < kHopeless)
          from = &one;
      if (from == nullptr) return false;
      const auto [axis, value] = moves_[from->moves++];
      Key key = from->key;
      key[axis] = value;
      if (!seen_.insert(key).second) continue;
      Configuration one = measure_.askedConfiguration();
      for (std::size_t k = 0; k < axes_.size(); ++k)
        if (key[k] > 0) one = changed(one, axes_[k], axes_[k].others[key[k] - 1]);
      if (!allHaveEffect(one, measure_.asked())) continue;
      if (std::optional<Measured> measured = measure_.glance(one)) know(std::move(*measured));
      return true;
    }
  }

  [[nodiscard]] std::size_t count() const { return tried_.size(); }
  /// The `most` that are nearest to the front, the nearest first. Changes that bring nothing are left out.
  [[nodiscard]] std::vector<Measured> nearFront(std::size_t most) const {
    std::vector<std::pair<double, const Tried*>> all;
    for (const Tried& one : tried_)
      if (!one.idle) all.emplace_back(promise(one), &one);
    std::ranges::stable_sort(all, {}, [](const auto& one) { return one.first; });
    std::vector<Measured> near;
    for (const auto& [value, one] : all)
      if (near.size() < most) near.push_back(one->measured);
    return near;
  }
  /// The values that no combination tried had: "--order bsp, oracle; --divisions 64"; "" if all were tried.
  [[nodiscard]] std::string neverTried() const {
    std::string all;
    for (std::size_t k = 0; k < axes_.size(); ++k) {
      std::string values;
      for (int v = 1; v <= std::ssize(axes_[k].others); ++v)
        if (std::ranges::none_of(tried_, [&](const Tried& one) { return one.key[k] == v; }))
          values += (values.empty() ? " " : ", ") + axes_[k].text(axes_[k].others[v - 1]);
      if (!values.empty()) all += (all.empty() ? "--" : "; --") + std::string{axes_[k].name()} + values;
    }
    return all;
  }

 private:
  /// For each axis the value: 0 as it is, otherwise 1 + the index of another.
  using Key = std::vector<int>;
  struct Tried {
    Key key;
    double ms, error;
    Measured measured;
    bool idle = false;      ///< some of its changes bring nothing
    std::size_t moves = 0;  ///< how many of them were made
  };

  /// The changes of one value, the most promising first. Those that were tried alone and lose are left out;
  /// those that have no effect alone come last.
  void findMoves() {
    constexpr double kLoses = 3;
    std::vector<std::tuple<double, std::size_t, int>> all;
    for (std::size_t k = 0; k < axes_.size(); ++k)
      for (int v = 1; v <= std::ssize(axes_[k].others); ++v) {
        Key key(axes_.size(), 0);
        key[k] = v;
        const auto alone = std::ranges::find(tried_, key, &Tried::key);
        const double value = alone == tried_.end() ? kLoses : promise(*alone);
        if (value <= kLoses) all.emplace_back(value, k, v);
      }
    std::ranges::sort(all);
    for (const auto& [value, axis, to] : all) moves_.emplace_back(axis, to);
  }
  /// Its time in times of the fastest tried that is as accurate.
  [[nodiscard]] double promise(const Tried& one) const {
    double least = one.ms;
    for (const Tried& other : tried_)
      if (other.error <= kErrorTie * one.error) least = std::min(least, other.ms);
    return one.ms / least;
  }
  /// True if `other` is as fast and as accurate with some of its changes alone: those of `simple`.
  [[nodiscard]] static bool makesIdle(const Tried& simple, const Tried& other) {
    constexpr double kIdle = 1.1;  // a change brings nothing if it is at most so many times as slow without
    bool part = simple.ms <= kIdle * other.ms && simple.error <= kErrorTie * other.error;
    for (std::size_t k = 0; k < simple.key.size(); ++k)
      part = part && (simple.key[k] == 0 || simple.key[k] == other.key[k]);
    return part;
  }

  Measure& measure_;
  const std::vector<Axis>& axes_;
  std::vector<Tried> tried_;
  std::set<Key> seen_;
  std::vector<std::pair<std::size_t, int>> moves_;  ///< an axis and its value
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

/// ---- The front, and the choice on it

namespace {

std::string textIn(double v, const char* format) {
  char text[32];
  std::snprintf(text, sizeof text, format, v);
  return text;
}
std::string error(double v) { return textIn(v, "%.2g"); }
std::string ms(double v) { return textIn(v, v < 9.95 ? "%.2g" : "%.0f") + " ms"; }

std::string samples(std::int64_t count) {
  return (count == 0 ? "No" : std::to_string(count)) + (count <= 1 ? " sample shows" : " samples show");
}

bool keeps(const Measured& one, const AccuracyLimit& limit) {
  return errorOnAllViews(one) <= (1 - kSpare) * limit.rms &&
         (!limit.wrong || one.here.wrongFaces <= *limit.wrong);
}

/// The next combination on the front that is cheaper, if there is one.
const Measured* nextCheaper(const Trade& trade, const Measured& chosen) {
  const Measured* next = nullptr;
  for (const int k : trade.front)
    if (trade.combinations[k].cost.time.ratio < chosen.cost.time.ratio) next = &trade.combinations[k];
  return next;
}

}  // namespace

std::vector<int> frontOf(const std::vector<Measured>& measured) {
  std::vector<int> order(measured.size()), front;
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](int k) { return measured[k].cost.time.ratio; });
  for (const int k : order) {
    if (!front.empty() && kErrorTie * measured[k].elsewhere >= measured[front.back()].elsewhere) continue;
    while (!front.empty() && measured[front.back()].cost.time.interval.meets(measured[k].cost.time.interval))
      front.pop_back();
    front.push_back(k);
  }
  return front;
}

bool areTimed(const std::vector<Measured>& some) {
  return std::ranges::any_of(some, [](const Measured& one) { return one.cost.time.ms > 0; });
}

Trade withSingles(Trade trade) {
  trade.combinations.clear();
  if (trade.asked.cost.time.ms > 0) {
    trade.combinations.push_back(trade.asked);
    for (const TradeRow& row : trade.rows) trade.combinations.push_back(row.measured);
  }
  trade.front = frontOf(trade.combinations);
  return trade;
}

double errorOnAllViews(const Measured& one) {
  return std::max(one.elsewhere, one.here.afterTable.rootMeanSquare);
}

std::pair<std::string, std::string> toldApart(double a, double b) {
  for (int digits = 2; digits < 17; ++digits) {
    const std::string format = "%." + std::to_string(digits) + "g";
    std::pair both{textIn(a, format.c_str()), textIn(b, format.c_str())};
    if (both.first != both.second || a == b) return both;
  }
  return {error(a), error(b)};
}

Chosen chooseWithin(const Trade& trade, const AccuracyLimit& limit) {
  Chosen choice;
  const std::vector<Measured>& all = trade.combinations;
  if (all.empty()) return choice;
  std::vector<Measured> kept;
  std::vector<int> indices;
  for (int k = 0; k < static_cast<int>(all.size()); ++k)
    if (keeps(all[k], limit)) kept.push_back(all[k]), indices.push_back(k);
  choice.accurate = !kept.empty();
  choice.combination =
      choice.accurate ? indices[frontOf(kept).front()]
                      : static_cast<int>(std::ranges::min_element(all, {}, errorOnAllViews) - all.begin());
  const Measured& chosen = all[choice.combination];
  choice.why.push_back("Of " + std::to_string(all.size()) + " combinations that were timed, it is the " +
                       (choice.accurate ? "cheapest on the front within the limit, with " +
                                              textOf(100 * kSpare) + " % to spare."
                                        : "most accurate."));
  const auto [off, allowed] = toldApart(errorOnAllViews(chosen), limit.rms);
  choice.why.push_back("Its RMS error is at most " + off + " in this view and in " +
                       std::to_string(trade.views) + " turned ones" +
                       (errorOnAllViews(chosen) <= limit.rms ? ", and " : ", but ") + allowed +
                       " is allowed. It takes " + ms(chosen.cost.time.ms) + ".");
  if (!choice.accurate)
    choice.why.push_back(trade.neverTried.empty()
                             ? "Every value of every short cut was tried, but not every combination."
                             : "Never tried: " + trade.neverTried + ".");
  else if (const Measured* const next = nextCheaper(trade, chosen))
    choice.why.push_back("The next cheaper on the front, " + next->configuration.name() + ", takes " +
                         ms(next->cost.time.ms) + " and is off by " + error(errorOnAllViews(*next)) + ".");
  choice.why.push_back(
      samples(chosen.here.wrongFaces) + " a wrong face. " +
      (limit.wrong ? std::to_string(*limit.wrong) + " may." : "The limit is for the intensity alone."));
  return choice;
}

}  // namespace xnewell
