#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "shading/picture/picture.h"
#include "shading/scene/settings.h"
#include "x11/options/options.h"
#include "x11/views/shows.h"

namespace xnewell {

/// The controls: what the user can change while the program runs. Each control is a row. The panel draws
/// these rows, and the keys change them.

/// Everything that controls change. Undo keeps copies of it.
struct Setup {
  PictureSettings picture;
  Fill fill = Fill::Scanline;
  int divisions = 0;         ///< of the patches; 0: as the scene was read
  Show show = Show::Shaded;  ///< what the view of the picture shows
  bool operator==(const Setup&) const = default;
};

/// The server can fill only polygons that have one cell each. If the setup has no polygons, or polygons with
/// several cells, this function switches to the scanline filler. It returns a sentence that says why, or ""
/// if nothing changed.
[[nodiscard]] std::string_view keepFillable(Setup& setup);

/// A slider. Its small letter gives it the focus; then the arrows change it.
struct SliderRow {
  const Setting* setting;
  char key;
  std::string_view label;
  Section section;
  double low, high,
      step;  ///< an arrow moves one step, with Shift ten; if logarithmic, a step is a share of the track
  bool logarithmic;
  int decimals;
  [[nodiscard]] double get(const Setup& setup) const;
  /// Sets the value. Ia and Ip are two thumbs on one bar. The thumb that moves pushes the other, so that
  /// Ia + Ip <= 1.
  void set(Setup& setup, double value) const;
  /// True if the slider has an effect, as far as the setup alone can tell. If not, whenOff() says why.
  [[nodiscard]] bool enabled(const Setup& setup) const;
  [[nodiscard]] std::string whenOff() const { return noEffect(label, *setting) + "."; }
};
[[nodiscard]] const std::vector<SliderRow>& sliders();

/// A choice. Its capital letter takes the next option.
struct ChoiceRow {
  char key;
  std::string_view label, tells;
  Section section;
  std::vector<std::string_view> options;
  std::function<int(const Setup&)> get;
  std::function<void(Setup&, int)> set;
  std::function<std::optional<int>(const Setup&)> next = {};  ///< Control::next
};
/// choices() are in the column. others() have no place there: the mistake in the equation, pick and bits.
[[nodiscard]] const std::vector<ChoiceRow>& choices();
[[nodiscard]] const std::vector<ChoiceRow>& others();

struct ToggleRow {
  const Setting* setting;
  char key;
  std::string_view label;
  [[nodiscard]] bool get(const Setup& setup) const;
};
[[nodiscard]] const std::vector<ToggleRow>& toggles();

/// The control of a key; null if the key has no such control.
[[nodiscard]] const SliderRow* sliderOf(char key);
[[nodiscard]] const ChoiceRow* choiceOf(char key);  ///< in choices() or others()
[[nodiscard]] const ToggleRow* toggleOf(char key);

/// The hues that the key `H` visits.
struct HueRow {
  std::string_view name;
  glm::dvec3 hue;
};
inline constexpr std::array kHues{
    HueRow{"red", {1, 0, 0}},      HueRow{"amber", {1, 0.7, 0}}, HueRow{"green", {0, 1, 0}},
    HueRow{"blue", {0.3, 0.5, 1}}, HueRow{"gray", {1, 1, 1}},
};

/// The gammas that the key `g` visits.
inline constexpr std::array kGammas{1.0, 1.4, 1.8, 2.2};

/// The light's direction from the scene's centre, in degrees. Azimuth is the angle about the up axis: 0 where
/// the default view stands, positive to its right. Elevation is the angle above the horizon.
struct LightAngles {
  double azimuth = 0, elevation = 0;
};
/// The unit vector from `centre` towards the light. The centre matters only for a point light.
[[nodiscard]] glm::dvec3 towardsLight(const Illumination& light, glm::dvec3 centre);
[[nodiscard]] LightAngles lightAngles(const Illumination& light, UpAxis up,
                                      glm::dvec3 centre = glm::dvec3{0});
/// Turns the light: azimuth about the up axis, elevation towards it. Elevation stays within +-90 degrees. A
/// point light keeps its distance from the centre.
void turnLight(Illumination& light, UpAxis up, double azimuth, double elevation,
               glm::dvec3 centre = glm::dvec3{0});
/// Puts the light where `towards`, a unit vector, points from the centre. A point light keeps its distance.
void aimLight(Illumination& light, glm::dvec3 towards, glm::dvec3 centre);

}  // namespace xnewell
