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
  const auto counted = [&](double u) { return rounding.counted(std::ldexp(u, -box.exponent)); };
  for (const double u : mesh.rounding) coarsest = std::max(coarsest, counted(u));
  mostRounding_ = rounding.most(coarsest);
  for (int k = 0; k < parts.count(); ++k) {
    if (k > 0 && parts.plane[k] == parts.plane[k - 1]) {
      ++sheets.back().partCount;
      continue;
    }
    ModelSheet& sheet = sheets.emplace_back();
    sheet.firstPart = k;
    sheet.partCount = 1;
    sheet.u = counted(mesh.roundingOf(parts.face[k]));
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

std::vector<ItemBox> Sheets::places(const std::vector<int>& open) const {
  const glm::dvec3 from{0.43, 0.56, 0.47};
  std::vector<ItemBox> boxes;
  boxes.reserve(open.size() == sheets.size() ? parts.count() : 2 * open.size());
  for (const int s : open) {
    const ModelSheet& sheet = sheets[s];
    if (sheet.area == 0.0) continue;
    const glm::dvec3 foot = sheet.plane.N * (sheet.plane.d - glm::dot(sheet.plane.N, from));
    for (int k = sheet.firstPart; k < sheet.firstPart + sheet.partCount; ++k) {
      double steepness = sheet.steepness;
      if (sheet.partCount > 1) {
        const double area = glm::length(newellVector(box.points, parts.part(k)));
        if (area == 0.0) continue;
        steepness = 2.0 * perimeter(parts.part(k)) / area;
      }
      Box around;
      for (const int c : parts.part(k)) around.add(box.points[c]);
      const double distance =
          glm::length(glm::max(glm::abs(around.low - from), glm::abs(around.high - from)));
      const double play = (sheet.partCount == 1 ? 1.0 : 2.0) * mostRounding_ * (steepness * distance + 1.0);
      // Two feet are never more than 4 apart. Rounding a number up to 8 to float changes it by at most
      // 2^-22.
      const double nearFoot = std::min(play, 4.0) + 0x1p-22, nearby = mostRounding_ + 0x1p-22;
      ItemBox& place = boxes.emplace_back(ItemBox{k, parts.plane[k], {}, {}});
      for (int axis = 0; axis < 3; ++axis) {
        place.low[axis] = static_cast<float>(foot[axis] - nearFoot);
        place.high[axis] = static_cast<float>(foot[axis] + nearFoot);
        place.low[axis + 3] = static_cast<float>(around.low[axis] - nearby);
        place.high[axis + 3] = static_cast<float>(around.high[axis] + nearby);
      }
    }
  }
  return boxes;
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
  const double delta = std::sqrt(2.0) * u + rounding.arithmetic();
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
