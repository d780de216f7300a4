#include <algorithm>
#include <cmath>

#include "x11/scanline/scanline_page.h"

namespace xnewell {

namespace {

constexpr int kGutter = 16, kNarrowBelow = 900, kNumbers = 32;  // of the rows, left of the grid
constexpr int kLeastSide = 6, kMostSide = 24;

int leftWidth(const Rect& body) { return (body.width + kGutter) * 14 / 24 - kGutter; }

/// The grid and the charts in an area; their heights are shares of `upper`.
void placeGrid(ScanlineLayout& at, const Rect& area, int upper, bool compact) {
  const int labels = compact ? 16 : 22, value = upper / (compact ? 13 : 12), between = compact ? 8 : 14,
            drift = upper / 20, above = compact ? 6 : 10;
  at.grid = {area.x + kNumbers, area.y, area.width - kNumbers,
             area.height - (labels + value + between + drift + above)};
  at.value = {at.grid.x, at.grid.y + at.grid.height + labels, at.grid.width, value};
  at.drift = {at.grid.x, at.value.y + value + between, at.grid.width, drift};
}

}  // namespace

ScanlineLayout layoutOfScanline(const Rect& body) {
  static const std::vector<std::string> kinds = [] {
    std::vector<std::string> names;
    for (const ScanMarkRow& row : kScanMarks) names.emplace_back(row.name);
    return names;
  }();
  ScanlineLayout at;
  const bool compact = body.height < kCompactBelow;
  static_cast<TransportLayout&>(at) = layoutOfTransport(body, compact, body.width < kNarrowBelow, kinds);
  at.body = body;
  const int upper = at.rule - body.y - (compact ? 4 : 8), left = leftWidth(body);
  at.line = std::clamp(upper / 29, 13, 24);
  const int findings = 3 * std::min(at.line, 17) + 4;
  const Rect charts{body.x, body.y, left, upper - findings};
  placeGrid(at, charts, upper, compact);
  const int y = at.drift.y + at.drift.height + (compact ? 6 : 10);
  at.finding = {body.x, y, left, findings};
  const int right = body.x + left + kGutter;
  at.column = {right, body.y, body.x + body.width - right, upper};
  const int wide = at.column.width * 3 / 8;
  const int spare = std::max(0, upper - 29 * at.line);
  at.overview = {at.column.x + at.column.width - wide, body.y, wide,
                 (compact ? 5 : 6) * at.line + 2 + spare / 2};
  at.choices = at.column.y + at.column.height - 5;
  return at;
}

ScanlineLayout layoutOfScanlineSight(const Rect& area) {
  ScanlineLayout at;
  placeGrid(at, area, 340, /*compact=*/true);
  return at;
}

Rect scanlinePicture(const Rect& body) {
  const ScanlineLayout at = layoutOfScanline(body);
  return {at.grid.x - kNumbers, at.grid.y, at.grid.width + kNumbers, at.grid.height};
}

GridWindow gridWindow(const Rect& grid, const ScanlineRun& run, int step) {
  glm::ivec2 low{1 << 30}, high{-(1 << 30)};
  for (const ScanPart& part : run.parts())
    for (const glm::ivec3& v : part.outline)
      low = glm::min(low, glm::ivec2{v} / kGrid), high = glm::max(high, glm::ivec2{v} / kGrid + 1);
  const glm::ivec2 wide = high - low + 4;  // two pixels on all sides
  GridWindow window;
  window.side = std::clamp(std::min(grid.width / wide.x, grid.height / wide.y), kLeastSide, kMostSide);
  window.columns = grid.width / window.side, window.rows = grid.height / window.side;
  glm::ivec2 middle = (low + high) / 2;
  if (step > 0) {
    const ScanSample& sample = run.samples()[static_cast<std::size_t>(step - 1)];
    if (wide.x > window.columns) middle.x = sample.column;
    if (wide.y > window.rows) middle.y = run.spanOf(sample).row;
  } else if (!run.samples().empty()) {
    if (wide.x > window.columns) middle.x = run.samples().front().column;
    if (wide.y > window.rows) middle.y = run.spanOf(run.samples().front()).row;
  }
  window.column = middle.x - window.columns / 2, window.row = middle.y - window.rows / 2;
  return window;
}

int overviewScale(const Rect& overview, const IndexImage& image, int unit) {
  const auto times = [](int pixels, int room) { return (pixels + room - 1) / std::max(1, room); };
  return std::max(
      {1, times(image.width, overview.width * unit), times(image.height, overview.height * unit)});
}

}  // namespace xnewell
