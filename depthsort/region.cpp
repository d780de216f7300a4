#include "depthsort/region.h"

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cassert>
#include <cmath>
#include <limits>

#include "geometry/exact/two_doubles.h"

namespace xnewell {

namespace {

namespace mp = boost::multiprecision;

/// An integer of 512 bits and a sign. Two cut lines meet at (X, Y) / W with |X|, |Y| <= 2^279 and |W| <=
/// 2^247. The value of a third line there is a X + b Y + c W, below 3 * 2^402.
using Wide = mp::number<mp::cpp_int_backend<512, 512, mp::signed_magnitude, mp::unchecked, void>>;

struct ExactLine {
  Wide a, b, c;
};

Int128 difference(std::int64_t p, std::int64_t c, std::int64_t q, std::int64_t d) {
  return Int128{p} * d - Int128{q} * c;
}

/// D d - E c for |D|, |E| <= 2^93 and 0 < c, d <= 2^61, as high * 2^64 + low, -2^63 <= low < 2^63. With low
/// this near to zero, the sum of both in doubles is accurate even if the value is small and negative.
struct Product {
  Int128 high, low;
};
Product difference(Int128 D, std::int64_t c, Int128 E, std::int64_t d) {
  constexpr Int128 kMask = (Int128{1} << 64) - 1;
  const Int128 low = (D & kMask) * d - (E & kMask) * c;
  const Int128 carry = (low + (Int128{1} << 63)) >> 64;
  return {(D >> 64) * d - (E >> 64) * c + carry, low - (carry << 64)};
}

/// The coefficients of an edge, or of a side of an area.
std::array<std::int64_t, 3> wholeLine(const SnappedScene& scene, const Line& line) {
  const std::int64_t side = line.q;
  if (line.kind == Line::Kind::Upright) return {side, 0, -side * line.p};
  if (line.kind == Line::Kind::Level) return {0, side, -side * line.p};
  const glm::ivec3 &p = scene.vertices[line.p], &q = scene.vertices[line.q];
  const std::int64_t a = q.y - p.y, b = p.x - q.x;
  return {a, b, -a * p.x - b * p.y};
}

ExactLine exactly(const SnappedScene& scene, const Line& line) {
  if (line.kind != Line::Kind::Cut) {
    const auto [a, b, c] = wholeLine(scene, line);
    return {Wide{a}, Wide{b}, Wide{c}};
  }
  const ScreenPlane &P = scene.planes[line.p], &Q = scene.planes[line.q];
  return {Wide{difference(P.A, P.C, Q.A, Q.C)}, Wide{difference(P.B, P.C, Q.B, Q.C)},
          Wide{P.D} * Q.C - Wide{Q.D} * P.C};
}

/// A sum of products of coefficients, and the sum of their absolute values.
struct FineSum {
  /// Each coefficient is off by kTwoDoubles of itself. Two products and three sums follow, at most: less than
  /// nine times kTwoDoubles of `size` in all. `size` is off by a few 2^-53 of itself.
  static constexpr double kOff = 16 * kTwoDoubles;

  TwoDoubles value;
  double size;
  /// The sign; 0 if it is in doubt.
  [[nodiscard]] int sign() const { return value.high > kOff * size ? 1 : value.high < -kOff * size ? -1 : 0; }
};
/// x y - z w
FineSum difference(const TwoDoubles& x, const TwoDoubles& y, const TwoDoubles& z, const TwoDoubles& w) {
  return {x * y + -(z * w), std::abs(x.high * y.high) + std::abs(z.high * w.high)};
}

Line scaled(Line line) {
  const double largest = std::max(std::abs(line.a), std::abs(line.b));
  if (largest > 0.0) line.a /= largest, line.b /= largest, line.c /= largest;
  return line;
}

bool sameLine(const Line& l, const Line& m) {
  if (l.isOfArea()) return l.kind == m.kind && l.p == m.p;
  return l.kind == m.kind && ((l.p == m.p && l.q == m.q) || (l.p == m.q && l.q == m.p));
}

/// True if the three lines are the cuts of three planes with each other: they meet in one point. None is the
/// same as another.
bool cutThreePlanes(const Line& l, const Line& m, const Line& n) {
  if (l.kind != Line::Kind::Cut || m.kind != Line::Kind::Cut) return false;
  const auto other = [](const Line& line, int plane) { return line.p == plane ? line.q : line.p; };
  const int shared = l.p == m.p || l.p == m.q ? l.p : l.q;
  if (shared != m.p && shared != m.q) return false;
  return sameLine(n, {Line::Kind::Cut, other(l, shared), other(m, shared)});
}

}  // namespace

Line Regions::edge(int from, int to) const {
  Line line{Line::Kind::Edge, from, to};
  const auto [a, b, c] = wholeLine(scene_, line);
  line.a = static_cast<double>(a), line.b = static_cast<double>(b), line.c = static_cast<double>(c);
  return scaled(line);
}

Line Regions::upright(int at, int side) {
  return {Line::Kind::Upright, at, side, double(side), 0.0, -double(side) * at};
}

Line Regions::level(int at, int side) {
  return {Line::Kind::Level, at, side, 0.0, double(side), -double(side) * at};
}

Line Regions::cut(int over, int under) const {
  const ScreenPlane &P = scene_.planes[over], &Q = scene_.planes[under];
  const Product c = difference(P.D, P.C, Q.D, Q.C);
  return scaled({Line::Kind::Cut, over, under, approximately(difference(P.A, P.C, Q.A, Q.C)),
                 approximately(difference(P.B, P.C, Q.B, Q.C)),
                 approximately(c.high) * 0x1p64 + approximately(c.low)});
}

Line Regions::flipped(Line line) {
  std::swap(line.p, line.q);
  line.a = -line.a, line.b = -line.b, line.c = -line.c;
  return line;
}

void Regions::outline(const SnappedFace& face, Region& region) const {
  region.resize(face.count);
  for (int k = 0; k < face.count; ++k) {
    const int from = face.first + k, to = face.first + (k + 1 == face.count ? 0 : k + 1);
    const glm::ivec3& end = scene_.vertices[to];
    region[k] = {edge(from, to), {static_cast<double>(end.x), static_cast<double>(end.y), 0.0}};
  }
}

Signs Regions::signs(const Line& line, const Region& region) const {
  Signs signs;
  for (std::size_t k = 0; k < region.size() && !signs.both(); ++k) signs.add(sign(line, region, k));
  return signs;
}

bool Regions::reaches(const Region& region, const Line& line) const {
  const auto isSure = [&](const Side& side) { return estimate(line, side.corner) > 0; };
  if (std::ranges::any_of(region, isSure)) return true;
  std::size_t k = 0;
  while (k < region.size() && sign(line, region, k) <= 0) ++k;
  return k < region.size();
}

void Regions::clip(Region& region, const Line& line) const {
  const int count = static_cast<int>(region.size());
  const auto next = [count](int k) { return k + 1 == count ? 0 : k + 1; };
  constexpr int kFew = 32;  // most regions have no more corners and need no allocation
  std::array<std::int8_t, kFew> few;
  std::vector<std::int8_t> many;
  if (count > kFew) many.resize(count);
  std::int8_t* const at = count > kFew ? many.data() : few.data();
  Signs signs;
  for (int k = 0; k < count; ++k) {
    at[k] = static_cast<std::int8_t>(sign(line, region, k));
    signs.add(at[k]);
  }
  if (!signs.negative) return;
  if (!signs.positive) return region.clear();

  // Corner k is the end of side k. A side stays if one of its ends is strictly inside, and these sides are
  // successive. The first and the last of them have one end inside and one not, so they really cross the line
  // and meet it in a corner. If an old corner lies on the line, it is that corner.
  int last = 0;
  while (at[last] > 0 || at[next(last)] <= 0) last = next(last);
  const Corner before = region[last].corner;  // the start of the first side
  const bool beginsThere = at[last] == 0;
  Region& kept = kept_;
  kept.clear();
  int k = last;
  do {
    k = next(k);
    kept.push_back(region[k]);
  } while (at[k] > 0);
  if (at[k] < 0) kept.back().corner = meeting(kept.back().line, line);
  kept.push_back({line, beginsThere ? before : meeting(line, kept.front().line)});
  region.swap(kept);
}

Corner Regions::meeting(const Line& l, const Line& m) const {
  const double w = l.a * m.b - m.a * l.b;
  // The numerators have an error of at most 2^-50 (|c| + |c'|), and w of at most 2^-49.
  if (std::abs(w) < 0x1p-30) {  // the lines are nearly parallel
    const ExactLine p = exactly(scene_, l), q = exactly(scene_, m);
    const Wide X = p.b * q.c - q.b * p.c, Y = q.a * p.c - p.a * q.c, W = p.a * q.b - q.a * p.b;
    const double x = X.convert_to<double>() / W.convert_to<double>();
    const double y = Y.convert_to<double>() / W.convert_to<double>();
    return {x, y, 0x1p-50 * (std::abs(x) + std::abs(y) + 1.0)};
  }
  const double x = (l.b * m.c - m.b * l.c) / w, y = (m.a * l.c - l.a * m.c) / w;
  return {x, y, 0x1p-48 * (std::abs(l.c) + std::abs(m.c) + std::abs(x) + std::abs(y) + 1.0) / std::abs(w)};
}

Regions::FineLine Regions::fineLine(const Line& line) const {
  if (line.kind != Line::Kind::Cut) {
    const auto [a, b, c] = wholeLine(scene_, line);
    return {{double(a), 0.0}, {double(b), 0.0}, twoDoubles(c)};
  }
  const ScreenPlane &P = scene_.planes[line.p], &Q = scene_.planes[line.q];
  const Product c = difference(P.D, P.C, Q.D, Q.C);
  const TwoDoubles high = twoDoubles(c.high);
  return {twoDoubles(difference(P.A, P.C, Q.A, Q.C)), twoDoubles(difference(P.B, P.C, Q.B, Q.C)),
          TwoDoubles{high.high * 0x1p64, high.low * 0x1p64} + twoDoubles(c.low)};
}

const Regions::FineLine& Regions::finely(const Line& line) const {
  constexpr unsigned kKept = 256;
  if (lines_.empty()) lines_.resize(kKept);
  KeptLine& kept = lines_[(31u * static_cast<unsigned>(line.p) + static_cast<unsigned>(line.q)) % kKept];
  if (kept.p != line.p || kept.q != line.q || kept.kind != line.kind)
    kept = {line.kind, line.p, line.q, fineLine(line)};
  return kept.fine;
}

/// The sign of n where l and m meet; 0 if it is in doubt.
int Regions::fineSign(const FineLine& n, const FineLine& l, const FineLine& m) {
  const FineSum W = difference(l.a, m.b, m.a, l.b);
  if (W.sign() == 0) return 0;
  const FineSum X = difference(l.b, m.c, m.b, l.c), Y = difference(m.a, l.c, l.a, m.c);
  const FineSum sum{n.a * X.value + n.b * Y.value + n.c * W.value,
                    std::abs(n.a.high) * X.size + std::abs(n.b.high) * Y.size + std::abs(n.c.high) * W.size};
  return sum.sign() * W.sign();
}

int Regions::exactSign(const Line& line, const Line& first, const Line& second, const Corner& at) const {
  if (sameLine(line, first) || sameLine(line, second)) return 0;
  if (at.exact()) {
    const auto x = static_cast<std::int64_t>(at.x), y = static_cast<std::int64_t>(at.y);
    if (line.kind == Line::Kind::Cut)
      return compareDepths(scene_.planes[line.p], scene_.planes[line.q], x, y);
    const auto [a, b, c] = wholeLine(scene_, line);
    const std::int64_t value = a * x + b * y + c;  // below 2^62
    return value < 0 ? -1 : value > 0;
  }
  if (cutThreePlanes(line, first, second)) return 0;
  const FineLine fine = finely(line), fineFirst = finely(first);
  if (const int sign = fineSign(fine, fineFirst, finely(second))) return sign;
  const ExactLine l = exactly(scene_, first), m = exactly(scene_, second), n = exactly(scene_, line);
  const Wide X = l.b * m.c - m.b * l.c, Y = m.a * l.c - l.a * m.c, W = l.a * m.b - m.a * l.b;
  assert(W != 0);
  const Wide value = n.a * X + n.b * Y + n.c * W;
  return value.sign() * W.sign();
}

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

int floorToInt(double z) {
  return static_cast<int>(std::clamp(std::floor(z), double{std::numeric_limits<int>::min()},
                                     double{std::numeric_limits<int>::max()}));
}

}  // namespace

Extents extentsOf(const SnappedScene& scene, const SnappedFace& face) {
  const glm::ivec3* const v = &scene.vertices[face.first];
  Extents e{{v->x, v->y, v->x, v->y}, v->z, v->z};
  for (const glm::ivec3* p = v + 1; p != v + face.count; ++p) {
    e.box = {std::min(e.box.x0, p->x), std::min(e.box.y0, p->y), std::max(e.box.x1, p->x),
             std::max(e.box.y1, p->y)};
    e.zFar = std::min(e.zFar, p->z);
    e.zNear = std::max(e.zNear, p->z);
  }
  if (face.throughVertices) return e;
  double far = kInfinity, near = -far;
  for (const glm::ivec3* p = v; p != v + face.count; ++p) {
    const double z = depthAt(scene.planes[face.plane], p->x, p->y), rounding = 0x1p-50 * std::abs(z);
    far = std::min(far, z - rounding);
    near = std::max(near, z + rounding);
  }
  e.zFar = floorToInt(far);
  e.zNear = floorToInt(near + 1.0);
  return e;
}

Extents extentsOf(const SnappedScene& scene, const SnappedFace& face, const Region& piece,
                  const Extents& parent) {
  const ScreenPlane& plane = scene.planes[face.plane];
  const double A = static_cast<double>(plane.A) / static_cast<double>(plane.C),
               B = static_cast<double>(plane.B) / static_cast<double>(plane.C);
  const glm::ivec3& anchor = scene.vertices[face.first];
  const double z0 = depthAt(plane, anchor.x, anchor.y);
  double x0 = kInfinity, x1 = -x0, y0 = x0, y1 = -x0, far = x0, near = -x0;
  for (const Side& side : piece) {
    const Corner& c = side.corner;
    x0 = std::min(x0, c.x - c.radius), x1 = std::max(x1, c.x + c.radius);
    y0 = std::min(y0, c.y - c.radius), y1 = std::max(y1, c.y + c.radius);
    const double dx = c.x - anchor.x, dy = c.y - anchor.y, z = A * dx + B * dy + z0;
    const double rounding = (std::abs(A) + std::abs(B)) * c.radius +
                            0x1p-50 * (std::abs(A * dx) + std::abs(B * dy) + std::abs(z0));
    far = std::min(far, z - rounding), near = std::max(near, z + rounding);
  }
  return {{std::max(parent.box.x0, floorToInt(x0)), std::max(parent.box.y0, floorToInt(y0)),
           std::min(parent.box.x1, floorToInt(x1 + 1.0)), std::min(parent.box.y1, floorToInt(y1 + 1.0))},
          std::max(parent.zFar, floorToInt(far)),
          std::min(parent.zNear, floorToInt(near + 1.0))};
}

PixelArea rowsOf(const ScreenBox& box, const PixelArea& area, bool inPixels) {
  if (inPixels) return area;
  const int top = std::max(area.top, box.y0 >> kGridBits);
  return {area.left, top, area.right, std::max(top, std::min(area.bottom, (box.y1 >> kGridBits) + 1))};
}

void enterPiece(SortedScene& sorted, const PieceOf& of, const Region& region, const PixelArea& area) {
  Piece piece{of.face, static_cast<int>(sorted.cuts.size()), 0, area, of.parent};
  for (const Side& side : region)
    if (side.line.kind == Line::Kind::Cut) {
      sorted.cuts.push_back({side.line.p, side.line.q});
      ++piece.cuts;
    }
  sorted.pieces.push_back(piece);
}

}  // namespace xnewell
