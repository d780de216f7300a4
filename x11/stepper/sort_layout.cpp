#include "x11/stepper/sort_layout.h"

#include <algorithm>
#include <cmath>

#include "x11/drawing/painter.h"
#include "x11/drawing/sheet.h"

namespace xnewell {

namespace {

constexpr int kGutter = 16, kTestRowsShown = 8;
constexpr int kNarrowBelow = 900;  // pixels; a body narrower than this is narrow

void placeLower(SortLayout& at) {
  const Rect& body = at.body;
  const bool narrow = body.width < kNarrowBelow;
  const int top = at.rule + (at.compact ? 4 : 6), height = at.compact ? 20 : 22, gap = narrow ? 2 : 4;
  int x = body.x;
  for (int k = 0; k < kTransport; ++k) {
    const bool play = k == static_cast<int>(Transport::Play);
    const int width = narrow ? (play ? 32 : 22) : (play ? 44 : 28);
    at.transport[k] = {x, top, width, height};
    x += width + gap;
  }
  const int speedWidth = narrow ? 130 : 168;
  at.speed = {body.x + body.width - speedWidth, top + height / 2 - 7, speedWidth, 15};
  int right = at.speed.x - (narrow ? 48 : 92);
  for (int k = static_cast<int>(kLandmarks.size()); k-- > 0;) {
    const int width = textWidth(kLandmarks[k].name) + 13;
    right -= width;
    at.kinds[k] = {right, top + height / 2 - 9, width, 19};
  }
  at.step = {x + 10, top, right - (narrow ? 4 : 62) - (x + 10), height};
  const int lanes = at.rule + (at.compact ? 28 : 35);
  at.timeline = {body.x + 68, lanes, body.width - 68, body.y + body.height - lanes - (at.compact ? 4 : 9)};
}

void placeRight(SortLayout& at, int x, int upper) {
  const Rect& body = at.body;
  const int width = body.x + body.width - x, labels = at.compact ? 112 : 132;
  at.side = {x + labels, body.y, width - labels, upper * 22 / 100};
  const int counts = (at.compact ? 18 : 26) + 5 * at.line;
  at.counts = {x, body.y + upper - counts, width, counts};
  const int top = at.side.y + at.side.height + (at.compact ? 30 : 42);
  const int rows = (at.counts.y - (at.compact ? 4 : 8) - top) / at.line - 1;  // the last line has words
  at.list = {x, top, width, rows * at.line};

  const bool narrow = width < 380;
  const int first = x + (narrow ? 160 : 168), second = x + (narrow ? 251 : 288);
  for (int k = 0; k < kToggleCount; ++k) {
    const int row = k < kPolygonStop ? k : k == kPolygonStop ? 0 : 4;
    const int left = k < kPolygonStop ? first : second;
    at.toggles[k] = {left, at.counts.y + counts - (5 - row) * at.line, 17 + textWidth(kToggleNames[k]),
                     at.line};
  }
}

}  // namespace

SortLayout layoutOfSort(const Rect& body) {
  SortLayout at;
  at.body = body;
  at.compact = body.height < kCompactBelow;
  at.line = at.compact ? 14 : 16;
  const int lower = at.compact ? 84 : 104, upper = body.height - lower - (at.compact ? 4 : 8);
  at.rule = body.y + body.height - lower;

  const int left = (body.width + kGutter) * 7 / 12 - kGutter;
  const int heading = at.compact ? 19 : 26;
  const int findings = (body.width < kNarrowBelow ? 4 : 3) * at.line + (at.compact ? 4 : 8);
  const int table = heading + kTestRowsShown * at.line, gap = at.compact ? 3 : 6;
  at.picture = {body.x, body.y, left, upper - table - gap - findings};
  at.table = {body.x, at.picture.y + at.picture.height, left, table};
  at.finding = {body.x, at.table.y + table + gap, left, findings};
  int x = body.x + 13;
  for (std::size_t k = 0; k < kAnswers.size(); ++k) {
    const int width = kKeyCap + 6 + textWidth(kAnswers[k]);
    at.answers[k] = {x, at.finding.y + at.line + 3, width, at.line + 2};
    x += width + 20;
  }
  placeRight(at, body.x + left + kGutter, upper);
  placeLower(at);
  return at;
}

SortSpot spotAt(const SortLayout& at, int x, int y) {
  const auto among = [&](const auto& rects, SortPart part) -> std::optional<SortSpot> {
    for (int k = 0; k < static_cast<int>(rects.size()); ++k)
      if (rects[k].has(x, y)) return SortSpot{part, k};
    return std::nullopt;
  };
  if (const auto spot = among(at.transport, SortPart::Transport)) return *spot;
  if (const auto spot = among(at.toggles, SortPart::Toggle)) return *spot;
  if (const auto spot = among(at.kinds, SortPart::Kind)) return *spot;
  if (const auto spot = among(at.answers, SortPart::Answer)) return *spot;
  // The thumb reaches beyond both ends.
  if (Rect{at.speed.x - 5, at.speed.y, at.speed.width + 10, at.speed.height}.has(x, y))
    return {SortPart::Speed};
  if (at.timeline.has(x, y)) return {SortPart::Timeline};
  if (at.picture.has(x, y)) return {SortPart::Picture};
  if (at.list.has(x, y)) return {SortPart::Row, (y - at.list.y) / at.line};
  return {};
}

int columnOf(const Rect& timeline, int step, int steps) {
  const double share = static_cast<double>(step) / std::max(1, steps);
  return timeline.x + static_cast<int>(std::lround(share * (timeline.width - 1)));
}

int stepAt(const Rect& timeline, int x, int steps) {
  const double share = static_cast<double>(x - timeline.x) / (timeline.width - 1);
  return static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * steps));
}

int columnOfSpeed(const Rect& track, double speed) {
  const double share = std::log(speed / kSlowest) / std::log(kFastest / kSlowest);
  return track.x + static_cast<int>(std::lround(share * (track.width - 1)));
}

double speedAt(const Rect& track, int x) {
  const double share = std::clamp(static_cast<double>(x - track.x) / (track.width - 1), 0.0, 1.0);
  return kSlowest * std::pow(kFastest / kSlowest, share);
}

}  // namespace xnewell
