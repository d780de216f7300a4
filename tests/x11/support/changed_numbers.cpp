#include "tests/x11/support/changed_numbers.h"

#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <vector>

namespace xnewell {

namespace {

struct Place {
  std::size_t first, count;
};

/// Where the text has numbers. Digits in names, as in "box 1", count too.
std::vector<Place> numbersIn(const std::string& text) {
  const auto isIn = [&](std::size_t k, std::string_view set) {
    return k < text.size() && set.find(text[k]) != std::string_view::npos;
  };
  std::vector<Place> places;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (!isIn(k, "-.0123456789")) continue;
    std::size_t end = k;
    bool digits = false;
    while (isIn(end, "-+.0123456789") || (digits && isIn(end, "eE") && isIn(end + 1, "-+0123456789"))) {
      digits |= std::isdigit(static_cast<unsigned char>(text[end])) != 0;
      ++end;
    }
    if (digits) places.push_back({k, end - k});
    k = end;
  }
  return places;
}

std::string exactly(double v) {
  std::array<char, 40> text;
  std::snprintf(text.data(), text.size(), "%.17g", v);
  return text.data();
}

template <std::size_t N>
std::string oneOf(const std::array<const char*, N>& all, std::mt19937& rng) {
  return all[rng() % N];
}

/// `v` and something that is little beside it, or beside 1.
std::string nearly(double v, std::mt19937& rng) {
  switch (below(4, rng)) {
    case 0:
      return exactly(std::nextafter(v, below(2, rng) == 0 ? 1e300 : -1e300));
    case 1:
      return exactly(v * (1 + std::pow(10.0, -below(16, rng))));
    case 2:
      return exactly(v + std::pow(10.0, -below(30, rng)));
    default:
      return exactly(v);
  }
}

}  // namespace

std::string oddNumber(std::mt19937& rng) {
  static constexpr std::array kZeros{"0", "-0", "0.0", "1e-400"};
  static constexpr std::array kNone{"nan", "inf",  "-inf", "NaN", "1e999", "-1e999",
                                    "",    "0x10", "1e",   "--1", "1.2.3"};
  static constexpr std::array kWhole{
      "2147483647", "2147483648", "-2147483648",         "4294967295",           "4294967296",
      "16777217",   "65536",      "9223372036854775807", "-9223372036854775809", "18446744073709551616"};
  static constexpr std::array kSmall{"-1", "1", "2", "3", "0.5", "7", "90", "180", "360", "255", "256"};
  const int what = below(100, rng);
  if (what < 15) return oneOf(kZeros, rng);
  if (what < 25) return oneOf(kNone, rng);
  if (what < 33) return oneOf(kWhole, rng);
  if (what < 45) return oneOf(kSmall, rng);
  const int most = what < 70 ? 20 : what < 85 ? 40 : 323;
  const int power = below(2 * most + 1, rng) - most;
  const std::string sign = below(3, rng) == 0 ? "-" : "",
                    digits = below(2, rng) == 0 ? "1" : exactly(1 + below(9000, rng) / 1000.0);
  return sign + digits + "e" + std::to_string(std::min(power, 308));
}

std::string withChangedNumbers(const std::string& text, std::mt19937& rng) {
  std::string changed = text;
  static constexpr std::array kCounts{1, 1, 1, 2, 2, 3, 5, 12};
  for (int k = kCounts[rng() % kCounts.size()]; k > 0; --k) {
    const std::vector<Place> places = numbersIn(changed);
    if (places.empty()) return changed;
    const std::size_t which = rng() % places.size();
    const auto textOf = [&](std::size_t place) {
      return changed.substr(places[place].first, places[place].count);
    };
    const auto valueOf = [&](std::size_t place) { return std::atof(textOf(place).c_str()); };
    std::string number;
    switch (below(10, rng)) {
      case 0:
        number = nearly(valueOf(which), rng);
        break;
      case 1:
        number = nearly(valueOf(rng() % places.size()), rng);
        break;
      case 2:
        number = nearly(valueOf(which >= 3 ? which - 3 : 0), rng);
        break;  // the same axis of the last point
      case 3:
        number = exactly(-valueOf(which));
        break;
      case 4: {  // the line twice
        const std::size_t at = places[which].first;
        const std::size_t first = changed.rfind('\n', at) + 1,
                          end = std::min(changed.find('\n', at), changed.size() - 1) + 1;
        changed.insert(first, changed.substr(first, end - first));
        continue;
      }
      default:
        number = oddNumber(rng);
    }
    changed.replace(places[which].first, places[which].count, number);
  }
  return changed;
}

}  // namespace xnewell
