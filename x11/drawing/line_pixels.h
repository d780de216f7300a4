#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include "x11/drawing/rect.h"

namespace xnewell {

/// The pixels of a line, both ends included. Each step along the longer axis gets the nearest pixel; half way
/// between two, the one with the larger coordinate. So the pixels are the same from either end.
/// @see Foley & van Dam 2e §3.2

/// Calls use(k, x, y) for each pixel of the line, the k-th of it, that lies within `area` along the longer
/// axis. Along the other axis it may lie outside. Coordinates stay within +-2^24. Bresenham 1965, begun where
/// the line enters the area. After k of n steps the other coordinate is floor(k d / n + 1/2) = floor((2 k d +
/// n) / 2n) from its start: `whole`, and `rest` of 2n.
template <class Use>
void forEachPixelOfLine(const Rect& area, int x0, int y0, int x1, int y1, Use&& use) {
  const bool steep = std::abs(y1 - y0) > std::abs(x1 - x0);
  const int from = steep ? y0 : x0, to = steep ? y1 : x1, across = steep ? x0 : y0;
  const int forward = to < from ? -1 : 1;
  const int areaFrom = steep ? area.y : area.x, areaEnd = areaFrom + (steep ? area.height : area.width);
  const std::int64_t n = std::abs(to - from), d = steep ? x1 - x0 : y1 - y0;

  const int enters = forward > 0 ? areaFrom - from : from - (areaEnd - 1);
  const int leaves = forward > 0 ? areaEnd - 1 - from : from - areaFrom;
  const int first = std::max(0, enters), last = std::min(static_cast<int>(n), leaves);
  const std::int64_t whole2n = std::max<std::int64_t>(1, 2 * n), numerator = 2 * first * d + n;
  std::int64_t rest = ((numerator % whole2n) + whole2n) % whole2n, whole = (numerator - rest) / whole2n;
  for (int k = first; k <= last; ++k) {
    const int along = from + forward * k, beside = across + static_cast<int>(whole);
    steep ? use(k, beside, along) : use(k, along, beside);
    rest += 2 * d;
    if (rest >= whole2n) {
      rest -= whole2n;
      ++whole;
    } else if (rest < 0) {
      rest += whole2n;
      --whole;
    }
  }
}

}  // namespace xnewell
