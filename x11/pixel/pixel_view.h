#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <string>

#include "x11/kit/quiz.h"
#include "x11/pixel/pixel_page.h"
#include "x11/window/window_view.h"

namespace xnewell {

/// A picture, what is below it, and the page beside both.
struct PixelFrame {
  Rect picture, below, column;
  int controls = 0;  ///< the baseline of the first row of controls
};
[[nodiscard]] PixelFrame frameOf(const Layout& at);

/// View 8: why one pixel of the picture has its colour. A changed setting keeps the pixel.
class PixelView : public WindowView {
 public:
  PixelView(Host& host, std::function<Subject()> subject) : WindowView{host}, subject_{std::move(subject)} {}

  /// Chooses the pixel at this share of the picture's width and height; outside it, the nearest.
  void choose(double x, double y);
  /// Chooses a pixel by its column and row in the picture that is drawn next.
  void choose(glm::ivec2 pixel);
  /// Its column and row in the picture that was drawn last.
  [[nodiscard]] glm::ivec2 pixel() const {
    return {std::min(width_ - 1, static_cast<int>(x_ * width_)),
            std::min(height_ - 1, static_cast<int>(y_ * height_))};
  }

  [[nodiscard]] Controls controls() override;
  [[nodiscard]] KeyTable ownKeys() override;
  void enter() override { list_.setFocus(std::nullopt); }

  [[nodiscard]] Rect picture(const Layout& at) const override { return frameOf(at).picture; }
  /// The page states what cells hold, so another hue draws it again.
  [[nodiscard]] bool late(const Setup& setup) const override {
    return late_ || setup_ != setup || list_.late();
  }
  void draw(Painter paint, const DrawContext& context) override;
  [[nodiscard]] std::string status() const override { return status_; }
  [[nodiscard]] std::string aside() const override {
    return "a changed setting keeps the pixel; Esc gives the arrows back to it";
  }
  [[nodiscard]] std::vector<std::string> report() const override { return words_; }
  [[nodiscard]] std::optional<int> inspected() const override {
    return quiz_.landed() ? quiz_.landed() : quiz_.isHiding() ? std::nullopt : cell_;
  }

 private:
  void move(int columns, int rows);
  void goTo(int column, int row);
  void walk(int steps);
  void turnBall(double around, double down);
  void addParts(Controls& all);

  std::function<Subject()> subject_;
  /// The pixel's place, as shares of the picture: so it stays in the scene if the window's size changes.
  double x_ = 0.5, y_ = 0.5;
  std::optional<glm::ivec2> asked_;  ///< the pixel of the next drawing
  std::optional<int> chosen_;        ///< a polygon of the history; none: the one that shows
  int vertex_ = 0, channel_ = 0;
  BallTurn ball_;
  Quiz quiz_{host_, [this] { late_ = true; }};
  std::optional<PixelBefore> found_, kept_;  ///< when the pixel was chosen; by k
  bool late_ = true;
  // The state of the last drawing.
  Rect picture_{};
  std::vector<page::Pressed> pressed_;
  Rect around_{};                 ///< the neighbourhood
  int width_ = 1, height_ = 1;    ///< of the picture, in pixels
  int painted_ = 0, shown_ = -1;  ///< of the history
  int vertices_ = 0, channels_ = 1;
  std::optional<PixelBefore> now_;
  std::optional<int> cell_;
  std::optional<Setup> setup_;
  std::string status_;
  std::vector<std::string> words_;
};

}  // namespace xnewell
