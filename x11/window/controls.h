#pragma once

#include <iosfwd>
#include <string>
#include <string_view>

#include "shading/picture/picture.h"
#include "shading/scene/settings.h"
#include "x11/options/options.h"
#include "x11/views/views.h"

namespace xnewell {

/// What the user can change while the program runs. setting_controls.h has the controls.

/// Everything that controls change. Undo keeps copies of it.
struct Setup {
  PictureSettings picture;
  Fill fill = Fill::Scanline;
  int divisions = 0;          ///< of the patches; 0: as the scene was read
  View show = View::Picture;  ///< what the view of the picture shows
  bool operator==(const Setup&) const = default;
};

/// The server can fill only polygons that have one cell each. If the setup has no polygons, or polygons with
/// several cells, this function switches to the scanline filler. It returns a sentence that says why, or ""
/// if nothing changed.
[[nodiscard]] std::string_view keepFillable(Setup& setup);

/// Who changes a light that has no control of its own elsewhere, in Host::change().
inline constexpr char kLampChange = 1;

/// The lights that the setup shows, in the scene's units: those that it has changed, the scene's own, or the
/// one of its illumination.
[[nodiscard]] std::vector<Light> lampsOf(const Setup& setup, const Scene& scene);
/// True if they are not the one of the illumination.
[[nodiscard]] bool hasOwnLamps(const Setup& setup, const Scene& scene);
/// Puts a light in the place of one of them.
void putLamp(Setup& setup, const Scene& scene, std::size_t lamp, const Light& light);

/// The light's direction from the scene's centre, in degrees. Azimuth is the angle about the up axis: 0 where
/// the default view stands, positive to its right. Elevation is the angle above the horizon.
struct LightAngles {
  double azimuth = 0, elevation = 0;
};
/// The unit vector from `centre` towards the light. The centre matters only for a light at a place.
[[nodiscard]] glm::dvec3 towardsLight(const Light& light, glm::dvec3 centre);
[[nodiscard]] LightAngles lightAngles(const Light& light, UpAxis up, glm::dvec3 centre = glm::dvec3{0});
/// Turns the light: azimuth about the up axis, elevation towards it. Elevation stays within +-90 degrees. A
/// light at a place keeps its distance from the centre, and the cone of a spot turns with it.
void turnLight(Light& light, UpAxis up, double azimuth, double elevation, glm::dvec3 centre = glm::dvec3{0});
/// Puts the light where `towards`, a unit vector, points from the centre.
void aimLight(Light& light, glm::dvec3 towards, glm::dvec3 centre);

/// Writes a note for each option that was given but has no effect on this picture. Scripts may always give
/// all options; a user who tries one out should learn why nothing changes. There is also a note for each part
/// of the scene that the picture leaves out, and for a picture that shows nothing.
void noteNoEffect(std::ostream& out, const Options& options, const Picture& picture);

/// Writes a note if the picture shows nothing, and says why.
void noteEmpty(std::ostream& out, const Picture& picture);

/// The same for a control that has just changed `setup`: a sentence, or "" if the control has an effect.
/// `picture` is the one before the change; the next one has the same scene and the same plan of colours.
[[nodiscard]] std::string whyNoEffect(char control, const Picture& picture, const Setup& setup);

}  // namespace xnewell
