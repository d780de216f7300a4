#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geometry/model/vertex_normals.h"
#include "geometry/view/camera.h"
#include "shading/light/environment.h"
#include "shading/light/illumination.h"
#include "shading/light/intensities.h"
#include "shading/light/refine.h"
#include "shading/picture/shared.h"
#include "shading/scene/picture_settings.h"
#include "shading/scene/scene.h"

namespace xnewell {

/// What shading knows of a scene: normals at vertices, the light resolved, and what is evaluated once and
/// kept. It holds only what the method requires: flat shading asks for no vertex normals, Phong's for no
/// intensities. An immutable value of shared parts: the next one shares with it what did not change.
class SceneShading {
 public:
  /// What these settings ask for. A part is made anew only if something it depends on changed since this.
  [[nodiscard]] SceneShading next(const Scene& scene, const PictureSettings& settings, Channels channels,
                                  const Camera& camera) const;

  /// The scene's polygons, divided; nothing unless PictureSettings::adapt asks for it.
  [[nodiscard]] const std::optional<Refined>& refined() const { return *refined_; }
  /// What is projected and painted of a scene: its own, or refined().
  [[nodiscard]] const Mesh& mesh(const Scene& scene) const {
    return refined() ? refined()->mesh : scene.mesh;
  }
  [[nodiscard]] const ConvexParts& parts(const Scene& scene) const {
    return refined() ? refined()->parts : scene.parts;
  }
  /// True if mesh() and parts() are the other's too.
  [[nodiscard]] bool hasMeshOf(const SceneShading& other) const {
    return refined_.isOneWith(other.refined_) || (!refined() && !other.refined());
  }
  /// Empty unless the method interpolates.
  [[nodiscard]] const Vertices& vertices() const { return refined() ? refined()->vertices : *vertices_; }
  /// Centroids of faces, of pieces if refined, or vertices.
  [[nodiscard]] const ShadingPoints& points() const { return refined() ? refined()->points : *points_; }
  /// Where flat shading evaluates a face, an index into points().
  [[nodiscard]] int pointOf(const SnappedFace& face) const { return refined() ? face.part : face.number; }
  [[nodiscard]] const Lighting& lighting() const { return *lighting_; }
  /// At points(), of one channel; empty where nothing is lit once for all.
  [[nodiscard]] const Intensities& intensities(int channel) const { return *lit_[channel].intensities; }
  /// The terms of intensities().
  [[nodiscard]] const Terms& diffuse(int channel) const { return *lit_[channel].diffuse; }
  [[nodiscard]] const Terms& specular(int channel) const { return *lit_[channel].specular; }
  /// By channel and material, of none first; empty unless the method looks one up.
  [[nodiscard]] const std::vector<Environment>& environments(int channel) const {
    return maps_->environments[channel];
  }
  /// Normals of vertices where the environment is looked up.
  [[nodiscard]] const std::vector<glm::dvec3>& mapped() const { return maps_->N; }

 private:
  // What parts were made with, or nothing.
  struct Points {
    bool ofVertices;
    NormalRule normals;
    double crease, adapt;
    bool operator==(const Points&) const = default;
  };
  struct Light {
    Illumination light;
    Channels channels;
    Shading shading;
    bool operator==(const Light&) const = default;
  };
  struct Eye {
    glm::dvec3 eye, lookAt;
    bool operator==(const Eye&) const = default;
  };
  struct Frame {
    EnvironmentForm form;
    ViewSpec view;
    bool operator==(const Frame&) const = default;
  };

  /// One channel. When the eye moves the diffuse terms stay.
  struct Lit {
    Shared<Terms> diffuse, specular;
    Shared<Intensities> intensities;
  };
  struct Maps {
    std::array<std::vector<Environment>, 3> environments;
    std::vector<glm::dvec3> N;
  };

  [[nodiscard]] Refined refine(const Scene& scene, const PictureSettings& settings) const;
  void light(int channel, bool newLight, bool newHighlight);
  [[nodiscard]] Maps makeMaps(const Scene& scene, const PictureSettings& settings,
                              const Camera& camera) const;

  std::optional<Points> pointsMade_;
  std::optional<Light> lightMade_;
  std::optional<Eye> eyeMade_;
  std::optional<Frame> frameMade_;
  Shared<Vertices> vertices_;
  Shared<ShadingPoints> points_;
  Shared<std::optional<Refined>> refined_;
  Shared<Lighting> lighting_;
  std::array<Lit, 3> lit_;
  Shared<Maps> maps_;
};

}  // namespace xnewell
