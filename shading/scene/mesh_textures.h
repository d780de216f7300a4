#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "geometry/model/mesh.h"
#include "shading/fill/texture.h"

namespace xnewell {

/// Lets a material have a texture only where there are texture coordinates. Faces without them get a copy of
/// their material that has none.
void partTextures(Mesh& mesh);

/// The textures of a scene. Each file is read once.
class TextureReader {
 public:
  /// The index of the texture in a file. @throws as readTexture()
  int read(const std::filesystem::path& file);
  /// Reads the files that the file of the mesh names (Mesh::textureFiles), and lets the materials refer to
  /// them. Files that are not PNG, that are not there, or that no face has coordinates for, are not read:
  /// Mesh::notes says so.
  /// @throws ParseError `a.mtl:3: skin.png: not a PNG file`
  void readAll(Mesh& mesh);

  [[nodiscard]] std::vector<Texture> take() { return std::move(textures_); }

 private:
  std::vector<Texture> textures_;
  std::map<std::string, int> numbers_;
};

}  // namespace xnewell
