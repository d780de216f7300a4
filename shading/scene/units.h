#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "geometry/view/camera.h"
#include "shading/light/light.h"
#include "shading/scene/scene.h"

namespace xnewell {

/// Lengths have two units. A scene's file, its Scene::camera and all PictureSettings have the file's. The
/// mesh, SceneLight and a placed Camera have the scene's: 2^exponent of the file's. The walk converts the
/// settings once, at its beginning; who places a camera or finds the lights without a walk calls the
/// functions below. No conversion rounds, unless a result is below 2^-1022.

/// The settings of a file or a user, with all lengths in the scene's units. @throws ViewError if one of them
/// is out of the range of doubles
[[nodiscard]] PictureSettings inSceneUnits(PictureSettings settings, const Scene& scene);
[[nodiscard]] CameraSettings inSceneUnits(CameraSettings camera, const Scene& scene);
[[nodiscard]] glm::dvec3 inSceneUnits(glm::dvec3 point, const Scene& scene);
[[nodiscard]] glm::dvec3 inFileUnits(glm::dvec3 point, const Scene& scene);
/// The centre of the scene's box, in the file's units.
[[nodiscard]] glm::dvec3 centreOf(const Scene& scene);

/// placeCamera() for settings in the file's units. `aspect` is width / height of the picture.
[[nodiscard]] Camera placeCamera(const Scene& scene, const CameraSettings& settings, double aspect,
                                 Cull cull = Cull::Keep);
/// Eye, look-at point, up vector and projection of a camera, and the height of a parallel view, as settings
/// in the file's units.
[[nodiscard]] CameraSettings saidOf(const Camera& camera, const Scene& scene);
/// All of a camera in the textbook's terms: VRP, VPN, VUP, PRP, window, front and back plane, and the
/// projection, as settings in the file's units. Placed again it has the same view, and its eye is PRP.
[[nodiscard]] CameraSettings textbooksOf(const Camera& camera, const Scene& scene);
/// moved() for settings in the file's units.
[[nodiscard]] CameraSettings moved(const CameraSettings& settings, const Camera& camera, const Scene& scene,
                                   double azimuth, double elevation, double zoom);

/// All lights of the scene, in its units: its own, or if it has none the user's.
[[nodiscard]] std::vector<Light> lightsOf(const Scene& scene, const Illumination& user);

}  // namespace xnewell
