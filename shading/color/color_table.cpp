#include "shading/color/color_table.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "geometry/exact/power.h"

namespace xnewell {

double ratioOfShades(double I0, int n) {
  double low = 1.0, high = 1.0 / I0;  // low^n <= 1/I0 < high^n, or n == 1
  for (;;) {
    const double middle = low + (high - low) / 2;
    if (middle <= low || middle >= high) return low;
    (power(middle, n) * I0 <= 1.0 ? low : high) = middle;
  }
}

ColorTable::ColorTable(const TableSettings& settings)
    : settings_{settings}, first_{settings.first.value_or(kTables[static_cast<int>(settings.kind)].first)} {
  const int N = settings.shades;
  assert(N >= 2 && N <= kMaxShades && settings.I0 > 0.0 && settings.I0 < 1.0);
  assert(0.0 <= settings.low && settings.low <= settings.high && settings.high <= 1.0);
  levels_.resize(N);
  thresholds_.resize(N - 1);
  if (settings.kind == TableKind::Corrected) {
    const double lowest = std::max(settings.I0, settings.low), highest = std::max(lowest, settings.high);
    const double r = ratioOfShades(lowest / highest, N - 1);
    for (int j = 0; j < N; ++j) levels_[j] = std::min(highest, lowest * power(r, j));
    levels_[N - 1] = highest;
    for (int j = 0; j + 1 < N; ++j) {
      const double below = levels_[j], above = levels_[j + 1];
      thresholds_[j] = settings.pick == Pick::Log ? std::sqrt(below) * std::sqrt(above) : (below + above) / 2;
    }
  } else {
    const double offset = settings.kind == TableKind::Linear ? 1.0 : 0.0;
    const double low = settings.low, width = settings.high - low;
    for (int j = 0; j < N; ++j) levels_[j] = (offset + 239.0 * low + 239.0 * width * j / (N - 1)) / 255.0;
    for (int j = 0; j + 1 < N; ++j) thresholds_[j] = low + width * (j + 0.5) / (N - 1);
  }
  // A bucket holds the number of thresholds below its lower end. A product with a power of two is exact.
  static_assert((kBuckets & (kBuckets - 1)) == 0);
  bucket_.assign(kBuckets + 1, 0);
  for (const double threshold : thresholds_)
    if (threshold < 1.0) ++bucket_[static_cast<int>(threshold * kBuckets) + 1];
  std::partial_sum(bucket_.begin(), bucket_.end(), bucket_.begin());
}

double ColorTable::Picked::nearest(double I) const {
  return std::max(from, std::min(I, last ? to : std::nextafter(to, 0.0)));
}

int ColorTable::shade(double I) const {
  assert(!std::isnan(I));
  if (I >= 1.0) return shades() - 1;
  if (!(I >= 0.0)) return 0;
  const int b = static_cast<int>(I * kBuckets);
  const auto from = thresholds_.begin() + bucket_[b], to = thresholds_.begin() + bucket_[b + 1];
  return static_cast<int>(std::upper_bound(from, to, I) - thresholds_.begin());
}

Rgb16 ColorTable::color(int j) const {
  const auto stored = [&](double v) {
    return static_cast<std::uint16_t>(settings_.bits == 8 ? 257.0 * std::floor(255.0 * v + 0.5)
                                                          : std::floor(65535.0 * v + 0.5));
  };
  const glm::dvec3 color = levels_[j] * settings_.hue;
  return {stored(color.r), stored(color.g), stored(color.b)};
}

}  // namespace xnewell
