#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geometry/model/vertex_normals.h"
#include "geometry/view/camera.h"
#include "shading/fill/environment.h"
#include "shading/fill/intensities.h"
#include "shading/light/illumination.h"
#include "shading/picture/refine.h"
#include "shading/picture/shared.h"
#include "shading/scene/picture_settings.h"
#include "shading/scene/scene.h"

namespace xnewell {

/// The vertices of the scene's own mesh, with the normals that the settings ask for.
[[nodiscard]] Vertices smoothVertices(const Scene& scene, const PictureSettings& settings);

/// The data that shading computes once for a scene and keeps: normals at vertices, the resolved light, and
/// evaluated intensities. It holds only what is required: no vertex normals for flat shading, no intensities
/// for Phong shading, and no normals at all where all light is ambient (environment maps keep theirs). A
/// method that uses no light has the lighting() alone. It is an immutable value made of shared parts. The
/// next value shares with it all parts that did not change.
class SceneShading {
 public:
  /// The data for these settings. A part is computed again only if something that it depends on has changed.
  [[nodiscard]] SceneShading next(const Scene& scene, const PictureSettings& settings, Channels channels,
                                  const Camera& camera) const;

  /// Only the lighting(), which says how many lights there are and of which kind. Everything else is empty.
  [[nodiscard]] SceneShading onlyLights() const {
    SceneShading lights;
    lights.lighting_ = lighting_;
    return lights;
  }

  /// The scene's polygons, divided; empty unless PictureSettings::adapt is above 0 and the method uses it.
  [[nodiscard]] const std::optional<Refined>& refined() const { return *refined_; }
  /// The mesh that is projected and painted: the scene's own, or that of refined().
  [[nodiscard]] const Mesh& mesh(const Scene& scene) const {
    return refined() ? refined()->mesh : scene.mesh;
  }
  [[nodiscard]] const ConvexParts& parts(const Scene& scene) const {
    return refined() ? refined()->parts : scene.parts;
  }
  /// True if both have the same mesh() and parts().
  [[nodiscard]] bool hasMeshOf(const SceneShading& other) const {
    return refined_.shared() == other.refined_.shared() || (!refined() && !other.refined());
  }
  /// Empty unless the method interpolates. Without normals, `ofCorner` is the index into points() and there
  /// are no vertices.
  [[nodiscard]] const Vertices& vertices() const { return refined() ? refined()->vertices : own_->vertices; }
  /// The vertices, or the centroids of faces; in refined() of their pieces. Without normals, one for each
  /// material (the first for none) stands for all vertices.
  [[nodiscard]] const ShadingPoints& points() const { return refined() ? refined()->points : own_->points; }
  /// The index into points() at which flat shading evaluates a face.
  [[nodiscard]] int pointOf(const SnappedFace& face) const { return refined() ? face.part : face.number; }
  /// Every method has it, also one that uses no light.
  [[nodiscard]] const Lighting& lighting() const { return *lighting_; }
  /// The intensities of one channel at points(). They are empty unless the method is flat or Gouraud shading.
  /// If lighting().luminance, those of channel 0 are the luminance of all three.
  [[nodiscard]] const Intensities& intensities(int channel) const {
    return lighting().luminance ? *luminance_ : *lit_[channel].intensities;
  }
  /// The terms of intensities(). They are kept where something asks for them: a texture at each pixel, or the
  /// next picture of a scene that is not large.
  [[nodiscard]] const Terms& diffuse(int channel) const { return *lit_[channel].diffuse; }
  [[nodiscard]] const Terms& specular(int channel) const { return *lit_[channel].specular; }
  /// The environments of a channel by material, or those of the luminance for channel 0; the first is for
  /// faces without a material. Empty unless the method is environment mapping.
  [[nodiscard]] const std::vector<Environment>& environments(int channel) const {
    return maps_->environments[channel];
  }
  /// The normals at points(), in the axes in which the environments of a channel are looked up.
  [[nodiscard]] const std::vector<glm::dvec3>& mapped(int channel) const { return maps_->N[channel]; }

 private:
  // What the parts are made from.
  struct Eye {
    glm::dvec3 eye, lookAt;
    bool operator==(const Eye&) const = default;
  };
  struct Light {
    Illumination light;
    Channels channels;
    std::optional<std::vector<xnewell::Light>> lights = {};  ///< PictureSettings::lights
    std::optional<Eye> eye = {};                             ///< with a mistake, any term may ask for it
    bool operator==(const Light&) const = default;
  };
  struct OfLighting {
    Light light;
    Eye eye;
    bool operator==(const OfLighting&) const = default;
  };
  struct OfPoints {
    bool ofVertices, withNormals;
    NormalRule normals = {};
    double crease = 0;
    bool longN = false;
    bool operator==(const OfPoints&) const = default;
  };
  /// The places of the scene's own mesh.
  struct Own {
    Vertices vertices;
    ShadingPoints points;
  };
  /// The eye, where a highlight asks for it.
  using HighlightEye = std::optional<Eye>;
  struct OfRefined {
    Shared<Own> own;
    double adapt;
    Light light;
    HighlightEye eye;
    bool operator==(const OfRefined&) const = default;
  };
  struct OfDiffuse {
    Shared<Own> own;
    Shared<std::optional<Refined>> refined;
    Light light;
    bool operator==(const OfDiffuse&) const = default;
  };
  struct OfSpecular {
    OfDiffuse diffuse;
    HighlightEye eye;
    bool operator==(const OfSpecular&) const = default;
  };
  struct OfMaps {
    Shared<Own> own;
    Light light;
    EnvironmentForm form;
    ViewSpec view;
    bool operator==(const OfMaps&) const = default;
  };

  /// One channel. When the eye moves, the diffuse terms stay valid unless the polygons are divided again.
  struct Lit {
    Cached<OfDiffuse, Terms> diffuse;
    Cached<OfSpecular, Terms> specular;
    Cached<OfSpecular, Intensities> intensities;
  };
  struct Maps {
    std::array<std::vector<Environment>, 3> environments;
    std::array<std::vector<glm::dvec3>, 3> N;
  };

  [[nodiscard]] static Own ownPlaces(const Scene& scene, const PictureSettings& settings,
                                     const OfPoints& points);
  [[nodiscard]] Refined refine(const Scene& scene, const PictureSettings& settings) const;
  void light(int channel, const OfSpecular& by, bool keepsTerms);
  [[nodiscard]] Intensities luminanceOfAll() const;
  [[nodiscard]] Maps makeMaps(const Scene& scene, const PictureSettings& settings,
                              const Camera& camera) const;

  Cached<OfLighting, Lighting> lighting_;
  Cached<OfPoints, Own> own_;
  Cached<OfRefined, std::optional<Refined>> refined_;
  std::array<Lit, 3> lit_;
  Cached<std::array<Shared<Intensities>, 3>, Intensities> luminance_;  ///< only if lighting().luminance
  Cached<OfMaps, Maps> maps_;
};

}  // namespace xnewell
