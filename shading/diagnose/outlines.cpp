#include "shading/diagnose/outlines.h"

#include <algorithm>
#include <glm/vec2.hpp>

#include "depthsort/oracle.h"
#include "shading/diagnose/face_images.h"

namespace xnewell {

Outlines outlinesOf(const RgbImage& handed, const std::vector<int>& faces, TurnWay turn,
                    std::array<std::uint8_t, 3> ground, double least) {
  constexpr int kFar = 40;  // pixels; farther ones count as that far
  const int w = handed.width, h = handed.height;
  const bool isDark = std::max({ground[0], ground[1], ground[2]}) <= 16;
  const auto shows = [&](int i, int j) { return faces[static_cast<std::size_t>(j) * w + i] != kNothing; };
  const auto isAllAlike = [&](int i, int j, int by) {
    for (int y = std::max(0, j - by); y <= std::min(h - 1, j + by); ++y)
      for (int x = std::max(0, i - by); x <= std::min(w - 1, i + by); ++x)
        if (shows(x, y) != shows(i, j)) return false;
    return true;
  };
  Outlines outlines;
  long both = 0, either = 0;
  std::vector<glm::ivec2> others;
  for (int j = 1; j + 1 < h; ++j)
    for (int i = 1; i + 1 < w; ++i) {
      if (!isAllAlike(i, j, 1)) continue;
      const bool ours = shows(i, j);
      const auto [x, y] = turned(turn, i, j, w, h);
      const std::uint8_t* const p = handed.pixel(x, y);
      const bool theirs = p[0] != ground[0] || p[1] != ground[1] || p[2] != ground[2] || (isDark && ours);
      both += ours && theirs, either += ours || theirs;
      if (ours != theirs) others.push_back({i, j});
    }
  outlines.overlap = either == 0 ? 1.0 : static_cast<double>(both) / static_cast<double>(either);
  if (outlines.overlap < least) return outlines;
  for (const glm::ivec2& at : others) {
    if (!isAllAlike(at.x, at.y, 2)) continue;
    ++outlines.apart;
    while (outlines.farthest < kFar && isAllAlike(at.x, at.y, std::max(2, outlines.farthest)))
      outlines.farthest = std::max(3, outlines.farthest + 1), outlines.i = at.x, outlines.j = at.y;
  }
  return outlines;
}

}  // namespace xnewell
