#pragma once

#include <string>
#include <utility>
#include <vector>

#include "shading/trade/trade.h"

namespace xnewell {

/// The front of a trade, and the choice on it.

/// Errors are equal if the larger is at most so many times the smaller.
inline constexpr double kErrorTie = 1.05;

/// The indices of those for which no other is cheaper and more accurate (by Measured::elsewhere), the
/// cheapest first. Of two that are equally fast, as far as their times tell, the more accurate counts; of two
/// that are equally accurate (kErrorTie), the faster.
[[nodiscard]] std::vector<int> frontOf(const std::vector<Measured>& measured);

/// True if any of them has a time.
[[nodiscard]] bool areTimed(const std::vector<Measured>& some);

/// A trade that is not far enough for combinations, with the single short cuts in their place; without any
/// if these have no times either.
[[nodiscard]] Trade withSingles(Trade trade);

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

/// The cheapest point of the front of those combinations that keep the limit: on all views with kSpare for
/// the RMS error, on the user's own view for wrong faces. If none does, the most accurate of all.
[[nodiscard]] Chosen chooseWithin(const Trade& trade, const AccuracyLimit& limit);

/// Two numbers in two digits, or in as many as it takes to tell them apart: {"0.012", "0.01"}.
[[nodiscard]] std::pair<std::string, std::string> toldApart(double a, double b);

}  // namespace xnewell
