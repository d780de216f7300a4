#pragma once

#include "shading/scene/json_node.h"
#include "shading/scene/picture_settings.h"

namespace xnewell {

/// Reads the "shading" of a scene file (scene_file.h) and changes the settings that it gives. @throws
/// ParseError
void readShading(PictureSettings& settings, const Node& node);

/// Refuses settings that `node` gives but that have no effect (Need::Unmet::Refused), for example a range
/// without attenuation linear. It also refuses an attenuation if the light has no place. `settings` are those
/// that readShading() left. @throws ParseError
void expectCounts(const PictureSettings& settings, const Node& node);

/// Does the same for settings that set-ups and lessons may keep for another method
/// (Need::Unmet::RefusedOrKept). @throws ParseError
void expectDivides(const PictureSettings& settings, const Node& node);

}  // namespace xnewell
