#include "shading/trade/choice.h"

#include <algorithm>
#include <cstdio>
#include <numeric>

namespace xnewell {

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
