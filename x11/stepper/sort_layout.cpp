#include "x11/stepper/sort_layout.h"

#include <algorithm>

#include "x11/drawing/painter.h"
#include "x11/drawing/sheet.h"

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

}  // namespace xnewell
