#include "shading/picture/cell_use.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

namespace xnewell {

CellRange sceneCells(const Picture& picture) {
  const SceneColors& colors = picture.colors();
  if (channelsOf(colors.plan()) == Channels::Rgb) return {colors.table().first(), picture.chosenColors()};
  const ColorTable& last = colors.tables().back();
  return {colors.table().first(), last.first() + last.shades() - colors.table().first()};
}

std::vector<CellRange> rampsOf(const Picture& picture) {
  std::vector<CellRange> ramps;
  if (channelsOf(picture.colors().plan()) == Channels::Rgb) return ramps;
  for (const ColorTable& table : picture.colors().tables()) ramps.push_back({table.first(), table.shades()});
  return ramps;
}

CellUse cellUse(const IndexImage& image, const std::vector<std::uint32_t>& faces) {
  assert(faces.empty() || faces.size() == image.pixels.size());
  CellUse use;
  // Four counts by turns: neighbours have the same cell, and adding to one count four times would wait for
  // itself.
  std::array<std::array<int, 256>, 4> counts{};
  for (std::size_t k = 0; k < image.pixels.size(); ++k) ++counts[k % 4][image.pixels[k]];
  for (const auto& count : counts)
    for (std::size_t cell = 0; cell < count.size(); ++cell) use.samples[cell] += count[cell];

  std::vector<std::pair<std::uint8_t, std::uint32_t>> shown;  // one entry for each run of equal samples
  for (std::size_t k = 0; k < faces.size(); ++k) {
    const std::pair both{image.pixels[k], faces[k]};
    if (faces[k] != 0 && (shown.empty() || shown.back() != both)) shown.push_back(both);
  }
  std::ranges::sort(shown);
  shown.erase(std::unique(shown.begin(), shown.end()), shown.end());
  for (const auto& [cell, face] : shown) ++use.polygons[cell];
  return use;
}

int usedCells(const CellUse& use, const CellRange& cells) {
  int used = 0;
  for (int cell = cells.first; cell <= cells.last(); ++cell) used += use.samples[cell] > 0;
  return used;
}

int medianCell(const CellUse& use, const CellRange& cells) {
  std::int64_t all = 0, below = 0;
  for (int cell = cells.first; cell <= cells.last(); ++cell) all += use.polygons[cell];
  for (int cell = cells.first; cell <= cells.last(); ++cell) {
    below += use.polygons[cell];
    if (2 * below > all) return cell;
  }
  return cells.first;
}

}  // namespace xnewell
