#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

/// 8-bit red, green, blue, row by row from the top: what a screen or a PNG shows of an index image.
struct RgbImage {
  int width = 0, height = 0;
  std::vector<std::uint8_t> pixels;  ///< 3 width height bytes

  RgbImage() = default;
  RgbImage(int w, int h) : width{w}, height{h}, pixels(std::size_t(3) * w * h) {}
  bool operator==(const RgbImage&) const = default;
};
