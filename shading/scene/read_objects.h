#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "geometry/model/mesh.h"
#include "shading/fill/texture.h"
#include "shading/scene/json_text.h"
#include "shading/scene/scene.h"

namespace xnewell {

/// The "objects" of a scene file and the "materials" that they use (scene_file.h): one mesh, in the file's
/// units and order.
struct Objects {
  Mesh mesh;
  std::vector<PatchRun> patches;
  std::vector<RoundRun> rounds;
  std::vector<Texture> textures;  ///< the textures that some object uses
};

/// Reads the objects. `text` is the text of the file, which shows the decimals of its numbers. `divisions` is
/// for patches that do not set their own. @throws ParseError, std::system_error
[[nodiscard]] Objects readObjects(const Node& root, std::string_view text,
                                  const std::filesystem::path& folder, int divisions);

}  // namespace xnewell
