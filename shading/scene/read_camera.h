#pragma once

#include "geometry/view/camera.h"
#include "shading/scene/json_node.h"
#include "shading/scene/scene.h"

namespace xnewell {

/// The "camera" of a scene file (scene_file.h), in the file's units. @throws ParseError
[[nodiscard]] CameraSettings readCamera(const Node& node);

/// `camera`, which `node` says, in the scene's units. @throws ParseError where it sees nothing in a picture
/// of any size: of each mistake that the file alone decides its reader is to hear, not who draws a picture of
/// it
[[nodiscard]] CameraSettings seeing(const CameraSettings& camera, const Scene& scene, const Node& node);

}  // namespace xnewell
