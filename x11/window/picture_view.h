#pragma once

#include <array>
#include <functional>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "shading/color/color_table.h"
#include "x11/drawing/painter.h"
#include "x11/kit/control.h"
#include "x11/views/views.h"
#include "x11/window/control_column.h"
#include "x11/window/controls.h"
#include "x11/window/layout.h"
#include "x11/window/window_view.h"

namespace xnewell {

/// The view of the picture with all its controls, keys and pointer.
class PictureView : public WindowView {
 public:
  /// `subject` is the scene that the controls change; `done` says which lessons were begun; `play` begins a
  /// game about the picture. All arguments must outlive it.
  PictureView(
      Host& host, std::function<Subject()> subject,
      std::function<std::vector<bool>()> done = [] { return std::vector<bool>{}; },
      std::function<void()> play = [] {})
      : WindowView{host}, subject_{std::move(subject)}, done_{std::move(done)}, play_{std::move(play)} {
    list_.setFocus(ControlId{'s'});
  }

  /// Shows the opening page over the picture until the first drag, and few controls.
  void welcome() { opening_ = forBeginners_ = true; }
  /// Shows all controls; false if all are shown.
  bool showAll() { return std::exchange(forBeginners_, false); }
  [[nodiscard]] bool late(const Setup& setup) const override {
    return WindowView::late(setup) || drawn_ != std::pair{opening_, forBeginners_};
  }

  [[nodiscard]] Controls controls() override;
  [[nodiscard]] KeyTable ownKeys() override;

  /// A press on the picture that is dragged turns the scene; one that is not explains the pixel under it.
  [[nodiscard]] bool grab(int x, int y) override;
  void dragTo(int x, int y) override;
  void drop() override;
  [[nodiscard]] Rect picture(const Layout& at) const override { return at.picture; }
  [[nodiscard]] Rect frame(const Layout& at) const override { return at.picture; }
  [[nodiscard]] bool hasDrawer() const override { return true; }
  void draw(Painter paint, const DrawContext& context) override;
  /// The picture of normals has colours of its own.
  [[nodiscard]] const OwnColors* colors() const override {
    return rowOf(shownAs_).hasOwnColors() ? &colors_ : nullptr;
  }
  [[nodiscard]] const CellUse* use() const override { return shownAs_ == View::Picture ? nullptr : &use_; }
  [[nodiscard]] std::string status() const override { return counts_; }
  [[nodiscard]] std::string aside() const override { return aside_; }

 private:
  /// The opening page: sentences and doors, as buttons.
  void addOpening(Controls& all);
  void drawOpening(Pen& pen);
  void drawColumn(Painter paint, const DrawContext& context);
  void drawCaption(Painter paint, const DrawContext& context);
  /// What a picture beside a drawer has above and below it: its title, and what was found, in large letters.
  void drawHeadlines(Painter paint, const DrawContext& context);
  void findInexactness(const DrawContext& context);
  /// A light more, beside the chosen one, which gives it half of its Ip; and one less.
  void addLamp();
  void removeLamp();

  std::function<Subject()> subject_;
  std::function<std::vector<bool>()> done_;
  std::function<void()> play_;
  bool opening_ = false, forBeginners_ = false;
  bool toldOfTurning_ = false;
  std::optional<glm::ivec2>
      clicked_;  ///< where the picture was pressed, in units, if it was not dragged since
  // The state of the last drawing.
  std::pair<bool, bool> drawn_;  ///< opening_, forBeginners_
  Layout at_;
  ControlColumn column_;
  glm::dmat3 toView_{1};  ///< from world coordinates to right, up, towards the viewer
  std::size_t lamp_ = 0;  ///< the light that was chosen last
  View shownAs_ = View::Picture;
  ShownPicture shown_;
  CachedGroundTruth truth_;
  OwnColors colors_;
  CellUse use_;
  std::string counts_, aside_;
  std::string inexact_;   ///< how wrong the picture is, as a sentence
  bool counted_ = false;  ///< true if inexact_ is known
};

}  // namespace xnewell
