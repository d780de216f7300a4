#pragma once

#include "shading/scene/json_node.h"
#include "shading/scene/picture_settings.h"

namespace xnewell {

/// The "shading" of a scene file (scene_file.h): changes what it says. @throws ParseError
void readShading(PictureSettings& settings, const Node& node);

/// That what `node` says of attenuation has a light to fade: the settings are what it left them.
/// @throws ParseError
void expectCounts(const PictureSettings& settings, const Node& node);

/// That "adapt" divides polygons where it is said. A set-up may keep it for another method. @throws
/// ParseError
void expectDivides(const PictureSettings& settings, const Node& node);

}  // namespace xnewell
