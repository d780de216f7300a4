#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <string>

#include "x11/views/mach_bands.h"
#include "x11/window/window_view.h"

namespace xnewell {

/// The view of the Mach bands in the window: keys and pointer move the scanline.
class MachBandsView : public WindowView {
 public:
  MachBandsView(Host& host, std::function<Subject()> subject)
      : WindowView{host}, subject_{std::move(subject)} {}

  /// Chooses the scanline by its row in the picture that is drawn next.
  void choose(int row) { asked_ = row, row_.reset(); }
  [[nodiscard]] int row() const { return row_.value_or(0); }

  [[nodiscard]] Controls controls() override;
  [[nodiscard]] KeyTable ownKeys() override;
  void enter() override { list_.setFocus(ControlId{'y'}); }

  [[nodiscard]] Rect picture(const Layout& at) const override;
  /// Profiles stand under their pixels.
  [[nodiscard]] Rect frame(const Layout& at) const override { return picture(at); }
  [[nodiscard]] Setup painted(const Setup& setup) const override;
  [[nodiscard]] bool late(const Setup&) const override { return row_ != drawnRow_ || list_.late(); }
  void draw(Painter paint, const DrawContext& context) override;
  [[nodiscard]] std::string status() const override { return status_; }
  [[nodiscard]] std::vector<std::string> report() const override { return words_; }

 private:
  void moveScanline(int rows) { moveTo(row_.value_or(0) + rows); }
  void moveTo(int row) { row_ = std::clamp(row, 0, height_ - 1); }

  std::function<Subject()> subject_;
  int unit_ = 1;              ///< of the layout drawn last
  std::optional<int> asked_;  ///< the row of the next drawing
  std::optional<int> row_;    ///< the scanline's row in the picture; none: the row that shows most
  // The state of the last drawing.
  Rect picture_{};
  std::optional<int> firstRow_;  ///< the first row of the picture that is shown
  int height_ = 1, divisions_ = 0;
  bool patches_ = false;  ///< the scene has some; it may set the divisions of all
  std::optional<int> drawnRow_;
  std::string status_;
  std::vector<std::string> words_;
};

}  // namespace xnewell
