#include "x11/scanline/scanline_code.h"

#include <algorithm>

#include "x11/scanline/scanline_words.h"

namespace xnewell {

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

}  // namespace xnewell
