#pragma once

#include <array>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <string_view>
#include <vector>

#include "shading/light/illumination.h"

namespace xnewell {

/// Phong shading by a look-up. A map of 256 x 256 places holds what a surface reflects for each direction of
/// its normal. Two components of the interpolated normal say where to look. The light is infinitely far away:
/// L and fatt are those at the scene's centre. The specular term is cos^n of the angle between N and L.

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

/// kMapCentre + kMapScale c, for a component c of a unit normal in [-1, 1]: the whole part is the column or
/// the row of the map.
inline constexpr double kMapScale = 127.0, kMapCentre = 128.0;

/// The intensities that one surface reflects, in one channel. An intensity above 1 is clamped when it is
/// shown.
struct Environment {
  glm::dmat3 frame{1.0};           ///< from the world to the axes in which x and y are looked up
  bool twoMaps = false;            ///< whether normals with z < 0 have a map of their own
  std::vector<float> front, away;  ///< 65,536 each, row by row; `away` is empty unless twoMaps
};

/// With one light, a place of `rotated` whose x and y lie within the unit circle is off by at most 2^-24 +
/// n 2^-43: it is stored as a float, and near the rim z has few digits.
/// `viewFrame` is the rotation from the world to the eye's axes: x to the right, y up, z towards the viewer.
[[nodiscard]] Environment makeEnvironment(EnvironmentForm form, const Lighting& lighting,
                                          const Material& material, int channel, const glm::dmat3& viewFrame,
                                          const glm::dvec3& centre);

}  // namespace xnewell
