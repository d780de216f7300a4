#include "geometry/model/sheets.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "geometry/exact/box.h"
#include "geometry/exact/scale.h"

namespace xnewell {

UnitBox::UnitBox(const std::vector<glm::dvec3>& meshPoints) {
  // Scale first, so that differences do not overflow.
  Box box = boxOf(meshPoints);
  std::frexp(box.magnitude(), &first);
  box = {scaled(box.low, -first), scaled(box.high, -first)};
  side = std::frexp(box.side(), &second);
  magnitude = std::ldexp(box.magnitude(), -second);
  exponent = first + second;
  points.reserve(meshPoints.size());
  low = box.low;
  for (const glm::dvec3& p : meshPoints) points.push_back(scaled(scaled(p, -first) - low, -second));
}

glm::dvec3 UnitBox::inWorld(const glm::dvec3& p) const { return scaled(scaled(p, second) + low, first); }

Sheets::Sheets(const Mesh& mesh, const ConvexParts& convexParts)
    : parts{convexParts}, box{mesh.points}, rounding{box.side, box.magnitude} {
  double coarsest = 0.0;
  for (const double u : mesh.rounding) coarsest = std::max(coarsest, std::ldexp(u, -box.exponent));
  mostRounding_ = rounding.most(coarsest);
  sheets.reserve(parts.plane.empty() ? 0 : parts.plane.back() + 1);
  for (int k = 0; k < parts.count(); ++k) {
    if (k > 0 && parts.plane[k] == parts.plane[k - 1]) {
      ++sheets.back().partCount;
      continue;
    }
    ModelSheet& sheet = sheets.emplace_back();
    sheet.firstPart = k;
    sheet.partCount = 1;
    sheet.u = std::ldexp(mesh.roundingOf(parts.face[k]), -box.exponent);
  }
  for (ModelSheet& sheet : sheets) {
    const int k = sheet.firstPart;
    const auto outline = sheet.partCount == 1 ? parts.part(k) : mesh.face(parts.face[k]);
    const glm::dvec3 v = newellVector(box.points, outline);
    sheet.area = glm::length(v);
    sheet.centroid = centroid(box.points, outline);
    if (sheet.area > 0.0) {
      sheet.plane.N = v / sheet.area;
      sheet.steepness = 2.0 * perimeter(outline) / sheet.area;
    }
    sheet.plane.d = glm::dot(sheet.plane.N, sheet.centroid);
  }
}

std::span<const int> Sheets::corners(const ModelSheet& sheet) const {
  const auto at = [&](int k) { return parts.corners.data() + parts.firstCorner[k]; };
  return {at(sheet.firstPart), at(sheet.firstPart + sheet.partCount)};
}

double Sheets::perimeter(std::span<const int> outline) const {
  double sum = 0.0;
  glm::dvec3 last = box.points[outline.back()];
  for (const int c : outline) {
    sum += glm::length(box.points[c] - last);
    last = box.points[c];
  }
  return sum;
}

Sheets::Shape Sheets::shapeOf(int part) const {
  const ModelSheet& sheet = of(part);
  if (sheet.partCount == 1) return {sheet.area, sheet.steepness};
  const double area = glm::length(newellVector(box.points, parts.part(part)));
  return {area, 2.0 * perimeter(parts.part(part)) / area};
}

Sheets::Place Sheets::placeOf(int part, double steepness, const glm::dvec3& from, double r) const {
  const ModelSheet& sheet = of(part);
  Box around;
  for (const int c : parts.part(part)) around.add(box.points[c]);
  const glm::dvec3 foot = sheet.plane.N * (sheet.plane.d - glm::dot(sheet.plane.N, from));
  const double distance = glm::length(glm::max(glm::abs(around.low - from), glm::abs(around.high - from)));
  const double play = (sheet.partCount == 1 ? 1.0 : 2.0) * r * (steepness * distance + 1.0);
  Place place;
  for (int axis = 0; axis < 3; ++axis) {
    place.low[axis] = place.high[axis] = foot[axis];
    place.play[axis] = std::min(4.0, play);  // two feet are never farther apart
    place.low[axis + 3] = around.low[axis];
    place.high[axis + 3] = around.high[axis];
    place.play[axis + 3] = r;
  }
  return place;
}

namespace {

/// Rounding a number up to 8 to float changes it by at most this.
constexpr double kToFloat = 0x1p-22;

/// The value below which this share of the values lie.
double quantile(std::vector<double>& values, double share) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size()));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// How some intervals lie: the middle one, how far apart those of the middle half are, and the usual width.
struct Spread {
  double middle, apart, width;
  [[nodiscard]] double wide() const { return apart / width; }  ///< in widths
};
template <class Item, class Low, class High>
Spread spreadOf(std::span<const Item> items, const Low& low, const High& high) {
  std::vector<double> centres, widths;
  for (const Item& item : items) {
    centres.push_back((low(item) + high(item)) / 2.0);
    widths.push_back(high(item) - low(item));
  }
  const double first = quantile(centres, 0.25), last = quantile(centres, 0.75);
  return {quantile(centres, 0.5), last - first, quantile(widths, 0.5)};
}

}  // namespace

bool Sheets::isWide(int part, double least) const {
  const auto outline = parts.part(part);
  glm::dvec3 a = box.points[outline.back()];
  for (const int c : outline) {
    const glm::dvec3 b = box.points[c], edge = b - a;
    const double length = glm::length(edge);
    const auto isFar = [&](int q) {
      return glm::length(glm::cross(edge, box.points[q] - a)) > least * length;
    };
    if (length > 0.0 && std::ranges::none_of(outline, isFar)) return false;
    a = b;
  }
  return true;
}

Sheets::Places Sheets::places(const std::vector<int>& open) const {
  const glm::dvec3 from{0.43, 0.56, 0.47};
  constexpr int kDust = -1, kWide = -2;
  Places result;
  result.among.reserve(open.size() == sheets.size() ? parts.count() : 2 * open.size());
  for (const int s : open) {
    const ModelSheet& sheet = sheets[s];
    if (sheet.area == 0.0) continue;
    for (int k = sheet.firstPart; k < sheet.firstPart + sheet.partCount; ++k) {
      const Shape shape = shapeOf(k);
      if (shape.area == 0.0) continue;
      const Place place = placeOf(k, shape.steepness, from, mostRounding_);
      const double length = std::hypot(place.high[3] - place.low[3], place.high[4] - place.low[4],
                                       place.high[5] - place.low[5]);
      const bool dust = length < 0.9 * delta(sheet.u);
      ItemBox& item =
          (dust ? result.dust : result.among).emplace_back(ItemBox{k, dust ? kDust : parts.plane[k], {}, {}});
      for (int axis = 0; axis < 6; ++axis) {
        item.low[axis] = static_cast<float>(place.low[axis] - (place.play[axis] + kToFloat));
        item.high[axis] = static_cast<float>(place.high[axis] + (place.play[axis] + kToFloat));
      }
    }
  }
  if (result.dust.empty()) return result;
  for (const ItemBox& item : result.among) {
    if (!isWide(item.item, 1.1 * delta(of(item.item).u))) continue;
    result.dust.push_back(item);
    result.dust.back().group = kWide;
  }
  return result;
}

bool Sheets::refine(std::span<ItemBox> boxes) const {
  constexpr std::size_t kMany = 1'024;
  if (boxes.size() < kMany) return false;
  glm::dvec3 from{0.0};
  for (int axis = 0; axis < 3; ++axis) {
    const auto at = [&](const ItemBox& b) { return of(b.item).centroid[axis]; };
    from[axis] = spreadOf(std::span<const ItemBox>{boxes}, at, at).middle;
  }
  std::vector<Place> places;
  places.reserve(boxes.size());
  for (const ItemBox& b : boxes)
    places.push_back(placeOf(b.item, shapeOf(b.item).steepness, from, 2.0 * rounding.most(of(b.item).u)));

  std::array<Spread, 6> spread;
  bool separates = false;
  for (int axis = 0; axis < 6; ++axis) {
    spread[axis] = spreadOf(
        std::span<const Place>{places}, [&](const Place& p) { return p.low[axis] - p.play[axis]; },
        [&](const Place& p) { return p.high[axis] + p.play[axis]; });
    const Spread now = spreadOf(
        std::span<const ItemBox>{boxes}, [&](const ItemBox& b) { return double{b.low[axis]}; },
        [&](const ItemBox& b) { return double{b.high[axis]}; });
    separates |= now.wide() < 4.0 && spread[axis].wide() > std::max(2.0, 4.0 * now.wide());
  }
  if (!separates) return false;

  for (std::size_t k = 0; k < boxes.size(); ++k)
    for (int axis = 0; axis < 6; ++axis) {
      const Spread& all = spread[axis];
      const int exponent = -std::ilogb(std::max(all.apart, all.width));
      // What lies beyond 7 units lies at 7: it still overlaps what it did.
      const auto inUnits = [&](double x) {
        return std::clamp(std::ldexp(x - all.middle, exponent), -7.0, 7.0);
      };
      const Place& p = places[k];
      boxes[k].low[axis] = static_cast<float>(inUnits(p.low[axis] - p.play[axis]) - kToFloat);
      boxes[k].high[axis] = static_cast<float>(inUnits(p.high[axis] + p.play[axis]) + kToFloat);
    }
  return true;
}

bool Sheets::oneTooFar(int i, int j) const {
  const ModelSheet& P = of(i);
  const double u = std::max(P.u, of(j).u);
  const double rho = rounding.most(u);
  return std::ranges::any_of(parts.part(j), [&](int c) {
    const glm::dvec3 apart = box.points[c] - P.centroid;
    return std::abs(glm::dot(P.plane.N, apart)) > Rounding::mostOff(rho, P.steepness, glm::length(apart));
  });
}

bool Sheets::parted(int i, int j, const glm::dvec3& N) const {
  const glm::dvec3 n = glm::abs(N);
  const int dropped = n.z >= n.x && n.z >= n.y ? 2 : n.y >= n.x ? 1 : 0;
  return partedByEdgesOf(i, j, dropped) || partedByEdgesOf(j, i, dropped);
}

/// Asks the edges of part i, seen along the axis `dropped`.
bool Sheets::partedByEdgesOf(int i, int j, int dropped) const {
  const double u = std::max(of(i).u, of(j).u);
  const auto P = parts.part(i), Q = parts.part(j);
  const double delta = this->delta(u);
  const auto seen = [&](int c) {
    return glm::dvec2{box.points[c][(dropped + 1) % 3], box.points[c][(dropped + 2) % 3]};
  };
  const auto cross = [](const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; };
  double area = 0.0;
  const glm::dvec2 origin = seen(P[0]);
  for (std::size_t c = 2; c < P.size(); ++c) area += cross(seen(P[c - 1]) - origin, seen(P[c]) - origin);
  std::size_t inside = 0;  // a corner of Q inside the last edge is probably inside the next too
  glm::dvec2 a = seen(P.back());
  for (const int c : P) {
    const glm::dvec2 b = seen(c), edge = area < 0.0 ? a - b : b - a;
    const double length = glm::length(edge);
    const auto outside = [&](const glm::dvec2& q) {
      const double across = cross(edge, q - a);
      if (across <= 2.0 * delta * length) return true;
      if (across > 4.0 * delta * length) return false;
      const double beyond = std::abs(glm::dot(b - a, 2.0 * q - a - b)) / length;  // times the length
      return across <= delta * (length + beyond);
    };
    std::size_t tried = 0;
    while (tried < Q.size() && outside(seen(Q[inside]))) {
      inside = inside + 1 == Q.size() ? 0 : inside + 1;
      ++tried;
    }
    if (tried == Q.size() && edge != glm::dvec2{0.0}) return true;
    a = b;
  }
  return false;
}

}  // namespace xnewell
