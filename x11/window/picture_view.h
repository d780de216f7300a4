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
#include "x11/window/controls.h"
#include "x11/window/layout.h"
#include "x11/window/window_view.h"

namespace xnewell {

/// The column of controls at the right edge of the window.

/// A button does the same as its key.
struct ButtonRow {
  char key;
  std::string_view label;
  bool always;  ///< also in a window of less than 1024 x 768
};
inline constexpr std::array kButtons{
    ButtonRow{'[', "Ia = 1", false}, ButtonRow{']', "Ip = 1", false},     ButtonRow{'u', "undo", true},
    ButtonRow{'r', "reset", true},   ButtonRow{'w', "save", true},        ButtonRow{'e', "open", true},
    ButtonRow{'U', "redo", false},   ButtonRow{kDrawerKey, "hide", true},
};

/// The places of the column's parts. The kit (x11/kit) draws the controls and finds them under the pointer,
/// except for the ball of the light and the bar of Ia and Ip, which are drawn here.
struct ControlColumn {
  bool compact = false;
  Rect area, ball, bar;
  int radius = 0;  ///< of the sphere in the middle of `ball`
  struct Heading {
    int y;
    std::string_view name;
  };
  std::vector<Heading> headings;
  std::vector<std::pair<ControlId, ControlPlace>> places;
};
/// The column of a window, if layoutOf() says that it is roomy. If there are too many controls for its
/// height, the rows are closer together. `controls` are those of all settings, with the buttons and the
/// light; `thumbs` are the values of the bar's two thumbs, Ia and Ia + Ip.
/// For beginners there are only a few rows.
[[nodiscard]] ControlColumn layoutOfControls(const Layout& at, const Controls& controls, glm::dvec2 thumbs,
                                             bool forBeginners = false);

/// The buttons, as controls. `press` gets a button's letter.
[[nodiscard]] Controls buttonControls(const std::function<void(char)>& press);

/// The cells that show the intensities k / 255 on the ball. If there are few cells, two of them are mixed.
struct BallCells {
  std::array<std::uint8_t, 256> low{}, high{};
  std::array<int, 256> share{};  ///< how many of 64 neighbours get `high`
};

/// What the light's ball and the bar of the intensities show.
struct LightShown {
  const Setup& setup;
  LightAngles angles;         ///< of the chosen light
  std::vector<Light> lamps;   ///< from the scene's centre: to the right, up, towards the viewer
  std::size_t lamp = 0;       ///< the chosen one
  double size = 1, unit = 1;  ///< of the scene, and the length that `inverse` takes for 1
  const BallCells& ball;
  double ambient = 0, lights = 0;  ///< the intensities in force: Ia, and the sum of all Ip
  bool IaIsOwn = false;            ///< the scene says Ia
  Look light, Ia, Ip;
};
/// Where the ring of a light is on the ball.
[[nodiscard]] glm::ivec2 ringOf(const ControlColumn& at, const Light& lamp);
/// Draws the headings, the light and the intensities on a background of paper.
void drawLightControls(Pen& pen, const ControlColumn& at, const LightShown& shown);

/// The direction on the ball under the pointer, a unit vector: to the right, up, towards the viewer. Outside
/// the sphere's outline it points to the far side.
[[nodiscard]] glm::dvec3 directionOnBall(const ControlColumn& at, int x, int y);

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
