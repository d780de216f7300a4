#pragma once

#include "x11/window/bench.h"
#include "x11/window/control_column.h"
#include "x11/window/control_keys.h"

namespace xnewell {

/// The view of the picture with all its controls, keys and pointer.
class PictureBench : public Bench {
 public:
  /// The scene that the controls change.
  using Subject = std::function<ControlKeys::Subject()>;
  /// `keys` are shared with the other views that show controls. All arguments must outlive it.
  PictureBench(Host& host, ControlKeys& keys, Subject subject)
      : host_{host}, keys_{keys}, subject_{std::move(subject)} {}

  [[nodiscard]] bool press(const Key&, const Setup&) override { return false; }
  [[nodiscard]] std::string_view sharedKeys() const override { return allControls(); }
  void hover(int x, int y) override;
  [[nodiscard]] bool grab(int x, int y) override;
  void dragTo(int x, int y) override;
  void drop() override;
  void leave() override { hover_.reset(); }

  [[nodiscard]] Rect picture(const Layout& at) const override { return at.picture; }
  [[nodiscard]] bool late(const Setup& setup) const override;
  void draw(IndexImage& image, const Desk& desk) override;
  /// The picture of normals has colours of its own.
  [[nodiscard]] const OwnColors* colors() const override {
    return shownAs_ == Show::Normals ? &colors_ : nullptr;
  }
  [[nodiscard]] const CellUse* use() const override { return shownAs_ == Show::Shaded ? nullptr : &use_; }
  [[nodiscard]] std::string status() const override { return counts_; }
  [[nodiscard]] std::string aside() const override { return aside_; }
  [[nodiscard]] std::vector<Legend> legend() const override;
  [[nodiscard]] std::vector<HelpLine> help() const override;

 private:
  void grabControl(const ControlHit& hit);
  void dragControl(int x, int y);
  void drawCaption(IndexImage& image, const Desk& desk);

  Host& host_;
  ControlKeys& keys_;
  Subject subject_;
  std::optional<ControlHit> hover_;
  char dragged_ = 0;   ///< the key of the control that is dragged, or `t` for the scene
  int x_ = 0, y_ = 0;  ///< the pointer's last place during a drag
  // The state of the last drawing.
  Layout at_;
  ControlColumn column_;
  glm::dmat3 toView_{1};  ///< from world coordinates to right, up, towards the viewer
  char focus_ = 0, drawnDragged_ = 0;
  std::optional<ControlHit> drawnHover_;
  Show shownAs_ = Show::Shaded;
  ShownPicture shown_;
  LastTruth truth_;
  OwnColors colors_;
  CellUse use_;
  std::string counts_, aside_;
  std::string inexact_;   ///< how wrong the picture is, as a sentence
  bool counted_ = false;  ///< true if inexact_ is known
};

}  // namespace xnewell
