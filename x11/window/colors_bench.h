#pragma once

#include <optional>
#include <string>
#include <vector>

#include "x11/views/colors_page.h"
#include "x11/window/bench.h"

namespace xnewell {

/// The view of the colour table in the window, without a server: which cell is inspected, and what keys and
/// pointer do to the colours that are stored. Only colours change: the picture is not painted again.
class ColorsBench : public Bench {
 public:
  /// The host outlives it.
  explicit ColorsBench(Host& host) : host_{host} {}

  [[nodiscard]] bool press(const Key& key, const Setup& setup) override;
  [[nodiscard]] std::string_view sharedKeys() const override { return "HBJT"; }
  void release(char letter) override;
  /// The pointer over a cell, or over a column of the plots.
  void hover(int x, int y) override;
  /// The stored values are dragged.
  [[nodiscard]] bool grab(int x, int y) override;
  void dragTo(int x, int y) override;
  void drop() override {
    grabbed_ = false;
    dragged_ = 0;
  }
  void leave() override;
  /// The ramp is: tick() moves it by a shade.
  [[nodiscard]] bool moving() const override { return moving_; }
  void tick() override;

  [[nodiscard]] Rect picture(const Layout& at) const override { return layoutOfColors(at.body).picture; }
  /// With the table that picks the indices: another one where they are held.
  [[nodiscard]] Setup painted(const Setup& setup) const override;
  [[nodiscard]] PaletteEffects stored(const Setup& setup) const override;
  /// Whether what was drawn tells of other cells or colours than there are now.
  [[nodiscard]] bool late(const Setup& setup) const override { return told(setup) != drawn_; }
  void draw(IndexImage& image, const Desk& desk) override;
  [[nodiscard]] std::string status() const override { return levels_; }
  [[nodiscard]] std::vector<Legend> legend() const override;
  [[nodiscard]] std::vector<HelpLine> help() const override;
  [[nodiscard]] bool countsPolygons() const override { return true; }
  [[nodiscard]] std::optional<int> inspected() const override { return cell(); }

 private:
  /// Everything stored as it was.
  void undo();
  void inspect(int cell);
  [[nodiscard]] int cell() const { return cell_.value_or(0); }
  bool pressOnSlider(const Key& key, int times);
  bool grabLine(const TableLineHit& hit);
  void setSlider(double share);
  [[nodiscard]] bool hasRamp(const char* what);
  /// Held indices know one number of shades and one I0: with others they follow the setup.
  [[nodiscard]] bool holds(const Setup& setup) const;
  /// All words and curves depend on: not what passes by itself, the light and the moving ramp.
  struct Told {
    std::optional<int> cell;
    PaletteEffects effects;
    Setup setup;
    char focus = 0;
    bool moving = false, holds = false;
    bool operator==(const Told&) const = default;
  };
  [[nodiscard]] Told told(const Setup& setup) const;
  [[nodiscard]] std::vector<TableLine> lines(const Picture& picture, const Setup& setup) const;

  Host& host_;
  std::optional<int> cell_;
  PaletteEffects effects_;  ///< but for `stored`, which follows from the setup and held_
  bool moving_ = false, grabbed_ = false;
  double brightest_ = 255.0;           ///< of 255, that the ramp's last cell holds
  int grabbedY_ = 0;                   ///< of the pointer
  char focus_ = 0;                     ///< of a slider that has the arrows; 0: the cells have them
  char dragged_ = 0;                   ///< the slider that is
  std::optional<TableSettings> held_;  ///< what picks the indices
  // Of what was drawn last.
  ColorsLayout at_;
  Rect strip_{};
  std::vector<TableLine> lines_;
  std::string levels_;
  CellRange scene_;
  bool ramps_ = false;
  std::optional<Told> drawn_;
};

}  // namespace xnewell
