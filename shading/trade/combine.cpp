#include "shading/trade/combine.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "shading/trade/choice.h"

namespace xnewell {

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

}  // namespace xnewell
