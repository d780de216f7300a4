#pragma once

#include <string_view>

#include "shading/light/illumination.h"
#include "shading/scene/json_node.h"
#include "shading/scene/picture_settings.h"

namespace xnewell {

/// Reads the "shading" of a scene file (scene_file.h) and changes the settings that it gives. @throws
/// ParseError
void readShading(PictureSettings& settings, const Node& node);

/// Refuses settings that `node` gives but that have no effect (Need::Unmet::Refused), for example a range
/// without attenuation linear. It also refuses an attenuation if no light has a place. `settings` are those
/// that readShading() left; `scene` has the lights that were there before. @throws ParseError
void expectCounts(const PictureSettings& settings, const SceneLight& scene, const Node& node);
/// A file that lists lights says it there, not in "shading".
inline constexpr std::string_view kOwnAttenuation = "Each of the scene's lights has its own attenuation";

/// Does the same for settings that set-ups and lessons may keep for another method
/// (Need::Unmet::RefusedOrKept). @throws ParseError
void expectDivides(const PictureSettings& settings, const Node& node);

}  // namespace xnewell
