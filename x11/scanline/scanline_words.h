#pragma once

#include <optional>
#include <string>
#include <vector>

#include "shading/explain/scanline_run.h"
#include "x11/drawing/sheet.h"

namespace xnewell {

/// The words and numbers of a polygon that is filled, for view 0 and for `trace --scanline`.

/// The face of the picture with this name, an index into snapped().faces: "59.1", or "59" for its first part.
/// -1 if there is none.
[[nodiscard]] int faceNamed(const Picture& picture, const std::string& name);

/// Says that the picture has no such face, or that the face has no such convex part.
[[nodiscard]] std::string noFace(const Picture& picture, const std::string& scene, const std::string& name);

/// A value that was stepped, with as many decimals as it takes for its whole part to be that of the number.
[[nodiscard]] std::string steppedText(double value, int decimals);

/// "A": a corner of a part.
[[nodiscard]] char letterOfCorner(int vertex);
/// "A B": the ends of an edge of a part, as the outline runs.
[[nodiscard]] std::string nameOf(const ScanEdge& edge);

/// An edge in the row of a sample.
struct EdgeLine {
  std::string name, rows, x, step;
  std::string is;  ///< left, right, done, waits
  bool active = false;
};
/// The edges of the sample's part; the active ones first.
[[nodiscard]] std::vector<EdgeLine> edgeLines(const ScanlineRun& run, const ScanSample& sample);

/// The numbers of a row: where they are, and the quantities there.
struct SpanLine {
  std::string label, x;
  std::vector<std::string> numbers;  ///< one for each quantity
  std::string cell;                  ///< "" if there is none
};
/// The left edge, the right edge, the increment, the row's first sample, and this sample.
[[nodiscard]] std::vector<SpanLine> spanLines(const ScanlineRun& run, const ScanSample& sample);

/// Two ways to the number that picks the cell, and what stands between.
struct PixelLine {
  std::string label, how, value, cell;
};
[[nodiscard]] std::vector<PixelLine> pixelLines(const ScanlineRun& run, int step);

/// What is found about the polygon. `eight` is the same run with 8 bits; null if it has no bits to choose.
[[nodiscard]] Finding findingOf(const ScanlineRun& run, const ScanlineRun* eight);

/// "value = 11.5 + 239 I; its whole part is the cell": from I to the value, for the polygon's own table.
[[nodiscard]] std::string valueText(const ScanlineRun& run);
/// "Gouraud: I at the corners, along two edges, along the row"
[[nodiscard]] std::string methodText(const ScanlineRun& run);
/// What a run of a scene whose cells hold colours says: its cells are not those of explain and view 8.
inline constexpr std::string_view kInOneHue = "in one hue";
/// "row 161, pixel 55: value 120.2847, cell 120"
[[nodiscard]] std::string stepText(const ScanlineRun& run, int step);
/// All of it, a line each.
[[nodiscard]] std::vector<std::string> scanAsLines(const ScanlineRun& run, int step,
                                                   const ScanlineRun* eight);

}  // namespace xnewell
