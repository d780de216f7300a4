#include "x11/scanline/scanline_trace.h"

#include <cerrno>
#include <nlohmann/json.hpp>
#include <ostream>
#include <stdexcept>
#include <system_error>

#include "x11/drawing/wording.h"
#include "x11/scanline/scanline_words.h"

namespace xnewell {

namespace {

using Json = nlohmann::ordered_json;

class ScanlineTeller {
 public:
  ScanlineTeller(const ScanlineRun& run, std::ostream& out) : run_{run}, out_{out} {}

  void tell(const std::string& scene, bool oneHue) {
    const Picture& picture = run_.picture();
    const std::string name = faceName(picture, run_.face());
    line({{"event", "polygon"},
          {"scene", scene},
          {"size", {picture.settings().width, picture.settings().height}},
          {"face", name},
          {"shading", rowOf(picture.settings().shading).name},
          {"samples", run_.steps()},
          {"parts", run_.parts().size()},
          {"one_hue", oneHue},
          {"says",
           "face " + name + ": " + methodText(run_) +
               (run_.parts().size() > 1
                    ? "; filled as " + counted(static_cast<std::int64_t>(run_.parts().size()), "triangle")
                    : "") +
               (oneHue ? "; " + std::string{kInOneHue} + ", so explain has other cells" : "")}});
    int part = -1, span = -1;
    for (int step = 1; step <= run_.steps(); ++step) {
      const ScanSample& sample = run_.samples()[static_cast<std::size_t>(step - 1)];
      if (sample.part != part) edges(sample.part), span = -1;
      if (sample.span != span) row(sample);
      part = sample.part, span = sample.span;
      pixel(step, sample);
    }
    const Finding finding = findingOf(run_, nullptr);
    line({{"event", "summary"},
          {"samples", run_.steps()},
          {"largest_drift", run_.mostDrift()},
          {"other_cells", run_.differing()},
          {"says", finding.bold + ' ' + finding.why}});
  }

 private:
  void line(const Json& object) {
    out_ << object.dump(-1, ' ', false, Json::error_handler_t::replace) << '\n';
    if (!out_) throw std::system_error{errno, std::generic_category(), "standard output"};
  }

  void edges(int part) {
    const ScanPart& p = run_.parts()[static_cast<std::size_t>(part)];
    for (const ScanEdge& edge : p.edges) {
      Json values = Json::object();
      for (const ScanQuantity& quantity : run_.quantities(part))
        values[quantity.name] = {quantity.atVertex[static_cast<std::size_t>(edge.from)],
                                 quantity.atVertex[static_cast<std::size_t>(edge.to)]};
      line({{"event", "edge"},
            {"part", part},
            {"edge", nameOf(edge)},
            {"top", {edge.top.x / double{kGrid}, edge.top.y / double{kGrid}}},
            {"bottom", {edge.bottom.x / double{kGrid}, edge.bottom.y / double{kGrid}}},
            {"rows", {edge.firstRow, edge.endRow - 1}},
            {"dx", edge.step()},
            {"is", edge.left ? "left" : "right"},
            {"values", values},
            {"says", "edge " + nameOf(edge) + " spans the rows " + std::to_string(edge.firstRow) + " to " +
                         std::to_string(edge.endRow - 1) + "; x grows by " + fixed(edge.step(), 4) +
                         " a row"}});
    }
  }

  void row(const ScanSample& sample) {
    const ScanSpan& span = run_.spanOf(sample);
    const std::vector<ScanEdge>& edges = run_.parts()[static_cast<std::size_t>(sample.part)].edges;
    const ScanEdge &left = edges[static_cast<std::size_t>(span.left)],
                   &right = edges[static_cast<std::size_t>(span.right)];
    const double x0 = left.x(span.row), x1 = right.x(span.row);
    Json values = Json::object();
    for (const ScanQuantity& quantity : run_.quantities(sample.part)) {
      const double from = run_.onEdge(sample.part, span.left, span.row, quantity),
                   to = run_.onEdge(sample.part, span.right, span.row, quantity);
      values[quantity.name] = {{"left", from}, {"right", to}};
      if (x1 > x0) values[quantity.name]["increment"] = (to - from) / (x1 - x0);
    }
    line({{"event", "row"},
          {"part", sample.part},
          {"row", span.row},
          {"left", {{"edge", nameOf(left)}, {"x", x0}}},
          {"right", {{"edge", nameOf(right)}, {"x", x1}}},
          {"from", span.from},
          {"to", span.to - 1},
          {"values", values},
          {"says", "row " + std::to_string(span.row) + ": the samples " + std::to_string(span.from) + " to " +
                       std::to_string(span.to - 1) + " lie between " + nameOf(left) + " and " +
                       nameOf(right)}});
  }

  void pixel(int step, const ScanSample& sample) {
    line({{"event", "pixel"},
          {"step", step},
          {"pixel", {sample.column, run_.spanOf(sample).row}},
          {"by_steps", sample.stepped},
          {"direct", sample.direct},
          {"drift", sample.stepped - sample.direct},
          {"cell", sample.steppedCell},
          {"direct_cell", sample.directCell},
          {"says", stepText(run_, step)}});
  }

  const ScanlineRun& run_;
  std::ostream& out_;
};

}  // namespace

void printScanline(const std::string& scene, const std::string& polygon, const Picture& picture, bool oneHue,
                   std::ostream& out) {
  const int face = faceNamed(picture, polygon);
  if (face < 0) throw std::invalid_argument{noFace(picture, scene, polygon)};
  const ScanlineRun run{picture, face};
  if (run.tooLarge())
    throw std::invalid_argument{"--scanline: face " + polygon + " has more than " +
                                grouped(ScanlineRun::kMostSamples) + " samples: use a smaller --size"};
  ScanlineTeller{run, out}.tell(scene, oneHue);
}

}  // namespace xnewell
