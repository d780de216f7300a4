#include "x11/stepper/outline.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace xnewell {

namespace {

// The coordinates of Painter end at 2^24; dashes need lengths below half the range of int.
constexpr double kFarthestDrawn = 1 << 20;

/// Cuts a segment to the part near the image; false if there is none. Liang and Barsky 1984.
bool nearImage(Place& from, Place& to) {
  const double dx = to.x - from.x, dy = to.y - from.y;
  double enters = 0.0, leaves = 1.0;
  const auto clip = [&](double slope, double room) {  // slope * t <= room
    if (slope == 0.0) return room >= 0.0;
    const double t = room / slope;
    (slope < 0.0 ? enters : leaves) = slope < 0.0 ? std::max(enters, t) : std::min(leaves, t);
    return enters <= leaves;
  };
  if (!clip(-dx, from.x + kFarthestDrawn) || !clip(dx, kFarthestDrawn - from.x) ||
      !clip(-dy, from.y + kFarthestDrawn) || !clip(dy, kFarthestDrawn - from.y))
    return false;
  const Place start = from;
  if (enters > 0.0) from = {start.x + enters * dx, start.y + enters * dy};
  if (leaves < 1.0) to = {start.x + leaves * dx, start.y + leaves * dy};
  return true;
}

int pixel(double v) { return static_cast<int>(std::floor(v)); }

}  // namespace

Outline outlineOf(const Region& region) {
  Outline figure;
  for (const Side& side : region) figure.push_back({side.corner.x / kGrid, side.corner.y / kGrid});
  return figure;
}

Place middleOf(const Outline& figure) {
  Place middle;
  for (const Place& p : figure) {
    middle.x += p.x / static_cast<double>(figure.size());
    middle.y += p.y / static_cast<double>(figure.size());
  }
  return middle;
}

void segment(Painter& painter, Place from, Place to, std::uint8_t cell, const LineStyle& style) {
  if (!nearImage(from, to)) return;
  painter.line(pixel(from.x), pixel(from.y), pixel(to.x), pixel(to.y), cell, style);
}

void outline(Painter& painter, const Outline& figure, std::uint8_t cell, const LineStyle& style) {
  if (figure.empty()) return;
  Place from = figure.back();
  for (const Place& to : figure) {
    segment(painter, from, to, cell, style);
    from = to;
  }
}

void tint(Painter& painter, const Rect& area, const Outline& figure, Stipple stipple, std::uint8_t cell) {
  for (int j = area.y; j < area.y + area.height; ++j) {
    const double y = j + 0.5;
    double left = kFarthestDrawn, right = -kFarthestDrawn;
    for (std::size_t k = 0; k < figure.size(); ++k) {
      const Place &a = figure[k], &b = figure[k + 1 == figure.size() ? 0 : k + 1];
      if ((a.y <= y) == (b.y <= y)) continue;
      const double x = a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x);
      left = std::min(left, x), right = std::max(right, x);
    }
    const int from = std::max(area.x, static_cast<int>(std::ceil(std::max(left, -kFarthestDrawn) - 0.5)));
    const int to =
        std::min(area.x + area.width, static_cast<int>(std::ceil(std::min(right, kFarthestDrawn) - 0.5)));
    painter.stipple({from, j, to - from, 1}, stipple, cell);
  }
}

std::optional<Chord> zeroLine(const Outline& figure, const std::vector<double>& values) {
  assert(figure.size() == values.size());
  std::vector<Place> ends;
  for (std::size_t k = 0; k < figure.size() && ends.size() < 2; ++k) {
    const std::size_t next = k + 1 == figure.size() ? 0 : k + 1;
    const double a = values[k], b = values[next];
    if ((a < 0.0) == (b < 0.0)) continue;
    const double t = a / (a - b);
    ends.push_back(
        {figure[k].x + t * (figure[next].x - figure[k].x), figure[k].y + t * (figure[next].y - figure[k].y)});
  }
  if (ends.size() < 2) return std::nullopt;
  return Chord{ends[0], ends[1]};
}

}  // namespace xnewell
