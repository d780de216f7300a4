#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <optional>
#include <string>

#include "x11/views/shows.h"
#include "x11/window/bench.h"
#include "x11/window/control_column.h"

namespace xnewell {

/// The view of the picture with all its controls, keys and pointer.
class PictureBench : public Bench {
 public:
  /// `subject` is the scene that the controls change. All arguments must outlive it.
  PictureBench(Host& host, std::function<Subject()> subject) : Bench{host}, subject_{std::move(subject)} {
    list_.setFocus(ControlId{'s'});
  }

  [[nodiscard]] Controls controls() override;
  [[nodiscard]] KeyTable ownKeys() override;

  /// A press on the picture that is dragged turns the scene; one that is not explains the pixel under it.
  [[nodiscard]] bool grab(int x, int y) override;
  void dragTo(int x, int y) override;
  void drop() override;
  [[nodiscard]] Rect picture(const Layout& at) const override { return at.picture; }
  [[nodiscard]] bool hasDrawer() const override { return true; }
  void draw(Painter paint, const Desk& desk) override;
  /// The picture of normals has colours of its own.
  [[nodiscard]] const OwnColors* colors() const override {
    return rowOf(shownAs_).ownColors ? &colors_ : nullptr;
  }
  [[nodiscard]] const CellUse* use() const override { return shownAs_ == Show::Shaded ? nullptr : &use_; }
  [[nodiscard]] std::string status() const override { return counts_; }
  [[nodiscard]] std::string aside() const override { return aside_; }

 private:
  void drawColumn(Painter paint, const Desk& desk);
  void drawCaption(Painter paint, const Desk& desk);
  /// What a picture beside a drawer has above and below it: its title, and what was found, in large letters.
  void drawHeadlines(Painter paint, const Desk& desk);
  void findInexactness(const Desk& desk);

  std::function<Subject()> subject_;
  std::optional<glm::ivec2>
      clicked_;  ///< where the picture was pressed, in units, if it was not dragged since
  // The state of the last drawing.
  Layout at_;
  ControlColumn column_;
  glm::dmat3 toView_{1};  ///< from world coordinates to right, up, towards the viewer
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
