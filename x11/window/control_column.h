#pragma once

#include <array>
#include <optional>
#include <vector>

#include "shading/color/index_image.h"
#include "shading/color/palette.h"
#include "x11/drawing/rect.h"
#include "x11/window/controls.h"
#include "x11/window/layout.h"

namespace xnewell {

/// The column of controls at the right edge of the window: where each control is, how it is drawn, and which
/// one the pointer is on.

/// A button does the same as its key.
struct ButtonRow {
  char key;
  std::string_view label;
  bool always;  ///< also in a window of less than 1024 x 768
};
inline constexpr std::array kButtons{
    ButtonRow{'[', "Ia = 1", false}, ButtonRow{']', "Ip = 1", false}, ButtonRow{'u', "undo", true},
    ButtonRow{'r', "reset", true},   ButtonRow{'w', "save", true},    ButtonRow{'e', "open", true},
    ButtonRow{'U', "redo", false},
};

/// A control's place, in pixels.
struct ControlPlace {
  enum class Kind { Slider, Choice, Toggle, Light, Intensity, Button };
  Kind kind;
  char key;
  int x, y;                        ///< the left edge of the key's cap, and the baseline of the text
  Rect row;                        ///< its own area; for an intensity also the half of the bar with its thumb
  Rect track;                      ///< for a slider and the intensities: from the lowest value to the highest
  std::vector<Rect> options = {};  ///< of a choice
};
struct ControlColumn {
  bool compact = false;
  Rect area, ball;
  int radius = 0;  ///< of the sphere in the middle of `ball`
  struct Heading {
    int y;
    std::string_view name;
  };
  std::vector<Heading> headings;
  std::vector<ControlPlace> places;

  [[nodiscard]] const ControlPlace* find(char key) const;
};
/// The column of a window, if layoutOf() says that it is roomy. If there are too many controls for its
/// height, the rows are closer together.
[[nodiscard]] ControlColumn layoutOfControls(const Layout& at);

/// The control that the pointer is on.
struct ControlHit {
  char key = 0;
  int option = -1;  ///< of a choice
  bool operator==(const ControlHit&) const = default;
};
/// The control at a point. The ball of the light counts as `l`. On the bar of the intensities it is the one
/// whose thumb is nearer.
[[nodiscard]] std::optional<ControlHit> controlAt(const ControlColumn& at, const Setup& setup, int x, int y);

/// The cells that show the intensities k / 255 on the ball. If there are few cells, two of them are mixed.
struct BallCells {
  std::array<std::uint8_t, 256> low{}, high{};
  std::array<int, 256> share{};  ///< how many of 64 neighbours get `high`
};

/// What the column shows besides the settings.
struct ControlsShown {
  const Setup& setup;
  const Setup& defaults;
  LightAngles light;
  glm::dvec3 lightInView{0, 0, 1};  ///< unit: to the right, up, towards the viewer
  const BallCells& ball;
  bool ownLights = false;  ///< the scene has lights of its own, which the settings do not change
  char focus = 0;          ///< the key of the control that the arrows change
  std::optional<ControlHit> hover = {};
  char dragged = 0;
};
/// Draws the column on a background of paper.
void drawControls(IndexImage& image, const ControlColumn& at, const ControlsShown& shown,
                  const CellPlan& plan);

/// The direction on the ball under the pointer, a unit vector: to the right, up, towards the viewer. Outside
/// the sphere's outline it points to the far side.
[[nodiscard]] glm::dvec3 directionOnBall(const ControlColumn& at, int x, int y);

}  // namespace xnewell
