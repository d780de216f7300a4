#include "shading/scene/mesh_textures.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include "geometry/files/model_file.h"
#include "geometry/files/parse_error.h"
#include "geometry/files/text_file.h"

namespace xnewell {

namespace {

bool hasUv(const Mesh& mesh, int face) {
  if (mesh.uvOfCorner.empty()) return false;
  const int *const first = mesh.uvOfCorner.data() + mesh.firstCorner[face], *const end =
                                                                                mesh.uvOfCorner.data() +
                                                                                mesh.firstCorner[face + 1];
  return std::find(first, end, -1) == end;
}

}  // namespace

void partTextures(Mesh& mesh) {
  const std::size_t materials = mesh.materials.size();
  std::vector<bool> shown(materials, false);
  for (int f = 0; f < mesh.faceCount(); ++f)
    if (const int m = mesh.material[f]; m >= 0 && hasUv(mesh, f)) shown[m] = true;
  for (std::size_t m = 0; m < materials; ++m)
    if (!shown[m]) mesh.materials[m].texture = -1;

  std::vector<int> bare(materials, -1);
  for (int f = 0; f < mesh.faceCount(); ++f) {
    const int m = mesh.material[f];
    if (m < 0 || mesh.materials[m].texture < 0 || hasUv(mesh, f)) continue;
    if (bare[m] < 0) {
      bare[m] = static_cast<int>(mesh.materials.size());
      MeshMaterial copy = mesh.materials[m];
      copy.texture = -1;
      mesh.materials.push_back(std::move(copy));
    }
    mesh.material[f] = bare[m];
  }
}

int TextureReader::read(const std::filesystem::path& file) {
  const auto known = numbers_.find(file.string());
  if (known != numbers_.end()) return known->second;
  textures_.push_back(readTexture(file.string()));
  return numbers_.emplace(file.string(), static_cast<int>(textures_.size()) - 1).first->second;
}

void TextureReader::readAll(Mesh& mesh) {
  const std::vector<TextureFile> files = std::exchange(mesh.textureFiles, {});
  if (files.empty()) return;
  partTextures(mesh);
  std::vector<int> numbers;  // of each file, if it is shown
  for (std::size_t k = 0; k < files.size(); ++k) {
    const TextureFile& texture = files[k];
    const std::string name = "'" + visible(texture.file) + "'";
    const auto note = [&](const std::string& what) {
      mesh.notes.emplace_back(ParseError{texture.namedIn, texture.line, "the texture " + name + what}.what());
    };
    const bool shown = std::ranges::find(mesh.materials, static_cast<int>(k), &MeshMaterial::texture) !=
                       mesh.materials.end();
    numbers.push_back(-1);
    if (!shown || extensionOf(texture.file) != ".png") {
      note(shown ? " is not a .png file: its surfaces have Kd" : " is not shown: its faces have no vt");
      continue;
    }
    try {
      numbers.back() = read(texture.file);
    } catch (const std::system_error& e) {
      note(" cannot be read (" + e.code().message() + "): its surfaces have Kd");
    } catch (const ParseError& e) {
      throw ParseError{texture.namedIn, texture.line, e.what()};
    }
  }
  for (MeshMaterial& m : mesh.materials)
    if (m.texture >= 0) m.texture = numbers[m.texture];
}

}  // namespace xnewell
