#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <vector>

#include "geometry/view/project.h"
#include "geometry/view/view.h"
#include "shading/fill/evaluated.h"
#include "shading/picture/scene_shading.h"
#include "shading/scene/picture_settings.h"
#include "shading/scene/scene.h"

namespace xnewell {

/// The surfaces of a picture and the light on them. All parts belong to the picture. They must outlive the
/// users of this structure.
struct Surfaces {
  const Scene& scene;
  const Mesh& mesh;  ///< the scene's mesh, or the refined one
  const SnappedScene& snapped;
  const ViewSpec& view;
  const PictureSettings& settings;
  const SceneShading& shading;

  /// 1 or -1. A face's normals times this factor point to the side that the light is computed for. This is
  /// the side that the viewer sees; it is the front if only fronts are lit.
  [[nodiscard]] double side(const SnappedFace& face) const {
    return face.back && settings.light.twoSided ? -1.0 : 1.0;
  }
};

/// Evaluates one channel sample by sample: Phong shading, and textures.
class SurfaceEvaluator {
 public:
  SurfaceEvaluator(const Surfaces& surfaces, int channel);

  /// True if the samples of a face are evaluated one by one.
  [[nodiscard]] bool evaluates(const SnappedFace& face) const;
  /// Calls use(t, evaluated) for each triangle of such a face. `evaluated` is a PhongTriangle or a
  /// TermsTriangle, or the luminance of three of them. The caller gives it a ramp and a counter of clamped
  /// samples.
  template <class Use>
  void forEachEvaluated(const SnappedFace& face, Use&& use) const {
    forEachTriangle(s_.snapped, face, [&](const FaceTriangle& t) {
      const auto each = [&](const auto& of) {
        if (s_.shading.lighting().luminance)
          use(t, LuminanceTriangle{std::array{of(0), of(1), of(2)}});
        else
          use(t, of(channel_));
      };
      if (s_.shading.lighting().onlyAmbient())
        each([&](int channel) { return ambient(face, t, channel); });
      else if (s_.settings.shading == Shading::Phong)
        each([&](int channel) { return phong(face, t, channel); });
      else
        each([&](int channel) { return terms(face, t, channel); });
    });
  }
  /// 1 / w at the three vertices. w is the depth along the viewing direction, divided by the least depth of
  /// the three. All are 1 in a parallel projection and in affine mapping.
  [[nodiscard]] std::array<double, 3> overDepths(const FaceTriangle& triangle) const;

 private:
  [[nodiscard]] bool textured(const SnappedFace& face) const;
  [[nodiscard]] PhongTriangle phong(const SnappedFace& face, const FaceTriangle& t, int channel) const;
  /// The ambient term alone: no normal, and no texture, which ambient light does not show.
  [[nodiscard]] TermsTriangle ambient(const SnappedFace& face, const FaceTriangle& t, int channel) const;
  [[nodiscard]] TermsTriangle terms(const SnappedFace& face, const FaceTriangle& t, int channel) const;
  void addTexture(EvaluatedTriangle& e, const SnappedFace& face, const FaceTriangle& t,
                  const PixelPlanes& planes, const std::array<double, 3>& q, int channel) const;

  Surfaces s_;
  int channel_;
  /// Unit vector in the world; depth grows in the opposite direction.
  glm::dvec3 towardsViewer_;
};

/// Values of the surfaces at the samples of a picture, in double precision, before a colour table rounds
/// them. Plots show these values, and pictures are measured against them.

/// The face that each sample shows, for some rows of a picture.
struct SeenRows {
  int width = 0, firstRow = 0;
  std::vector<int> faces;  ///< indices into SnappedScene::faces, row by row; kNothing where no face shows

  [[nodiscard]] int endRow() const { return firstRow + static_cast<int>(faces.size()) / width; }
};

/// The intensity of one channel, clamped to [0, 1]; NaN where nothing shows. `ofFaces` has the intensity of
/// each face if the method gives each face a single one. Values are interpolated as the method defines it,
/// without the fixed point, the single precision and the tables that the fillers use. Only an environment is
/// looked up in its map, whose entries have single precision. Where cell numbers are interpolated
/// (Interpolated), it is the intensity of which they are the cells at the vertices.
[[nodiscard]] std::vector<double> intensitiesAt(const SeenRows& seen, const Surfaces& surfaces, int channel,
                                                const std::vector<double>& ofFaces);

/// Unit vectors in the world, or 0 where nothing shows. They point to the side of the face that the light is
/// computed for. They are interpolated if the method interpolates; otherwise they are the normal of the face.
[[nodiscard]] std::vector<glm::dvec3> normalsAt(const SeenRows& seen, const Surfaces& surfaces);

}  // namespace xnewell
