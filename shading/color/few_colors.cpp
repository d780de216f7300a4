#include "shading/color/few_colors.h"

#include <algorithm>
#include <vector>

namespace xnewell {

namespace {

std::uint32_t keyOf(const std::uint8_t* rgb) {
  return std::uint32_t{rgb[0]} << 16 | std::uint32_t{rgb[1]} << 8 | rgb[2];
}

}  // namespace

std::optional<ColoredImage> inFewColors(const RgbImage& picture) {
  constexpr std::size_t kMost = 256;
  std::vector<std::uint32_t> colors;  // ascending
  for (std::size_t k = 0; k < picture.rgb.size(); k += 3) {
    const std::uint32_t key = keyOf(&picture.rgb[k]);
    const auto place = std::ranges::lower_bound(colors, key);
    if (place != colors.end() && *place == key) continue;
    if (colors.size() == kMost) return std::nullopt;
    colors.insert(place, key);
  }
  ColoredImage cells{IndexImage{picture.width, picture.height, 0}, {}};
  for (std::size_t k = 0; k < cells.image.pixels.size(); ++k)
    cells.image.pixels[k] = static_cast<std::uint8_t>(
        std::ranges::lower_bound(colors, keyOf(&picture.rgb[3 * k])) - colors.begin());
  const auto sixteen = [](std::uint32_t key, int shift) {
    return static_cast<std::uint16_t>(257 * (key >> shift & 255));
  };
  for (std::size_t c = 0; c < colors.size(); ++c)
    cells.palette[c] = {sixteen(colors[c], 16), sixteen(colors[c], 8), sixteen(colors[c], 0)};
  return cells;
}

}  // namespace xnewell
