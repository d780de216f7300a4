#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "geometry/mesh.h"

/// Flat shading by the illumination equation, in world coordinates:
///   I = ka Ia + f Ip [ kd max(0, N.L) + ks max(0, R.V)^n ],  R = 2 N (N.L) - L,  f = 1,
/// the bracket 0 where N.L <= 0. @see Foley & van Dam 2e §16.1
///
/// What a face holds is computed when it is made and kept: no transformation ever touches it.
/// A two-sided face holds both its sides; the light reaches one of them, and which one the
/// eye sees is the projected outline's to say (SnappedFace::back). So the camera decides nothing here but
/// V, and V only enters the specular term.

/// Holds: all in [0, 1], Ia + Ip <= 1, 0 <= n <= 1,000,000 (x^0 = 1).
struct Illumination {
  double Ia = 0.2, Ip = 0.7;
  double ka = 0.9, kd = 0.9, ks = 0.4;
  int n = 20;
  glm::dvec3 light{-0.54, -0.64, 0.55};  ///< direction towards the light, any length but 0
  std::optional<glm::dvec3> lightPosition =
      std::nullopt;        ///< a point light in the scene's coordinates instead
  bool constantL = false;  ///< take L at the scene's centre for every face (the light is far away)
  bool constantV = false;  ///< take V at the look-at point for every face (the viewer is far away)
  bool twoSided = true;    ///< else the back is as dark and as lit as the front
  bool operator==(const Illumination&) const = default;
};

enum class SeenSide { Front, Back };

/// The shading attributes of one face. Splitting copies them by copying its number.
struct FaceShade {
  glm::dvec3 N{0};            ///< unit normal by Newell's method; 0 where the face has no area
  glm::dvec3 at{0};           ///< centroid, where flat shading evaluates
  glm::dvec3 L{0};            ///< unit, towards the light
  double NdotL = 0;           ///< in [-1, 1]; negative: the light reaches the back
  double ambient = 0;         ///< ka Ia
  double diffuse = 0;         ///< Ip kd |N.L|, of the side the light reaches
  double specular = 0;        ///< Ip ks max(0, R.V)^n, of the same side
  std::array<double, 2> I{};  ///< intensity of the front and of the back, clamped to [0, 1]
  bool clamped = false;       ///< one of them was above 1
};

/// The share of a colour that lands on the single ramp: 0.30 R + 0.59 G + 0.11 B, the gray of X servers.
[[nodiscard]] double luminance(glm::dvec3 color);

/// Everything but the specular term, which is 0.
[[nodiscard]] std::vector<FaceShade> shadeFaces(const Mesh& mesh, const Illumination& light);

/// The specular term and the intensities, again whenever the eye moves. ks = 0 costs nothing but the sums.
void shadeSpecular(std::span<FaceShade> faces, const Illumination& light, glm::dvec3 eye, glm::dvec3 lookAt);
