#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "shading/color/quantize.h"
#include "tests/support/full_color_picture.h"

namespace xnewell {

/// Pictures with colours for quantize(), and what it makes of them.

inline int squaredDistance(glm::u8vec3 p, glm::u8vec3 q) {
  int sum = 0;
  for (int axis = 0; axis < 3; ++axis) sum += (p[axis] - q[axis]) * (p[axis] - q[axis]);
  return sum;
}

inline RgbImage pictureOf(const std::vector<glm::u8vec3>& colors, int width) {
  RgbImage image{width, static_cast<int>(colors.size()) / width};
  for (std::size_t k = 0; k < image.rgb.size(); ++k) image.rgb[k] = colors[k / 3][int(k % 3)];
  return image;
}

inline glm::u8vec3 randomColor(std::mt19937& rng) {
  return {std::uint8_t(rng()), std::uint8_t(rng()), std::uint8_t(rng())};
}

struct Result {
  std::vector<Rgb16> colors;
  IndexImage cells;
  RgbImage image;
};
inline Result resultOf(const RgbImage& picture, const QuantizeSettings& settings, Shows shows = {}) {
  Result result{{}, IndexImage{picture.width, picture.height, 0}, {}};
  result.colors = quantize(picture, shows, settings, result.cells);
  result.image = shown(result.cells, result.colors, settings.first);
  return result;
}

}  // namespace xnewell
