#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace xnewell {

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

}  // namespace xnewell
