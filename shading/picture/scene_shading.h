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
#include "shading/scene/picture_settings.h"
#include "shading/scene/scene.h"

namespace xnewell {

/// What shading knows of a scene: normals at vertices, the light resolved, and what is evaluated once and
/// kept. Only what the method requires: flat shading asks for no vertex normals, Phong's for no intensities,
/// and nothing is done again unless what it depends on changed.
class SceneShading {
 public:
  /// True if mesh() and parts() are others than before.
  bool make(const Scene& scene, const PictureSettings& settings, Channels channels, const Camera& camera);

  /// The scene's polygons, divided; nothing unless PictureSettings::adapt asks for it.
  [[nodiscard]] const std::optional<Refined>& refined() const { return refined_; }
  /// What is projected and painted of a scene: its own, or refined().
  [[nodiscard]] const Mesh& mesh(const Scene& scene) const { return refined_ ? refined_->mesh : scene.mesh; }
  [[nodiscard]] const ConvexParts& parts(const Scene& scene) const {
    return refined_ ? refined_->parts : scene.parts;
  }
  /// Empty unless the method interpolates.
  [[nodiscard]] const Vertices& vertices() const { return refined_ ? refined_->vertices : vertices_; }
  /// Centroids of faces, of parts if refined, or vertices.
  [[nodiscard]] const ShadingPoints& points() const { return refined_ ? refined_->points : points_; }
  /// Where flat shading evaluates a face, an index into points().
  [[nodiscard]] int pointOf(const SnappedFace& face) const { return refined_ ? face.part : face.number; }
  [[nodiscard]] const Lighting& lighting() const { return lighting_; }
  /// At points(), of one channel; empty where nothing is lit once for all.
  [[nodiscard]] const Intensities& intensities(int channel) const { return intensities_[channel]; }
  /// By channel and material, of none first; empty unless the method looks one up.
  [[nodiscard]] const std::vector<Environment>& environments(int channel) const {
    return environments_[channel];
  }
  /// Normals of vertices where the environment is looked up.
  [[nodiscard]] const std::vector<glm::dvec3>& mapped() const { return mapped_; }

 private:
  /// What results were made with, or nothing.
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

  void refine(const Scene& scene, const PictureSettings& settings);
  void makeEnvironments(const Scene& scene, const PictureSettings& settings, const Camera& camera);

  std::optional<Points> pointsMade_;
  std::optional<Light> lightMade_;
  std::optional<Eye> eyeMade_;
  std::optional<Frame> frameMade_;
  Vertices vertices_;
  ShadingPoints points_;
  std::optional<Refined> refined_;
  Lighting lighting_;
  std::array<Intensities, 3> intensities_;
  std::array<std::vector<Environment>, 3> environments_;
  std::vector<glm::dvec3> mapped_;
};

}  // namespace xnewell
