#pragma once

#include <string>
#include <utility>
#include <vector>

#include "shading/trade/trade.h"

namespace xnewell {

/// The cheapest configuration that is accurate enough, and why it is this one.
struct Chosen {
  int combination = -1;   ///< index into Trade::combinations; -1 if there are none
  bool accurate = false;  ///< its error stays within the limit; otherwise it is the most accurate of all
  std::vector<std::string> why = {};  ///< sentences, with numbers
};

/// The largest RMS error of the intensity that a combination has on any view, the user's own included.
[[nodiscard]] double errorOnAllViews(const Measured& one);

/// What is chosen stays below the limit by this share, because other samples of the same view have a slightly
/// different error.
inline constexpr double kSpare = 0.03;

/// Times are equal if the larger is at most so many times the smaller, and so are errors. Chance must not
/// decide between equals: a fixed rule does. Nor may chance decide which times are equal, though many are
/// close together. So the equally fast ones end at the widest gap between their times; the first time beyond
/// the gap may be the first beyond the tie, or kTimeFar.
inline constexpr double kTimeTie = 1.15, kTimeFar = 1.3, kErrorTie = 1.05;

/// True if a combination stays within the limit on all views, with kSpare for its RMS error.
[[nodiscard]] bool keeps(const Measured& one, const AccuracyLimit& limit);

/// Leaves out of some combinations those that have all changes of another one and more, though that one takes
/// at most `saves` times as long. What has some of the changes of one that is left stays too, so that a lucky
/// time does not put more changes in the place of fewer.
[[nodiscard]] std::vector<const Measured*> usefulOf(std::vector<const Measured*> some, double saves);

/// The choice among the combinations of a trade whose times are not rough. Of those that keep the limit it is
/// the fastest. Of equally fast ones it is the one with the fewest changes, of these the most accurate, and
/// of equally accurate ones the first by the axes of the trade and their values. If none keeps the limit, it
/// is the most accurate; of those with the same errors it is the fastest, and then the one with the fewest
/// changes.
[[nodiscard]] Chosen chooseWithin(const Trade& trade, const AccuracyLimit& limit);

/// Two numbers in two digits, or in as many as it takes to tell them apart: {"0.012", "0.01"}.
[[nodiscard]] std::pair<std::string, std::string> toldApart(double a, double b);

}  // namespace xnewell
