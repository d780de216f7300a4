#include "x11/stepper/sort_layout.h"

#include <algorithm>

#include "x11/drawing/painter.h"
#include "x11/drawing/sheet.h"
#include "x11/drawing/wording.h"
#include "x11/stepper/sort_pen.h"
#include "x11/stepper/sort_wording.h"

namespace xnewell {

namespace {

constexpr int kGutter = 16, kTestRowsShown = 8;
constexpr int kHeadline = 30;
constexpr int kNarrowBelow = 900;  // pixels; a body narrower than this is narrow

void placeSidesAndList(SortLayout& at, int x, int width, int upper) {
  const int labels = at.compact ? 112 : 132;
  at.side = {x + labels, at.body.y, width - labels, upper * 22 / 100};
  const int top = at.side.y + at.side.height + (at.compact ? 30 : 42);
  const int rows = (at.counts.y - (at.compact ? 4 : 8) - top) / at.line - 1;  // the last line has words
  at.list = {x, top, width, rows * at.line};
  const int kept = std::max(3, rows * 2 / 5) * at.line;
  at.ring = {x, top + kept + at.line, width, at.list.height - kept};
}

void placeCounts(SortLayout& at, int x, int upper) {
  const Rect& body = at.body;
  const int width = body.x + body.width - x, counts = (at.compact ? 18 : 26) + 5 * at.line;
  at.counts = {x, body.y + upper - counts, width, counts};
  const bool narrow = width < 380;
  const int first = x + (narrow ? 160 : 168), second = x + (narrow ? 251 : 288);
  for (int k = 0; k < kToggleCount; ++k) {
    const int row = k < kPolygonStop ? k : k == kPolygonStop ? 0 : k == kOwn ? 3 : 4;
    const int left = k < kPolygonStop ? first : second;
    const int baseline = at.counts.y + counts - (4 - row) * at.line - 4;
    at.toggles[k] = {.x = left,
                     .y = baseline,
                     .area = {left, baseline + 4 - at.line, 17 + textWidth(kToggleNames[k]), at.line},
                     .box = {left, baseline - 10, 11, 11},
                     .style = {.boxAfterKey = true},
                     .bare = true};
  }
}

}  // namespace

SortLayout layoutOfSort(const Rect& body, bool shut, bool own) {
  static const std::vector<std::string> kinds = [] {
    std::vector<std::string> names;
    for (const LandmarkRow& row : kLandmarks) names.emplace_back(row.name);
    return names;
  }();
  SortLayout at;
  static_cast<TransportLayout&>(at) =
      layoutOfTransport(body, body.height < kCompactBelow, body.width < kNarrowBelow, kinds);
  at.body = body;
  at.shut = shut;
  at.line = !at.compact ? 16 : shut ? 15 : 14;
  const int upper = at.rule - body.y - (at.compact ? 4 : 8);

  const int left = (body.width + kGutter) * (shut ? 11 : 14) / (shut ? 20 : 24) - kGutter;
  const int right = body.x + left + kGutter;
  const int heading = at.compact ? 19 : 26;
  const int findings = (at.narrow || shut ? 4 : 3) * at.line + (at.compact ? 4 : 8);
  const int table = heading + kTestRowsShown * at.line, gap = at.compact ? 3 : 6;
  placeCounts(at, right, upper);
  if (shut) {
    at.headline = {body.x, body.y, body.width, kHeadline};
    at.picture = {body.x, body.y + kHeadline, left, upper - kHeadline};
    at.table = {right, at.picture.y, body.width - left - kGutter, table};
  } else {
    at.picture = {body.x, body.y, left, upper - table - gap - findings};
    at.table = {body.x, at.picture.y + at.picture.height, left, table};
    placeSidesAndList(at, right, body.width - left - kGutter, upper);
  }
  at.well = at.picture;
  at.heading = heading;
  const int given = own ? (kTestRowsShown - kOwnTests) * at.line : 0;
  at.table.height -= given;
  at.finding = {at.table.x, at.table.y + at.table.height + gap, at.table.width, findings + given};
  if (shut) {
    const int below = at.finding.y + at.finding.height + at.line;
    constexpr int kLeast = 70;
    if (const int room = at.counts.y - at.line - below; room >= kLeast)
      at.ring = {right, below, at.finding.width, room};
  }
  const int first = shut ? 3 : at.line + 3;  // the headline has the first line
  const auto inRows = [&](const auto& names, auto& places, int apart, int below) {
    int x = at.finding.x + 13, y = at.finding.y + first;
    for (std::size_t k = 0; k < names.size(); ++k) {
      const int width = kKeyCap + 6 + textWidth(names[k]);
      if (x + width > at.finding.x + at.finding.width) x = at.finding.x + 13, y += at.line + below;
      places[k] = {x, y, width, at.line + 2};
      x += width + apart;
    }
  };
  inRows(kAnswers, at.answers, shut ? 14 : 20, 0);
  inRows(kActs, at.acts, at.compact || shut ? 8 : 20, 4);
  return at;
}

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
