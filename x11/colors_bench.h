#pragma once

#include <optional>
#include <string>
#include <vector>

#include "shading/colors_page.h"
#include "x11/controls.h"
#include "x11/key.h"

/// The view of the colour table in the window, without a server: which cell is inspected, and what keys and
/// pointer do to the colours that are stored. Only colours change: the picture is not painted again.
class ColorsBench {
 public:
  /// Keys of its own. False: not one of them.
  [[nodiscard]] bool press(const Key& key, const Setup& setup);
  void release(char letter);
  /// Esc, and leaving the view.
  void undo();
  /// The pointer over a cell, or over a column of the plots.
  void hover(int x, int y);
  void inspect(int cell);
  /// The button pressed over the stored values, then the pointer moved, then let go.
  [[nodiscard]] bool grab(int x, int y);
  void dragBy(int dx, int dy);
  void drop() { grabbed_ = false; }
  /// The ramp is moving: tick() is to be called every so often, and moves it by a shade.
  [[nodiscard]] bool moving() const { return moving_; }
  void tick();

  [[nodiscard]] int cell() const { return cell_.value_or(0); }
  /// A sentence about the last key, "" for none.
  [[nodiscard]] const std::string& notice() const { return notice_; }
  /// The setup with the table that picks the indices: another one where they are held.
  [[nodiscard]] Setup painted(Setup setup) const;
  /// What is stored instead of the painted picture's colours.
  [[nodiscard]] PaletteEffects stored(const Setup& setup) const;
  /// Whether what was drawn tells of other cells or colours than there are now.
  [[nodiscard]] bool wordsAreLate(const Setup& setup) const;

  /// What is painted, for the page to show.
  struct Shown {
    const Picture& picture;
    const IndexImage& image;
    const CellUse& use;
    const CellPlan& plan;
    const Palette& palette;  ///< the picture's own, without effects
  };
  /// The page at `body`, all else paper. Returns what the status line says of the table.
  std::string draw(IndexImage& image, const Rect& body, const Shown& shown, const Setup& setup);

 private:
  [[nodiscard]] bool hasRamp(const char* what);
  /// Held indices know one number of shades and one I0: with others they follow the setup.
  [[nodiscard]] bool holds(const Setup& setup) const;
  /// All words and curves depend on: not what passes by itself, the light and the moving ramp.
  struct Told {
    std::optional<int> cell;
    PaletteEffects effects;
    Setup setup;
    bool moving = false, holds = false;
    bool operator==(const Told&) const = default;
  };
  [[nodiscard]] Told told(const Setup& setup) const;
  [[nodiscard]] std::vector<TableLine> lines(const Picture& picture, const Setup& setup) const;

  std::optional<int> cell_;
  PaletteEffects effects_;  ///< but for `stored`, which follows from the setup and held_
  bool moving_ = false, grabbed_ = false;
  std::optional<TableSettings> held_;  ///< what picks the indices
  std::string notice_;
  int x_ = 0, y_ = 0;  ///< the pointer, while the curve is dragged
  // Of what was drawn last.
  ColorsLayout at_;
  CellRange scene_;
  bool ramps_ = false;
  std::optional<Told> drawn_;
};
