#pragma once

#include <array>
#include <optional>
#include <vector>

#include "shading/color/palette.h"
#include "x11/server/display.h"
#include "x11/visual/emulation.h"
#include "x11/visual/visual.h"

namespace xnewell {

/// Cells of a map that others use too (`--colormap shared`), or of a map that is too small for the whole
/// table. We use only what nobody else can change: cells of our own, and read-only cells, which cannot change
/// as long as some program holds them, as we do. So it does not matter what other programs do to the map.
class SharedCells {
 public:
  /// Takes up to `shades` cells for a ramp, and cells for those interface colours that the map does not have
  /// yet. The interface gets at most a quarter of the free cells, so that few cells still make a picture. An
  /// interface colour without a cell is shown by the nearest colour there is, so those that would suffer most
  /// come first: black and white, which the map has anyway; then the grays between them; then the colours
  /// that carry a meaning; last those that hardly differ from black or white. A ramp of one shade is useless:
  /// its cell is given back. If `shades` is 0, we take only black and white.
  /// We leave kLeft cells to programs that start later, or a quarter if fewer than 4 kLeft were free. Of a
  /// map that is `ours`, we leave none. All other programs wait during this. So if two programs start
  /// together, they share the cells and neither gets none.
  SharedCells(Display* display, Colormap map, const VisualInfo& visual, int shades, bool ours);
  static constexpr std::size_t kLeft = 16;
  ~SharedCells();
  SharedCells(const SharedCells&) = delete;
  SharedCells& operator=(const SharedCells&) = delete;

  /// The cells that we may store into: the pixel values of shade 0, 1, ...
  [[nodiscard]] const std::vector<unsigned long>& ramp() const { return ramp_; }
  /// Gives all cells of the ramp back, for a caller that can show more without them. held() still returns the
  /// colours that it found before.
  void giveRampBack();
  /// The cell that shows an interface colour exactly, if there is one.
  [[nodiscard]] std::optional<unsigned long> interfaceCell(Cell cell) const {
    return interface_[static_cast<int>(cell)];
  }
  /// All read-only colours of the map; at least black and white. We take hold of each, with one request each.
  [[nodiscard]] std::vector<OfferedColor> held();
  /// The levels that each channel of a visual with channels can have. These are even levels, as far as cells
  /// are free or others show the same level, and levels that others show; at least 0 and full. Each costs one
  /// request.
  [[nodiscard]] std::array<std::vector<OfferedLevel>, 3> levels();

 private:
  /// Takes the read-only cell with that colour: one that the map has, or a new one if a cell is free.
  std::optional<unsigned long> take(Rgb16 color);

  Display* display_;
  Colormap map_;
  VisualInfo visual_;
  std::vector<unsigned long> ramp_;
  std::array<std::optional<unsigned long>, kCells> interface_{};
  std::vector<OfferedColor> held_;
  std::vector<unsigned long> taken_;  ///< the read-only cells, each listed as often as we took it
};

}  // namespace xnewell
