#include <algorithm>
#include <array>
#include <cmath>

#include "x11/scanline/scanline_pen.h"

namespace xnewell {

namespace {

/// Pixel under pixel of the grid: what its columns and rows are in units.
struct OnGrid {
  GridWindow window;
  Rect area;
  [[nodiscard]] int x(int column) const { return area.x + (column - window.column) * window.side; }
  [[nodiscard]] int y(int row) const { return area.y + (row - window.row) * window.side; }
  [[nodiscard]] int middle(int column) const { return x(column) + window.side / 2; }
  /// A place on the grid of 1/65536 pixel.
  [[nodiscard]] int placeX(double v) const {
    return area.x +
           static_cast<int>(std::clamp(std::round((v / kGrid - window.column) * window.side), -1e5, 1e5));
  }
  [[nodiscard]] int placeY(double v) const {
    return area.y +
           static_cast<int>(std::clamp(std::round((v / kGrid - window.row) * window.side), -1e5, 1e5));
  }
};

void drawCells(ScanlinePen& pen, const OnGrid& on) {
  const ScanlineRun& run = pen.page.run;
  const int side = on.window.side;
  Painter paint = pen.paint.within(on.area);
  paint.fillRect(on.area, pen(Cell::White));
  const int row = pen.sample ? run.spanOf(*pen.sample).row : -1;
  if (pen.sample) paint.fillRect({on.area.x, on.y(row), on.area.width, side}, pen(Cell::Focus));
  for (int i = 0; i <= on.window.columns; ++i)
    paint.vline(on.x(on.window.column + i), on.area.y, on.area.height, pen(Cell::Rule));
  for (int j = 0; j <= on.window.rows; ++j)
    paint.hline(on.area.x, on.y(on.window.row + j), on.area.width, pen(Cell::Rule));
  for (int j = 0; j < on.window.rows; ++j)
    for (int i = 0; i < on.window.columns; ++i)
      paint.point(on.middle(on.window.column + i), on.y(on.window.row + j) + side / 2, pen(Cell::Faint));
  for (int k = 0; k < run.steps(); ++k) {
    const ScanSample& sample = run.samples()[static_cast<std::size_t>(k)];
    const int x = on.x(sample.column), y = on.y(run.spanOf(sample).row);
    if (k < pen.page.view.step) paint.fillRect({x, y, side, side}, sample.steppedCell);
    if (k < pen.page.view.step && sample.steppedCell != sample.directCell) {
      paint.frame({x, y, side, side}, pen(Cell::White));
      paint.frame({x + 1, y + 1, side - 2, side - 2}, pen(Cell::Alarm));
    }
    if (k >= pen.page.view.step) paint.fillRect({x + side / 2 - 1, y + side / 2 - 1, 2, 2}, pen(Cell::Ink));
  }
}

void drawOutlines(ScanlinePen& pen, const OnGrid& on) {
  const ScanlineRun& run = pen.page.run;
  Painter paint = pen.paint.within(on.area);
  const ScanSpan* const span = pen.sample ? &run.spanOf(*pen.sample) : nullptr;
  for (int k = 0; k < static_cast<int>(run.parts().size()); ++k) {
    const ScanPart& part = run.parts()[static_cast<std::size_t>(k)];
    const int count = static_cast<int>(part.outline.size());
    for (int v = 0; v < count; ++v) {
      const glm::ivec3 &a = part.outline[static_cast<std::size_t>(v)],
                       &b = part.outline[static_cast<std::size_t>((v + 1) % count)];
      const int x0 = on.placeX(a.x), y0 = on.placeY(a.y), x1 = on.placeX(b.x), y1 = on.placeY(b.y);
      bool active = false;
      if (span && k == pen.sample->part)
        for (const int edge : {span->left, span->right})
          active |= part.edges[static_cast<std::size_t>(edge)].from == v;
      if (active) {
        paint.line(x0, y0, x1, y1, pen(Cell::White), {.thickness = 5});
        paint.line(x0, y0, x1, y1, pen(Cell::Ink), {.thickness = 3});
      } else {
        paint.line(x0, y0, x1, y1, pen(Cell::Ink), {.on = 4, .off = 3});
      }
    }
  }
  if (!span) return;
  const ScanPart& part = run.parts()[static_cast<std::size_t>(pen.sample->part)];
  for (const int edge : {span->left, span->right}) {
    const double x = part.edges[static_cast<std::size_t>(edge)].x(span->row);
    paint.disc(on.placeX(x * kGrid), on.placeY((span->row + 0.5) * kGrid), 4, pen(Cell::White));
    paint.disc(on.placeX(x * kGrid), on.placeY((span->row + 0.5) * kGrid), 3, pen(Cell::Ink));
  }
  if (pen.filled) {
    const Rect at{on.x(pen.sample->column), on.y(span->row), on.window.side + 1, on.window.side + 1};
    paint.frame({at.x - 2, at.y - 2, at.width + 4, at.height + 4}, pen(Cell::Black));
    paint.frame({at.x - 1, at.y - 1, at.width + 2, at.height + 2}, pen(Cell::White));
    paint.frame(at, pen(Cell::White));
  }
  // The letters stand outside, away from the middle.
  double mx = 0, my = 0;
  for (const glm::ivec3& v : part.outline) mx += v.x, my += v.y;
  mx /= static_cast<double>(part.outline.size()), my /= static_cast<double>(part.outline.size());
  for (int v = 0; v < static_cast<int>(part.outline.size()); ++v) {
    const glm::ivec3& p = part.outline[static_cast<std::size_t>(v)];
    const double length = std::max(1.0, std::hypot(p.x - mx, p.y - my));
    const int x = on.placeX(p.x) + static_cast<int>(std::lround(11 * (p.x - mx) / length)) - 3,
              y = on.placeY(p.y) + static_cast<int>(std::lround(11 * (p.y - my) / length)) + 5;
    const std::string letter{letterOfCorner(v)};
    const int inX = std::clamp(x, on.area.x + 2, on.area.x + on.area.width - 9),
              inY = std::clamp(y, on.area.y + 11, on.area.y + on.area.height - 3);
    paint.fillRect({inX - 1, inY - 10, 9, 12}, pen(Cell::White));
    paint.text(inX, inY, letter, pen(Cell::Ink), Voice::Bold);
  }
}

void drawNumbers(ScanlinePen& pen, const OnGrid& on) {
  const int row = pen.sample ? pen.page.run.spanOf(*pen.sample).row : -1;
  const int every = on.window.side < 8 ? 10 : 5;
  for (int j = on.window.row; j < on.window.row + on.window.rows; ++j) {
    const int y = on.y(j) + on.window.side / 2 + 4;
    if (j == row)
      pen.boldRight(on.area.x - 6, y, std::to_string(j));
    else if (j % every == 0 && std::abs(j - row) * on.window.side >= 13)
      pen.softRight(on.area.x - 6, y, std::to_string(j));
  }
  const int column = pen.filled ? pen.sample->column : -1, y = on.area.y + on.area.height + 12;
  for (int i = on.window.column; i < on.window.column + on.window.columns; ++i) {
    const std::string name = std::to_string(i);
    const int x = on.middle(i) - textWidth(name) / 2;
    if (i == column)
      pen.bold(x, y, name);
    else if (i % every == 0 && std::abs(i - column) * on.window.side >= textWidth(name) + 8)
      pen.soft(x, y, name);
  }
}

/// Words beside a chart, where its columns leave room. False if they leave none.
bool drawChartWords(ScanlinePen& pen, const Rect& at, int from, int to,
                    const std::array<std::string, 2>& words) {
  const int wide = std::max(textWidth(words[0]), textWidth(words[1])) + 12;
  const int top = at.y + (at.height - 26) / 2 + 10;
  for (int k = 0; k < 2; ++k) {
    if (from - at.x >= wide)
      pen.softRight(from - 10, top + 14 * k, words[static_cast<std::size_t>(k)]);
    else if (at.x + at.width - to >= wide)
      pen.soft(to + 10, top + 14 * k, words[static_cast<std::size_t>(k)]);
    else
      return false;
  }
  return true;
}

void drawCharts(ScanlinePen& pen, const OnGrid& on) {
  const ScanlineRun& run = pen.page.run;
  const ScanSpan& span = run.spanOf(*pen.sample);
  std::vector<const ScanSample*> row;
  for (const ScanSample& sample : run.samples())
    if (sample.part == pen.sample->part && sample.span == pen.sample->span) row.push_back(&sample);
  const Rect &value = pen.at.value, &drift = pen.at.drift;
  double low = 1e300, high = -1e300, most = 0;
  for (const ScanSample* sample : row) {
    low = std::min({low, sample->stepped, sample->direct}),
    high = std::max({high, sample->stepped, sample->direct});
    most = std::max(most, std::abs(sample->stepped - sample->direct));
  }
  const double room = std::max(0.5, (high - low) * 0.08);
  low -= room, high += room;
  const auto inside = [&](int x) { return x >= value.x && x < value.x + value.width; };
  const auto yOf = [&](double v) {
    return value.y + value.height - 1 -
           static_cast<int>(std::lround((v - low) / (high - low) * (value.height - 1)));
  };
  pen.paint.vline(value.x, value.y, value.height, pen(Cell::Soft));
  pen.rule(value.x, value.y + value.height, value.width);
  pen.softRight(value.x - 4, value.y + 9, fixed(std::floor(high), 0));
  pen.softRight(value.x - 4, value.y + value.height, fixed(std::floor(low), 0));
  Painter inValue = pen.paint.within({value.x, value.y - 3, value.width, value.height + 6});
  for (std::size_t k = 0; k + 1 < row.size(); ++k)
    if (!pen.page.view.asking || row[k + 1] <= pen.sample)
      inValue.line(on.middle(row[k]->column), yOf(row[k]->direct), on.middle(row[k + 1]->column),
                   yOf(row[k + 1]->direct), pen(Cell::Soft));
  for (const ScanSample* sample : row) {
    if (sample > pen.sample || !pen.filled || !inside(on.middle(sample->column))) continue;
    inValue.disc(on.middle(sample->column), yOf(sample->stepped), on.window.side > 8 ? 2 : 1, pen(Cell::Ink));
  }
  (void)drawChartWords(pen, value, on.x(span.from), on.x(span.to),
                       {"value in the table:", "line direct, dots by steps"});

  if (run.isConstant()) return;  // nothing is stepped
  const double scale = run.choosesBits() ? std::ldexp(1.0, run.bits()) : std::ldexp(1.0, 24);
  const double limit = std::max(1.0, std::ceil(most * scale));
  const int zero = drift.y + drift.height / 2;
  pen.paint.vline(drift.x, drift.y, drift.height, pen(Cell::Soft));
  pen.rule(drift.x, zero, drift.width);
  const std::string most1 = limit < 1e4 ? fixed(limit, 0) : "";
  pen.softRight(drift.x - 4, drift.y + 8, most1.empty() ? "+" : "+" + most1);
  pen.softRight(drift.x - 4, drift.y + drift.height + 2, most1.empty() ? "-" : "-" + most1);
  for (const ScanSample* sample : row) {
    if (sample > pen.sample || !pen.filled || !inside(on.middle(sample->column))) continue;
    const double steps = (sample->stepped - sample->direct) * scale;
    const int high1 = static_cast<int>(std::lround(std::abs(steps) / limit * (drift.height / 2)));
    const int x = on.middle(sample->column) - 1;
    const bool differs = sample->steppedCell != sample->directCell;
    pen.paint.fillRect(steps >= 0 ? Rect{x, zero - high1, 3, high1 + 1} : Rect{x, zero, 3, high1 + 1},
                       pen(differs ? Cell::Alarm : Cell::Ink));
  }
  const std::array<std::string, 2> words{
      "drift, in steps", "of 2^-" + std::to_string(run.choosesBits() ? run.bits() : 24) + " shade"};
  if (!drawChartWords(pen, drift, on.x(span.from), on.x(span.to), words))
    pen.softRight(drift.x + drift.width, drift.y - 1, words[0] + ' ' + words[1]);
}

}  // namespace

void drawScanlineGrid(ScanlinePen& pen) {
  const OnGrid on{gridWindow(pen.at.grid, pen.page.run, pen.page.view.step), pen.at.grid};
  drawCells(pen, on);
  drawOutlines(pen, on);
  pen.paint.frame(pen.at.grid, pen(Cell::Rule));
  drawNumbers(pen, on);
  if (pen.sample) drawCharts(pen, on);
}

}  // namespace xnewell
