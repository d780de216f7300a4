#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <glm/geometric.hpp>
#include <random>
#include <span>
#include <vector>

#include "shading/color/color_difference.h"
#include "shading/color/color_table.h"
#include "shading/color/images.h"
#include "shading/color/quantize.h"

namespace xnewell {

/// Full-colour pictures for tests that put them into colour cells, and what the cells then show.

struct FullColorPicture {
  RgbImage rgb;
  std::vector<std::uint8_t> shows;
};

/// Seven balls of different hues under a white and a blue light, with highlights, on an empty background.
inline FullColorPicture coloredBalls(int width, int height) {
  const std::array<glm::dvec3, 7> hues{{{1, 0.15, 0.1},
                                        {0.9, 0.8, 0.1},
                                        {0.2, 0.7, 0.2},
                                        {0.1, 0.3, 1},
                                        {0.6, 0.2, 0.7},
                                        {0.9, 0.6, 0.5},
                                        {0.8, 0.8, 0.8}}};
  const glm::dvec3 white = glm::normalize(glm::dvec3{-1, -1, 1.5}),
                   blue = glm::normalize(glm::dvec3{1, 1, 0.3});
  FullColorPicture picture{RgbImage{width, height}, std::vector<std::uint8_t>(std::size_t(width) * height)};
  const double radius = 0.49 * std::min(width / 4.0, height / 2.0);
  for (int j = 0; j < height; ++j)
    for (int i = 0; i < width; ++i) {
      // Four balls above, three below.
      const double x = 4.0 * (i + 0.5) / width, y = 2.0 * (j + 0.5) / height;
      const int row = static_cast<int>(y);
      const int column = static_cast<int>(std::max(0.0, x - 0.5 * row));
      if (column > 3 - row) continue;
      const double u = (x - 0.5 * row - column - 0.5) * width / 4 / radius;
      const double v = (y - row - 0.5) * height / 2 / radius, square = u * u + v * v;
      if (square >= 1) continue;
      const glm::dvec3 N{u, v, std::sqrt(1 - square)};
      const double diffuse = std::max(0.0, dot(N, white)), rim = std::max(0.0, dot(N, blue));
      const double mirrored = std::max(0.0, 2 * dot(N, white) * N.z - white.z);
      const glm::dvec3 color =
          hues[4 * row + column] * (0.1 + 0.8 * diffuse + rim * glm::dvec3{0.1, 0.2, 0.6}) +
          0.5 * std::pow(mirrored, 30);
      for (int axis = 0; axis < 3; ++axis)
        picture.rgb.pixel(i, j)[axis] =
            static_cast<std::uint8_t>(std::floor(255 * std::min(1.0, color[axis]) + 0.5));
      picture.shows[std::size_t(j) * width + i] = 1;
    }
  return picture;
}

/// The picture as a server shows it, with `colors` in the cells from `first` on; other cells are black.
inline RgbImage shown(const IndexImage& cells, std::span<const Rgb16> colors, int first) {
  RgbImage image{cells.width, cells.height};
  for (std::size_t k = 0; k < cells.pixels.size(); ++k) {
    const std::size_t number = std::size_t(cells.pixels[k]) - first;
    if (number >= colors.size()) continue;
    const Rgb16 c = colors[number];
    image.rgb[3 * k] = static_cast<std::uint8_t>(c.r >> 8);
    image.rgb[3 * k + 1] = static_cast<std::uint8_t>(c.g >> 8);
    image.rgb[3 * k + 2] = static_cast<std::uint8_t>(c.b >> 8);
  }
  return image;
}

/// The mean of each whole 8 x 8 block. That is what the eye sees of a dithered picture from a distance.
inline RgbImage blocksOf(const RgbImage& image) {
  RgbImage blocks{image.width / 8, image.height / 8};
  for (int j = 0; j < blocks.height; ++j)
    for (int i = 0; i < blocks.width; ++i)
      for (int axis = 0; axis < 3; ++axis) {
        int sum = 0;
        for (int place = 0; place < 64; ++place)
          sum += image.pixel(8 * i + place % 8, 8 * j + place / 8)[axis];
        blocks.pixel(i, j)[axis] = static_cast<std::uint8_t>((sum + 32) / 64);
      }
  return blocks;
}

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

/// Scattered colours, so that no two cells can be mixed up.
inline Palette scattered(unsigned seed) {
  std::mt19937 rng{seed};
  const auto value = [&] { return static_cast<std::uint16_t>(rng()); };
  Palette palette;
  for (Rgb16& c : palette) c = {value(), value(), value()};
  return palette;
}

}  // namespace xnewell
