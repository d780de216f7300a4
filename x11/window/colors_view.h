#pragma once

#include <optional>
#include <string>

#include "x11/views/colors_page.h"
#include "x11/window/window_view.h"

namespace xnewell {

/// The view of the colour table in the window, without a server: which cell is inspected, and how keys and
/// pointer change the stored colours. Only colours change; the picture is not painted again.
class ColorsView : public WindowView {
 public:
  /// The host must outlive it.
  explicit ColorsView(Host& host) : WindowView{host} {}

  [[nodiscard]] Controls controls() override;
  [[nodiscard]] KeyTable ownKeys() override;
  void release(char letter) override;
  /// The pointer moves over a cell, over a column of the plots, or over a control.
  void hover(int x, int y) override;
  /// Handles a press of the button, which may start a drag on a slider or on the curve of stored values.
  [[nodiscard]] bool grab(int x, int y) override;
  void leave() override;
  bool reset() override;
  /// True while the ramp moves: tick() moves it by one shade.
  [[nodiscard]] bool moving() const override { return moving_; }
  void tick() override;

  [[nodiscard]] Rect picture(const Layout& at) const override { return layoutIn(at).picture; }
  /// The setup whose table picks the indices. While the indices are held, the stored table may be another
  /// one.
  [[nodiscard]] Setup painted(const Setup& setup) const override;
  [[nodiscard]] PaletteEffects stored(const Setup& setup) const override;
  /// True if the cells, the colours or the controls have changed since the page was drawn.
  [[nodiscard]] bool late(const Setup& setup) const override { return told(setup) != drawn_ || list_.late(); }
  void draw(Painter paint, const DrawContext& context) override;
  [[nodiscard]] std::string status() const override { return levels_; }
  [[nodiscard]] std::vector<std::string> report() const override { return words_; }
  [[nodiscard]] bool countsPolygons() const override { return true; }
  [[nodiscard]] std::optional<int> inspected() const override { return cell(); }

  /// Chooses the cell that the page is about.
  void choose(int cell) { inspect(cell); }

 private:
  [[nodiscard]] static ColorsLayout layoutIn(const Layout& at) {
    ColorsLayout colors = layoutOfColors(at.body);
    colors.picture = framed(colors.picture, at.frame.width);
    return colors;
  }
  /// Restores all stored colours, releases the indices and gives the arrows back to the cells.
  void undo();
  void inspect(int cell);
  [[nodiscard]] int cell() const { return cell_.value_or(0); }
  /// The cell that the page shows at a place.
  [[nodiscard]] std::optional<int> cellAt(int x, int y) const;
  void bendTo(int y);
  /// Held indices are for one number of shades and one I0. If these change, the indices follow the settings
  /// again.
  [[nodiscard]] bool holds(const Setup& setup) const;
  /// What words and curves on the page describe: the table at rest, without the lit cell and without the
  /// ramp's shift.
  struct Shown {
    std::optional<int> cell;
    PaletteEffects effects;
    Setup setup;
    bool moving = false, holds = false;
    bool operator==(const Shown&) const = default;
  };
  [[nodiscard]] Shown told(const Setup& setup) const;

  std::optional<int> cell_;
  PaletteEffects effects_;  ///< except `stored`, which follows from the settings and held_
  bool moving_ = false;
  bool again_ = false;        ///< the key was pressed while the cell was lit
  bool chosen_ = false;       ///< a click or a key chose the cell, so the pointer above others leaves it
  double brightest_ = 255.0;  ///< the value in the last cell of the ramp, of 255
  std::optional<TableSettings> held_;  ///< the table that picks the indices
  // The state of the last drawing.
  ColorsLayout at_;
  Rect strip_{};
  Controls facts_;  ///< the lines of the table, without keys
  std::string levels_;
  std::vector<std::string> words_;
  CellRange scene_;
  bool ramps_ = false;
  std::optional<Shown> drawn_;
};

}  // namespace xnewell
