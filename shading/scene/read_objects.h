#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "geometry/model/mesh.h"
#include "shading/fill/texture.h"
#include "shading/scene/json_node.h"
#include "shading/scene/scene.h"

namespace xnewell {

/// The "objects" of a scene file and the "materials" that they wear (scene_file.h), one after the other in
/// one mesh, in the file's units.
struct Objects {
  Mesh mesh;
  std::vector<PatchRun> patches;
  std::vector<Texture> textures;  ///< those that an object wears
};

/// `text` is the file as it stands, for the decimals of its numbers; `divisions` of patches that do not say
/// theirs. @throws ParseError, std::system_error
[[nodiscard]] Objects readObjects(const Node& root, std::string_view text,
                                  const std::filesystem::path& folder, int divisions);

}  // namespace xnewell
