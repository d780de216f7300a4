#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "shading/color/index_image.h"
#include "shading/picture/picture.h"

namespace xnewell {

/// Which cells a picture shows, how often and on how many polygons.

/// Cells first .. first + count - 1.
struct CellRange {
  int first = 0, count = 0;
  [[nodiscard]] int last() const { return first + count - 1; }
  [[nodiscard]] bool has(int cell) const { return cell >= first && cell <= last(); }
  bool operator==(const CellRange&) const = default;
};

/// The cells that hold the colours of a painted picture.
[[nodiscard]] CellRange sceneCells(const Picture& picture);
/// The ramps among them, none where a plan holds colours.
[[nodiscard]] std::vector<CellRange> rampsOf(const Picture& picture);

struct CellUse {
  std::array<int, 256> samples{};   ///< the ground's too, so that they add up to the picture's
  std::array<int, 256> polygons{};  ///< faces of the model that show the cell at one sample at least
};

/// `faces` as Picture::faceImage() has them, 0 where nothing is; or empty, and no polygons are counted.
[[nodiscard]] CellUse cellUse(const IndexImage& image, const std::vector<std::uint32_t>& faces = {});

/// How many of the cells are used.
[[nodiscard]] int usedCells(const CellUse& use, const CellRange& cells);

/// The middle one of the cells that these polygons show, in the order of the cells and each as often as
/// polygons show it: a shade that many have, and no large ground of few. The first cell where none shows any.
[[nodiscard]] int medianCell(const CellUse& use, const CellRange& cells);

}  // namespace xnewell
