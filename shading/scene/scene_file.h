#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "shading/scene/scene.h"

namespace xnewell {

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
