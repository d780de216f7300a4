#pragma once

#include <filesystem>
#include <string>

#include "shading/scene/scene.h"

namespace xnewell {

/// Returns the text of a scene file (scene_file.h) that saves the present set-up of a scene: camera, light,
/// methods and table. If the file is read again, it gives the same settings bit for bit. The scene itself is
/// named, not copied. The text has its built-in name, or the path of its file. The path is relative to
/// `folder`, where the text will be stored, if the file is inside that folder. `settings` are in the scene's
/// units. The text says that an X server fills if inPixels is true.
[[nodiscard]] std::string savedScene(const Scene& scene, const PictureSettings& settings,
                                     const std::filesystem::path& folder);

}  // namespace xnewell
