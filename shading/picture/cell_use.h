#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "shading/color/images.h"
#include "shading/picture/picture.h"

namespace xnewell {

/// Counts which cells a picture shows, at how many samples and on how many polygons.

/// The cells first .. first + count - 1.
struct CellRange {
  int first = 0, count = 0;
  [[nodiscard]] int last() const { return first + count - 1; }
  [[nodiscard]] bool has(int cell) const { return cell >= first && cell <= last(); }
  bool operator==(const CellRange&) const = default;
};

/// The cells that hold the colours of a painted picture.
[[nodiscard]] CellRange sceneCells(const Picture& picture);
/// The ramps among these cells; empty if the plan holds colours.
[[nodiscard]] std::vector<CellRange> rampsOf(const Picture& picture);

struct CellUse {
  /// includes the background: the sum is the number of samples in the picture
  std::array<int, 256> samples{};
  std::array<int, 256> polygons{};  ///< faces of the model that show the cell at one sample or more
};

/// `faces` is Picture::faceImage(): 0 where nothing shows. If `faces` is empty, no polygons are counted.
[[nodiscard]] CellUse cellUse(const IndexImage& image, const std::vector<std::uint32_t>& faces = {});

/// The number of cells in the range that at least one sample shows.
[[nodiscard]] int usedCells(const CellUse& use, const CellRange& cells);

/// The median of the cells that polygons show. A cell counts once for each polygon that shows it. So the
/// median is a shade of many polygons, and a few large ones do not decide it. It is the first cell if no
/// polygon shows a cell of the range.
[[nodiscard]] int medianCell(const CellUse& use, const CellRange& cells);

}  // namespace xnewell
