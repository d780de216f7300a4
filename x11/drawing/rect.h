#pragma once

#include <algorithm>

namespace xnewell {

/// The pixels [x, x + width) x [y, y + height), y downward; empty where a side is not positive.
struct Rect {
  int x = 0, y = 0, width = 0, height = 0;
  [[nodiscard]] bool empty() const { return width <= 0 || height <= 0; }
  /// True if pixel (i, j) is one of them. Precondition: its sides end within int.
  [[nodiscard]] bool has(int i, int j) const { return i >= x && i < x + width && j >= y && j < y + height; }
  bool operator==(const Rect&) const = default;
};

/// The rectangle with all its sides `factor` times as far from the origin, such as units in pixels.
[[nodiscard]] constexpr Rect operator*(const Rect& r, int factor) {
  return {r.x * factor, r.y * factor, r.width * factor, r.height * factor};
}

/// The pixels that two rectangles share. Precondition: their sides end within int.
[[nodiscard]] constexpr Rect intersection(const Rect& a, const Rect& b) {
  const int x = std::max(a.x, b.x), y = std::max(a.y, b.y);
  return {x, y, std::min(a.x + a.width, b.x + b.width) - x, std::min(a.y + a.height, b.y + b.height) - y};
}

}  // namespace xnewell
