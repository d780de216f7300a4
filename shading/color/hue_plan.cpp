#include "shading/color/hue_plan.h"

#include <algorithm>
#include <cassert>

namespace xnewell {

double stepOf(const HueNeed& need, const TableSettings& table, int N) {
  constexpr double kFinest = 1.0 / 255.0;
  if (isEven(table.kind)) return std::max(kFinest, (need.high - need.low) / (N - 1));
  const double lowest = std::max(table.I0, need.low), highest = std::max(lowest, need.high);
  return std::max(kFinest, ratioOfShades(lowest / highest, N - 1) - 1.0);
}

std::vector<TableSettings> planHues(std::span<const HueNeed> needs, const TableSettings& table) {
  const int hues = static_cast<int>(needs.size());
  assert(hues >= 1 && 2 * hues <= table.shades);
  std::vector<TableSettings> ramps;
  for (const HueNeed& need : needs) {
    TableSettings ramp = table;
    ramp.hue = need.hue, ramp.low = need.low, ramp.high = need.high;
    ramp.shades = 2;
    ramps.push_back(ramp);
  }

  // The amount by which one more shade for a hue would lower that hue's part of the sum.
  std::vector<double> gains(hues);
  const auto gainOf = [&](int k) {
    const int N = ramps[k].shades;
    return static_cast<double>(needs[k].samples) *
           (stepOf(needs[k], table, N) - stepOf(needs[k], table, N + 1));
  };
  for (int k = 0; k < hues; ++k) gains[k] = gainOf(k);
  for (int left = table.shades - 2 * hues; left > 0; --left) {
    const auto most = std::max_element(gains.begin(), gains.end());
    if (*most <= 0.0) break;
    const int k = static_cast<int>(most - gains.begin());
    ++ramps[k].shades;
    gains[k] = gainOf(k);
  }

  int first = table.first.value_or(kTables[static_cast<int>(table.kind)].first);
  for (TableSettings& ramp : ramps) {
    ramp.first = first;
    first += ramp.shades;
  }
  return ramps;
}

}  // namespace xnewell
