#pragma once

#include <array>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <string_view>
#include <vector>

#include "shading/light/illumination.h"

namespace xnewell {

/// Phong shading by a look-up: a picture of what a surface reflects in each direction of its normal, 256 x
/// 256 places, found by two components of the interpolated normal. Its light is infinitely far away: L and f
/// are those at the scene's centre. The specular term is cos^n of the angle between N and L.

enum class EnvironmentForm { Rotated, Published };
struct EnvironmentRow {
  EnvironmentForm id;
  std::string_view name, looksUp;
};
inline constexpr std::array kEnvironmentForms{
    EnvironmentRow{EnvironmentForm::Rotated, "rotated",
                   "x and y of N turned so that L is (0, 0, 1), and the sign of its z: exact"},
    EnvironmentRow{EnvironmentForm::Published, "published",
                   "Lx - Nx and Ly - Ny as seen: exact for a light on the view axis"},
};

/// A component of a unit normal, in [-1, 1], as a value whose whole part is the column or row of the map.
inline constexpr double kMapScale = 127.0, kMapCentre = 128.0;

/// What a channel of one surface reflects, as intensities. Those above 1 are clamped when they are shown.
struct Environment {
  glm::dmat3 frame{1.0};           ///< from the world to where x and y are looked up
  bool twoMaps = false;            ///< whether z < 0 is another map
  std::vector<float> front, away;  ///< 65,536 each, row by row; `away` empty unless twoMaps
};

/// `viewFrame` is the rotation from the world to the eye's axes: x right, y up, z towards the viewer.
[[nodiscard]] Environment makeEnvironment(EnvironmentForm form, const Lighting& lighting,
                                          const Material& material, int channel, const glm::dmat3& viewFrame,
                                          const glm::dvec3& centre);

}  // namespace xnewell
