#include "shading/trade/choice.h"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <optional>

namespace xnewell {

namespace {

std::string textIn(double v, const char* format) {
  char text[32];
  std::snprintf(text, sizeof text, format, v);
  return text;
}
std::string error(double v) { return textIn(v, "%.2g"); }
std::string ms(double v) { return textIn(v, v < 9.95 ? "%.2g" : "%.0f") + " ms"; }

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

std::string samples(std::int64_t count) {
  return (count == 0 ? "no" : std::to_string(count)) + (count <= 1 ? " sample" : " samples");
}

/// Where a combination stands among equals: the fewest changes, then the order of the axes and their values.
std::vector<double> rankOf(const Trade& trade, const Configuration& one) {
  std::vector<double> rank{static_cast<double>(one.changes.size())};
  for (const Axis& axis : trade.axes) {
    const double value = valueOn(axis, one);
    rank.push_back(value == axis.now ? 0 : 1);
    rank.push_back(value);
  }
  return rank;
}

/// Of some combinations, those whose measure is at most `tie` times the least.
template <class Measure>
std::vector<int> bestOf(const std::vector<int>& some, double tie, Measure&& measure) {
  double least = std::numeric_limits<double>::infinity();
  for (const int k : some) least = std::min(least, measure(k));
  std::vector<int> best;
  for (const int k : some)
    if (measure(k) <= tie * least) best.push_back(k);
  return best;
}

/// Those that are as fast as the fastest, up to the widest gap.
std::vector<int> fastestOf(std::vector<int> some, const std::vector<Measured>& all) {
  if (some.empty()) return some;
  const auto ratioOf = [&](int k) { return all[k].cost.time.ratio; };
  std::ranges::stable_sort(some, {}, ratioOf);
  const double least = ratioOf(some.front());
  std::size_t count = 0;
  double widest = 0;
  for (std::size_t k = 0; k < some.size() && ratioOf(some[k]) <= kTimeTie * least; ++k) {
    const double next = k + 1 < some.size() ? ratioOf(some[k + 1]) : kTimeFar * least;
    const double gap = std::min(next, kTimeFar * least) / ratioOf(some[k]);
    if (gap > widest) widest = gap, count = k + 1;
  }
  some.resize(count);
  return some;
}

/// What the best combination with another value of an axis has to say; "" if no other value was tried. The
/// best is the fastest that is accurate enough, or else the most accurate.
std::string otherwise(const Trade& trade, const Axis& axis, const Measured& chosen,
                      const AccuracyLimit& limit) {
  const double mine = valueOn(axis, chosen.configuration);
  const Measured *fastest = nullptr, *nearest = nullptr;
  for (const Measured& one : trade.combinations) {
    if (valueOn(axis, one.configuration) == mine) continue;
    if (keeps(one, limit) && (!fastest || one.cost.time.ms < fastest->cost.time.ms)) fastest = &one;
    if (!nearest || errorOnAllViews(one) < errorOnAllViews(*nearest)) nearest = &one;
  }
  if (!nearest) return "";
  const Measured& best = fastest ? *fastest : *nearest;
  const std::string says = fastest ? (best.cost.rough ? "about " : "") + ms(best.cost.time.ms)
                           : errorOnAllViews(best) > (1 - kSpare) * limit.rms
                               ? error(errorOnAllViews(best))
                               : error(errorOnAllViews(best)) + ", with " +
                                     samples(std::max(best.here.wrongFaces, best.wrongElsewhere)) +
                                     " of a wrong face";
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

/// True if `simple` has some of the changes of `other`, or none, or all.
bool isPart(const Measured& simple, const Measured& other) {
  return std::ranges::all_of(simple.configuration.changes, [&](const Change& change) {
    return std::ranges::find(other.configuration.changes, change) != other.configuration.changes.end();
  });
}

}  // namespace

std::vector<const Measured*> usefulOf(std::vector<const Measured*> some, double saves) {
  std::ranges::stable_sort(some, {}, [](const Measured* one) { return one->configuration.changes.size(); });
  std::vector<const Measured*> useful;
  for (const Measured* const one : some)
    if (std::ranges::none_of(useful, [&](const Measured* simple) {
          return simple->cost.time.ms <= saves * one->cost.time.ms && isPart(*simple, *one);
        }))
      useful.push_back(one);
  std::erase_if(some, [&](const Measured* one) {
    return std::ranges::none_of(useful, [&](const Measured* other) { return isPart(*one, *other); });
  });
  return some;
}

double errorOnAllViews(const Measured& one) {
  return std::max(one.elsewhere, one.here.afterTable.rootMeanSquare);
}

bool keeps(const Measured& one, const AccuracyLimit& limit) {
  return errorOnAllViews(one) <= (1 - kSpare) * limit.rms &&
         (!limit.wrong || std::max(one.here.wrongFaces, one.wrongElsewhere) <= *limit.wrong);
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
  const auto errorOf = [&](int k) { return errorOnAllViews(all[k]); };
  const auto ratioOf = [&](int k) { return all[k].cost.time.ratio; };
  std::vector<int> timed, kept;
  for (int k = 0; k < static_cast<int>(all.size()); ++k)
    if (!all[k].cost.rough) timed.push_back(k);
  for (const int k : timed)
    if (keeps(all[k], limit)) kept.push_back(k);
  choice.accurate = !kept.empty();
  const auto changesOf = [&](int k) { return static_cast<double>(all[k].configuration.changes.size()); };
  const std::vector<int> best = choice.accurate
                                    ? bestOf(bestOf(fastestOf(kept, all), 1, changesOf), kErrorTie, errorOf)
                                    : bestOf(bestOf(timed, 1, errorOf), kTimeTie, ratioOf);
  if (best.empty()) return choice;
  choice.combination =
      *std::ranges::min_element(best, {}, [&](int k) { return rankOf(trade, all[k].configuration); });
  const Measured& chosen = all[choice.combination];
  // What was not seen on the other views may be further off there than here, but not less.
  const bool isLeast = std::ranges::none_of(
      all, [&](const Measured& one) { return errorOnAllViews(one) < errorOnAllViews(chosen); });
  choice.why.push_back(
      "Of " + std::to_string(all.size()) + " combinations that were tried, " +
      (choice.accurate ? "it is the fastest within the limit, with " + textOf(100 * kSpare) + " % to spare."
       : isLeast       ? "it is the most accurate."
                       : std::to_string(timed.size()) +
                       " were seen on all views and timed; it is the most accurate of these."));
  const auto [off, allowed] = toldApart(errorOnAllViews(chosen), limit.rms);
  choice.why.push_back("Its RMS error is at most " + off + " in this view and in " +
                       std::to_string(trade.views) + " turned ones" +
                       (errorOnAllViews(chosen) <= limit.rms ? ", and " : ", but ") + allowed +
                       " is allowed. It takes " + ms(chosen.cost.time.ms) + ".");
  if (limit.wrong)
    choice.why.push_back("At most " + samples(std::max(chosen.here.wrongFaces, chosen.wrongElsewhere)) +
                         " of a view may show a wrong face: " + std::to_string(*limit.wrong) +
                         " are allowed.");
  if (!choice.accurate) {
    choice.why.push_back(trade.neverTried.empty()
                             ? "Every value of every short cut was tried, but not every combination."
                             : "Never tried: " + trade.neverTried + ".");
    return choice;
  }
  for (const Axis& axis : trade.axes)
    if (std::string why = otherwise(trade, axis, chosen, limit); !why.empty())
      choice.why.push_back(std::move(why));
  if (chosen.configuration.settings.light.constantL && trade.constantL && *trade.constantL <= limit.rms)
    choice.why.push_back("L constant changes no intensity by more than " + error(*trade.constantL) +
                         ": all lamps are far from the whole scene.");
  if (chosen.pairs && chosen.pairs->proves()) {
    choice.why.push_back("The order is exact here: all " + std::to_string(chosen.pairs->pairs) +
                         " pairs of polygons that may overlap were tested.");
    return choice;
  }
  const std::int64_t wrong = chosen.here.wrongFaces;
  choice.why.push_back((wrong == 0 ? "No" : std::to_string(wrong)) +
                       (wrong == 0 || wrong == 1 ? " sample shows" : " samples show") + " a wrong face." +
                       (limit.wrong ? "" : " The limit is for the intensity alone."));
  return choice;
}

}  // namespace xnewell
