#pragma once

#include <cmath>
#include <cstdint>
#include <random>

namespace xnewell {

/// Random numbers that are the same with every standard library.
class Random {
 public:
  explicit Random(std::uint64_t seed) : rng_{seed} {}

  std::uint64_t bits() { return rng_(); }
  /// In [0, end).
  std::uint64_t below(std::uint64_t end) { return bits() % end; }
  /// In [low, high].
  std::int64_t integer(std::int64_t low, std::int64_t high) {
    const auto width = static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low);
    const std::uint64_t offset = width == UINT64_MAX ? bits() : below(width + 1);
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(low) + offset);
  }
  double uniform(double low, double high) {
    const double t = static_cast<double>(bits() >> 11) * 0x1p-53;
    return low * (1.0 - t) + high * t;
  }
  /// An exponential length: 2^low to 2^high, each exponent as often as another.
  double power(double low, double high) { return std::exp2(uniform(low, high)); }
  double sign() { return bits() & 1 ? 1.0 : -1.0; }
  bool oneIn(std::uint64_t n) { return below(n) == 0; }

 private:
  std::mt19937_64 rng_;
};

}  // namespace xnewell
