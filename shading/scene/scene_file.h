#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "geometry/view/camera.h"
#include "shading/light/illumination.h"
#include "shading/scene/json_text.h"
#include "shading/scene/picture_settings.h"
#include "shading/scene/scene.h"

namespace xnewell {

/// Reads the "camera" of a scene file (scene_file.h), in the file's units. @throws ParseError
[[nodiscard]] CameraSettings readCamera(const Node& node);

/// Throws ParseError if `camera`, which was read from `node`, sees nothing in a picture of any size. An error
/// that depends on the file alone is thus reported when the file is read, and not only when someone draws a
/// picture of it.
void expectSees(const CameraSettings& camera, const Scene& scene, const Node& node);

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

/// data/SCENES.md says what stands in a scene file.
/// @throws ParseError such as `room.json: objects[2].polygons[0]: a polygon needs at least 3 corners`; if the
/// text is not JSON, the message gives the line number instead of the key. @throws std::system_error
[[nodiscard]] Scene readSceneFile(const std::filesystem::path& file, int divisions = kDefaultDivisions);

/// True for a file that names another scene. No such file is a part of a scene. It throws what
/// readSceneFile() throws.
[[nodiscard]] bool isSetup(const std::filesystem::path& file);

/// The "shows" sentence of a file, or "" if it has none. It throws what readSceneFile() throws.
[[nodiscard]] std::string sentenceOf(const std::filesystem::path& file);

/// Reads a scene file from its text. Errors show `name` as the file's name. Relative paths start at `folder`.
[[nodiscard]] Scene parseSceneFile(std::string_view text, const std::string& name,
                                   const std::filesystem::path& folder, int divisions = kDefaultDivisions);

}  // namespace xnewell
