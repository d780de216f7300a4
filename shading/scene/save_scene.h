#pragma once

#include <filesystem>
#include <string>

#include "shading/scene/scene.h"

namespace xnewell {

/// A scene file (scene_file.h) that sets the scene up as it is now: camera, light, methods and table. Read
/// again it gives the same settings bit for bit. The scene itself is named, not copied: by its built-in name,
/// or by its file as seen from `folder`, where the text is to stand.
/// `settings` are in the scene's units; of inPixels it is said that a server fills.
[[nodiscard]] std::string savedScene(const Scene& scene, const PictureSettings& settings,
                                     const std::filesystem::path& folder);

/// The same scene with its patches divided otherwise. @throws as readScene()
[[nodiscard]] Scene redivided(const Scene& scene, int divisions);

}  // namespace xnewell
