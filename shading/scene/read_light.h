#pragma once

#include "shading/scene/json_node.h"
#include "shading/scene/scene.h"

namespace xnewell {

/// Reads "ambient" and "lights" of a scene file (scene_file.h) into scene units. Ia + the sum of Ip must not
/// exceed 1; if the scene's own light leaves less than the Ia and Ip of scene.settings, these are lowered to
/// fit. @throws ParseError
void readLight(Scene& scene, const Node& root);

}  // namespace xnewell
