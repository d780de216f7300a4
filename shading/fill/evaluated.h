#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "shading/fill/fill.h"
#include "shading/fill/ramp.h"
#include "shading/fill/texture.h"
#include "shading/light/illumination.h"

namespace xnewell {

/// Triangles that are evaluated at every pixel instead of stepped: for Phong's normals, which must be made
/// unit vectors again, and for textures. @see Phong 1975; Foley & van Dam 2e §16.2.5
///
/// A plane over the screen interpolates values over w, the depth. Places and texture coordinates must be
/// divided by 1 / w to be right on the surface. Normals need no division, because their length does not
/// matter. If they are not made unit vectors (a short cut that saves the square root), they are interpolated
/// as they are. Terms are interpolated as they are, as Gouraud did. The origin of the planes is a corner of
/// the triangle's own box, so a pixel has one value wherever its span starts. Eight pixels are evaluated at
/// once in single precision: the error is a few roundings of 2^-24, times n in the specular term. Beyond n =
/// 1,024 it is double precision. Places are relative to one of the triangle, and light and eye are subtracted
/// in double precision, so it does not matter how far the scene is from the origin.

/// A plane over the picture: c + gx (i - i0) + gy (j - j0).
struct PixelPlane {
  double c = 0, gx = 0, gy = 0;
  PixelPlane operator-(const PixelPlane& p) const { return {c - p.c, gx - p.gx, gy - p.gy}; }
  PixelPlane operator*(double s) const { return {c * s, gx * s, gy * s}; }
};

/// Makes planes through values at the vertices of a triangle. Their origin is the first pixel of its box.
class PixelPlanes {
 public:
  explicit PixelPlanes(const std::array<glm::ivec3, 3>& p);
  [[nodiscard]] PixelPlane operator()(const std::array<double, 3>& v) const;
  [[nodiscard]] int i0() const { return i0_; }
  [[nodiscard]] int j0() const { return j0_; }

 private:
  int i0_, j0_;
  double x0_, y0_;            ///< vertex 0, relative to the centre of (i0, j0), in pixels
  double x1_, y1_, x2_, y2_;  ///< the others, relative to vertex 0
  double perArea_;            ///< 0 for a sliver, which has the mean everywhere
};

/// What a triangle needs for its pixels to be evaluated, whatever is evaluated: a texture and cells.
struct EvaluatedTriangle {
  int i0 = 0, j0 = 0;                    ///< the planes' origin
  PixelPlane q{1, 0, 0};                 ///< 1 / w; w = 1 where the mapping is affine
  const Texture* texture = nullptr;      ///< none where null
  const std::uint8_t* texels = nullptr;  ///< the channel of it
  bool repeats = true;                   ///< whether texture coordinates leave [0, 1]
  PixelPlane u, v;                       ///< texture coordinates over w
  Ramp ramp;
  std::int64_t* clamped = nullptr;  ///< counts samples whose sum is above 1
};

/// The largest specular exponent with which PhongTriangle is evaluated in single precision.
inline constexpr int kMostForSingle = 1024;

/// Phong's illumination, evaluated at every pixel.
struct PhongTriangle : EvaluatedTriangle {
  const Lighting* lighting = nullptr;
  const Material* material = nullptr;
  int channel = 0;
  std::array<PixelPlane, 3> N;   ///< of the side that is seen; over w if `unitN`
  bool unitN = true;             ///< whether N is made a unit vector at each pixel
  bool placed = false;           ///< whether a light differs from place to place
  glm::dvec3 origin{0};          ///< a place on the triangle
  std::array<PixelPlane, 3> at;  ///< places relative to `origin`, over w
  bool variesV = false;          ///< whether V differs from place to place
  std::array<PixelPlane, 3> V;   ///< towards the eye, over w; a unit vector made of it does not depend on w

  /// Stores the cells of pixels (i, j) to (i + count - 1, j).
  void span(std::uint8_t* cells, int i, int j, int count) const;
  /// The intensity at one sample in double precision, not clamped.
  [[nodiscard]] double intensity(int i, int j) const;
  /// The same at pixels (i, j) to (i + count - 1, j), as precisely as span().
  void intensities(double* I, int i, int j, int count) const;
};

/// Terms that were evaluated once: at the face, or at the vertices and interpolated. The diffuse term is
/// multiplied by the texel.
struct TermsTriangle : EvaluatedTriangle {
  PixelPlane diffuse, rest;  ///< `rest`: the ambient and the specular term

  /// As PhongTriangle's.
  void span(std::uint8_t* cells, int i, int j, int count) const;
  [[nodiscard]] double intensity(int i, int j) const;
  void intensities(double* I, int i, int j, int count) const;
};

/// The luminance of three channels. Each channel is clamped to [0, 1] first.
template <class Triangle>
struct LuminanceTriangle {
  std::array<Triangle, 3> channel;
  Ramp ramp = {};
  std::int64_t* clamped = nullptr;

  void span(std::uint8_t* cells, int i, int j, int count) const {
    constexpr int kMost = 64;
    std::array<std::array<double, kMost>, 3> I;
    for (int done = 0; done < count; done += kMost) {
      const int pixels = std::min(kMost, count - done);
      for (int c = 0; c < 3; ++c) channel[c].intensities(I[c].data(), i + done, j, pixels);
      for (int k = 0; k < pixels; ++k) {
        for (int c = 0; c < 3; ++c) *clamped += I[c][k] > 1.0;
        cells[done + k] = ramp.cell(of({I[0][k], I[1][k], I[2][k]}));
      }
    }
  }
  [[nodiscard]] double intensity(int i, int j) const {
    return of({channel[0].intensity(i, j), channel[1].intensity(i, j), channel[2].intensity(i, j)});
  }

 private:
  [[nodiscard]] static double of(const glm::dvec3& I) { return luminance(glm::clamp(I, 0.0, 1.0)); }
};
template <class Triangle>
LuminanceTriangle(std::array<Triangle, 3>) -> LuminanceTriangle<Triangle>;

}  // namespace xnewell
