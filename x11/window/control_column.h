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

/// The column of controls at the window's right edge: where each one is, how it is drawn, and which one the
/// pointer is on.

/// A button does what its key does.
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
  int x, y;    ///< of the key's left edge, and the baseline
  Rect row;    ///< what it has to itself; of an intensity its thumb's half of the bar too
  Rect track;  ///< of a slider and of the intensities: from its lowest value to its highest
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
/// Of layoutOf(), where it is roomy.
[[nodiscard]] ControlColumn layoutOfControls(const Layout& at);

/// What the pointer is on.
struct ControlHit {
  char key = 0;
  int option = -1;  ///< of a choice
  bool operator==(const ControlHit&) const = default;
};
/// The ball of the light is `l`; of the two intensities the thumb that is nearer.
[[nodiscard]] std::optional<ControlHit> controlAt(const ControlColumn& at, const Setup& setup, int x, int y);

/// The cells that stand for intensities k / 255 on the ball: where few do, two of them by turns.
struct BallCells {
  std::array<std::uint8_t, 256> low{}, high{};
  std::array<int, 256> share{};  ///< of 64 neighbours those that have `high`
};

/// What the column shows beside the setup itself.
struct ControlsShown {
  const Setup& setup;
  const Setup& defaults;
  LightAngles light;
  glm::dvec3 lightInView{0, 0, 1};  ///< unit: to the right, up, towards the viewer
  const BallCells& ball;
  bool ownLights = false;  ///< the scene's, which are not those of the setup
  char focus = 0;          ///< key of the control that the arrows change
  std::optional<ControlHit> hover = {};
  char dragged = 0;
};
/// On paper.
void drawControls(IndexImage& image, const ControlColumn& at, const ControlsShown& shown,
                  const CellPlan& plan);

/// The direction on the ball under the pointer, unit, to the right, up and towards the viewer: past the
/// sphere's edge it goes on behind.
[[nodiscard]] glm::dvec3 directionOnBall(const ControlColumn& at, int x, int y);

}  // namespace xnewell
