#pragma once

#include "shading/scene/json_node.h"
#include "shading/scene/scene.h"

namespace xnewell {

/// The "ambient" and the "lights" of a scene file (scene_file.h), into the scene's units; what they leave of
/// Ia + sum of Ip <= 1 is the most that scene.settings keeps of the user's. @throws ParseError
void readLight(Scene& scene, const Node& root);

}  // namespace xnewell
