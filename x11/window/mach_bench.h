#pragma once

#include <optional>
#include <string>

#include "x11/views/mach_bands.h"
#include "x11/window/bench.h"
#include "x11/window/control_keys.h"

namespace xnewell {

/// The view of the Mach bands in the window: keys and pointer move the scanline.
class MachBench : public Bench {
 public:
  using Subject = std::function<ControlKeys::Subject()>;
  /// All arguments must outlive it.
  MachBench(Host& host, ControlKeys& keys, Subject subject)
      : host_{host}, keys_{keys}, subject_{std::move(subject)} {}

  [[nodiscard]] bool press(const Key& key, const Setup& setup) override;
  [[nodiscard]] std::string_view sharedKeys() const override { return "tzS+-"; }
  void hover(int x, int y) override;
  [[nodiscard]] bool grab(int x, int y) override;
  void dragTo(int x, int y) override;
  void drop() override { dragged_ = 0; }
  void enter() override { focus_ = 'y'; }
  void leave() override { hovered_ = 0; }

  [[nodiscard]] Rect picture(const Layout& at) const override;
  [[nodiscard]] Setup painted(const Setup& setup) const override;
  [[nodiscard]] bool late(const Setup& setup) const override;
  void draw(IndexImage& image, const Desk& desk) override;
  [[nodiscard]] std::string status() const override { return status_; }
  [[nodiscard]] std::vector<Legend> legend() const override;
  [[nodiscard]] std::vector<HelpLine> help() const override;

 private:
  /// The state that does not follow from the settings.
  struct Shown {
    int row = 0;
    char focus = 'y', hovered = 0, dragged = 0;
    int option = -1;
    bool operator==(const Shown&) const = default;
  };
  void askForDivisions();
  [[nodiscard]] Shown shown() const { return {row_.value_or(0), focus(), hovered_, dragged_, option_}; }
  /// The control that the arrows change: one of this view, or one of ControlKeys.
  [[nodiscard]] char focus() const { return focus_ ? focus_ : keys_.focus(); }
  void moveScanline(int rows);
  void divide(int divisions);
  /// The control whose row holds the point; for a choice also its option.
  [[nodiscard]] char rowAt(int x, int y, int& option) const;
  void drawControls(IndexImage& image, const Desk& desk);

  Host& host_;
  ControlKeys& keys_;
  Subject subject_;
  std::optional<int> row_;  ///< the scanline's row in the picture; none: the row that shows most
  char focus_ = 'y';        ///< y, k, or 0: the focus of ControlKeys
  char dragged_ = 0;        ///< y, k, or p for the picture; 0: nothing is dragged
  char hovered_ = 0;
  int option_ = -1;
  // The state of the last drawing.
  Rect picture_{}, controls_{};
  std::optional<int> firstRow_;  ///< the first row of the picture that is shown
  int height_ = 1, divisions_ = 0;
  bool patches_ = false;  ///< the scene has some; it may set the divisions of all
  std::vector<Rect> options_;
  std::optional<Shown> drawn_;
  std::string status_;
};

}  // namespace xnewell
