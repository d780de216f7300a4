#include <algorithm>
#include <cmath>

#include "x11/drawing/wording.h"
#include "x11/stepper/sort_pen.h"
#include "x11/stepper/sort_wording.h"

namespace xnewell {

Control kindsControl(const SortRun& run, const SortView& view) {
  Control kinds{.kind = Control::Kind::Choice,
                .part = sortId(SortPart::Kinds).part,
                .label = "jump to",
                .is = "the kind of step to jump to",
                .value = static_cast<double>(view.kind)};
  for (const LandmarkRow& row : kLandmarks) {
    kinds.options.emplace_back(row.name);
    kinds.lacking.push_back(run.landmarks().steps(row.id).empty());
  }
  return kinds;
}

Control toggleControl(const SortView& view, int index) {
  return {.kind = Control::Kind::Toggle,
          .part = sortId(SortPart::Toggle, index).part,
          .label = std::string{kToggleNames[index]},
          .value = (index == kPredict ? view.predict : view.stops[index]) ? 1.0 : 0.0};
}

namespace {

/// A bar or an arrow of an icon, and how far its left edge is from the middle.
struct Piece {
  char shape = 0;
  int at = 0;
};
using Icon = std::array<Piece, 2>;
constexpr std::array<Icon, kTransport> kIcons{{{{{'|', -5}, {'<', -1}}},
                                               {{{'<', -6}, {'<', 0}}},
                                               {{{'<', -3}}},
                                               {{{'>', -2}}},
                                               {{{'>', -2}}},
                                               {{{'>', -5}, {'>', 1}}},
                                               {{{'>', -4}, {'|', 3}}}}};
constexpr Icon kStopIcon{{{'|', -4}, {'|', 2}}};

void drawButton(SortPen& pen, int index) {
  const Rect& r = pen.at.transport[index];
  pen.paint.fillRect(r, pen(pen.look(SortPart::Transport, index).hovered ? Cell::White : Cell::Panel));
  pen.paint.frame(r, pen(Cell::Faint));
  pen.paint.hline(r.x + 1, r.y + 1, r.width - 2, pen(Cell::White));
  pen.paint.vline(r.x + 1, r.y + 1, r.height - 2, pen(Cell::White));
  pen.rule(r.x + 1, r.y + r.height - 2, r.width - 2);
  pen.paint.vline(r.x + r.width - 2, r.y + 1, r.height - 2, pen(Cell::Rule));
  const int top = r.y + r.height / 2 - 4;
  for (const auto& [shape, at] : index == kPlay && pen.view.playing ? kStopIcon : kIcons[index]) {
    const int x = r.x + r.width / 2 + at;
    if (shape == '|') pen.paint.fillRect({x, top, 2, 9}, pen(Cell::Ink));
    if (shape == '<') pen.paint.triangle(x, top, 5, Direction::Left, pen(Cell::Ink));
    if (shape == '>') pen.paint.triangle(x, top, 5, Direction::Right, pen(Cell::Ink));
  }
}

void drawKinds(SortPen& pen, int y) {
  if (!pen.at.narrow) pen.ink(pen.at.kinds.area.x - 54, y, "jump to");
  drawControl(pen, kindsControl(pen.run, pen.view), pen.at.kinds, pen.look(SortPart::Kinds));
}

void drawSpeed(SortPen& pen, int y) {
  const ControlPlace& place = pen.at.speed;
  const Look look = pen.look(SortPart::Speed);
  const double speed = pen.view.speed;
  if (look.focused) drawFocus(pen, place.area);
  if (!pen.at.narrow) pen.ink(place.track.x - 80, y, "speed");
  pen.boldRight(place.track.x - 8, y, fixed(speed, speed < 10.0 ? 1 : 0) + "/s");
  drawTrack(pen, place, shareOf(kSpeeds, speed), {}, true, look);
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
  pen.caps(pen.at.toggles[0].area.x, heading, "STOP AT");

  const int step = pen.view.step, all = pen.run.steps();
  const Landmarks& landmarks = pen.run.landmarks();
  int y = first + line - 4;
  const auto row = [&](std::string_view name, int now, int total) {
    pen.soft(at.x, y, name);
    const int end = at.x + (at.width < 380 ? 84 : 95);
    pen.boldRight(end - 1, y, grouped(now));
    const std::string of = "of " + grouped(total);
    const int right = pen.at.toggles[0].area.x - 14;
    const bool room = !pen.view.numbered && end + 4 + textWidth(of) <= right;  // the key caps are there
    if (room) pen.softRight(right, y, of);
    y += line;
  };
  row("pairs", landmarks.pairs(step), landmarks.pairs(all));
  for (const Landmark kind : {Landmark::Move, Landmark::Cycle, Landmark::Cut, Landmark::Paint})
    row(kLandmarks[static_cast<int>(kind)].several, landmarks.count(kind, step), landmarks.count(kind, all));

  for (int k = 0; k < kToggleCount; ++k) {
    const ControlPlace& place = pen.at.toggles[k];
    drawControl(pen, toggleControl(pen.view, k), place, pen.look(SortPart::Toggle, k));
    if (pen.view.numbered && k < kStops)
      pen.paint.keyCap(place.x - 19, place.y - 11, std::to_string(k + 1),
                       {pen(Cell::Focus), pen(Cell::Rule), pen(Cell::Faint), pen(Cell::Ink)});
  }
  const Rect &polygon = pen.at.toggles[kPolygonStop].area, &predict = pen.at.toggles[kPredict].area;
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
  if (const Score& score = pen.view.score; score.asked > 0)
    pen.paint.textRight(at.x + at.width, predict.y - 4,
                        std::to_string(score.right) + "/" + std::to_string(score.asked) + " right",
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
