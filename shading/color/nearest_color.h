#pragma once

#include <cstdint>
#include <glm/gtc/type_precision.hpp>
#include <span>
#include <vector>

namespace xnewell {

/// Finds the palette colour nearest to a given colour, exactly, by the squared distance of the 8-bit values.
/// If two are equally near, the later one counts. The 256^3 colours are divided into blocks of 8^3. When a
/// colour of a block is first asked for, we list the palette colours that are nearest to some colour of the
/// block; only those are compared.
class NearestColor {
 public:
  /// The palette has 1..255 colours and must outlive this object.
  explicit NearestColor(std::span<const glm::u8vec3> palette)
      : palette_{palette}, list_(kBlocks * kBlocks * kBlocks, -1) {}

  [[nodiscard]] int operator()(glm::u8vec3 color) {
    int& list = list_[((color.r >> kBits) * kBlocks + (color.g >> kBits)) * kBlocks + (color.b >> kBits)];
    if (list < 0) list = candidates(color);
    const std::uint8_t* at = &candidates_[list];
    int best = 0, least = 1 << 20;
    for (int count = *at++; count > 0; --count, ++at) {
      const int distance = squaredDistance(palette_[*at], color);
      if (distance <= least) least = distance, best = *at;
    }
    return best;
  }

 private:
  static constexpr int kBits = 3, kBlocks = 256 >> kBits;

  static int squaredDistance(glm::u8vec3 p, glm::u8vec3 q) {
    const int r = p.r - q.r, g = p.g - q.g, b = p.b - q.b;
    return r * r + g * g + b * b;
  }
  /// Appends the list of the block that holds `color`: first the number of candidates, then their palette
  /// indices in ascending order. Returns the place where the list begins.
  int candidates(glm::u8vec3 color);

  std::span<const glm::u8vec3> palette_;
  std::vector<int> list_;                 ///< where each block's list begins; -1 if it was not made yet
  std::vector<std::uint8_t> candidates_;  ///< the lists
};

}  // namespace xnewell
