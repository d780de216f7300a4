#include "shading/trade/combine.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "shading/picture/facts.h"
#include "shading/trade/measure.h"

namespace xnewell {

namespace {

/// A costlier value must reduce the error at least to this share.
constexpr double kBetter = 0.95;

/// A value of an axis, what it costs and how wrong it is.
struct Trial {
  double value;
  double ratio, error;
};

/// The values of an axis that are worth a combination, the cheapest first. Times within a tie of the base
/// count as its time; but where the shading takes all the time every order ties, though they are far apart
/// beside a cheap method, so that orders count by the time that was measured.
std::vector<Trial> usefulOf(const Trade& trade, std::size_t axis) {
  const bool order = trade.axes[axis].setting && trade.axes[axis].setting->key == "order";
  std::vector<Trial> all{{trade.axes[axis].now, 1.0, trade.asked.elsewhere}};
  for (const TradeRow& row : trade.rows)
    if (row.axis == static_cast<int>(axis)) {
      const Timing& time = row.measured.cost.time;
      all.push_back({row.value, time.tie && !order ? 1.0 : time.ratio, row.measured.elsewhere});
    }
  // The user's own value is the first of several that are equally good.
  std::ranges::stable_sort(all, [](const Trial& a, const Trial& b) {
    return a.ratio != b.ratio ? a.ratio < b.ratio : a.error < b.error;
  });
  std::vector<Trial> useful;
  double least = std::numeric_limits<double>::infinity();  // error so far
  for (const Trial& trial : all) {
    const bool better = trial.error < kBetter * least;
    if (better || trial.value == trade.axes[axis].now) useful.push_back(trial);
    if (better) least = trial.error;
  }
  return useful;
}

/// Keeps the first, the last, and some between them.
std::vector<Trial> thinned(const std::vector<Trial>& trials, std::size_t count) {
  if (trials.size() <= count) return trials;
  std::vector<Trial> some;
  for (std::size_t k = 0; k < count; ++k)
    some.push_back(trials[count == 1 ? trials.size() - 1 : k * (trials.size() - 1) / (count - 1)]);
  return some;
}

/// Smaller comes first: the method, the divisions and the order, then by what is saved.
double rankOf(const Axis& axis, const std::vector<Trial>& useful) {
  if (!axis.setting) return -2;
  if (axis.setting->key == "method") return -3;
  if (axis.setting->key == "order") return -1;
  return useful.front().ratio;
}

bool allHaveEffect(const Configuration& configuration, const Picture& asked) {
  return std::ranges::all_of(configuration.changes, [&](const Change& change) {
    return !change.setting || hasEffect(*change.setting, factsOf(asked, configuration.settings));
  });
}

}  // namespace

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

std::vector<Configuration> combinationsOf(const Trade& trade, const Measure& measure, int most,
                                          std::vector<std::string>& left) {
  std::vector<std::vector<Trial>> useful;
  for (std::size_t k = 0; k < trade.axes.size(); ++k) useful.push_back(usefulOf(trade, k));
  std::vector<std::size_t> order(trade.axes.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](std::size_t k) { return rankOf(trade.axes[k], useful[k]); });

  // How many values of each axis there is room for. The method, the divisions and the order share the room;
  // the others get what is left.
  std::vector<std::size_t> count(trade.axes.size());
  std::size_t product = 1;
  for (const std::size_t k : order) {
    count[k] = useful[k].size();
    if (rankOf(trade.axes[k], useful[k]) >= 0)
      count[k] = std::min(count[k], static_cast<std::size_t>(most) / product);
    product *= count[k];
    while (product > static_cast<std::size_t>(most)) {
      std::size_t& largest = *std::ranges::max_element(count);
      product = product / largest * (largest - 1);
      --largest;
    }
  }

  std::vector<Configuration> all{measure.askedConfiguration()};
  for (const std::size_t k : order) {
    const Axis& axis = trade.axes[k];
    if (count[k] < useful[k].size())
      left.push_back(
          count[k] < 2
              ? "combinations leave --" + std::string{axis.name()} + " as it is: there is no room for more"
              : "combinations have " + std::to_string(count[k]) + " of the " +
                    std::to_string(useful[k].size()) + " useful values of --" + std::string{axis.name()});
    // If the only useful value is another than the user's, it takes its place.
    const std::vector<Trial> trials = count[k] < 2 && useful[k].size() > 1
                                          ? std::vector<Trial>{{axis.now, 1, 0}}
                                          : thinned(useful[k], count[k]);
    std::vector<Configuration> next;
    for (const Configuration& one : all)
      for (const Trial& trial : trials) {
        Configuration other = trial.value == axis.now ? one : changed(one, axis, trial.value);
        if (allHaveEffect(other, measure.asked())) next.push_back(std::move(other));
      }
    all = std::move(next);
  }
  return all;
}

std::vector<int> frontOf(const std::vector<Measured>& measured) {
  std::vector<int> order(measured.size()), front;
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](int k) { return measured[k].cost.time.ratio; });
  for (const int k : order) {
    if (!front.empty() && measured[k].elsewhere >= measured[front.back()].elsewhere) continue;
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

}  // namespace xnewell
