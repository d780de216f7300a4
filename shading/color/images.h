#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "shading/color/color_table.h"

namespace xnewell {

/// A picture of 8-bit red, green and blue for each pixel, row by row from the top. Used for pictures read
/// from files and for pictures with more than 256 colours.
struct RgbImage {
  int width = 0, height = 0;      ///< 1..8192 each
  std::vector<std::uint8_t> rgb;  ///< #bytes = 3 * width * height

  RgbImage() = default;
  RgbImage(int w, int h) : width{w}, height{h}, rgb(std::size_t{3} * w * h) {}
  [[nodiscard]] std::uint8_t* pixel(int i, int j) { return &rgb[3 * (std::size_t(j) * width + i)]; }
  [[nodiscard]] const std::uint8_t* pixel(int i, int j) const {
    return &rgb[3 * (std::size_t(j) * width + i)];
  }
  bool operator==(const RgbImage&) const = default;
};

/// A picture of 8-bit colour indices, row by row from the top. It does not depend on the server.
/// Pixel (i, j), with j counted downward, covers [i, i+1) x [j, j+1); its sample is the centre.
struct IndexImage {
  int width = 0, height = 0;  ///< 1..8192 each
  std::vector<std::uint8_t> pixels;

  IndexImage() = default;
  IndexImage(int w, int h, std::uint8_t fill) : width{w}, height{h}, pixels(std::size_t(w) * h, fill) {}
  [[nodiscard]] std::uint8_t* row(int j) { return pixels.data() + std::size_t(j) * width; }
  [[nodiscard]] const std::uint8_t* row(int j) const { return pixels.data() + std::size_t(j) * width; }
  bool operator==(const IndexImage&) const = default;
};

/// An index image together with the colours of its cells.
struct ColoredImage {
  IndexImage image;
  Palette palette;
};

}  // namespace xnewell
