#include "tests/support/exact_region.h"

#include <algorithm>
#include <cmath>

namespace xnewell {

namespace {

Rational quotient(const Int128& n, std::int64_t d) {
  return {boost::multiprecision::cpp_int{n}, boost::multiprecision::cpp_int{d}};
}

ExactLine edgeOf(const ExactPoint& p, const ExactPoint& q) {
  const Rational a = q.y - p.y, b = p.x - q.x;
  return {a, b, -(a * p.x + b * p.y)};
}

}  // namespace

Rational valueAt(const ExactLine& l, const ExactPoint& p) { return l.a * p.x + l.b * p.y + l.c; }

ExactLine exactEdge(const glm::ivec3& p, const glm::ivec3& q) { return edgeOf({p.x, p.y}, {q.x, q.y}); }

ExactLine exactDifference(const ScreenPlane& P, const ScreenPlane& Q) {
  return {quotient(P.A, P.C) - quotient(Q.A, Q.C), quotient(P.B, P.C) - quotient(Q.B, Q.C),
          quotient(P.D, P.C) - quotient(Q.D, Q.C)};
}

bool samePlane(const ScreenPlane& P, const ScreenPlane& Q) {
  const ExactLine d = exactDifference(P, Q);
  return d.a == 0 && d.b == 0 && d.c == 0;
}

ExactRegion exactOutline(const SnappedScene& scene, const SnappedFace& face) {
  ExactRegion region;
  for (int k = 0; k < face.count; ++k) {
    const glm::ivec3& p = scene.vertices[face.first + k];
    region.push_back({p.x, p.y});
  }
  return region;
}

ExactRegion exactFragment(const SnappedScene& scene, const SortedScene& sorted, const Fragment& fragment) {
  ExactRegion region = exactOutline(scene, scene.faces[fragment.face]);
  if (fragment.piece < 0) return region;
  const Piece& piece = sorted.pieces[fragment.piece];
  for (int c = piece.firstCut; c < piece.firstCut + piece.cuts; ++c) {
    const CutLine& cut = sorted.cuts[c];
    region = clipped(region, exactDifference(scene.planes[cut.over], scene.planes[cut.under]));
  }
  return region;
}

// Sutherland and Hodgman 1974, for one line.
ExactRegion clipped(const ExactRegion& region, const ExactLine& line) {
  ExactRegion kept;
  bool inside = false;
  for (std::size_t k = 0; k < region.size(); ++k) {
    const ExactPoint &p = region[k], &q = region[(k + 1) % region.size()];
    const Rational atP = valueAt(line, p), atQ = valueAt(line, q);
    inside |= atP > 0;
    if (atP >= 0) kept.push_back(p);
    if (atP * atQ < 0) {
      const Rational t = atP / (atP - atQ);
      kept.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
    }
  }
  return inside ? kept : ExactRegion{};
}

ExactRegion common(ExactRegion region, const ExactRegion& other) {
  if (other.empty()) return {};
  for (std::size_t k = 0; k < other.size() && !region.empty(); ++k)
    region = clipped(region, edgeOf(other[k], other[(k + 1) % other.size()]));
  return region;
}

ExactRegion within(ExactRegion region, const PixelArea& area) {
  const auto at = [](int pixel) { return Rational{std::int64_t{pixel} * kGrid}; };
  for (const ExactLine& side : {ExactLine{1, 0, -at(area.left)}, ExactLine{0, 1, -at(area.top)},
                                ExactLine{-1, 0, at(area.right)}, ExactLine{0, -1, at(area.bottom)}})
    region = clipped(region, side);
  return region;
}

Rational exactDoubleArea(const ExactRegion& region) {
  Rational sum = 0;
  for (std::size_t k = 0; k < region.size(); ++k) {
    const ExactPoint &p = region[k], &q = region[(k + 1) % region.size()];
    sum += p.y * q.x - p.x * q.y;  // y points down
  }
  return sum;
}

Rational greatest(const ExactLine& line, const ExactRegion& region) {
  Rational most = valueAt(line, region.front());
  for (const ExactPoint& p : region) most = std::max(most, valueAt(line, p));
  return most;
}

bool exactlyCovers(const ExactRegion& region, int i, int j) {
  const ExactPoint centre{Rational{2 * i + 1, 2} * kGrid, Rational{2 * j + 1, 2} * kGrid};
  for (std::size_t k = 0; k < region.size(); ++k) {
    const ExactLine side = edgeOf(region[k], region[(k + 1) % region.size()]);
    const Rational value = valueAt(side, centre);
    const Rational& part = value != 0 ? value : side.a != 0 ? side.a : side.b;
    if (part <= 0) return false;
  }
  return !region.empty();
}

bool exactlyOwnsSample(const ExactRegion& region, int width, int height) {
  if (region.empty()) return false;
  const auto pixel = [](const Rational& r) { return std::floor(r.convert_to<double>() / kGrid); };
  const auto [left, right] = std::ranges::minmax_element(region, {}, &ExactPoint::x);
  const auto [top, bottom] = std::ranges::minmax_element(region, {}, &ExactPoint::y);
  const auto within = [](double value, int size) {
    return static_cast<int>(std::clamp(value, 0.0, size - 1.0));
  };
  for (int j = within(pixel(top->y) - 1, height); j <= within(pixel(bottom->y) + 1, height); ++j)
    for (int i = within(pixel(left->x) - 1, width); i <= within(pixel(right->x) + 1, width); ++i)
      if (exactlyCovers(region, i, j)) return true;
  return false;
}

double thickness(const ExactRegion& region) {
  Rational squared = 0;
  for (const ExactPoint& p : region)
    for (const ExactPoint& q : region)
      squared = std::max(squared, Rational{(p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y)});
  return exactDoubleArea(region).convert_to<double>() / std::sqrt(squared.convert_to<double>());
}

}  // namespace xnewell
