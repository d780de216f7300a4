#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <string_view>
#include <utility>
#include <vector>

#include "x11/drawing/painter.h"
#include "x11/kit/control.h"
#include "x11/window/controls.h"
#include "x11/window/layout.h"

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

}  // namespace xnewell
