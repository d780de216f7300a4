#include <algorithm>
#include <cmath>
#include <limits>

#include "depthsort/record/explain.h"
#include "shading/laboratory/profile.h"
#include "x11/drawing/wording.h"
#include "x11/lessons/sight_pen.h"
#include "x11/views/plot.h"

namespace xnewell {

namespace {

/// What these z-extents say about an order.
std::string remarkOn(const std::vector<Range>& extents) {
  int same = 0, overlap = 0, pairs = 0;
  for (std::size_t p = 0; p < extents.size(); ++p)
    for (std::size_t q = 0; q < p; ++q) {
      const Range &P = extents[p], &Q = extents[q];
      const double close = 0.02 * std::max(P.high - P.low, Q.high - Q.low);
      same += std::abs(P.low - Q.low) <= close && std::abs(P.high - Q.high) <= close;
      overlap += std::max(P.low, Q.low) <= std::min(P.high, Q.high);
      ++pairs;
    }
  if (pairs == 0) return "";
  if (same == pairs) return "The extents are the same: z alone cannot say which is farthest.";
  if (overlap == 0) return "No two extents overlap: z alone says which goes first.";
  return overlap == pairs ? "All extents overlap: z alone cannot say which goes first."
                          : "Where two extents overlap, z alone cannot say which goes first.";
}

}  // namespace

void drawExtents(SightPen& pen) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const SnappedScene& snapped = pen.sight.picture.snapped();
  std::vector<Range> extents(pen.sight.exhibit.names.size(), {kNone, -kNone});
  Range all{kNone, -kNone};
  const auto take = [](Range& r, double z) { r = {std::min(r.low, z), std::max(r.high, z)}; };
  for (const SnappedFace& face : snapped.faces)
    for (int corner = face.first; corner < face.first + face.count; ++corner) {
      const int z = snapped.vertices[corner].z;
      take(all, z);
      for (std::size_t k = 0; k < extents.size(); ++k)
        if (pen.sight.exhibit.names[k].face == face.number) take(extents[k], z);
    }
  int y = pen.section("z-extents");
  const int left = pen.at.below.x + kNameWidth, width = pen.right() - left;
  pen.soft(left, pen.at.below.y + 17, "far");
  pen.softRight(pen.right(), pen.at.below.y + 17, "near");
  const int pitch = pen.at.compact ? 21 : 22;
  const double span = std::max(1.0, all.high - all.low), margin = 0.06 * span;
  const auto place = [&](double z) {
    return left + static_cast<int>(std::lround((z - all.low + margin) / (span + 2 * margin) * width));
  };
  for (std::size_t k = 0; k < extents.size(); ++k, y += pitch) {
    pen.plate(pen.at.below.x + 9, y - 5, pen.sight.exhibit.names[k].name, Cell::Ink, Cell::White, 8);
    pen.paint.fillRect({left, y - 9, width, 9}, pen(Cell::Rule));
    if (extents[k].low > extents[k].high) continue;
    const int from = place(extents[k].low);
    pen.paint.fillRect({from, y - 9, std::max(3, place(extents[k].high) - from), 9}, pen(Cell::Soft));
  }
  pen.softRight(pen.right(), y, remarkOn(extents));
}

void drawCurves(SightPen& pen) {
  const Sight& sight = pen.sight;
  const Rect& below = pen.at.below;
  pen.section("what the cells hold");
  const CellRange cells = sceneCells(sight.picture);
  const int half = (below.width - 16) / 2, top = below.y + 34, height = below.height - 34 - kPlotBelow;
  const int nameRoom = kPlotRight;
  const auto area = [&](int x) { return Rect{x + kPlotLeft, top, half - kPlotLeft - nameRoom, height}; };
  const int second = below.x + half + 16;
  pen.softRight(below.x + half, below.y + 17, "of 255");
  pen.caps(second, below.y + 17, "step to the next");
  pen.paint.textRight(pen.right(), below.y + 17, pen.at.compact ? "%" : "per cent brighter", pen(Cell::Soft));

  drawPlot(pen.paint, sight.plan, area(below.x),
           {.cells = cells,
            .ticks = {0, 64, 128, 192, 255},
            .curves = storedCurves(sight.picture, sight.palette)});
  drawPlot(pen.paint, sight.plan, area(second),
           {.cells = cells,
            .ticks = {0.1, 1, 10, 100},
            .logarithmic = true,
            .curves = stepCurves(sight.picture, sight.palette),
            .level = kSeenStep,
            .levelName = "the eye"});
}

/// Draws, for each method and exactly under the columns of the picture, the row as a strip and its intensity.
void drawProfiles(SightPen& pen) {
  const Sight& sight = pen.sight;
  const Rect &below = pen.at.below, &at = pen.at.picture;
  const int row = defaultScanline(sight.picture), unit = pen.paint.unit();
  Painter fine = pen.paint.pixels();
  const Scanline line = scanlineOf(sight.picture, row, pen(Cell::Well));

  const int marked = at.y + row / unit;
  pen.paint.line(at.x, marked, at.x + at.width - 1, marked, pen(Cell::White), {1, 4, 4});
  pen.section("row " + std::to_string(row) + " of the picture");
  if (!pen.at.compact)
    pen.softRight(pen.right(), below.y + 17, "the strip repeats the row, the curve is its intensity");
  const int block = (below.height - 24) / 3, strip = block * 2 / 5, curve = block - strip - 4;
  for (int k = 0; k < 3; ++k) {
    const Profile& profile = line.profiles[k];
    const int top = below.y + 24 + k * block;
    drawStrip(pen.paint, {at.x, top, at.width, strip}, profile.cells);
    pen.paint.fillRect({at.x, top + strip, at.width, curve}, pen(Cell::Panel));
    const int left = at.x * unit, base = (top + strip + curve - 2) * unit;
    int last = -1;
    for (int i = 0; i < at.width * unit; ++i) {
      if (std::isnan(profile.I[i])) {
        last = -1;
        continue;
      }
      const int y = base - static_cast<int>(std::lround(profile.I[i] * (curve - 4) * unit));
      fine.line(left + std::max(0, i - (last >= 0)), last >= 0 ? last : y, left + i, y, pen(Cell::Ink));
      last = y;
    }
    const std::string name{rowOf(profile.method).label};
    pen.paint.fillRect({at.x + 4, top + 3, textWidth(name) + 8, 15}, pen(Cell::Paper));
    pen.bold(at.x + 8, top + 14, name);
  }
}

}  // namespace xnewell
