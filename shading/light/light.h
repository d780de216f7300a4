#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <string_view>

namespace xnewell {

/// Light sources. @see Foley & van Dam 2e §16.1

/// A directional light is so far away that L is the same everywhere. A spot is a point light that shines into
/// a cone.
enum class LightKind { Directional, Point, Spot };
struct LightRow {
  LightKind id;
  std::string_view name;
};
inline constexpr std::array kLights{
    LightRow{LightKind::Directional, "directional"},
    LightRow{LightKind::Point, "point"},
    LightRow{LightKind::Spot, "spot"},
};

/// What the distance d leaves of a point light or a spot. d is in units of the world, so 1/d has a meaning.
enum class Attenuation { None, Inverse, InverseSquare, Linear, Textbook };
struct AttenuationRow {
  Attenuation id;
  std::string_view name, f;
};
inline constexpr std::array kAttenuations{
    AttenuationRow{Attenuation::None, "none", "1"},
    AttenuationRow{Attenuation::Inverse, "inverse", "min(1, 1/d)"},
    AttenuationRow{Attenuation::InverseSquare, "inverse-square", "min(1, 1/d^2)"},
    AttenuationRow{Attenuation::Linear, "linear", "max(0, 1 - d/range)"},
    AttenuationRow{Attenuation::Textbook, "textbook", "min(1, 1/(c1 + c2 d + c3 d^2))"},
};

struct Light {
  LightKind kind = LightKind::Directional;
  glm::dvec3 Ip{0};               ///< RGB, each in [0, 1]
  glm::dvec3 direction{0, 0, 1};  ///< directional: towards the light; spot: its axis, away from it. Not 0
  glm::dvec3 position{0};         ///< of a point light or a spot, world coordinates
  Attenuation attenuation = Attenuation::None;
  double range = 1;               ///< dmax of `linear`, > 0
  glm::dvec3 c{1, 0, 0};          ///< c1, c2, c3 of `textbook`, >= 0
  double inner = 15, outer = 20;  ///< degrees from the spot's axis, 0 <= inner <= outer <= 180
  int falloff = 1;                ///< the exponent between the two cones, 0..1,000,000
  bool operator==(const Light&) const = default;
};

/// Ia + the sum of all Ip must not exceed 1 in any channel. The rounding of decimal numbers is allowed for.
inline constexpr double kMostLight = 1.0 + 0x1p-40;

}  // namespace xnewell
