#pragma once

#include <vector>

namespace xnewell {

/// Rounds terms to some decimals so that what is written adds up: the sum of the results is the rounded sum
/// of the terms. Each is rounded down, and those with the largest remainders get one unit more. So each is
/// off by less than one unit of the last decimal. The terms are finite and below 2^52 units.
[[nodiscard]] std::vector<double> roundedTerms(const std::vector<double>& terms, int decimals);

}  // namespace xnewell
