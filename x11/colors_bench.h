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
  /// What it has to know of the picture that is shown, after each frame.
  void show(const Picture& picture, const ColorsLayout& at, const CellUse& use);

  /// Keys of its own. False: not one of them.
  [[nodiscard]] bool press(const Key& key);
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
  /// The ramp moves by a shade.
  void tick();

  /// Indices are held as this table picks them, or follow the setup's.
  void hold(const std::optional<TableSettings>& indices) { held_ = indices; }
  [[nodiscard]] const std::optional<TableSettings>& held() const { return held_; }
  /// The setup with the table that picks the indices.
  [[nodiscard]] Setup painted(Setup setup) const;

  [[nodiscard]] int cell() const { return cell_.value_or(0); }
  /// The ramp is moving: tick() is to be called every so often.
  [[nodiscard]] bool moving() const { return moving_; }
  /// What is stored, and what of it the words and curves are about: not what passes by itself, the light and
  /// the moving ramp.
  [[nodiscard]] PaletteEffects stored(const Setup& setup) const;
  [[nodiscard]] PaletteEffects told(const Setup& setup) const;
  /// A sentence about the last key, "" for none.
  [[nodiscard]] const std::string& notice() const { return notice_; }

  /// The settings of the table with their keys.
  [[nodiscard]] std::vector<TableLine> lines(const Picture& picture, const Setup& setup) const;

 private:
  [[nodiscard]] bool hasRamp(const char* what);

  std::optional<int> cell_;
  PaletteEffects effects_;  ///< `stored` is not kept here: it follows from the setup and held_
  bool moving_ = false, grabbed_ = false;
  std::optional<TableSettings> held_;
  std::string notice_;
  // Of the picture that is shown.
  ColorsLayout at_;
  CellRange scene_;
  bool ramps_ = false;
  int x_ = 0, y_ = 0;  ///< the pointer, while the curve is dragged
};
