#include "geometry/model/sheets.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numeric>

#include "geometry/exact/box.h"
#include "geometry/exact/scale.h"

namespace xnewell {

UnitBox::UnitBox(const std::vector<glm::dvec3>& meshPoints) {
  // Scale first, so that differences do not overflow.
  Box box = xnewell::boxOf(meshPoints);
  std::frexp(box.magnitude(), &frame.first);
  box = {scaled(box.low, -frame.first), scaled(box.high, -frame.first)};
  side = std::frexp(box.side(), &frame.second);
  magnitude = std::ldexp(box.magnitude(), -frame.second);
  exponent = frame.first + frame.second;
  points.reserve(meshPoints.size());
  frame.low = box.low;
  for (const glm::dvec3& p : meshPoints) points.push_back(frame.inUnits(p));
}

Sheets::Sheets(const Mesh& mesh, const ConvexParts& convexParts)
    : parts{convexParts}, box{mesh.points}, rounding{box.side, box.magnitude}, mesh_{mesh} {
  double coarsest = 0.0;
  for (const double u : mesh.rounding)
    coarsest = std::max(coarsest, roundings_.emplace_back(std::ldexp(u, -box.exponent)));
  mostRounding_ = rounding.most(coarsest);
  firstPart_.reserve(parts.count() + 1);
  for (int k = 0; k < parts.count(); ++k)
    if (k == 0 || parts.plane[k] != parts.plane[k - 1]) firstPart_.push_back(k);
  firstPart_.push_back(parts.count());
  for (int s = 0; s < count(); ++s)
    if (partCount(s) > 1) divided_.emplace(s, madeSheet(s));
}

double Sheets::roundingOf(int s) const {
  return roundings_.empty() ? 0.0 : roundings_[mesh_.group[parts.face[firstPart(s)]]];
}

ModelSheet Sheets::sheet(int s) const { return partCount(s) == 1 ? madeSheet(s) : divided_.at(s); }

ModelSheet Sheets::madeSheet(int s) const {
  ModelSheet sheet;
  sheet.partCount = partCount(s);
  sheet.u = roundingOf(s);
  const int k = firstPart(s);
  const auto outline = sheet.partCount == 1 ? parts.part(k) : mesh_.face(parts.face[k]);
  const glm::dvec3 v = newellVector(box.points, outline);
  sheet.area = glm::length(v);
  sheet.centroid = centroid(box.points, outline);
  if (sheet.area > 0.0) {
    sheet.plane.N = v / sheet.area;
    sheet.steepness = 2.0 * perimeter(outline) / sheet.area;
  }
  sheet.plane.d = glm::dot(sheet.plane.N, sheet.centroid);
  return sheet;
}

std::span<const int> Sheets::corners(int s) const {
  const auto at = [&](int k) { return parts.corners.data() + parts.firstCorner[k]; };
  return {at(firstPart(s)), at(firstPart(s + 1))};
}

Box Sheets::boxOf(int part) const {
  Box around;
  for (const int c : parts.part(part)) around.add(box.points[c]);
  return around;
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

Sheets::Shape Sheets::shapeOf(const SheetPart& P) const {
  if (P.sheet.partCount == 1) return {P.sheet.area, P.sheet.steepness};
  const double area = glm::length(newellVector(box.points, parts.part(P.part)));
  return {area, 2.0 * perimeter(parts.part(P.part)) / area};
}

Sheets::Place Sheets::placeOf(const SheetPart& P, double steepness, const glm::dvec3& from, double r) const {
  const ModelSheet& sheet = P.sheet;
  const Box around = boxOf(P.part);
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

BoxCells::Lists Sheets::cells() const {
  constexpr double kPartsWide = 16.0;
  const double beyond = mostRounding_ + kToFloat;
  const auto boxAt = [&](std::size_t k) {
    const Box around = boxOf(static_cast<int>(k));
    ItemBox item;
    for (int axis = 0; axis < 3; ++axis) {
      item.low[axis + 3] = static_cast<float>(around.low[axis] - beyond);
      item.high[axis + 3] = static_cast<float>(around.high[axis] + beyond);
    }
    return item;
  };
  const std::size_t count = parts.count();
  BoxCells::Lists lists;
  if (count >= kManyBoxes) lists = BoxCells{count, boxAt, kPartsWide}.lists(count, boxAt);
  if (lists.cells() > 0) return lists;
  lists.begin = {0, parts.count()};  // one cell
  lists.boxes.resize(count);
  std::iota(lists.boxes.begin(), lists.boxes.end(), 0);
  return lists;
}

void Sheets::findPlaces(std::span<const int> some, Places& result) const {
  const glm::dvec3 from{0.43, 0.56, 0.47};
  constexpr int kDust = -1, kWide = -2;
  result.sheets.clear(), result.items.clear(), result.among.clear(), result.dust.clear();
  int last = -1;
  for (const int k : some) {
    if (parts.plane[k] != last) result.sheets.push_back(sheet(last = parts.plane[k]));
    if (result.sheets.back().area == 0.0) continue;
    const SheetPart P{k, result.sheets.back()};
    const Shape shape = shapeOf(P);
    if (shape.area == 0.0) continue;
    const Place place = placeOf(P, shape.steepness, from, mostRounding_);
    const double length = glm::length(
        glm::dvec3{place.high[3] - place.low[3], place.high[4] - place.low[4], place.high[5] - place.low[5]});
    const bool dust = length < 0.9 * delta(P.sheet.u);
    ItemBox& item = (dust ? result.dust : result.among)
                        .emplace_back(ItemBox{
                            static_cast<int>(result.items.size()), dust ? kDust : parts.plane[k], {}, {}});
    result.items.push_back({k, static_cast<int>(result.sheets.size()) - 1});
    for (int axis = 0; axis < 6; ++axis) {
      item.low[axis] = static_cast<float>(place.low[axis] - (place.play[axis] + kToFloat));
      item.high[axis] = static_cast<float>(place.high[axis] + (place.play[axis] + kToFloat));
    }
  }
  if (result.dust.empty()) return;
  for (const ItemBox& item : result.among) {
    const SheetPart P = result[item.item];
    if (!isWide(P.part, 1.1 * delta(P.sheet.u))) continue;
    result.dust.push_back(item);
    result.dust.back().group = kWide;
  }
}

bool Sheets::refine(const Places& near, std::span<ItemBox> boxes) const {
  constexpr std::size_t kMany = 1'024;
  if (boxes.size() < kMany) return false;
  glm::dvec3 from{0.0};
  for (int axis = 0; axis < 3; ++axis) {
    const auto at = [&](const ItemBox& b) { return near[b.item].sheet.centroid[axis]; };
    from[axis] = spreadOf(std::span<const ItemBox>{boxes}, at, at).middle;
  }
  std::vector<Place> places;
  places.reserve(boxes.size());
  for (const ItemBox& b : boxes) {
    const SheetPart P = near[b.item];
    places.push_back(placeOf(P, shapeOf(P).steepness, from, 2.0 * rounding.most(P.sheet.u)));
  }

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

bool Sheets::oneTooFar(const SheetPart& P, const SheetPart& Q) const {
  const double rho = rounding.most(std::max(P.sheet.u, Q.sheet.u));
  return std::ranges::any_of(parts.part(Q.part), [&](int c) {
    const glm::dvec3 apart = box.points[c] - P.sheet.centroid;
    return std::abs(glm::dot(P.sheet.plane.N, apart)) >
           Rounding::mostOff(rho, P.sheet.steepness, glm::length(apart));
  });
}

bool Sheets::parted(const SheetPart& P, const SheetPart& Q, const glm::dvec3& N) const {
  const glm::dvec3 n = glm::abs(N);
  const int dropped = n.z >= n.x && n.z >= n.y ? 2 : n.y >= n.x ? 1 : 0;
  return partedByEdgesOf(P, Q, dropped) || partedByEdgesOf(Q, P, dropped);
}

/// Asks the edges of the first part, seen along the axis `dropped`.
bool Sheets::partedByEdgesOf(const SheetPart& first, const SheetPart& second, int dropped) const {
  const double u = std::max(first.sheet.u, second.sheet.u);
  const auto P = parts.part(first.part), Q = parts.part(second.part);
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
