#pragma once

#include <algorithm>
#include <cassert>
#include <cstring>
#include <span>

#include "shading/color/color_difference.h"

namespace xnewell {

/// Statistics of CIEDE2000 over the pixels that count.
struct ImageDifference {
  double mean = 0, largest = 0;  ///< 0 if no pixel counts
  std::int64_t pixels = 0;
};
/// Compares two pictures of the same size pixel by pixel. `counts` holds one byte per pixel; 0 leaves the
/// pixel out. If `counts` is empty, every pixel counts.
[[nodiscard]] inline ImageDifference imageDifference(const RgbImage& p, const RgbImage& q,
                                                     std::span<const std::uint8_t> counts = {}) {
  assert(p.width == q.width && p.height == q.height);
  assert(counts.empty() || counts.size() * 3 == p.rgb.size());
  ImageDifference result;
  double sum = 0;
  // Neighbouring pixels are often alike, so we keep the difference of the last pair.
  const std::uint8_t* lastP = nullptr;
  const std::uint8_t* lastQ = nullptr;
  double difference = 0;
  for (std::size_t k = 0; 3 * k < p.rgb.size(); ++k) {
    if (!counts.empty() && !counts[k]) continue;
    const std::uint8_t *atP = &p.rgb[3 * k], *atQ = &q.rgb[3 * k];
    if (!lastP || std::memcmp(atP, lastP, 3) || std::memcmp(atQ, lastQ, 3))
      difference = std::memcmp(atP, atQ, 3) ? ciede2000(labFromSrgb(atP), labFromSrgb(atQ)) : 0.0;
    lastP = atP, lastQ = atQ;
    sum += difference;
    result.largest = std::max(result.largest, difference);
    ++result.pixels;
  }
  if (result.pixels) result.mean = sum / static_cast<double>(result.pixels);
  return result;
}

}  // namespace xnewell
