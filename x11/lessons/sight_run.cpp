#include <algorithm>
#include <cmath>

#include "depthsort/record/explain.h"
#include "depthsort/record/replay.h"
#include "x11/drawing/wording.h"
#include "x11/lessons/sight_pen.h"
#include "x11/scanline/scanline_page.h"
#include "x11/stepper/frames.h"
#include "x11/stepper/sort_wording.h"

namespace xnewell {

namespace {

/// Draws all tests of a pair, with numbers if they were made. Returns the next baseline.
int drawTests(SightPen& pen, const Explainer& explainer, const Event& e, int y) {
  constexpr int kAsks = 44, kNumbers = 324;  // pixels from the left
  const int x = pen.at.below.x, pitch = pen.at.compact ? 15 : 16;
  const std::vector<Test> made = explainer.testsMade(e);
  for (const TestRow& row : kTestRows) {
    if (row.id == Test::SamePlane) continue;
    const bool reached = std::ranges::find(made, row.id) != made.end();
    const bool settles = reached && row.id == made.back();
    if (settles && e.verdict != Verdict::Crossing)
      pen.paint.tick(x + 2, y - 8, pen(Cell::Good));
    else if (reached)
      pen.paint.cross(x + 2, y - 8, pen(Cell::Alarm));
    const Cell ink = !reached ? Cell::Faint : settles ? Cell::Ink : Cell::Soft;
    pen.paint.text(x + 20, y, row.name, pen(ink));
    pen.paint.text(x + kAsks, y, row.asks, pen(ink), settles ? Voice::Bold : Voice::Plain);
    if (reached)
      pen.paint.text(x + kNumbers, y, numbersThatFit(explainer, e, row.id, pen.right() - x - kNumbers),
                     pen(ink));
    y += pitch;
  }
  return y;
}

/// Draws the list of polygons that are not painted yet, in the order in which they are taken, with their
/// z-extents to scale.
void drawList(SightPen& pen, const Explainer& explainer, const Event& e, int y) {
  const SortedScene& run = *pen.sight.run;
  const int bottom = pen.at.below.y + pen.at.below.height, pitch = 16;
  Replay replay{pen.sight.picture.snapped(), run};
  replay.goTo(pen.sight.step);
  const std::vector<Replay::Listed> list = replay.list(std::max(0, (bottom - y) / pitch));
  Range all = explainer.zExtent(e.P);
  for (int face = 0; face < static_cast<int>(pen.sight.picture.snapped().faces.size()); ++face) {
    const Range z = explainer.zExtent(face);
    all = {std::min(all.low, z.low), std::max(all.high, z.high)};
  }
  const int x = pen.at.below.x, left = x + kNameWidth + 44, width = pen.right() - left;
  const auto place = [&](double z) {
    return left + static_cast<int>(std::lround((z - all.low) / std::max(1e-9, all.high - all.low) * width));
  };
  pen.caps(x, y, "the list");
  pen.soft(left, y, "far");
  pen.softRight(pen.right(), y, "near");
  for (const auto& [id, marked] : list) {
    if ((y += pitch) > bottom) break;
    if (marked) pen.paint.triangle(x + 2, y - 8, 5, Direction::Right, pen(Cell::Ink));
    const int end = pen.ink(x + 16, y, explainer.name(id));
    if (marked) pen.soft(end + 8, y, "marked");
    const Range z = explainer.zExtent(id);
    pen.paint.fillRect({left, y - 8, width, 7}, pen(Cell::Rule));
    pen.paint.fillRect({place(z.low), y - 8, std::max(3, place(z.high) - place(z.low)), 7},
                       pen(id == e.P   ? Cell::P
                           : id == e.Q ? Cell::Q
                                       : Cell::Soft));
  }
}

}  // namespace

void drawRun(SightPen& pen) {
  const Sight& sight = pen.sight;
  const Rect& at = pen.at.picture;
  const SortedScene& run = *sight.run;
  Frames frames{sight.picture, run, true, {sight.step}, sight.plan, pen.paint.unit()};
  pen.paint.within(at).place(frames.at(sight.step), at.x, at.y);

  const Event& e = run.events[sight.step - 1];
  const Explainer explainer{sight.picture.scene().mesh, sight.picture.snapped(), run, true};
  int splits = 0;
  for (int k = 0; k + 1 < sight.step; ++k) splits += run.events[k].kind == Event::Kind::Split;
  const int x = pen.at.below.x;
  int y = pen.section("step " + std::to_string(sight.step) + " of " + std::to_string(run.events.size()));
  int name = pen.paint.textRight(pen.right(), pen.at.below.y + 17, explainer.name(e.P), pen(Cell::Ink));
  const auto legend = [&](Cell cell, std::string_view letter, int before) {
    const int swatch = pen.softRight(before - 6, pen.at.below.y + 17, letter) - 16;
    pen.paint.fillRect({swatch, pen.at.below.y + 8, 10, 10}, pen(cell));
    pen.paint.frame({swatch, pen.at.below.y + 8, 10, 10}, pen(Cell::Ink));
    return swatch - 16;
  };
  if (e.Q >= 0) {
    pen.paint.fillRect({name, pen.at.below.y + 5, pen.right() - name, 16}, pen(Cell::Paper));
    name = pen.paint.textRight(pen.right(), pen.at.below.y + 17, explainer.name(e.Q), pen(Cell::Ink));
    const int before = legend(Cell::Q, "Q", name);
    name = pen.paint.textRight(before, pen.at.below.y + 17, explainer.name(e.P), pen(Cell::Ink));
  }
  legend(Cell::P, "P", name);
  if (e.kind == Event::Kind::Compare) y = drawTests(pen, explainer, e, y) + 3;
  for (const std::string& line : broken(explainer.sentence(e, splits), pen.at.below.width / 6)) {
    pen.ink(x, y, line);
    y += 15;
  }
  if (e.kind != Event::Kind::Compare) drawList(pen, explainer, e, y + 8);
}

void drawFilling(SightPen& pen) {
  const Exhibit& exhibit = pen.sight.exhibit;
  if (exhibit.names.empty()) return;
  const auto run = scanlineOfFace(pen.sight.picture, exhibit.names.front().face, exhibit.stepBits);
  if (!run || run->steps() == 0) return;
  // A step in the second half of a row, so that the charts have something to show.
  int step = static_cast<int>(exhibit.filled * run->steps());
  if (step > 0) {
    const ScanSample& at = run->samples()[static_cast<std::size_t>(step - 1)];
    const ScanSpan& span = run->spanOf(at);
    step = std::min(run->steps(), step + std::max(0, span.from + (span.to - span.from) * 2 / 3 - at.column));
  }
  // Its outline in the picture.
  Painter inside = pen.paint.within(pen.at.picture);
  for (const ScanPart& part : run->parts())
    for (std::size_t k = 0; k < part.outline.size(); ++k) {
      const auto place = [&](std::size_t v) {
        const glm::ivec3& p = part.outline[v % part.outline.size()];
        return glm::ivec2{pen.at.picture.x + p.x / kGrid / pen.paint.unit(),
                          pen.at.picture.y + p.y / kGrid / pen.paint.unit()};
      };
      inside.line(place(k).x, place(k).y, place(k + 1).x, place(k + 1).y, pen(Cell::White));
    }
  const int first = pen.section("face " + exhibit.names.front().name + ", pixel by pixel");
  pen.softRight(pen.right(), first - 22, std::to_string(exhibit.stepBits) + " bits after the point");
  drawScanlineSight(
      pen,
      {pen.at.below.x, first - 8, pen.at.below.width, pen.at.below.height - (first - 8 - pen.at.below.y)},
      *run, step);
}

}  // namespace xnewell
