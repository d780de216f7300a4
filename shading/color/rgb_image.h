#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

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

}  // namespace xnewell
