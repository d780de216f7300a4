#pragma once

#include <algorithm>
#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "geometry/model/mesh.h"
#include "shading/light/lanes.h"
#include "shading/light/light.h"

namespace xnewell {

/// The illumination equation, in world coordinates and for each channel by itself:
///   I = ka Ia + sum over lights of s f Ip [ kd max(0, N.L) + ks max(0, R.V)^n ],  R = 2 N (N.L) - L,
/// the bracket 0 where N.L <= 0; ka, kd and ks times the surface's colour. f is the attenuation, s the share
/// of a spot. @see Foley & van Dam 2e §16.1
///
/// Ambient and diffuse terms never depend on the camera; the specular term does on the eye's place, through
/// V, and on nothing else of it.

/// Of which cosine the specular term is the n-th power.
enum class Form { Textbook, HalfVector, Tutorial };
struct FormRow {
  Form id;
  std::string_view name, cosine;
};
inline constexpr std::array kForms{
    FormRow{Form::Textbook, "textbook", "R.V, R the reflected L (Phong 1975)"},
    FormRow{Form::HalfVector, "half-vector", "N.H, H half way from L to V (Blinn 1977)"},
    FormRow{Form::Tutorial, "tutorial", "N.L: c = ambient + cos x diffuse + cos^n x specular"},
};

/// What the user says of the light, for what a scene does not say itself.
/// Holds: all in [0, 1], Ia + Ip <= 1, 0 <= n <= 1,000,000 (x^0 = 1).
struct Illumination {
  double Ia = 0.2, Ip = 0.7;
  double ka = 0.9, kd = 0.9, ks = 0.4;
  int n = 20;
  glm::dvec3 light{-0.54, -0.64, 0.55};  ///< direction towards the light, any length but 0
  std::optional<glm::dvec3> lightPosition =
      std::nullopt;                             ///< a point light in the scene's coordinates instead
  Attenuation attenuation = Attenuation::None;  ///< of the point light
  std::optional<double> range = std::nullopt;   ///< scene's units; else twice the way to the scene's centre
  /// c1, c2, c3 in the scene's units; else 1, 0 and what makes f = 1/2 at the scene's centre.
  std::optional<glm::dvec3> c = std::nullopt;
  Form form = Form::Textbook;
  bool constantL = false;  ///< take L and f at the scene's centre everywhere (the light is far away)
  bool constantV = false;  ///< take V at the look-at point everywhere (the viewer is far away)
  bool twoSided = true;    ///< else the back is as dark and as lit as the front
  bool operator==(const Illumination&) const = default;
};

/// What a scene says of its light; lengths in the scene's units.
struct SceneLight {
  std::optional<glm::dvec3> Ia;  ///< RGB
  std::vector<Light> lights;     ///< empty: the user's light
  double unit = 1;               ///< of the world in the scene's units: what `inverse` takes for 1
};

/// Which channels a picture computes.
enum class Channels {
  Luminance,   ///< one: the gray of every colour
  Brightness,  ///< one: of surfaces the largest component, for their hue is in the colour table
  Rgb,
};

/// Of one surface, what a place on it reflects, by channel.
struct Material {
  std::array<double, 3> ambient{};  ///< ka Ia of its colour
  std::array<double, 3> kd{}, ks{};
  int n = 1;
  double leastCosine = 0;  ///< below it cos^n is less than 2^-40 and counts as 0
};

/// The equation's right side, resolved: everything that is the same for all places.
struct Lighting {
  struct Source {
    std::array<double, 3> Ip{};
    bool placed = false;    ///< its direction, distance or cone must be asked of each place
    bool constantL = true;  ///< L and f below hold everywhere
    bool spot = false;
    glm::dvec3 L{0}, position{0}, axis{0};  ///< L and axis unit
    double f = 1;
    bool linear = false;
    glm::dvec3 c{1, 0, 0};  ///< c.x is 1/range if linear
    double cosInner = 1, cosOuter = 1;
    int falloff = 1;
  };
  int channels = 1;
  std::vector<Source> sources;      ///< those that can reach the scene
  std::vector<Material> materials;  ///< of no material first, then as Mesh::materials
  Form form = Form::Textbook;
  bool twoSided = true;
  bool specular = false;  ///< whether any material has a specular term
  bool constantV = false;
  glm::dvec3 farV{0}, eye{0};
  [[nodiscard]] bool asksForEye() const { return specular && form != Form::Tutorial; }
  /// Whether V differs from place to place.
  [[nodiscard]] bool variesV() const { return asksForEye() && !constantV; }
  /// Whether a light asks where it falls.
  [[nodiscard]] bool placed() const { return std::ranges::any_of(sources, &Source::placed); }
  [[nodiscard]] bool needsPlaces() const { return variesV() || placed(); }
};

[[nodiscard]] Lighting resolve(const Mesh& mesh, const SceneLight& scene, const Illumination& user,
                               Channels channels, glm::dvec3 eye, glm::dvec3 lookAt);

/// The share of a colour that lands on a single ramp: 0.30 R + 0.59 G + 0.11 B, the gray of X servers.
[[nodiscard]] double luminance(glm::dvec3 color);

/// A value for the front and for the back of a face: a light reaches only one of them.
template <class Real>
struct FrontBack {
  Real front, back;
  /// The value of the one that is seen.
  [[nodiscard]] const Real& seen(bool isBack) const { return isBack ? back : front; }
};

}  // namespace xnewell
