#pragma once

#include <array>
#include <glm/vec3.hpp>

#include "geometry/view/project.h"
#include "geometry/view/view.h"
#include "shading/fill/evaluated.h"
#include "shading/picture/scene_shading.h"
#include "shading/scene/picture_settings.h"
#include "shading/scene/scene.h"

namespace xnewell {

/// The surfaces of a picture and the light on them. All of it is the picture's, and outlives its users.
struct Surfaces {
  const Scene& scene;
  const Mesh& mesh;  ///< the scene's, or what it was refined to
  const SnappedScene& snapped;
  const ViewSpec& view;
  const PictureSettings& settings;
  const SceneShading& shading;

  /// 1 or -1: the normals of a face times this are those of the side that is seen.
  [[nodiscard]] double side(const SnappedFace& face) const {
    return face.back && settings.light.twoSided ? -1.0 : 1.0;
  }
};

/// What is evaluated sample by sample: Phong's illumination, and textures. One channel.
class SurfaceEvaluator {
 public:
  SurfaceEvaluator(const Surfaces& surfaces, int channel);

  /// Whether a face's samples are evaluated one by one.
  [[nodiscard]] bool evaluates(const SnappedFace& face) const;
  /// Calls use(t, evaluated) for each triangle of such a face. `evaluated` is a PhongTriangle or a
  /// TermsTriangle; the caller gives it a ramp and a count of clamped samples.
  template <class Use>
  void forEachEvaluated(const SnappedFace& face, Use&& use) const {
    forEachTriangle(s_.snapped, face, [&](const FaceTriangle& t) {
      if (s_.settings.shading == Shading::Phong)
        use(t, phong(face, t));
      else
        use(t, terms(face, t));
    });
  }
  /// 1 / w at the vertices, w their depth along the viewing direction over the least of the three.
  [[nodiscard]] std::array<double, 3> overDepths(const FaceTriangle& triangle) const;

 private:
  [[nodiscard]] bool textured(const SnappedFace& face) const;
  [[nodiscard]] PhongTriangle phong(const SnappedFace& face, const FaceTriangle& t) const;
  [[nodiscard]] TermsTriangle terms(const SnappedFace& face, const FaceTriangle& t) const;
  void addTexture(EvaluatedTriangle& e, const SnappedFace& face, const FaceTriangle& t,
                  const PixelPlanes& planes, const std::array<double, 3>& q) const;

  Surfaces s_;
  int channel_;
  glm::dvec3 towardsViewer_;  ///< the direction against which depth grows, unit, world
};

}  // namespace xnewell
