#include "x11/scanline/scanline_words.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "x11/drawing/wording.h"
#include "x11/kit/typed_line.h"

namespace xnewell {

namespace {

constexpr int kPlaceDecimals = 4;

std::string withSign(double v, int decimals) { return (v < 0 ? "" : "+") + fixed(v, decimals); }

const std::vector<ScanEdge>& edgesOf(const ScanlineRun& run, const ScanSample& sample) {
  return run.parts()[static_cast<std::size_t>(sample.part)].edges;
}

/// Decimals that a quantity is written with: cells and places of a map have fewer, as they are larger.
int decimalsOf(const ScanQuantity& quantity) {
  if (quantity.name == "value" || quantity.name == "column" || quantity.name == "row") return 4;
  return quantity.name == "I" ? 6 : 5;
}

std::string threeOf(const glm::dvec3& v) {
  return withSign(v.x, 4) + ' ' + withSign(v.y, 4) + ' ' + withSign(v.z, 4);
}

/// The drift in steps of the chosen bits.
double inSteps(const ScanlineRun& run, double drift) { return std::ldexp(drift, run.bits()); }

std::string largestDrift(const ScanlineRun& run) {
  const double drift = run.mostDrift();
  return drift < 5e-5 ? fixed(inSteps(run, drift), 1) + " steps of 2^-" + std::to_string(run.bits())
                      : fixed(drift, drift < 0.1 ? 4 : 2) + " shade";
}

/// How many additions lead from corner A of a triangle to a sample of it, along a column and a row; 0 where
/// the values are not stepped so.
int mostAdditions(const ScanlineRun& run) {
  double most = 0;
  if (run.stepsValues() && !run.goesAlongRows())
    for (const ScanPart& part : run.parts())
      for (const ScanSpan& span : part.spans) {
        const glm::dvec2 A = glm::dvec2{part.outline[0]} / static_cast<double>(kGrid);
        const double far = std::max(std::abs(span.from + 0.5 - A.x), std::abs(span.to - 0.5 - A.x));
        most = std::max(most, far + std::abs(span.row + 0.5 - A.y));
      }
  return static_cast<int>(std::ceil(most));
}

}  // namespace

std::string steppedText(double value, int decimals) {
  while (decimals < 12 && std::stod(fixed(value, decimals)) >= std::floor(value) + 1.0) ++decimals;
  return fixed(value, decimals);
}

int faceNamed(const Picture& picture, const std::string& name) {
  const auto& faces = picture.snapped().faces;
  const std::optional<int> number = wholeNumber(name.substr(0, name.find('.')));
  for (int f = 0; number && f < static_cast<int>(faces.size()); ++f)
    if (faces[static_cast<std::size_t>(f)].number == *number &&
        (name.find('.') == std::string::npos || nameOfFace(picture, f) == name))
      return f;
  return -1;
}

std::string noFace(const Picture& picture, const std::string& scene, const std::string& name) {
  const std::string number = name.substr(0, name.find('.')), of = "--scanline: the picture of " + scene;
  if (number == name || faceNamed(picture, number) < 0) return of + " has no face " + number;
  const auto& faces = picture.snapped().faces;
  const auto own = std::ranges::equal_range(faces, *wholeNumber(number), {}, &SnappedFace::number);
  return of + " has no face " + name + ": of face " + number + " it has " +
         counted(std::ssize(own), "convex part") + (own.size() > 1 ? ", from " : ", ") +
         nameOfFace(picture, static_cast<int>(own.begin() - faces.begin()));
}

char letterOfCorner(int vertex) { return static_cast<char>('A' + vertex % 26); }

std::string nameOf(const ScanEdge& edge) { return {letterOfCorner(edge.from), ' ', letterOfCorner(edge.to)}; }

std::vector<EdgeLine> edgeLines(const ScanlineRun& run, const ScanSample& sample) {
  const ScanSpan& span = run.spanOf(sample);
  const std::vector<ScanEdge>& edges = edgesOf(run, sample);
  std::vector<EdgeLine> lines;
  for (int k = 0; k < static_cast<int>(edges.size()); ++k) {
    const ScanEdge& edge = edges[static_cast<std::size_t>(k)];
    const bool active = k == span.left || k == span.right;
    lines.push_back({.name = nameOf(edge),
                     .rows = std::to_string(edge.firstRow) + ".." + std::to_string(edge.endRow - 1),
                     .x = active ? fixed(edge.x(span.row), kPlaceDecimals) : "",
                     .step = withSign(edge.step(), kPlaceDecimals),
                     .is = k == span.left            ? "left"
                           : k == span.right         ? "right"
                           : edge.endRow <= span.row ? "done"
                                                     : "waits",
                     .active = active});
  }
  std::ranges::stable_sort(lines, {}, [](const EdgeLine& line) {
    return line.is == "left" ? 0 : line.is == "right" ? 1 : line.is == "waits" ? 2 : 3;
  });
  return lines;
}

std::vector<SpanLine> spanLines(const ScanlineRun& run, const ScanSample& sample) {
  const ScanSpan& span = run.spanOf(sample);
  const std::vector<ScanEdge>& edges = edgesOf(run, sample);
  const std::vector<ScanQuantity>& quantities = run.quantities(sample.part);
  const double left = edges[static_cast<std::size_t>(span.left)].x(span.row),
               right = edges[static_cast<std::size_t>(span.right)].x(span.row);
  ScanSample first = sample;
  first.column = span.from;
  const auto written = [&](const auto& of) {
    std::vector<std::string> numbers;
    for (const ScanQuantity& quantity : quantities) numbers.push_back(of(quantity));
    return numbers;
  };
  const auto onEdge = [&](int edge) {
    return written([&](const ScanQuantity& q) {
      return fixed(run.onEdge(sample.part, edge, span.row, q), decimalsOf(q));
    });
  };
  const auto at = [&](const ScanSample& here) {
    return written([&](const ScanQuantity& q) { return fixed(run.at(here, q), decimalsOf(q)); });
  };
  const std::string perPixel =
      quantities.empty() ? "a pixel" : "d" + std::string{quantities.front().name} + "/dx, a pixel";
  std::vector<SpanLine> lines{
      {"left edge", fixed(left, kPlaceDecimals), onEdge(span.left), ""},
      {"right edge", fixed(right, kPlaceDecimals), onEdge(span.right), ""},
      {quantities.size() > 2 ? "d/dx, a pixel" : perPixel, "+1", written([&](const ScanQuantity& q) {
         const double wide = right - left;
         const double growth = run.onEdge(sample.part, span.right, span.row, q) -
                               run.onEdge(sample.part, span.left, span.row, q);
         return wide > 0 ? withSign(growth / wide, decimalsOf(q)) : "-";
       }),
       ""},
      {"first", fixed(span.from + 0.5, 1), at(first), ""},
      {"pixel " + std::to_string(sample.column), fixed(sample.column + 0.5, 1), at(sample),
       std::to_string(sample.directCell)}};
  // The first sample's cell is that of the run.
  for (const ScanSample& other : run.samples())
    if (other.part == sample.part && other.span == sample.span) {
      lines[3].cell = std::to_string(other.directCell);
      break;
    }
  return lines;
}

std::vector<PixelLine> pixelLines(const ScanlineRun& run, int step) {
  const ScanSample& sample = run.samples()[static_cast<std::size_t>(step - 1)];
  const ScanSpan& span = run.spanOf(sample);
  std::vector<PixelLine> lines;
  const std::string steppedCell = std::to_string(sample.steppedCell),
                    directCell = std::to_string(sample.directCell);
  if (run.isConstant()) {
    lines.push_back({"one value", "for all samples", fixed(sample.direct, 4), directCell});
    return lines;
  }
  const Explanation e = run.explained(sample);
  if (run.stepsValues()) {
    std::string how = "the row's first value";
    if (sample.column > span.from) {
      const ScanSample& before = run.samples()[static_cast<std::size_t>(step - 2)];
      how = fixed(before.stepped, 8) + ' ' + withSign(sample.stepped - before.stepped, 8);
    }
    lines.push_back({"by steps", how, steppedText(sample.stepped, 8), steppedCell});
    how = "along the edges and the row";
    if (e.vertices.size() == 3 && !run.goesAlongRows()) {
      how.clear();
      for (int k = 0; k < 3; ++k)
        how += (k > 0 ? " + " : "") + fixed(e.vertices[static_cast<std::size_t>(k)].onScreen, 3) + ' ' +
               letterOfCorner(k);
    }
    lines.push_back({"direct", how, fixed(sample.direct, 8), directCell});
  } else {
    if (run.hasNormals()) {
      lines.push_back({"sum of N", threeOf(e.sum), "length " + fixed(glm::length(e.sum), 4), ""});
      lines.push_back({"unit N", threeOf(e.equations.front().N), "I " + fixed(e.intensity, 6), ""});
    }
    if (run.isTextured()) {
      const ScanlineRun::TexturePlaces places = run.texturePlaces(sample);
      const auto uv = [](const glm::dvec2& at) { return "u " + fixed(at.x, 4) + "  v " + fixed(at.y, 4); };
      lines.push_back({"affine", uv(places.affine), "", ""});
      lines.push_back({"in perspective", uv(places.perspective), "", ""});
    }
    if (e.place)
      lines.push_back({"in the map",
                       "column " + std::to_string(e.place->column) + ", row " + std::to_string(e.place->row),
                       "I " + fixed(e.intensity, 6), ""});
    lines.push_back(
        {"by steps",
         run.hasNormals() && run.bits() < 24 ? "N by steps, then the equation" : "as the picture's loop",
         fixed(sample.stepped, 6), steppedCell});
    lines.push_back({"direct", "in double precision", fixed(sample.direct, 6), directCell});
  }
  const double drift = sample.stepped - sample.direct;
  const bool same = sample.steppedCell == sample.directCell;
  lines.push_back({"drift",
                   run.choosesBits()
                       ? withSign(inSteps(run, drift), 1) + " steps of 2^-" + std::to_string(run.bits())
                       : "",
                   withSign(drift, 8), same ? "same" : "other"});
  if (run.goesAlongRows()) {
    const ScanlineRun::ByTriangles fan = run.byTriangles(sample);
    lines.push_back({"triangles", "a fan has", fixed(fan.value, 8), std::to_string(fan.cell)});
  }
  return lines;
}

Finding findingOf(const ScanlineRun& run, const ScanlineRun* eight) {
  const std::string samples = counted(run.steps(), "sample");
  if (run.tooLarge())
    return {"This polygon is too large to step through.",
            "It has more than " + grouped(ScanlineRun::kMostSamples) + " samples. Click a smaller one."};
  if (run.steps() == 0)
    return {"This polygon owns no sample.",
            "It lies between the centres of the pixels, or outside the picture."};
  if (run.isConstant())
    return {"One value fills the polygon.",
            "Only the edges are stepped: each row adds dx to x. S chooses a method that steps along the row, "
            "too."};
  if (run.isTextured()) {
    double most = 0;
    for (const ScanSample& sample : run.samples()) {
      const ScanlineRun::TexturePlaces places = run.texturePlaces(sample);
      most = std::max(most, glm::length(places.affine - places.perspective));
    }
    return {most > 5e-5 ? "u/w, v/w and 1/w are linear on the screen; u and v are not."
                        : "Here u and v are linear on the screen.",
            most > 5e-5 ? "Affine steps would miss the place in the texture by up to " + fixed(most, 4) +
                              ". A division at each pixel finds it."
                        : "All corners are equally far from the eye, so affine steps find the same texels."};
  }
  if (run.goesAlongRows()) {
    double most = 0;
    int other = 0;
    for (const ScanSample& sample : run.samples()) {
      const ScanlineRun::ByTriangles fan = run.byTriangles(sample);
      most = std::max(most, std::abs(fan.value - sample.stepped));
      other += fan.cell != sample.steppedCell;
    }
    return {"Along the rows, a value depends on the edges that the row meets.",
            "A fan of triangles differs by up to " + fixed(most, 2) + " shade, at " + grouped(other) +
                " of " + samples + ". A triangle's values do not change when it turns."};
  }
  if (run.hasNormals() && run.bits() == 24) {
    double shortest = 1;
    for (const ScanSample& sample : run.samples())
      shortest = std::min(shortest, glm::length(run.explained(sample).sum));
    if (const std::string length = fixed(shortest, 4); length == fixed(1.0, 4))
      return {"The sum of N is stepped; here its length stays 1.",
              "The corners have one N. Phong shading divides by the length at every pixel all the same."};
    return {"The sum of N is stepped; its length is not 1.",
            "It is as short as " + fixed(shortest, 4) +
                " here, so Phong shading divides by the length at every pixel."};
  }
  if (!run.choosesBits())
    return {"A place in the map is stepped, and looked up.",
            "Column and row are linear on the screen. The map holds I, so nothing is computed at a pixel."};
  const int differing = run.differing();
  Finding finding{differing == 0 ? "The steps drift, and no cell changes."
                                 : "The steps drift, and " + counted(differing, "sample") +
                                       (differing == 1 ? " has" : " have") + " another cell.",
                  "At most " + largestDrift(run)};
  if (const int additions = mostAdditions(run); additions > 0)
    finding.why += ": up to " + std::to_string(additions) +
                   " additions err by half a step; half a cell is 2^" + std::to_string(run.bits() - 1) +
                   " steps.";
  else
    finding.why += " in " + samples + ": an addition errs by half a step at most.";
  if (eight && run.bits() != 8)
    finding.why +=
        " With 8 bits: " + largestDrift(*eight) + ", " + counted(eight->differing(), "other cell") + ".";
  return finding;
}

std::string valueText(const ScanlineRun& run) {
  const Ramp& ramp = run.ramp();
  if (run.picture().settings().interpolated == Interpolated::Cell)
    return "the value is a cell + 1/2 at the corners";
  if (ramp.low != 0.0 || ramp.high != 1.0) return "the whole part of the value is the cell";
  return "value = " + fixed(ramp.first + 0.5, 1) + " + " + std::to_string(ramp.shades - 1) + " I; " +
         (ramp.table != nullptr ? "the corrected table has its cell" : "its whole part is the cell");
}

std::string methodText(const ScanlineRun& run) {
  if (run.isConstant()) return "one cell for the polygon: only the edges are stepped";
  if (run.isTextured()) return "a texture: u/w, v/w and 1/w at the corners, along two edges, along the row";
  if (run.hasNormals()) return "Phong: N at the corners, along two edges, along the row; then the equation";
  if (run.stepsValues()) return "Gouraud: I at the corners, along two edges, along the row";
  return "environment map: its column and row at the corners, along two edges, along the row";
}

std::string stepText(const ScanlineRun& run, int step) {
  if (step == 0) return "before the first sample";
  const ScanSample& sample = run.samples()[static_cast<std::size_t>(step - 1)];
  return "row " + std::to_string(run.spanOf(sample).row) + ", pixel " + std::to_string(sample.column) +
         ": value " + steppedText(sample.stepped, 2) + ", cell " + std::to_string(sample.steppedCell);
}

std::vector<std::string> scanAsLines(const ScanlineRun& run, int step, const ScanlineRun* eight) {
  std::vector<std::string> lines{stepText(run, step), methodText(run)};
  const auto joined = [](std::string text, const std::string& more) {
    return more.empty() ? text : text.empty() ? more : text + "  " + more;
  };
  if (step > 0 && !run.tooLarge()) {
    const ScanSample& sample = run.samples()[static_cast<std::size_t>(step - 1)];
    lines.emplace_back("edge  rows  x  dx  is");
    for (const EdgeLine& line : edgeLines(run, sample))
      lines.push_back(joined(joined(joined(joined(line.name, line.rows), line.x), line.step), line.is));
    std::string names = "x";
    for (const ScanQuantity& quantity : run.quantities(sample.part))
      names = joined(names, std::string{quantity.name});
    lines.push_back(joined(names, "cell"));
    for (const SpanLine& line : spanLines(run, sample)) {
      std::string text = joined(line.label, line.x);
      for (const std::string& number : line.numbers) text = joined(text, number);
      lines.push_back(joined(text, line.cell));
    }
    for (const PixelLine& line : pixelLines(run, step))
      lines.push_back(joined(joined(joined(line.label, line.how), line.value), line.cell));
  }
  const Finding finding = findingOf(run, eight);
  lines.push_back(finding.bold + ' ' + finding.why);
  return lines;
}

}  // namespace xnewell
