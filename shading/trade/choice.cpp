#include "shading/trade/choice.h"

#include <algorithm>
#include <cstdio>
#include <optional>

namespace xnewell {

namespace {

std::string digits(double v, const char* format) {
  char text[32];
  std::snprintf(text, sizeof text, format, v);
  return text;
}
std::string error(double v) { return digits(v, "%.2g"); }
std::string ms(double v) { return digits(v, v < 9.95 ? "%.2g" : "%.0f") + " ms"; }

/// The value that a configuration has on an axis.
double valueOn(const Axis& axis, const Configuration& one) {
  for (const Change& change : one.changes)
    if (change.setting == axis.setting) return change.value;
  return axis.now;
}

/// A value of an axis as people say it.
std::string phraseOf(const Axis& axis, double value) {
  Configuration one;
  return changed(one, axis, value).name();
}

bool isFaster(const Measured& a, const Measured& b) { return a.cost.time.ratio < b.cost.time.ratio; }

bool isWithin(const Measured& one, double limit) { return errorOnAllViews(one) <= (1 - kSpare) * limit; }

/// What the best combination with another value of an axis has to say; "" if no other value was tried. The
/// best is the fastest that is accurate enough, or else the most accurate.
std::string otherwise(const Trade& trade, const Axis& axis, const Measured& chosen, double limit) {
  const double mine = valueOn(axis, chosen.configuration);
  const Measured *fastest = nullptr, *nearest = nullptr;
  for (const Measured& one : trade.combinations) {
    if (valueOn(axis, one.configuration) == mine) continue;
    if (isWithin(one, limit) && (!fastest || isFaster(one, *fastest))) fastest = &one;
    if (!nearest || errorOnAllViews(one) < errorOnAllViews(*nearest)) nearest = &one;
  }
  if (!nearest) return "";
  const Measured& best = fastest ? *fastest : *nearest;
  const std::string says = fastest ? ms(best.cost.time.ms) : error(errorOnAllViews(best));
  const std::string value = phraseOf(axis, valueOn(axis, best.configuration));
  if (axis.others.size() == 1)
    return "With " + value +
           (fastest ? ", the fastest within the limit that was tried takes "
                    : ", the best that was tried is off by ") +
           says + ".";
  const std::string noun{axis.setting ? axis.setting->label : "divisions"};
  return fastest ? "Of the other values of " + noun + " that were tried, the fastest within the limit is " +
                       value + ", with " + says + "."
                 : "No other value of " + noun + " that was tried suffices; the best, " + value +
                       ", is off by " + says + ".";
}

}  // namespace

double errorOnAllViews(const Measured& one) {
  return std::max(one.elsewhere, one.here.afterTable.rootMeanSquare);
}

Chosen chooseWithin(const Trade& trade, double limit) {
  Chosen choice;
  const std::vector<Measured>& all = trade.combinations;
  for (int k = 0; k < static_cast<int>(all.size()); ++k) {
    if (!isWithin(all[k], limit)) continue;
    if (choice.combination < 0 || isFaster(all[k], all[choice.combination])) choice.combination = k;
  }
  choice.accurate = choice.combination >= 0;
  const auto moreAccurate = [&](int a, int b) { return errorOnAllViews(all[a]) < errorOnAllViews(all[b]); };
  if (choice.accurate) {
    // What is as fast, as far as its time tells, and more accurate is better.
    const int fastest = choice.combination;
    for (int k = 0; k < static_cast<int>(all.size()); ++k)
      if (isWithin(all[k], limit) && all[k].cost.time.ratio <= kTied * all[fastest].cost.time.ratio &&
          all[k].cost.time.interval.meets(all[fastest].cost.time.interval) &&
          moreAccurate(k, choice.combination))
        choice.combination = k;
  } else {
    for (int k = 0; k < static_cast<int>(all.size()); ++k)
      if (choice.combination < 0 || moreAccurate(k, choice.combination)) choice.combination = k;
  }
  if (choice.combination < 0) return choice;
  const Measured& chosen = all[choice.combination];
  choice.why.push_back("Of " + std::to_string(all.size()) + " combinations that were tried, it is the " +
                       (choice.accurate
                            ? "fastest within the limit, with " + textOf(100 * kSpare) + " % to spare."
                            : "most accurate."));
  choice.why.push_back("Its RMS error is at most " + error(errorOnAllViews(chosen)) +
                       " in this view and in turned ones" + (choice.accurate ? ", and " : ", but ") +
                       error(limit) + " is allowed. It takes " + ms(chosen.cost.time.ms) + ".");
  if (!choice.accurate) return choice;
  for (const Axis& axis : trade.axes)
    if (std::string why = otherwise(trade, axis, chosen, limit); !why.empty())
      choice.why.push_back(std::move(why));
  if (chosen.configuration.settings.light.constantL && trade.constantL && *trade.constantL <= limit)
    choice.why.push_back("L constant changes no intensity by more than " + error(*trade.constantL) +
                         ": all lamps are far from the whole scene.");
  if (chosen.pairs && chosen.pairs->proves()) {
    choice.why.push_back("The order is exact here: all " + std::to_string(chosen.pairs->pairs) +
                         " pairs of polygons that may overlap were tested.");
    return choice;
  }
  const std::int64_t wrong = chosen.here.wrongFaces;
  choice.why.push_back((wrong == 0 ? "No" : std::to_string(wrong)) +
                       (wrong == 0 || wrong == 1 ? " sample shows" : " samples show") + " a wrong face.");
  return choice;
}

}  // namespace xnewell
