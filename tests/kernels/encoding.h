#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace xnewell {

/// Floating-point numbers as integers in the same order. Neighbouring numbers are neighbouring integers, so
/// half way between two encodings lies half way between the exponents, not between the values. -0 and 0 have
/// the encoding 0.

[[nodiscard]] inline std::int64_t encoded(double v) {
  const auto bits = std::bit_cast<std::int64_t>(v);
  return bits >= 0 ? bits : INT64_MIN - bits;
}
[[nodiscard]] inline double decodedDouble(std::int64_t n) {
  return std::bit_cast<double>(n >= 0 ? n : INT64_MIN - n);
}
[[nodiscard]] inline std::int64_t encoded(float v) {
  const auto bits = std::bit_cast<std::int32_t>(v);
  return bits >= 0 ? bits : INT32_MIN - std::int64_t{bits};
}
[[nodiscard]] inline float decodedFloat(std::int64_t n) {
  return std::bit_cast<float>(static_cast<std::int32_t>(n >= 0 ? n : INT32_MIN - n));
}

/// One number of a kernel's input: its type, and the range in which the claim holds.
struct Coordinate {
  enum class Type { Double, Float, Integer };
  Type type = Type::Double;
  double low = 0, high = 0;  ///< both inside

  [[nodiscard]] std::int64_t encode(double v) const {
    switch (type) {
      case Type::Float:
        return encoded(static_cast<float>(v));
      case Type::Integer:
        return std::llround(v);
      case Type::Double:
        break;
    }
    return encoded(v);
  }
  [[nodiscard]] double decode(std::int64_t n) const {
    switch (type) {
      case Type::Float:
        return decodedFloat(n);
      case Type::Integer:
        return static_cast<double>(n);
      case Type::Double:
        break;
    }
    return decodedDouble(n);
  }
};

[[nodiscard]] inline Coordinate doubles(double low, double high) {
  return {Coordinate::Type::Double, low, high};
}
[[nodiscard]] inline Coordinate floats(double low, double high) {
  return {Coordinate::Type::Float, low, high};
}
[[nodiscard]] inline Coordinate integers(double low, double high) {
  return {Coordinate::Type::Integer, low, high};
}

}  // namespace xnewell
