#include "shading/explain/rounded_terms.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/exact/power.h"

namespace xnewell {

std::vector<double> roundedTerms(const std::vector<double>& terms, int decimals) {
  const double unit = power(10.0, decimals);
  std::vector<double> whole;
  for (const double term : terms) whole.push_back(std::floor(term * unit));
  const double sum = std::floor(std::accumulate(terms.begin(), terms.end(), 0.0) * unit + 0.5);
  std::vector<std::size_t> order(terms.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::greater{}, [&](std::size_t k) { return terms[k] * unit - whole[k]; });
  double missing = sum - std::accumulate(whole.begin(), whole.end(), 0.0);
  for (const std::size_t k : order)
    if (missing-- > 0.0) ++whole[k];
  for (double& value : whole) value /= unit;
  return whole;
}

}  // namespace xnewell
