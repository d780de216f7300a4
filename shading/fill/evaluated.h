#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "shading/fill/face_triangles.h"
#include "shading/fill/ramp.h"
#include "shading/fill/texture.h"
#include "shading/light/illumination.h"

namespace xnewell {

/// What is evaluated at every pixel of a triangle instead of being stepped: Phong's normals, which must be
/// made unit vectors again, and textures. @see Phong 1975; Foley & van Dam 2e §16.2.5
///
/// What a plane over the screen interpolates is true to the surface after a division by depth w: places and
/// texture coordinates, and normals, whose length does not matter, without one. Terms are interpolated as
/// they are, as Gouraud did. Planes are taken from the triangle's own corner, so a pixel has one value
/// wherever its span starts. Single precision, eight pixels at once: the sum of a few roundings of 2^-24,
/// times n for the specular term; beyond n = 1,024, double precision.

/// A plane over the picture: c + gx (i - i0) + gy (j - j0).
struct PixelPlane {
  double c = 0, gx = 0, gy = 0;
  PixelPlane operator-(const PixelPlane& p) const { return {c - p.c, gx - p.gx, gy - p.gy}; }
  PixelPlane operator*(double s) const { return {c * s, gx * s, gy * s}; }
};

/// The planes through values at the vertices of a triangle, about the first pixel of its box.
class PixelPlanes {
 public:
  explicit PixelPlanes(const std::array<glm::ivec3, 3>& p);
  [[nodiscard]] PixelPlane operator()(const std::array<double, 3>& v) const;
  [[nodiscard]] int i0() const { return i0_; }
  [[nodiscard]] int j0() const { return j0_; }

 private:
  int i0_, j0_;
  double x0_, y0_;            ///< vertex 0 from the centre of (i0, j0), in pixels
  double x1_, y1_, x2_, y2_;  ///< the others from vertex 0
  double perArea_;            ///< 0 for a sliver: all is the mean
};

struct EvaluatedTriangle {
  int i0 = 0, j0 = 0;
  const Lighting* lighting = nullptr;
  const Material* material = nullptr;
  int channel = 0;
  bool phong = false;
  std::array<PixelPlane, 3> N;   ///< phong: of the side that is seen, over w
  bool placed = false;           ///< phong: whether a light asks for places in the scene
  std::array<PixelPlane, 3> at;  ///< over w
  bool variesV = false;          ///< phong: whether V differs from place to place
  std::array<PixelPlane, 3> V;   ///< towards the eye, over w, which a unit vector need not be rid of
  PixelPlane diffuse, rest;      ///< else: the terms themselves, `rest` ambient and specular
  const Texture* texture = nullptr;
  const std::uint8_t* texels = nullptr;  ///< the channel of it
  bool repeats = true;                   ///< whether texture coordinates leave [0, 1]
  PixelPlane u, v;                       ///< they, over w
  PixelPlane q{1, 0, 0};                 ///< 1 / w; w = 1 where the mapping is affine
  Ramp ramp;
  std::int64_t* clamped = nullptr;  ///< counts samples whose sum is above 1

  /// Stores the cells of pixels (i, j) to (i + count - 1, j).
  void span(std::uint8_t* cells, int i, int j, int count) const;
  /// The intensity at one sample in double precision, not clamped.
  [[nodiscard]] double intensity(int i, int j) const;
};

}  // namespace xnewell
