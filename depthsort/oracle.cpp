#include "depthsort/oracle.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "geometry/view/screen_plane.h"

namespace xnewell {

namespace {

/// The sign of a x + b y + c at a sample, for the edge from p to q; the inside is positive.
int edgeAtSample(const glm::ivec3& p, const glm::ivec3& q, int i, int j) {
  const std::int64_t a = q.y - p.y, b = p.x - q.x;
  const std::int64_t x = std::int64_t{i} * kGrid + kGrid / 2, y = std::int64_t{j} * kGrid + kGrid / 2;
  const std::int64_t value = a * (x - p.x) + b * (y - p.y);  // below 2^61
  for (const std::int64_t part : {value, a, b})
    if (part != 0) return part < 0 ? -1 : 1;
  return 0;
}

}  // namespace

int signAtSample(const SnappedScene& scene, const Line& line, int i, int j) {
  if (line.isOfArea()) {  // it runs between pixels
    const int pixel = line.kind == Line::Kind::Upright ? i : j;
    return pixel * kGrid >= line.p ? line.q : -line.q;
  }
  return line.kind == Line::Kind::Edge ? edgeAtSample(scene.vertices[line.p], scene.vertices[line.q], i, j)
                                       : nearer(scene.planes[line.p], scene.planes[line.q], i, j);
}

bool ownsSample(const SnappedScene& scene, const Region& region, int width, int height) {
  double top = region[0].corner.y, bottom = top;
  for (const Side& side : region) {
    top = std::min(top, side.corner.y - side.corner.radius);
    bottom = std::max(bottom, side.corner.y + side.corner.radius);
  }
  const int end = static_cast<int>(std::min<double>(height, std::floor(bottom / kGrid) + 1.0));
  for (int j = static_cast<int>(std::max(0.0, std::floor(top / kGrid))); j < end; ++j) {
    // Compute in doubles which columns lie inside all sides. Widen this range by one column at either end and
    // test its columns exactly.
    const double y = (j + 0.5) * kGrid;
    double from = 0.0, to = double{kGrid} * width;
    bool some = true;
    for (const Side& side : region) {
      const Line& l = side.line;
      const double value = l.b * y + l.c, rounding = 0x1p-48 * (std::abs(y) + std::abs(l.c));
      if (std::abs(l.a) < 0x1p-30)
        some &= value > -rounding - 1.0;
      else if (l.a > 0)
        from = std::max(from, (-value - rounding) / l.a);
      else
        to = std::min(to, (-value + rounding) / l.a);
    }
    if (!some) continue;
    const int last = static_cast<int>(std::min(width - 1.0, std::ceil(to / kGrid - 0.5)));
    for (int i = static_cast<int>(std::max(0.0, std::floor(from / kGrid - 0.5))); i <= last; ++i)
      if (std::ranges::all_of(region, [&](const Side& s) { return signAtSample(scene, s.line, i, j) > 0; }))
        return true;
  }
  return false;
}

namespace {

/// True if owns(i, j) for a sample of the picture in the box. Of more than four, one is taken for granted.
template <class Owns>
bool mayOwnSample(const ScreenBox& box, int width, int height, const Owns& owns) {
  const int left = std::max(0, sampleFrom(box.x0)), right = std::min(width, sampleFrom(box.x1));
  const int top = std::max(0, sampleFrom(box.y0)), bottom = std::min(height, sampleFrom(box.y1));
  if (left >= right || top >= bottom) return false;
  if (std::int64_t{right - left} * (bottom - top) > 4) return true;
  for (int j = top; j < bottom; ++j)
    for (int i = left; i < right; ++i)
      if (owns(i, j)) return true;
  return false;
}

}  // namespace

bool mayOwnSample(const SnappedScene& scene, const SnappedFace& face, const ScreenBox& box, int width,
                  int height) {
  const glm::ivec3* const v = &scene.vertices[face.first];
  return mayOwnSample(box, width, height, [&](int i, int j) {
    int k = 0;
    while (k < face.count && edgeAtSample(v[k], v[k + 1 == face.count ? 0 : k + 1], i, j) > 0) ++k;
    return k == face.count;
  });
}

bool mayOwnSample(const SnappedScene& scene, const Region& region, const ScreenBox& box, int width,
                  int height) {
  return mayOwnSample(box, width, height, [&](int i, int j) {
    return std::ranges::all_of(region, [&](const Side& s) { return signAtSample(scene, s.line, i, j) > 0; });
  });
}

bool hasAreaInPixels(const SnappedScene& scene, const SnappedFace& face) {
  const glm::ivec3* const v = &scene.vertices[face.first];
  const auto pixel = [&](int k) { return v[k] >> kGridBits; };
  const glm::ivec3 o = pixel(0);
  for (int k = 2; k < face.count; ++k) {
    const glm::ivec3 a = pixel(k - 1) - o, b = pixel(k) - o;
    if (a.x * b.y != a.y * b.x) return true;
  }
  return false;
}

bool mayShow(const SnappedScene& scene, const SnappedFace& face, const ScreenBox& box, int width, int height,
             bool inPixels) {
  return mayOwnSample(scene, face, box, width, height) ||
         (inPixels && box.overlaps({0, 0, width * kGrid, height * kGrid}) && hasAreaInPixels(scene, face));
}

bool isWide(const Region& region) {
  const auto squared = [](double dx, double dy) { return dx * dx + dy * dy; };
  const Corner& o = region[0].corner;
  double doubleArea = 0.0, longest = 0.0;
  for (std::size_t k = 1; k < region.size(); ++k) {
    const Corner &a = region[k].corner, &b = region[k + 1 == region.size() ? 0 : k + 1].corner;
    doubleArea += (a.y - o.y) * (b.x - o.x) - (a.x - o.x) * (b.y - o.y);
    for (std::size_t i = 0; i < k; ++i)
      longest = std::max(longest, squared(a.x - region[i].corner.x, a.y - region[i].corner.y));
  }
  return doubleArea > kThin * std::sqrt(longest);
}

namespace {

std::int64_t ceilDivide(std::int64_t n, std::int64_t positive) { return n / positive + (n % positive > 0); }

struct Columns {
  int from, to;
};

/// The samples of row j that a convex outline owns. Each edge is a half plane and keeps the columns on its
/// inner side. A sample exactly on a left edge is inside, on a right edge outside.
Columns columnsInside(const glm::ivec3* p, int count, int j, int width) {
  std::int64_t from = 0, to = width;
  const std::int64_t y = (std::int64_t{j} << kGridBits) + kGrid / 2;
  for (int v = 0; v < count; ++v) {
    const glm::ivec3 &a = p[v], &b = p[v + 1 == count ? 0 : v + 1];
    // Inside, A (x - ax) + B (y - ay) > 0. |A|, |B| <= 2^30, so the sums stay below 2^62.
    const std::int64_t A = std::int64_t{b.y} - a.y, B = std::int64_t{a.x} - b.x;
    if (A == 0) {
      const std::int64_t height = B > 0 ? y - a.y : a.y - y;
      if (height < 0 || (height == 0 && B < 0)) return {0, 0};
      continue;
    }
    const std::int64_t bound = (std::int64_t{a.x} - kGrid / 2) * A - B * (y - a.y);
    if (A > 0)
      from = std::max(from, ceilDivide(bound, A * kGrid));
    else
      to = std::min(to, ceilDivide(-bound, -A * kGrid));
  }
  return {static_cast<int>(from), static_cast<int>(std::max(from, to))};
}

}  // namespace

VisibleFaces::VisibleFaces(const SnappedScene& scene) : scene_{scene} {
  for (const SnappedFace& face : scene.faces) estimates_.emplace_back(scene, face, scene.planes[face.plane]);
}

std::vector<int> VisibleFaces::rows(int first, int end, int width) {
  const auto planeOf = [&](int f) -> const ScreenPlane& { return scene_.planes[scene_.faces[f].plane]; };
  std::vector<int> seen(std::size_t(width) * (end - first), kNothing);
  nearest_.resize(seen.size());
  for (int f = 0; f < static_cast<int>(scene_.faces.size()); ++f) {
    const SnappedFace& face = scene_.faces[f];
    const glm::ivec3* const outline = &scene_.vertices[face.first];
    const auto [top, bottom] =
        std::minmax_element(outline, outline + face.count, [](auto& a, auto& b) { return a.y < b.y; });
    const int until = std::min(end, (bottom->y >> kGridBits) + 1);
    for (int j = std::max(first, top->y >> kGridBits); j < until; ++j) {
      const Columns columns = columnsInside(outline, face.count, j, width);
      for (int i = columns.from; i < columns.to; ++i) {
        const std::size_t sample = std::size_t(j - first) * width + i;
        const int best = seen[sample];
        const double z = estimates_[f].at(i, j);
        if (best != kNothing) {
          const double ahead = z - nearest_[sample], doubt = estimates_[f].error() + estimates_[best].error();
          if (ahead < -doubt || (ahead <= doubt && nearer(planeOf(f), planeOf(best), i, j) < 0)) continue;
        }
        seen[sample] = f;
        nearest_[sample] = z;
      }
    }
  }
  return seen;
}

std::vector<int> visibleFaces(const SnappedScene& scene, int width, int height) {
  return VisibleFaces{scene}.rows(0, height, width);
}

}  // namespace xnewell
