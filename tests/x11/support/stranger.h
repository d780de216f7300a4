#pragma once

#include <cstddef>
#include <random>
#include <vector>

#include "tests/x11/support/x_server.h"

#include "x11/server/display.h"

namespace xnewell {

/// Another program with its own cells in the default map, in colours that are of no use to others.
class Stranger {
 public:
  /// Takes all free cells but `left`.
  Stranger(const XServer& server, std::size_t left) : display_{openDisplay(server.name())} {
    cells_ = freeCells();
    XFreeColors(get(), map(), cells_.data(), static_cast<int>(left), 0);
    cells_.erase(cells_.begin(), cells_.begin() + static_cast<std::ptrdiff_t>(left));
    paint(1);
  }
  [[nodiscard]] Display* get() const { return display_.get(); }
  [[nodiscard]] Colormap map() const { return DefaultColormap(get(), 0); }

  /// The number of free cells now, found by taking them one by one.
  [[nodiscard]] std::size_t countFree() const {
    std::vector<unsigned long> cells = freeCells();
    XFreeColors(get(), map(), cells.data(), static_cast<int>(cells.size()), 0);
    XSync(get(), 0);
    return cells.size();
  }
  /// Puts other colours into its cells.
  void paint(unsigned seed) {
    std::mt19937 rng{seed};
    const auto value = [&] { return static_cast<unsigned short>(rng()); };
    for (const unsigned long pixel : cells_) {
      XColor cell{.pixel = pixel,
                  .red = value(),
                  .green = value(),
                  .blue = value(),
                  .flags = DoRed | DoGreen | DoBlue,
                  .pad = 0};
      XStoreColor(get(), map(), &cell);
    }
    XSync(get(), 0);
  }
  /// Gives its cells back, and another program takes and colours them.
  void leave() {
    XFreeColors(get(), map(), cells_.data(), static_cast<int>(cells_.size()), 0);
    cells_ = freeCells();
    paint(2);
  }
  [[nodiscard]] const std::vector<unsigned long>& cells() const { return cells_; }

 private:
  [[nodiscard]] std::vector<unsigned long> freeCells() const {
    std::vector<unsigned long> cells;
    for (unsigned long pixel = 0; XAllocColorCells(get(), map(), 0, nullptr, 0, &pixel, 1) != 0;)
      cells.push_back(pixel);
    return cells;
  }
  OwnedDisplay display_;
  std::vector<unsigned long> cells_;
};

}  // namespace xnewell
