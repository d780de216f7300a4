#pragma once

#include "shading/json_node.h"
#include "shading/picture_settings.h"

/// The "shading" of a scene file (scene_file.h): changes what it says. @throws ParseError
void readShading(PictureSettings& settings, const Node& node);
