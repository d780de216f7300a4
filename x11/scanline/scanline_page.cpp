#include "x11/scanline/scanline_page.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "x11/scanline/scanline_pen.h"
#include "x11/scanline/scanline_words.h"

namespace xnewell {

namespace {

void drawPolygon(ScanlinePen& pen) {
  const ScanlineRun& run = pen.page.run;
  pen.y = pen.at.column.y + 10;
  pen.caps(pen.x(), pen.y, "polygon");
  const auto& parts = pen.page.run.parts();
  const int end = pen.at.overview.x - 12;
  if (parts.size() > 1 && pen.sample)
    pen.softRight(end, pen.y,
                  "triangle " + std::to_string(pen.sample->part + 1) + " of " + std::to_string(parts.size()));
  pen.y += pen.at.line;
  const auto row = [&](std::string_view label, const std::string& value) {
    pen.soft(pen.x(), pen.y, label);
    pen.boldRight(end, pen.y, beginningOf(value, end - pen.x() - textWidth(label) - 6));
    pen.y += pen.at.line;
  };
  row("face", pen.page.polygon);
  const SnappedFace& face = run.picture().snapped().faces[static_cast<std::size_t>(run.face())];
  std::string rows = "no row";
  if (!run.samples().empty()) {
    int first = run.spanOf(run.samples().front()).row, last = first;
    for (const ScanPart& part : parts)
      for (const ScanSpan& span : part.spans)
        first = std::min(first, span.row), last = std::max(last, span.row);
    rows = std::to_string(first) + ".." + std::to_string(last);
  }
  row("corners, rows", std::to_string(face.count) + ", " + rows);
  row("samples", grouped(pen.page.view.step) + " of " + grouped(run.steps()));
  if (run.isConstant()) {
    row("shading", "one value");
  } else if (pen.sample && !run.quantities(pen.sample->part).empty()) {
    const ScanQuantity& quantity = run.quantities(pen.sample->part).front();
    const std::string label = std::string{quantity.name} + " at A, B ..";
    std::string values;
    for (int decimals = 3; decimals >= 0; --decimals) {
      values.clear();
      for (const double v : quantity.atVertex) values += (values.empty() ? "" : " ") + fixed(v, decimals);
      if (textWidth(values) + textWidth(label) + 6 <= end - pen.x()) break;
    }
    row(label, values);
  }
  pen.key(pen.x(), pen.y - 11, "/");
  pen.soft(pen.x() + 20, pen.y, beginningOf("another, or click one", end - pen.x() - 20));
  pen.y = std::max(pen.y + pen.at.line, pen.at.overview.y + pen.at.overview.height + pen.at.line - 4);
}

void drawOverview(ScanlinePen& pen) {
  const IndexImage& image = pen.page.image;
  const Rect& at = pen.at.overview;
  Painter pixels = pen.paint.within(at).pixels();
  const int unit = pen.paint.unit(), scale = overviewScale(at, image, unit);
  IndexImage small;
  small.width = image.width / scale, small.height = image.height / scale;
  for (int j = 0; j < small.height; ++j)
    for (int i = 0; i < small.width; ++i) small.pixels.push_back(image.row(j * scale)[i * scale]);
  pen.paint.place(small, at.x, at.y);
  glm::ivec2 low{1 << 30}, high{-(1 << 30)};
  for (const ScanPart& part : pen.page.run.parts())
    for (const glm::ivec3& v : part.outline)
      low = glm::min(low, glm::ivec2{v} / kGrid), high = glm::max(high, glm::ivec2{v} / kGrid + 1);
  low /= scale, high = high / scale + 1;
  const Rect mark{at.x * unit + low.x - 2 * unit, at.y * unit + low.y - 2 * unit, high.x - low.x + 4 * unit,
                  high.y - low.y + 4 * unit};
  for (int k = 0; k < 2 * unit; ++k)
    pixels.frame({mark.x - k, mark.y - k, mark.width + 2 * k, mark.height + 2 * k},
                 pen(k < unit ? Cell::White : Cell::Black));
}

void drawEdges(ScanlinePen& pen) {
  const ScanlineRun& run = pen.page.run;
  const int row = run.spanOf(*pen.sample).row;
  pen.section("edges", "row " + std::to_string(row) + ": y " + fixed(row + 0.5, 1) + "; x grows by dx a row");
  const std::array ends{pen.along(144), pen.along(226), pen.along(322)};
  pen.soft(pen.x(), pen.y, "edge");
  pen.softRight(ends[0], pen.y, "rows"), pen.softRight(ends[1], pen.y, "x"),
      pen.softRight(ends[2], pen.y, "dx");
  pen.softRight(pen.right(), pen.y, "is");
  pen.y += pen.at.line;
  const std::size_t kRows = pen.at.compact ? 2 : 3;
  const std::vector<EdgeLine> lines = edgeLines(run, *pen.sample);
  for (std::size_t k = 0; k < kRows; ++k) {
    if (k < lines.size()) {
      const EdgeLine& line = lines[k];
      if (line.active) pen.white();
      const Voice voice = line.active ? Voice::Bold : Voice::Plain;
      const std::uint8_t ink = pen(line.active ? Cell::Ink : Cell::Soft);
      pen.paint.text(pen.x(), pen.y, line.name, ink, voice);
      pen.paint.textRight(ends[0], pen.y, line.rows, ink, voice);
      pen.paint.textRight(ends[1], pen.y, line.x, ink, voice);
      pen.paint.textRight(ends[2], pen.y, line.step, ink, voice);
      const bool more = k + 1 == kRows && lines.size() > kRows && !line.active;
      pen.paint.textRight(pen.right(), pen.y,
                          more ? "and " + std::to_string(lines.size() - kRows) + " more" : line.is, ink,
                          voice);
    }
    pen.y += pen.at.line;
  }
  if (pen.at.compact) return;
  const ScanSpan& span = run.spanOf(*pen.sample);
  pen.soft(pen.x(), pen.y,
           beginningOf("samples " + std::to_string(span.from) + ".." + std::to_string(span.to - 1) +
                           ": left edges in, right edges out",
                       pen.at.column.width));
  pen.y += pen.at.line;
}

void drawCode(ScanlinePen& pen) {
  const std::vector<CodeLine> lines = scanlineCode(pen.page.run, pen.page.view.step);
  const int top = pen.y - pen.at.line + 4, high = 20 + pen.at.line * static_cast<int>(lines.size() + 1);
  drawPseudocode(pen, {pen.x(), top, pen.at.column.width, high}, pen.at.line, "Foley & van Dam 3.6, 16.2.4",
                 lines);
  pen.y = top + high + pen.at.line / 2;
}

void drawSpan(ScanlinePen& pen) {
  const ScanlineRun& run = pen.page.run;
  const std::vector<ScanQuantity>& quantities = run.quantities(pen.sample->part);
  pen.section("span", valueText(run));
  // x, then the quantities, then the cell.
  std::vector<int> ends{pen.along(quantities.size() > 2 ? 150 : 168)};
  const int room = pen.right() - textWidth("  999") - ends.front();
  for (std::size_t k = 1; k <= quantities.size(); ++k)
    ends.push_back(ends.front() + room * static_cast<int>(k) / static_cast<int>(quantities.size()));
  pen.softRight(ends[0], pen.y, "x");
  for (std::size_t k = 0; k < quantities.size(); ++k) pen.softRight(ends[k + 1], pen.y, quantities[k].name);
  pen.softRight(pen.right(), pen.y, "cell");
  pen.y += pen.at.line;
  std::vector<SpanLine> lines = spanLines(run, *pen.sample);
  if (!pen.filled) lines.resize(lines.size() - 2);  // the next pixel may be asked for
  for (const SpanLine& line : lines) {
    const bool here = pen.filled && &line == &lines.back();
    if (here) pen.white();
    const Voice voice = here ? Voice::Bold : Voice::Plain;
    const std::string label = beginningOf(line.label, ends[0] - textWidth(line.x) - 6 - pen.x());
    pen.paint.text(pen.x(), pen.y, label, pen(Cell::Ink), voice);
    pen.paint.textRight(ends[0], pen.y, line.x, pen(Cell::Ink), voice);
    for (std::size_t k = 0; k < line.numbers.size(); ++k)
      pen.paint.textRight(ends[k + 1], pen.y, line.numbers[k], pen(Cell::Ink), voice);
    pen.paint.textRight(pen.right(), pen.y, line.cell, pen(Cell::Ink), voice);
    pen.y += pen.at.line;
  }
  if (!pen.filled) pen.y += 2 * pen.at.line;
}

void drawPixel(ScanlinePen& pen) {
  if (!pen.filled) return;
  pen.section("pixel " + std::to_string(pen.sample->column),
              pen.page.run.isConstant() ? "" : "two ways to the same number");
  for (const PixelLine& line : pixelLines(pen.page.run, pen.page.view.step)) {
    if (pen.y > pen.at.choices - pen.at.line) break;
    pen.soft(pen.x(), pen.y, line.label);
    const int end = line.cell.empty() ? pen.right() : pen.right() - 46,
              left = pen.x() + std::max(pen.at.narrow ? 56 : 66, textWidth(line.label) + 8);
    const int room = end - textWidth(line.value) - 6 - left;
    std::string how = line.how;
    if (textWidth(how) > room) std::erase(how, ' ');  // weights are worth more than their spaces
    const int spare = std::max(0, left - pen.x() - textWidth(line.label) - 8);
    pen.ink(left - std::clamp(textWidth(how) - room, 0, spare), pen.y, beginningOf(how, room + spare));
    pen.boldRight(end, pen.y, line.value);
    const bool same = line.cell == "same", other = line.cell == "other";
    if (same) pen.paint.tick(pen.right() - textWidth(line.cell) - 10, pen.y - 8, pen(Cell::Good));
    pen.paint.textRight(pen.right(), pen.y, line.cell,
                        pen(same    ? Cell::Good
                            : other ? Cell::Alarm
                                    : Cell::Ink),
                        other ? Voice::Bold : Voice::Plain);
    pen.y += pen.at.line;
  }
}

}  // namespace

Control scanKindsControl(const ScanlineRun& run, const ScanlineState& view) {
  Control kinds{.kind = Control::Kind::Choice,
                .part = transportId(TransportPart::Kinds).part,
                .label = "jump to",
                .is = "the kind of step to jump to",
                .value = static_cast<double>(view.kind)};
  for (const ScanMarkRow& row : kScanMarks) {
    kinds.options.emplace_back(row.name);
    kinds.lacking.push_back(run.marks(row.id).empty());
  }
  return kinds;
}

void drawScanlineFigure(Pen& plain, const Rect& at, const ScanlineRun& run, int step) {
  const ScanlineLayout layout = layoutOfScanlineFigure(at);
  const ScanlineState view{.step = step, .bits = run.bits()};
  const Finding none;
  const IndexImage noImage;
  const ScanlinePage page{run, view, none, {}, noImage};
  const ScanSample* const sample =
      run.samples().empty() ? nullptr : &run.samples()[static_cast<std::size_t>(std::max(0, step - 1))];
  ScanlinePen pen{plain, layout, page, sample, step > 0, at.y};
  drawScanlineGrid(pen);
}

void drawScanlinePage(Pen& plain, const ScanlineLayout& at, const ScanlinePage& page,
                      const ControlList* list) {
  const ScanlineRun& run = page.run;
  const int step = page.view.step;
  const ScanSample* const sample =
      run.samples().empty() ? nullptr : &run.samples()[static_cast<std::size_t>(std::max(0, step - 1))];
  ScanlinePen pen{plain, at, page, sample, step > 0, at.column.y};
  drawOverview(pen);
  drawPolygon(pen);
  if (sample) {
    if (page.view.code)
      drawCode(pen);
    else
      drawEdges(pen), drawSpan(pen);
    drawPixel(pen);
  }
  drawScanlineGrid(pen);
  drawFindingBox(pen, at.finding, std::min(at.line, 17), page.finding.bold, page.finding.why,
                 run.differing() > 0 ? Cell::Alarm
                 : run.steps() > 0   ? Cell::Good
                                     : Cell::Ink);
  pen.rule(at.body.x, at.rule, at.body.width);
  const TransportState state{step, run.steps(), page.view.playing, page.view.speed, page.view.asking};
  drawTransport(pen, at, state, scanKindsControl(run, page.view), list);
  const std::array lanes{Lane{"rows", run.marks(ScanMark::Row)}, Lane{"edges", run.marks(ScanMark::Edge)},
                         Lane{"shades", run.marks(ScanMark::Shade), Cell::Ink, true},
                         Lane{"differs", run.marks(ScanMark::Differs), Cell::Alarm, true}};
  drawTimeline(pen, at, state, lanes);
}

namespace {

/// What the lines call the value, its increment, and what a pixel gets.
struct Named {
  std::string value, paints;
};
Named namedOf(const ScanlineRun& run) {
  if (run.hasNormals()) return {"N", "the equation's cell at N / |N|"};
  if (run.isTextured()) return {"u/w, v/w, 1/w", "the texel at u, v"};
  if (run.stepsValues()) return {"V", "the cell of V"};
  return {"place", "the map's cell at the place"};
}

}  // namespace

std::vector<CodeLine> scanlineCode(const ScanlineRun& run, int step) {
  const bool constant = run.isConstant();
  const Named names = constant ? Named{"", "the polygon's cell"} : namedOf(run);
  std::vector<CodeLine> lines;
  const bool begun = step > 0;
  const ScanSample* const sample = begun ? &run.samples()[static_cast<std::size_t>(step - 1)] : nullptr;
  const bool newRow =
      begun && (step == 1 || run.samples()[static_cast<std::size_t>(step - 2)].span != sample->span ||
                run.samples()[static_cast<std::size_t>(step - 2)].part != sample->part);
  const std::vector<SpanLine> span = begun ? spanLines(run, *sample) : std::vector<SpanLine>{};
  enum class When { Row, Pixel, Never };
  const auto add = [&](std::string text, When when, std::string values = {}) {
    const bool ran = begun && (when == When::Row ? newRow : when == When::Pixel ? !newRow : false);
    lines.push_back({std::move(text), ran ? CodeLine::Ran::Before : CodeLine::Ran::Never,
                     begun ? std::move(values) : std::string{}});
  };
  const auto last = [](const SpanLine& line) {
    return line.numbers.empty() ? std::string{} : line.numbers.back();
  };
  const bool one = run.stepsValues();  // one number, which has room
  const auto V = [&](const ScanSample& of) { return steppedText(of.stepped, 4); };
  const auto firstOfRow = [&] {
    return *std::ranges::find_if(
        run.samples(), [&](const ScanSample& s) { return s.part == sample->part && s.span == sample->span; });
  };
  add("for each row y, from top to bottom", When::Row,
      begun ? "y = " + std::to_string(run.spanOf(*sample).row) : "");
  const std::vector<EdgeLine> edges = begun ? edgeLines(run, *sample) : std::vector<EdgeLine>{};
  const auto ifBegun = [&](const auto& words) { return begun ? words() : std::string{}; };
  add("  take up edges that begin, drop those that end", When::Row,
      ifBegun([&] { return edges[0].name + ", " + edges[1].name; }));
  add("  xL, xR: where they cross y + 1/2", When::Row, ifBegun([&] { return span[0].x + ", " + span[1].x; }));
  if (!constant) {
    add("  " + names.value + " at both: linear along the edges", When::Row,
        ifBegun([&] { return one ? last(span[0]) + ", " + last(span[1]) : ""; }));
    add("  d = (right - left) / (xR - xL)", When::Row, ifBegun([&] { return one ? last(span[2]) : ""; }));
  }
  add("  x = the first sample at xL or after", When::Row, ifBegun([&] { return span[3].x; }));
  if (!constant)
    add("  " + names.value + " there: left + (x - xL) d", When::Row,
        ifBegun([&] { return one ? V(firstOfRow()) : ""; }));
  add("  while x is before xR", When::Pixel, begun ? "x = " + span[4].x : "");
  add("    paint " + names.paints, When::Never, begun ? "cell " + std::to_string(sample->steppedCell) : "");
  lines.back().ran = begun ? CodeLine::Ran::Now : CodeLine::Ran::Never;
  add(constant ? "    x = x + 1" : "    x = x + 1, " + names.value + " = " + names.value + " + d",
      When::Pixel, one && begun ? V(*sample) : "");
  add("  each edge: x = x + dx", When::Row);
  if (!begun) lines.front().ran = CodeLine::Ran::Now;
  return lines;
}

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

ScanlineLayout layoutOfScanlineFigure(const Rect& area) {
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
