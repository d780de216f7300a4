#pragma once

#include <cstdint>
#include <glm/gtc/type_precision.hpp>
#include <span>
#include <vector>

namespace xnewell {

/// The nearest of a palette's colours by squared distance of the 8-bit values, exactly; of two equally near
/// the later. The 256^3 colours are divided into blocks of 8^3; what is nearest somewhere in a block
/// is found when its first colour is asked for, and only that is compared.
class NearestColor {
 public:
  /// 1..255 colours. The palette outlives this.
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
  /// Appends the list of the block that holds `color`: how many, then their numbers, ascending.
  int candidates(glm::u8vec3 color);

  std::span<const glm::u8vec3> palette_;
  std::vector<int> list_;                 ///< where each block's list begins, -1 while nobody asked
  std::vector<std::uint8_t> candidates_;  ///< the lists
};

}  // namespace xnewell
