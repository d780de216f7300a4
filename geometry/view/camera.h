#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <span>

#include "geometry/view/view.h"

namespace xnewell {

/// Where the eye stands: from what the user said, and from the scene for all the rest.

/// Oblique parallel projections: receding lines at `angle` to the horizontal, `length` long a unit.
struct Oblique {
  double length = 1.0;  ///< 1 cavalier, 1/2 cabinet
  double angle = 45.0;  ///< degrees
  bool operator==(const Oblique&) const = default;
};

inline constexpr double kDefaultFov = 30.0;  ///< degrees

/// Each part the user left out is chosen by `placeCamera`.
struct CameraSettings {
  std::optional<glm::dvec3> eye, lookAt, up;  ///< world
  std::optional<double> fov;  ///< degrees, vertical, in (0, 180), else kDefaultFov; perspective
  bool parallel = false;
  std::optional<double> height;    ///< world units the picture is tall; parallel
  std::optional<Oblique> oblique;  ///< makes the view parallel
  // The textbook's specification; vrp takes the place of lookAt, vpn and prp of eye.
  std::optional<glm::dvec3> vrp, vpn, vup, prp;
  std::optional<glm::dvec4> window;   ///< umin, umax, vmin, vmax
  std::optional<double> front, back;  ///< n of the clipping planes
  bool operator==(const CameraSettings&) const = default;
};

/// A placed camera. Shading sees only `eye` and `lookAt`, never the projection.
struct Camera {
  ViewSpec view;
  glm::dvec3 eye{0}, lookAt{0}, up{0};  ///< world
  bool operator==(const Camera&) const = default;
};

/// The direction from the scene's centre to the default eye, and up, for scenes with z or y up.
enum class UpAxis { Y, Z };
[[nodiscard]] glm::dvec3 upVector(UpAxis axis);

/// Completes the settings: without them the scene is framed whole, centred, with a margin of 6 % of the
/// smaller side, from a pleasant angle. `aspect` is width / height of the picture. The front plane of a
/// perspective view defaults to 1/1024 of the scene's largest side before the eye; the other planes enclose
/// the scene.
/// @throws ViewError as ViewSpec says
[[nodiscard]] Camera placeCamera(const CameraSettings& settings, std::span<const glm::dvec3> points,
                                 UpAxis axis, double aspect);

/// The settings after turning the eye about the look-at point: `azimuth` degrees about the up vector,
/// `elevation` degrees towards it (kept 1 degree short of straight up and down), and after dividing the
/// distance (perspective) or the height (parallel) by `zoom` > 0. The projection stays, an oblique or
/// off-axis window too as far as the textbook's specification is replaced by eye, look-at and up.
[[nodiscard]] CameraSettings moved(const CameraSettings& settings, const Camera& camera, double azimuth,
                                   double elevation, double zoom);

}  // namespace xnewell
