#pragma once

#include <cstdint>

#include "shading/color/color_table.h"
#include "shading/color/images.h"

namespace xnewell {

/// How different two colours look, in CIELAB and by CIEDE2000. A difference of 1 is about the least that the
/// eye sees between two patches side by side. These are measurements, not pictures, so they may use functions
/// of the C library whose last bit differs between machines.

/// CIE 1976 L*a*b* for D65 and the 2 degree observer. L lies in [0, 100]; a runs from green to red, b from
/// blue to yellow.
struct Lab {
  double L = 0, a = 0, b = 0;
};

/// Converts a colour stored as sRGB. @see IEC 61966-2-1; CIE 15
[[nodiscard]] Lab labFromSrgb(Rgb16 color);
/// Converts a colour of 8 bits per channel. Value v means 257 v of 65535.
[[nodiscard]] Lab labFromSrgb(const std::uint8_t* rgb);

/// CIEDE2000 with kL = kC = kH = 1. It is symmetric. It is continuous except where the two hues are opposite:
/// a difference of exactly half a turn, within rounding, does not count as more than half a turn. @see
/// Sharma, Wu, Dalal 2005
[[nodiscard]] double ciede2000(const Lab& p, const Lab& q);

}  // namespace xnewell
