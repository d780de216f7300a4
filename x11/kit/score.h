#pragma once

#include <string>

namespace xnewell {

/// How many questions the student has answered, and how many of them right at the first try.
struct Score {
  int right = 0, asked = 0;

  void add(bool isRight) { ++asked, right += isRight; }
  [[nodiscard]] std::string text() const {
    return std::to_string(right) + " of " + std::to_string(asked) + " right at the first try";
  }
  bool operator==(const Score&) const = default;
};

}  // namespace xnewell
