#pragma once

#include <algorithm>
#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "geometry/exact/box.h"
#include "geometry/model/mesh.h"
#include "shading/light/equation.h"

namespace xnewell {

/// What goes into the illumination equation (equation.h): what the user and the scene say, and from both the
/// numbers that are the same for all places.
///
/// The ambient and diffuse terms never depend on the camera. The specular term depends on the eye's place,
/// through V, and on nothing else of the camera.

/// What a texel does to the diffuse colour of its surface. Both leave the ambient and the specular term as
/// they are.
enum class TexelUse { Replaces, Multiplies };
struct TexelUseRow {
  TexelUse id;
  std::string_view name, diffuse;
};
inline constexpr std::array kTexelUses{
    TexelUseRow{TexelUse::Replaces, "replaces", "the texel is the surface's colour"},
    TexelUseRow{TexelUse::Multiplies, "multiplies", "the texel times the surface's colour, as map_Kd in MTL"},
};

/// What the user says about the light. It applies where the scene says nothing.
/// Lengths are in the file's units, but in the scene's for the functions of this header.
/// Holds: all are in [0, 1], Ia + Ip <= 1, 0 <= n <= 1,000,000 (x^0 = 1).
struct Illumination {
  double Ia = 0.2, Ip = 0.7;
  double ka = 0.9, kd = 0.9, ks = 0.4;
  int n = 20;
  glm::dvec3 light{-0.54, -0.64, 0.55};  ///< direction towards the light, of any length but 0
  std::optional<glm::dvec3> lightPosition = std::nullopt;  ///< if given, a point light here
  /// Of all lights at places. If empty, each light of the scene keeps its own, and the user's has none.
  std::optional<Attenuation> attenuation = std::nullopt;
  /// For these lights. attenuate() has the defaults.
  std::optional<double> range = std::nullopt;
  std::optional<glm::dvec3> c = std::nullopt;  ///< c1, c2, c3
  Form form = Form::Textbook;
  bool constantL = false;  ///< use L and fatt of the scene's centre everywhere: the light is far away
  bool constantV = false;  ///< use V of the look-at point everywhere: the viewer is far away
  bool twoSided = true;    ///< if not, the back of a face has the intensity of its front
  TexelUse texel = TexelUse::Replaces;
  Mistake mistake = Mistake::None;  ///< in the equation
  bool operator==(const Illumination&) const = default;
};

/// What a scene says about its light. Lengths are in the scene's units.
struct SceneLight {
  std::optional<glm::dvec3> Ia;  ///< RGB
  std::vector<Light> lights;     ///< if empty, there is the user's light
  double unit = 1;               ///< in the scene's units: the length that `inverse` takes for 1
  /// Whether a light has a place, so that it can be attenuated.
  [[nodiscard]] bool placed() const {
    return std::ranges::any_of(lights, [](const Light& l) { return l.kind != LightKind::Directional; });
  }
};

/// Which channels a picture computes.
enum class Channels {
  Luminance,   ///< one channel: the gray of each intensity
  Brightness,  ///< one channel: the largest component of a surface's colour; the table has its hue
  Rgb,
};

/// What one surface reflects, by channel.
struct Material {
  std::array<double, 3> ambient{};   ///< ka Ia; by a mistake, none or twice that
  std::array<double, 3> ka{};        ///< times the colour
  std::array<double, 3> kd{}, ks{};  ///< the same; of a texture, times what the texel multiplies
  int n = 1;
  double leastCosine = 0;  ///< for a smaller cosine cos^n is below 2^-40 and counts as 0
};

/// The numbers in the equation that are the same for all places.
struct Lighting {
  struct Source {
    std::array<double, 3> Ip{};
    bool placed = false;    ///< whether L, fatt or spot differ from place to place
    bool constantL = true;  ///< whether L and f below hold everywhere
    bool spot = false;
    glm::dvec3 L{0}, position{0}, axis{0};  ///< L and axis are unit vectors
    double f = 1;                           ///< fatt
    bool linear = false;
    glm::dvec3 c{1, 0, 0};  ///< f = 1 / max(1, c.x + c.y d + c.z d^2); if linear, 1 - c.x d
    double cosInner = 1, cosOuter = 1;
    int falloff = 1;
  };
  int channels = 1;
  /// Whether the picture has one channel, the luminance of these three. It is taken at the end: a red light
  /// on a green surface has none.
  bool luminance = false;
  std::vector<Source> sources;      ///< those that can reach the scene and that a face reflects
  std::vector<Material> materials;  ///< the first is for faces without one, then as in Mesh::materials
  Form form = Form::Textbook;
  Mistake mistake = Mistake::None;
  bool twoSided = true;
  bool specular = false;  ///< whether a face reflects any source in a highlight
  bool constantV = false;
  glm::dvec3 farV{0}, eye{0};
  /// Whether all light is ambient. Then each material has one intensity, at every place and in every
  /// direction, and nothing asks for a normal.
  [[nodiscard]] bool onlyAmbient() const { return sources.empty(); }
  [[nodiscard]] bool asksForEye() const { return specular && form != Form::Tutorial; }
  /// Whether V differs from place to place.
  [[nodiscard]] bool variesV() const { return asksForEye() && !constantV; }
  /// Whether a light differs from place to place.
  [[nodiscard]] bool placed() const { return std::ranges::any_of(sources, &Source::placed); }
  [[nodiscard]] bool needsPlaces() const { return variesV() || placed(); }
};

/// Gives a light at a place this attenuation; a directional light has none. Lengths are in the scene's units.
/// The defaults are computed from the distance between the light and the centre of the scene's box: `range`
/// is twice that distance, and c1, c2, c3 are 1, 0 and the value for which fatt = 1/2 at the centre. A light
/// in the middle counts as 2^-20 of the box's longest side away.
void attenuate(Light& light, Attenuation attenuation, const std::optional<double>& range,
               const std::optional<glm::dvec3>& c, const Box& scene);

/// The lights of the scene, or if it has none the user's, with the attenuation that the user says. Lengths
/// are in the scene's units. `box` is the scene's.
[[nodiscard]] std::vector<Light> lightsOf(const SceneLight& scene, const Illumination& user, const Box& box);
/// Their ambient light: the scene's Ia, or if it has none the user's.
[[nodiscard]] inline glm::dvec3 ambientOf(const SceneLight& scene, const Illumination& user) {
  return scene.Ia.value_or(glm::dvec3{user.Ia});
}
/// What a surface reflects in one channel, 0 to 2 for RGB. Values that the material sets win over the user's.
/// With a texture, kd is what the texel multiplies.
[[nodiscard]] Reflection reflectionOf(const MeshMaterial& m, const Illumination& user, int channel);

/// For Channels::Luminance, `colored` says whether the scene has colours. If it has none, one channel is
/// enough.
[[nodiscard]] Lighting resolve(const Mesh& mesh, const SceneLight& scene, const Illumination& user,
                               Channels channels, glm::dvec3 eye, glm::dvec3 lookAt, bool colored = false);

/// The gray of a colour on X servers, for pictures of one channel: 0.30 R + 0.59 G + 0.11 B.
[[nodiscard]] double luminance(glm::dvec3 color);

/// A value for the front and for the back of a face: a light reaches only one of them.
template <class Real>
struct FrontBack {
  Real front, back;
  /// The value of the one that is seen.
  [[nodiscard]] const Real& seen(bool isBack) const { return isBack ? back : front; }
};

}  // namespace xnewell
