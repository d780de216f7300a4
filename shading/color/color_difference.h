#pragma once

#include <cstdint>
#include <span>

#include "shading/color/color_table.h"
#include "shading/color/rgb_image.h"

namespace xnewell {

/// How far apart two colours look, in CIELAB and by CIEDE2000. A difference of 1 is about what the eye just
/// sees between two patches side by side. These are measurements: unlike a picture they may use the C
/// library's functions, whose last bit differs between machines.

/// CIE 1976 L*a*b* under D65, 2 degree observer: L in [0, 100], a from green to red, b from blue to yellow.
struct Lab {
  double L = 0, a = 0, b = 0;
};

/// Of a colour stored as sRGB. @see IEC 61966-2-1; CIE 15
[[nodiscard]] Lab labFromSrgb(Rgb16 color);
/// The same of 8 bits a channel: value v is 257 v of 65535.
[[nodiscard]] Lab labFromSrgb(const std::uint8_t* rgb);

/// CIEDE2000 with kL = kC = kH = 1. Symmetric, and continuous but where the hues are opposite: half a turn,
/// within rounding, counts as not beyond it. @see Sharma, Wu, Dalal 2005
[[nodiscard]] double ciede2000(const Lab& p, const Lab& q);

/// CIEDE2000 over the pixels that count.
struct ImageDifference {
  double mean = 0, largest = 0;  ///< 0 where no pixel counts
  std::int64_t pixels = 0;
};
/// Pixel against pixel of two pictures of one size. `counts` holds one byte a pixel, 0 where it does not;
/// without it all of them do.
[[nodiscard]] ImageDifference imageDifference(const RgbImage& p, const RgbImage& q,
                                              std::span<const std::uint8_t> counts = {});

}  // namespace xnewell
