#pragma once

#include <array>
#include <optional>
#include <vector>

#include "shading/color/palette.h"
#include "x11/server/display.h"
#include "x11/visual/emulation.h"
#include "x11/visual/visual.h"

namespace xnewell {

/// `--colormap shared`: cells of the default colormap, which other programs use too; or of any map that has
/// too few for the whole table. Only what nobody else can change is used: cells of our own, and cells that
/// are read-only for as long as somebody has them, as we then do. So it does not matter what others do to the
/// map.
class SharedCells {
 public:
  /// Takes up to `shades` cells for a ramp, and cells for the interface's colours where the map has not got
  /// them: of the free cells a quarter at most, so that few cells still make a picture. Whoever gets none is
  /// shown by the nearest colour there is; so the order is by what would suffer most: first the grays between
  /// black and white, for those two are always there, then the colours that mean something, last those that
  /// hardly differ from black or white. A ramp of one shade is none: the cell is given back. Where no shades
  /// are asked for, no cell is taken but the map's black and white.
  /// All others wait meanwhile, so that two programs that start together share and do not starve.
  SharedCells(Display* display, Colormap map, const VisualInfo& visual, int shades);
  ~SharedCells();
  SharedCells(const SharedCells&) = delete;
  SharedCells& operator=(const SharedCells&) = delete;

  /// Ours to store into: pixel values of shade 0, 1, ...
  [[nodiscard]] const std::vector<unsigned long>& ramp() const { return ramp_; }
  /// For who shows more without: all their cells back. The colours held() are then those asked for before.
  void giveRampBack();
  /// The cell that shows an interface colour exactly, if there is one.
  [[nodiscard]] std::optional<unsigned long> interfaceCell(Cell cell) const {
    return interface_[static_cast<int>(cell)];
  }
  /// All read-only colours of the map, black and white at least. Takes hold of them, which asks the server
  /// once for each.
  [[nodiscard]] std::vector<OfferedColor> held();
  /// Of a visual with channels: even levels of each, as far as there are free cells or others show the same,
  /// and those that others show; full and none at least. Asks the server once for each.
  [[nodiscard]] std::array<std::vector<OfferedLevel>, 3> levels();

 private:
  /// The read-only cell of that colour: the map's, or a new one where a cell is free.
  std::optional<unsigned long> take(Rgb16 color);

  Display* display_;
  Colormap map_;
  VisualInfo visual_;
  std::vector<unsigned long> ramp_;
  std::array<std::optional<unsigned long>, kCells> interface_{};
  std::vector<OfferedColor> held_;
  std::vector<unsigned long> taken_;  ///< read-only cells, each as often as it was taken
};

}  // namespace xnewell
