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

/// What can be changed while the program runs, one row a control: the panel draws these rows, the keys
/// walk them.

/// Everything a control changes. Undo keeps copies of it.
struct Setup {
  PictureSettings picture;
  Fill fill = Fill::Scanline;
  int divisions = 0;         ///< of patches; 0: as the scene was read
  Show show = Show::Shaded;  ///< in the view of the picture
  bool operator==(const Setup&) const = default;
};

/// A server fills polygons, each with one cell: where the setup has none, or has more, the scanline filler
/// takes its place. Why, as a sentence; "" where nothing changed.
[[nodiscard]] std::string_view keepFillable(Setup& setup);

/// A small letter goes to the slider; then the arrows change it.
struct SliderRow {
  const Setting* setting;
  char key;
  std::string_view label;
  Section section;
  double low, high,
      step;  ///< arrows move by `step`, with Shift by ten; logarithmic: by that share of the track
  bool logarithmic;
  int decimals;
  [[nodiscard]] double get(const Setup& setup) const;
  /// Ia and Ip are two thumbs on one bar: the one that moves pushes the other, so that Ia + Ip <= 1.
  void set(Setup& setup, double value) const;
  /// Whether it has an effect, as far as the setup alone decides that; where not, a sentence says why.
  [[nodiscard]] bool enabled(const Setup& setup) const;
  [[nodiscard]] std::string whenOff() const { return noEffect(label, *setting) + "."; }
};
[[nodiscard]] const std::vector<SliderRow>& sliders();

/// A capital takes the next option.
struct ChoiceRow {
  char key;
  std::string_view label, tells;
  Section section;
  std::vector<std::string_view> options;
  std::function<int(const Setup&)> get;
  std::function<void(Setup&, int)> set;
  /// The option after that of the setup; after the last, the first.
  [[nodiscard]] int next(const Setup& setup) const {
    return (get(setup) + 1) % static_cast<int>(options.size());
  }
};
/// Those of the column; pick and bits, which have no place there, are others().
[[nodiscard]] const std::vector<ChoiceRow>& choices();
[[nodiscard]] const std::vector<ChoiceRow>& others();

struct ToggleRow {
  const Setting* setting;
  char key;
  std::string_view label;
  [[nodiscard]] bool get(const Setup& setup) const;
  void flip(Setup& setup) const;
};
[[nodiscard]] const std::vector<ToggleRow>& toggles();

/// The control of a key; null where it is none of these.
[[nodiscard]] const SliderRow* sliderOf(char key);
[[nodiscard]] const ChoiceRow* choiceOf(char key);  ///< of choices() and others()
[[nodiscard]] const ToggleRow* toggleOf(char key);

/// What the control of a key is; "" for others.
[[nodiscard]] std::string_view whatIs(char key);

/// Hues the key `H` walks through.
struct HueRow {
  std::string_view name;
  glm::dvec3 hue;
};
inline constexpr std::array kHues{
    HueRow{"red", {1, 0, 0}},      HueRow{"amber", {1, 0.7, 0}}, HueRow{"green", {0, 1, 0}},
    HueRow{"blue", {0.3, 0.5, 1}}, HueRow{"gray", {1, 1, 1}},
};
void nextHue(Setup& setup);

/// Gammas the key `g` walks through.
inline constexpr std::array kGammas{1.0, 1.4, 1.8, 2.2};

/// Where a value stands on its track, in [0, 1], and back.
[[nodiscard]] double trackPosition(const SliderRow& row, double value);
[[nodiscard]] double trackValue(const SliderRow& row, double position);
/// The slider's value after `steps` of its steps, kept within its range.
void step(Setup& setup, const SliderRow& row, int steps);

/// The light as a direction from the scene's centre: azimuth in degrees about the up axis, 0 where the
/// default view stands and positive to its right; elevation above the horizon.
struct LightAngles {
  double azimuth = 0, elevation = 0;
};
/// Unit, towards the light as seen from `centre`, which matters for a point light.
[[nodiscard]] glm::dvec3 towardsLight(const Illumination& light, glm::dvec3 centre);
[[nodiscard]] LightAngles lightAngles(const Illumination& light, UpAxis up,
                                      glm::dvec3 centre = glm::dvec3{0});
/// Turns the light about the up axis and towards it, elevation kept within +-90 degrees; a point light keeps
/// its distance from the centre.
void turnLight(Illumination& light, UpAxis up, double azimuth, double elevation,
               glm::dvec3 centre = glm::dvec3{0});
/// Puts the light where `towards` points from the centre, unit; a point light keeps its distance.
void aimLight(Illumination& light, glm::dvec3 towards, glm::dvec3 centre);

}  // namespace xnewell
