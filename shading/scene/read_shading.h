#pragma once

#include "shading/scene/json_node.h"
#include "shading/scene/picture_settings.h"

namespace xnewell {

/// The "shading" of a scene file (scene_file.h): changes what it says. @throws ParseError
void readShading(PictureSettings& settings, const Node& node);

/// Refuses settings that `node` gives without effect (Need::Unmet::Refused), such as a range without
/// attenuation linear, and an attenuation without a light to fade. `settings` are what `node` left.
/// @throws ParseError
void expectCounts(const PictureSettings& settings, const Node& node);

/// The same for settings that set-ups and lessons may keep for another method (RefusedOrKept).
/// @throws ParseError
void expectDivides(const PictureSettings& settings, const Node& node);

}  // namespace xnewell
