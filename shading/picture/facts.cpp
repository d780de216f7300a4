#include "shading/picture/facts.h"

#include <algorithm>

namespace xnewell {

bool hasTextures(const Scene& scene) {
  return std::ranges::any_of(scene.mesh.materials, [](const MeshMaterial& m) { return m.texture >= 0; });
}

PictureFacts factsOf(const Picture& picture, const PictureSettings& settings) {
  const std::vector<MeshMaterial>& materials = picture.scene().mesh.materials;
  const bool shines = settings.light.ks > 0.0 || std::ranges::any_of(materials, [](const MeshMaterial& m) {
                        return m.ks.value_or(0.0) > 0.0;
                      });
  return {.settings = settings,
          .plan = picture.colors().plan(),
          .highlights = shines,
          .patches = !picture.scene().patches.empty(),
          .normals = !picture.scene().mesh.normals.empty(),
          .textures = hasTextures(picture.scene())};
}

PictureFacts factsOf(const Picture& picture) {
  PictureFacts facts = factsOf(picture, picture.settings());
  facts.highlights = picture.shading().lighting().specular;
  return facts;
}

}  // namespace xnewell
