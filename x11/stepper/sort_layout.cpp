#include "x11/stepper/sort_layout.h"

#include <algorithm>
#include <cmath>

#include "x11/drawing/painter.h"
#include "x11/drawing/sheet.h"

namespace xnewell {

namespace {

constexpr int kGutter = 16, kTestRowsShown = 8;
constexpr int kHeadline = 30;
constexpr int kNarrowBelow = 900;  // pixels; a body narrower than this is narrow

void placeLower(SortLayout& at) {
  const Rect& body = at.body;
  const bool narrow = at.narrow;
  const int top = at.rule + (at.compact ? 4 : 6), height = at.compact ? 20 : 22, gap = narrow ? 2 : 4;
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
  at.kinds.options.resize(kLandmarks.size());
  for (std::size_t k = kLandmarks.size(); k-- > 0;) {
    const int width = textWidth(kLandmarks[k].name) + 13;
    right -= width;
    at.kinds.options[k] = {right, middle - 10, width, 19};
  }
  at.kinds.area = {right, middle - 10, end - right, 19};
  at.kinds.bare = true;
  at.step = {x + 10, top, right - (narrow ? 4 : 62) - (x + 10), height};
  const int lanes = at.rule + (at.compact ? 28 : 35);
  at.timeline = {body.x + 68, lanes, body.width - 68, body.y + body.height - lanes - (at.compact ? 4 : 9)};
}

void placeSidesAndList(SortLayout& at, int x, int width, int upper) {
  const int labels = at.compact ? 112 : 132;
  at.side = {x + labels, at.body.y, width - labels, upper * 22 / 100};
  const int top = at.side.y + at.side.height + (at.compact ? 30 : 42);
  const int rows = (at.counts.y - (at.compact ? 4 : 8) - top) / at.line - 1;  // the last line has words
  at.list = {x, top, width, rows * at.line};
}

void placeCounts(SortLayout& at, int x, int upper) {
  const Rect& body = at.body;
  const int width = body.x + body.width - x, counts = (at.compact ? 18 : 26) + 5 * at.line;
  at.counts = {x, body.y + upper - counts, width, counts};
  const bool narrow = width < 380;
  const int first = x + (narrow ? 160 : 168), second = x + (narrow ? 251 : 288);
  for (int k = 0; k < kToggleCount; ++k) {
    const int row = k < kPolygonStop ? k : k == kPolygonStop ? 0 : 4;
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

SortLayout layoutOfSort(const Rect& body, bool shut) {
  SortLayout at;
  at.body = body;
  at.shut = shut;
  at.compact = body.height < kCompactBelow;
  at.narrow = body.width < kNarrowBelow;
  at.line = !at.compact ? 16 : shut ? 15 : 14;
  const int lower = at.compact ? 84 : 104, upper = body.height - lower - (at.compact ? 4 : 8);
  at.rule = body.y + body.height - lower;

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
  at.finding = {at.table.x, at.table.y + table + gap, at.table.width, findings};
  int x = at.finding.x + 13;
  const int first = shut ? 3 : at.line + 3;  // the headline has the first line
  for (std::size_t k = 0; k < kAnswers.size(); ++k) {
    const int width = kKeyCap + 6 + textWidth(kAnswers[k]);
    at.answers[k] = {x, at.finding.y + first, width, at.line + 2};
    x += width + (shut ? 14 : 20);
  }
  placeLower(at);
  return at;
}

int columnOf(const Rect& timeline, int step, int steps) {
  const double share = static_cast<double>(step) / std::max(1, steps);
  return timeline.x + static_cast<int>(std::lround(share * (timeline.width - 1)));
}

}  // namespace xnewell
