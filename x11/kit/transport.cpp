#include "x11/kit/transport.h"

#include <cmath>

#include "x11/drawing/wording.h"

namespace xnewell {

TransportLayout layoutOfTransport(const Rect& body, bool compact, bool narrow,
                                  std::span<const std::string> kinds) {
  TransportLayout at;
  at.compact = compact, at.narrow = narrow, at.left = body.x;
  at.rule = body.y + body.height - transportHeight(compact);
  const int top = at.rule + (compact ? 4 : 6), height = compact ? 20 : 22, gap = narrow ? 2 : 4;
  int x = body.x;
  for (int k = 0; k < kTransport; ++k) {
    const int width = narrow ? (k == kPlay ? 32 : 22) : (k == kPlay ? 44 : 28);
    at.transport[k] = {x, top, width, height};
    x += width + gap;
  }
  const int track = narrow ? 130 : 168, words = narrow ? 42 : 82, left = body.x + body.width - track;
  const int middle = top + height / 2;
  at.speed = {.area = {left - words, middle - 8, words + track + 5, 17},
              .track = {left, middle - 1, track, 2},
              .grip = {left - 5, middle - 8, track + 10, 17},  // the thumb reaches beyond both ends
              .bare = true};
  const int end = left - (narrow ? 48 : 92);
  int right = end;
  at.kinds.options.resize(kinds.size());
  for (std::size_t k = kinds.size(); k-- > 0;) {
    const int width = textWidth(kinds[k]) + 13;
    right -= width;
    at.kinds.options[k] = {right, middle - 10, width, 19};
  }
  at.kinds.area = {right, middle - 10, end - right, 19};
  at.kinds.bare = true;
  at.step = {x + 10, top, right - (narrow ? 4 : 62) - (x + 10), height};
  const int lanes = at.rule + (compact ? 28 : 35);
  at.timeline = {body.x + 68, lanes, body.width - 68, body.y + body.height - lanes - (compact ? 4 : 9)};
  return at;
}

int columnOf(const Rect& timeline, int step, int steps) {
  const double share = static_cast<double>(step) / std::max(1, steps);
  return timeline.x + static_cast<int>(std::lround(share * (timeline.width - 1)));
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

void drawButton(Pen& pen, const Rect& r, const Icon& icon, bool hovered) {
  pen.paint.fillRect(r, pen(hovered ? Cell::White : Cell::Panel));
  pen.paint.frame(r, pen(Cell::Faint));
  pen.paint.hline(r.x + 1, r.y + 1, r.width - 2, pen(Cell::White));
  pen.paint.vline(r.x + 1, r.y + 1, r.height - 2, pen(Cell::White));
  pen.rule(r.x + 1, r.y + r.height - 2, r.width - 2);
  pen.paint.vline(r.x + r.width - 2, r.y + 1, r.height - 2, pen(Cell::Rule));
  const int top = r.y + r.height / 2 - 4;
  for (const auto& [shape, at] : icon) {
    const int x = r.x + r.width / 2 + at;
    if (shape == '|') pen.paint.fillRect({x, top, 2, 9}, pen(Cell::Ink));
    if (shape == '<') pen.paint.triangle(x, top, 5, Direction::Left, pen(Cell::Ink));
    if (shape == '>') pen.paint.triangle(x, top, 5, Direction::Right, pen(Cell::Ink));
  }
}

void drawSpeed(Pen& pen, const TransportLayout& at, double speed, int y, const Look& look) {
  const ControlPlace& place = at.speed;
  if (look.focused) drawFocus(pen, place.area);
  if (!at.narrow) pen.ink(place.track.x - 80, y, "speed");
  pen.boldRight(place.track.x - 8, y, fixed(speed, speed < 10.0 ? 1 : 0) + "/s");
  drawTrack(pen, place, shareOf(kSpeeds, speed), {}, true, look);
}

}  // namespace

Control timelineControl(const TransportState& state, std::function<void(int step)> moveTo,
                        std::function<void(int steps)> by) {
  return {.kind = Control::Kind::Slider,
          .part = transportId(TransportPart::Timeline).part,
          .label = "step",
          .is = "the step that is shown",
          .value = static_cast<double>(state.step),
          .range = {0, static_cast<double>(state.steps), 1, false, 0},
          .set = [moveTo = std::move(moveTo)](double step) { moveTo(static_cast<int>(step)); },
          .move = [by = std::move(by)](int along, int up) { by(along + up); }};
}

Controls transportControls(const TransportState& state, Control kinds, double& speed,
                           const std::function<void(int step)>& moveTo,
                           const std::function<void(int steps)>& by,
                           const std::function<void(const Key&)>& press) {
  Controls all{timelineControl(state, moveTo, by),
               {.kind = Control::Kind::Slider,
                .part = transportId(TransportPart::Speed).part,
                .label = "speed",
                .is = "steps a second",
                .value = speed,
                .range = kSpeeds,
                .set = [&speed](double steps) { speed = steps; }},
               std::move(kinds)};
  for (int k = 0; k < kTransport; ++k)
    all.push_back({.kind = Control::Kind::Button,
                   .part = transportId(TransportPart::Button, k).part,
                   .set = [press, k](double) { press(kTransportKeys[k]); }});
  return all;
}

void placeTransport(ControlList& list, const TransportLayout& at) {
  list.place(transportId(TransportPart::Timeline),
             {.area = at.timeline, .track = at.timeline, .grip = at.timeline, .bare = true});
  list.place(transportId(TransportPart::Speed), at.speed);
  list.place(transportId(TransportPart::Kinds), at.kinds);
  for (int k = 0; k < kTransport; ++k)
    list.place(transportId(TransportPart::Button, k), {.area = at.transport[k], .bare = true});
}

void drawTransport(Pen& pen, const TransportLayout& layout, const TransportState& state, const Control& kinds,
                   const ControlList* list) {
  const auto look = [list](TransportPart part, int index = 0) {
    return list ? list->look(transportId(part, index)) : Look{};
  };
  for (int k = 0; k < kTransport; ++k)
    drawButton(pen, layout.transport[k], k == kPlay && state.playing ? kStopIcon : kIcons[k],
               look(TransportPart::Button, k).hovered);
  const Rect& at = layout.step;
  const int y = at.y + at.height / 2 + 4;
  const std::string now = grouped(state.step), of = " of " + grouped(state.steps);
  const bool word = at.width >= textWidth("step " + now + of);
  int x = at.x;
  if (word) x = pen.ink(x, y, "step ");
  x = pen.bold(x, y, now);
  if (x + textWidth(of) <= at.x + at.width) pen.soft(x, y, of);
  if (!layout.narrow) pen.ink(layout.kinds.area.x - 54, y, "jump to");
  drawControl(pen, kinds, layout.kinds, look(TransportPart::Kinds));
  drawSpeed(pen, layout, state.speed, y, look(TransportPart::Speed));
}

void drawTimeline(Pen& pen, const TransportLayout& layout, const TransportState& state,
                  std::span<const Lane> lanes) {
  const Rect& at = layout.timeline;
  const int head = columnOf(at, state.step, state.steps), count = static_cast<int>(lanes.size());
  pen.paint.fillRect({at.x, at.y, head - at.x, at.height}, pen(Cell::White));
  for (int k = 0; k < count; ++k) {
    const Lane& lane = lanes[static_cast<std::size_t>(k)];
    const int top = at.y + k * at.height / count, bottom = at.y + (k + 1) * at.height / count;
    pen.soft(layout.left, bottom - 3, lane.name);
    pen.rule(at.x, bottom - 1, at.width);
    std::vector<int> marks(at.width, 0), done(at.width, 0);
    for (const int step : lane.steps) {
      const int column = columnOf(at, step, state.steps) - at.x;
      ++marks[column];
      done[column] |= step <= state.step;
    }
    const int most = std::max(1, *std::ranges::max_element(marks)), height = bottom - top - 5;
    for (int i = 0; i < at.width; ++i) {
      if (marks[i] == 0 || (state.asking && !done[i])) continue;
      const int high = lane.many ? std::max(3, height * marks[i] / most) : height;
      const int width = lane.ahead ? 3 : lane.many || i + 1 == at.width ? 1 : 2;
      const int from =
          lane.ahead ? std::clamp(i - 1, 0, at.width - 3) : i;  // wider than the line of the step
      pen.paint.fillRect({at.x + from, bottom - 2 - high, width, high},
                         pen(done[i] || lane.ahead ? lane.cell : Cell::Faint));
    }
  }
  pen.paint.vline(head, at.y - 4, at.height + 4, pen(Cell::Ink));
  pen.paint.triangle(head - 4, at.y - 4, 5, Direction::Down, pen(Cell::Ink));
}

void appendTransportKeys(KeyTable& table, bool playing, const TransportActs& acts) {
  const auto add = [&](Key key, std::string legend, const char* does, std::string off, auto act) {
    append(table, {{{key}, std::move(legend), does, [act](const Key&) { act(); }, std::move(off)}});
  };
  const char* const atStart = acts.atStart ? "This is the start of the run." : "";
  const char* const atEnd = acts.atEnd ? "This is the end of the run." : "";
  const auto by = [&acts](int steps) {
    return [by = acts.by, steps](const Key& key) { by(key.shift ? kShiftSteps * steps : steps); };
  };
  const char* const steps = "a step back or forward; Shift: ten steps";
  append(table, {{{NamedKey::Left}, "step", steps, by(-1), atStart},
                 {{NamedKey::Right}, "step", steps, by(1), atEnd}});
  add(NamedKey::Space, playing ? "stop" : "play", "play, stop", acts.nothing, acts.play);
  const char* const ends = "the start of the run, its end";
  add(NamedKey::Home, "start", ends, atStart, acts.start);
  add(NamedKey::End, "end", ends, atEnd, acts.end);
  const char* const jumps = "the next step of the kind, the one before";
  add('j', "next of kind", jumps, acts.whyNoJump(true), [jump = acts.jump] { jump(true); });
  add('J', "back", jumps, acts.whyNoJump(false), [jump = acts.jump] { jump(false); });
  add('K', "kind", "the next kind of step", "", acts.nextKind);
  add('g', "go to step", "go to a step by its number", "", acts.askStep);
}

void appendSpeedKeys(KeyTable& table, double& speed) {
  const auto add = [&](char key, int presses, const char* off) {
    append(table, {{{key},
                    "speed",
                    "slower, faster",
                    [&speed, presses](const Key&) { speed = stepped(kSpeeds, speed, presses); },
                    off}});
  };
  add('-', -1, speed <= kSpeeds.low ? "This is the lowest speed." : "");
  add('+', 1, speed >= kSpeeds.high ? "This is the highest speed." : "");
}

}  // namespace xnewell
