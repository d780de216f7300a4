#include <algorithm>

#include "x11/drawing/wording.h"
#include "x11/stepper/sort_pen.h"
#include "x11/stepper/sort_wording.h"

namespace xnewell {

Control kindsControl(const SortRun& run, const SortState& view) {
  Control kinds{.kind = Control::Kind::Choice,
                .part = transportId(TransportPart::Kinds).part,
                .label = "jump to",
                .is = "the kind of step to jump to",
                .value = static_cast<double>(view.kind)};
  for (const LandmarkRow& row : kLandmarks) {
    kinds.options.emplace_back(nameOf(run, row.id));
    kinds.lacking.push_back(run.landmarks().steps(row.id).empty());
  }
  return kinds;
}

Control toggleControl(const SortState& view, int index) {
  return {.kind = Control::Kind::Toggle,
          .part = sortId(SortPart::Toggle, index).part,
          .label = view.theirs && index == 0 ? "false step" : std::string{kToggleNames[index]},
          .value = (index == kPredict ? view.predict
                    : index == kOwn   ? view.own.has_value()
                                      : view.stops[index])
                       ? 1.0
                       : 0.0};
}

namespace {

struct KindOfLane {
  Landmark kind;
  std::string_view name;
};
constexpr std::array kTimelineLanes{KindOfLane{Landmark::Failed, "false"},
                                    KindOfLane{Landmark::Move, "moves"},
                                    KindOfLane{Landmark::Cycle, "cycles"}, KindOfLane{Landmark::Cut, "cuts"},
                                    KindOfLane{Landmark::Paint, "paint"}};

TransportState stateOf(const SortPen& pen) {
  return {pen.view.step, pen.run.steps(), pen.view.playing, pen.view.speed, pen.view.asking};
}

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
  row(pen.run.theirs() ? "tests" : "pairs", landmarks.pairs(step), landmarks.pairs(all));
  for (const Landmark kind : {Landmark::Move, Landmark::Cycle, Landmark::Cut, Landmark::Paint})
    row(kLandmarks[static_cast<int>(kind)].several, landmarks.count(kind, step), landmarks.count(kind, all));

  for (int k = 0; k < kToggleCount; ++k) {
    const ControlPlace& place = pen.at.toggles[k];
    drawControl(pen, toggleControl(pen.view, k), place, pen.look(SortPart::Toggle, k));
    if (pen.view.numbered && k < kStops)
      pen.paint.keyCap(place.x - 19, place.y - 11, std::to_string(k + 1),
                       {pen(Cell::Focus), pen(Cell::Rule), pen(Cell::Faint), pen(Cell::Ink)});
  }
  const Rect& polygon = pen.at.toggles[kPolygonStop].area;
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
  // The finding has it while the student sorts, unless it is put away.
  const Score& score = pen.view.own ? pen.view.own->score : pen.view.score;
  if (score.asked > 0 && (!pen.view.own || pen.at.shut))
    pen.paint.textRight(at.x + at.width, heading,
                        std::to_string(score.right) + "/" + std::to_string(score.asked) +
                            (pen.view.own ? " valid" : " right"),
                        pen(Cell::Soft));
}

void drawTransport(SortPen& pen) {
  drawTransport(pen, pen.at, stateOf(pen), kindsControl(pen.run, pen.view), pen.list);
}

void drawTimeline(SortPen& pen) {
  std::vector<Lane> lanes;
  const Landmark alarm = pen.run.theirs() ? Landmark::Failed : Landmark::Cut;
  // Other programs write no cycles, and ours no false steps.
  for (const KindOfLane& lane : kTimelineLanes)
    if (lane.kind != (pen.run.theirs() ? Landmark::Cycle : Landmark::Failed))
      lanes.push_back({lane.name, pen.run.landmarks().steps(lane.kind),
                       lane.kind == alarm ? Cell::Alarm : Cell::Ink, lane.kind == Landmark::Paint,
                       lane.kind == Landmark::Failed});
  drawTimeline(pen, pen.at, stateOf(pen), lanes);
}

}  // namespace xnewell
