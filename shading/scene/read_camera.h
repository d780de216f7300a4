#pragma once

#include "geometry/view/camera.h"
#include "shading/scene/json_node.h"
#include "shading/scene/scene.h"

namespace xnewell {

/// Reads the "camera" of a scene file (scene_file.h), in the file's units. @throws ParseError
[[nodiscard]] CameraSettings readCamera(const Node& node);

/// Throws ParseError if `camera`, which was read from `node`, sees nothing in a picture of any size. An error
/// that depends on the file alone is thus reported when the file is read, and not only when someone draws a
/// picture of it.
void expectSees(const CameraSettings& camera, const Scene& scene, const Node& node);

}  // namespace xnewell
