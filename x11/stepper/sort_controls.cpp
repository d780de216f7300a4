#include <algorithm>
#include <cmath>

#include "x11/drawing/wording.h"
#include "x11/stepper/sort_pen.h"
#include "x11/stepper/sort_wording.h"

namespace xnewell {

namespace {

void drawToggle(SortPen& pen, int index, bool on) {
  const Rect& r = pen.at.toggles[index];
  const int y = r.y + pen.at.line - 4;
  const Rect box{r.x, y - 10, 11, 11};
  pen.paint.fillRect(box, pen(pen.hovers(SortPart::Toggle, index) ? Cell::Focus : Cell::White));
  pen.paint.frame(box, pen(Cell::Ink));
  if (on) pen.paint.tick(box.x + 2, box.y + 2, pen(Cell::Ink));
  pen.ink(r.x + 17, y, kToggleNames[index]);
  if (pen.view.numbered && index < kStops)
    pen.paint.keyCap(r.x - 19, y - 11, std::to_string(index + 1),
                     {pen(Cell::Focus), pen(Cell::Rule), pen(Cell::Faint), pen(Cell::Ink)});
}

void bar(SortPen& pen, int x, int middle) { pen.paint.fillRect({x, middle - 4, 2, 9}, pen(Cell::Ink)); }

void drawIcon(SortPen& pen, Transport button, const Rect& r) {
  const int cx = r.x + r.width / 2, cy = r.y + r.height / 2;
  const auto left = [&](int x) { pen.paint.triangle(x, cy - 4, 5, Direction::Left, pen(Cell::Ink)); };
  const auto right = [&](int x) { pen.paint.triangle(x, cy - 4, 5, Direction::Right, pen(Cell::Ink)); };
  switch (button) {
    case Transport::Start:
      bar(pen, cx - 5, cy);
      return left(cx - 1);
    case Transport::TenBack:
      left(cx - 6);
      return left(cx);
    case Transport::Back:
      return left(cx - 3);
    case Transport::Play:
      if (!pen.view.playing) return right(cx - 2);
      bar(pen, cx - 4, cy);
      return bar(pen, cx + 2, cy);
    case Transport::Forward:
      return right(cx - 2);
    case Transport::TenForward:
      right(cx - 5);
      return right(cx + 1);
    case Transport::End:
      right(cx - 4);
      return bar(pen, cx + 3, cy);
  }
}

void drawButton(SortPen& pen, int index) {
  const Rect& r = pen.at.transport[index];
  pen.paint.fillRect(r, pen(pen.hovers(SortPart::Transport, index) ? Cell::White : Cell::Panel));
  pen.paint.frame(r, pen(Cell::Faint));
  pen.paint.hline(r.x + 1, r.y + 1, r.width - 2, pen(Cell::White));
  pen.paint.vline(r.x + 1, r.y + 1, r.height - 2, pen(Cell::White));
  pen.rule(r.x + 1, r.y + r.height - 2, r.width - 2);
  pen.paint.vline(r.x + r.width - 2, r.y + 1, r.height - 2, pen(Cell::Rule));
  drawIcon(pen, static_cast<Transport>(index), r);
}

void drawKinds(SortPen& pen, int y) {
  const Rect& first = pen.at.kinds.front();
  if (first.x - 54 > pen.at.step.x + pen.at.step.width) pen.ink(first.x - 54, y, "jump to");
  for (int k = 0; k < static_cast<int>(kLandmarks.size()); ++k) {
    const Rect& r = pen.at.kinds[k];
    const bool chosen = k == static_cast<int>(pen.view.kind), hovered = pen.hovers(SortPart::Kind, k);
    if (chosen || hovered) pen.paint.fillRect(r, pen(chosen ? Cell::White : Cell::Panel));
    if (chosen) {
      pen.paint.frame(r, pen(Cell::Ink));
      pen.bold(r.x + 6, y, kLandmarks[k].name);
    } else {
      const bool none = pen.run.landmarks().steps(kLandmarks[k].id).empty();
      pen.paint.text(r.x + 6, y, kLandmarks[k].name, pen(none ? Cell::Faint : Cell::Soft));
    }
  }
}

void drawSpeed(SortPen& pen, int y) {
  const Rect& track = pen.at.speed;
  const double speed = pen.view.speed;
  const int label = pen.paint.textRight(track.x - 8, y, fixed(speed, speed < 10.0 ? 1 : 0) + "/s",
                                        pen(Cell::Ink), Voice::Bold);
  const Rect& last = pen.at.kinds.back();
  if (track.x - 82 > last.x + last.width) pen.ink(std::min(track.x - 80, label - 36), y, "speed");
  drawTrack(pen, track.x, track.y + 11, track.width - 1,
            {.share = double(columnOfSpeed(track, speed) - track.x) / std::max(1, track.width - 1),
             .hovered = pen.hovers(SortPart::Speed, 0),
             .dragged = pen.view.dragged});
}

struct Lane {
  Landmark kind;
  std::string_view name;
};
constexpr std::array kTimelineLanes{Lane{Landmark::Move, "moves"}, Lane{Landmark::Cycle, "cycles"},
                                    Lane{Landmark::Cut, "cuts"}, Lane{Landmark::Paint, "paint"}};

}  // namespace

void drawCounts(SortPen& pen) {
  const Rect& at = pen.at.counts;
  const int line = pen.at.line, first = at.y + at.height - 5 * line,
            heading = first - (pen.at.compact ? 4 : 10);
  pen.rule(at.x, at.y - (pen.at.compact ? 1 : 4), at.width);
  pen.caps(at.x, heading, "SO FAR");
  pen.caps(pen.at.toggles[0].x, heading, "STOP AT");

  const int step = pen.view.step, all = pen.run.steps();
  const Landmarks& landmarks = pen.run.landmarks();
  int y = first + line - 4;
  const auto row = [&](std::string_view name, int now, int total) {
    pen.soft(at.x, y, name);
    const int end = at.x + (at.width < 380 ? 84 : 95);
    pen.boldRight(end - 1, y, grouped(now));
    const std::string of = "of " + grouped(total);
    const int right = pen.at.toggles[0].x - 14;
    const bool room = !pen.view.numbered && end + 4 + textWidth(of) <= right;  // the key caps are there
    if (room) pen.softRight(right, y, of);
    y += line;
  };
  row("pairs", landmarks.pairs(step), landmarks.pairs(all));
  for (const Landmark kind : {Landmark::Move, Landmark::Cycle, Landmark::Cut, Landmark::Paint})
    row(kLandmarks[static_cast<int>(kind)].several, landmarks.count(kind, step), landmarks.count(kind, all));

  for (int k = 0; k < kStops; ++k) drawToggle(pen, k, pen.view.stops[k]);
  drawToggle(pen, kPredict, pen.view.predict);
  const Rect &polygon = pen.at.toggles[kPolygonStop], &predict = pen.at.toggles[kPredict];
  const int below = polygon.y + 2 * line - 4;
  if (pen.view.polygon) {
    const std::string face = fitting("face " + std::to_string(*pen.view.polygon), 90);
    if (pen.view.stops[kPolygonStop])
      pen.bold(polygon.x + 17, below, face);
    else
      pen.soft(polygon.x + 17, below, face);
  } else if (at.x + at.width - polygon.x > 100) {
    pen.soft(polygon.x + 17, below, "click one, or");
    pen.key(polygon.x + 17, below + line - 11, "/");
    pen.soft(polygon.x + 36, below + line, "number");
  }
  if (pen.view.asked > 0)
    pen.paint.textRight(at.x + at.width, predict.y - 4,
                        std::to_string(pen.view.right) + "/" + std::to_string(pen.view.asked) + " right",
                        pen(Cell::Soft));
}

void drawTransport(SortPen& pen) {
  for (int k = 0; k < kTransport; ++k) drawButton(pen, k);
  const Rect& at = pen.at.step;
  const int y = at.y + at.height / 2 + 4;
  const std::string now = grouped(pen.view.step), of = " of " + grouped(pen.run.steps());
  const bool word = at.width >= textWidth("step " + now + of);
  int x = at.x;
  if (word) x = pen.ink(x, y, "step ");
  x = pen.bold(x, y, now);
  if (x + textWidth(of) <= at.x + at.width) pen.soft(x, y, of);
  drawKinds(pen, y);
  drawSpeed(pen, y);
}

void drawTimeline(SortPen& pen) {
  const Rect& at = pen.at.timeline;
  const int steps = pen.run.steps(), head = columnOf(at, pen.view.step, steps);
  pen.paint.fillRect({at.x, at.y, head - at.x, at.height}, pen(Cell::White));
  const int lanes = static_cast<int>(kTimelineLanes.size());
  for (int k = 0; k < lanes; ++k) {
    const int top = at.y + k * at.height / lanes, bottom = at.y + (k + 1) * at.height / lanes;
    pen.soft(pen.at.body.x, bottom - 3, kTimelineLanes[k].name);
    pen.rule(at.x, bottom - 1, at.width);
    const bool paint = kTimelineLanes[k].kind == Landmark::Paint;
    std::vector<int> marks(at.width, 0), done(at.width, 0);
    for (const int step : pen.run.landmarks().steps(kTimelineLanes[k].kind)) {
      const int column = columnOf(at, step, steps) - at.x;
      ++marks[column];
      done[column] |= step <= pen.view.step;
    }
    const int most = std::max(1, *std::ranges::max_element(marks)), height = bottom - top - 5;
    for (int i = 0; i < at.width; ++i) {
      // Marks of later steps would give the answer away.
      if (marks[i] == 0 || (pen.view.asking && !done[i])) continue;
      const int high = paint ? std::max(3, height * marks[i] / most) : height;
      const Cell cell = !done[i]                                  ? Cell::Faint
                        : kTimelineLanes[k].kind == Landmark::Cut ? Cell::Alarm
                                                                  : Cell::Ink;
      const int width = paint || i + 1 == at.width ? 1 : 2;
      pen.paint.fillRect({at.x + i, bottom - 2 - high, width, high}, pen(cell));
    }
  }
  pen.paint.vline(head, at.y - 4, at.height + 4, pen(Cell::Ink));
  pen.paint.triangle(head - 4, at.y - 4, 5, Direction::Down, pen(Cell::Ink));
}

}  // namespace xnewell
