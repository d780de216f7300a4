#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <span>

#include "geometry/model/divide.h"
#include "geometry/view/view.h"

namespace xnewell {

/// Places the camera from the user's settings. The scene supplies what the user left out.

/// An oblique parallel projection. A line of one unit along n is drawn `length` units long, at `angle` to the
/// horizontal. This gives PRP its u and v, wherever the window is.
struct Oblique {
  double length = 1.0;  ///< 1 for a cavalier projection, 1/2 for a cabinet projection
  double angle = 45.0;  ///< degrees
  bool operator==(const Oblique&) const = default;
};

inline constexpr double kDefaultFov = 30.0;  ///< degrees

/// The user's settings. placeCamera() chooses each part that is left out.
struct CameraSettings {
  std::optional<glm::dvec3> eye, lookAt, up;  ///< world
  std::optional<double> fov;  ///< vertical, in degrees, in (0, 180), default kDefaultFov; for perspective
  bool parallel = false;
  std::optional<double> height;    ///< of the picture, in world units; for parallel views
  std::optional<Oblique> oblique;  ///< if set, the view is parallel
  // The textbook's specification. vrp replaces lookAt; vpn and prp replace eye. A parallel view is upright if
  // neither prp nor eye is given.
  std::optional<glm::dvec3> vrp, vpn, vup, prp;
  std::optional<glm::dvec4> window;   ///< umin, umax, vmin, vmax
  std::optional<double> front, back;  ///< the clipping planes, as values of n
  bool operator==(const CameraSettings&) const = default;
};

/// A placed camera. Shading sees only `eye` and `lookAt`, never the projection.
struct Camera {
  ViewSpec view;
  glm::dvec3 eye{0}, lookAt{0}, up{0};  ///< world
  /// Number of parts that are in view and nearer than the default front plane, wholly or partly. They are cut
  /// away there. 0 if the user gave the plane.
  int cutByFront = 0;
  bool operator==(const Camera&) const = default;
};

/// The axis that points up in the scene. It also selects the default direction from the scene's centre to the
/// eye.
enum class UpAxis { Y, Z };
[[nodiscard]] glm::dvec3 upVector(UpAxis axis);

/// Completes the settings. With no settings, the picture shows the whole scene, centred, from a pleasant
/// angle, with a margin of 6 % of half the picture's width or height. `aspect` is width / height of the
/// picture.
/// The front plane of a perspective view defaults to half way between the eye and the scene, but is at least
/// 1/1024 of the scene's largest side in front of the eye. Where something in view is nearer than that, the
/// plane is half way to it. `parts` tells what is in view: only what lies in the pyramid from the eye through
/// the window counts, and with Cull::Back no part that shows its back. (Without `parts` nothing does.) The
/// plane is never nearer than 2^-15 of the distance dB of the farthest that may be seen, and what is nearer
/// is cut away: Camera::cutByFront. dB is the distance of the back plane. But if a near part fills the
/// picture, dB is the distance of that part's farthest visible point, because it hides everything beyond. The
/// z of a place at the distance d is proportional to 1/d, and the screen has 2^29 steps of z or more from the
/// front plane to the back plane. So a step at dB is at most dB 2^15 2^-29 deep. In a picture of 600 rows
/// with the default field of view this is a fourteenth of what a pixel is wide there. The back plane and the
/// planes of a parallel view enclose the scene.
/// @throws ViewError as ViewSpec says
[[nodiscard]] Camera placeCamera(const CameraSettings& settings, std::span<const glm::dvec3> points,
                                 UpAxis axis, double aspect, const ConvexParts& parts = {},
                                 Cull cull = Cull::Keep);

/// The settings after a move of the eye. The eye turns about the look-at point, by `azimuth` degrees about
/// the up vector and by `elevation` degrees towards it (it stops 1 degree short of straight up and down). The
/// distance (perspective) or the height (parallel) is divided by `zoom` > 0. The kind of projection stays,
/// and so does an oblique angle. Eye, look-at and up replace the textbook's specification, so an off-axis
/// window, `front` and `back` are lost.
[[nodiscard]] CameraSettings moved(const CameraSettings& settings, const Camera& camera, double azimuth,
                                   double elevation, double zoom);

}  // namespace xnewell
