#include "shading/explain/rounded_terms.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

namespace xnewell::THIS_FILE {

// What is written adds up, and no term is off by a whole unit of its last decimal.
TEST(RoundedTerms, AddUp) {
  std::mt19937 rng{1};
  int different = 0;
  for (int k = 0; k < 20'000; ++k) {
    std::vector<double> terms(1 + rng() % 7);
    for (double& term : terms) term = static_cast<double>(rng()) * 0x1p-32;
    const int decimals = static_cast<int>(rng() % 6);
    const double unit = std::pow(10.0, -decimals);
    const std::vector<double> rounded = roundedTerms(terms, decimals);
    const double exact = std::accumulate(terms.begin(), terms.end(), 0.0);
    const double sum = std::accumulate(rounded.begin(), rounded.end(), 0.0);
    ASSERT_LE(std::abs(sum - exact), 0.5 * unit + 1e-12);
    for (std::size_t t = 0; t < terms.size(); ++t) {
      ASSERT_LT(std::abs(rounded[t] - terms[t]), unit);
      ASSERT_NEAR(rounded[t] / unit, std::round(rounded[t] / unit), 1e-6);
      different += std::abs(rounded[t] - terms[t]) > 0.5 * unit * (1 + 1e-9);
    }
  }
  EXPECT_GT(different, 1'000) << "rounded one by one, they would not add up";
}

}  // namespace xnewell::THIS_FILE
