#pragma once

#include "geometry/camera.h"
#include "shading/json_node.h"

/// The "camera" of a scene file (scene_file.h), in the file's units. @throws ParseError
[[nodiscard]] CameraSettings readCamera(const Node& node);
