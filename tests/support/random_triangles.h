#pragma once

#include <array>
#include <random>
#include <vector>

#include "geometry/model/solids.h"
#include "shading/fill/affine.h"
#include "shading/fill/evaluate_pixels.h"

namespace xnewell {

/// Triangles on the screen with random normals, places, terms and textures.
class RandomTriangles {
 public:
  explicit RandomTriangles(unsigned seed) : rng_{seed} {
    texture_ = {5, 3, {}, {}};
    for (int k = 0; k < 15; ++k) texture_.gray.push_back(static_cast<std::uint8_t>(17 * k));
    const Illumination user{.Ia = 0.1, .Ip = 0.6, .n = seed % 3 == 0 ? 1'000'000 : int(seed % 1000)};
    if (seed % 2)
      lights_ = {{.kind = LightKind::Spot,
                  .Ip = glm::dvec3{0.7},
                  .direction = {0, 0.1, -1},
                  .position = {0.2, 0, 2},
                  .outer = 40},
                 {.kind = LightKind::Point,
                  .Ip = glm::dvec3{0.7},
                  .position = {-1, 1, 0.5},
                  .attenuation = Attenuation::InverseSquare},
                 {.direction = {0, -1, 1}}};
    else
      lights_ = {{.Ip = glm::dvec3{user.Ip}, .direction = user.light}};
    lighting_ =
        resolve(cube(), {.Ia = {}, .lights = lights_}, user, Channels::Luminance, {0, 0, 5}, {0, 0, 0});
  }

  [[nodiscard]] double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(rng_()) * 0x1p-32);
  }
  /// Counter-clockwise, of about `size` pixels, somewhere within 8192 x 8192.
  [[nodiscard]] std::array<glm::ivec3, 3> outline(double size) {
    std::array<glm::ivec3, 3> p;
    do {
      const double x = uniform(0, 8192 - size), y = uniform(0, 8192 - size);
      for (glm::ivec3& v : p)
        v = {std::lrint((x + uniform(0, size)) * kGrid), std::lrint((y + uniform(0, size)) * kGrid), 0};
      if (doubleArea(p.data(), 3) < 0) std::swap(p[0], p[1]);
    } while (doubleArea(p.data(), 3) == 0);
    return p;
  }
  PhongTriangle phong(const std::array<glm::ivec3, 3>& p, bool textured) {
    const PixelPlanes planes{p};
    PhongTriangle e;
    e.lighting = &lighting_;
    e.material = &lighting_.materials[0];
    e.placed = lighting_.placed();
    e.variesV = lighting_.variesV();
    // Normals within 60 degrees of the z axis: in between they stay longer than 1/2.
    e.N = {three(planes, -0.6, 0.6), three(planes, -0.6, 0.6), planes({1, 1, 1})};
    e.at = {three(planes, -1, 1), three(planes, -1, 1), three(planes, -1, 0)};
    e.V = {three(planes, -1, 1), three(planes, -1, 1), three(planes, 4, 6)};
    addPixels(e, planes, textured);
    return e;
  }
  TermsTriangle terms(const std::array<glm::ivec3, 3>& p, bool textured) {
    const PixelPlanes planes{p};
    TermsTriangle e;
    e.diffuse = three(planes, 0, 1), e.rest = three(planes, 0, 0.5);
    addPixels(e, planes, textured);
    return e;
  }
  /// Calls use(triangle) with one of both.
  template <class Use>
  void triangle(const std::array<glm::ivec3, 3>& p, bool isPhong, bool textured, const Use& use) {
    if (isPhong)
      use(phong(p, textured));
    else
      use(terms(p, textured));
  }
  [[nodiscard]] const Lighting& lighting() const { return lighting_; }
  [[nodiscard]] int n() const { return lighting_.materials[0].n; }

  [[nodiscard]] const std::vector<Light>& lights() const { return lights_; }

  std::int64_t clamped = 0;

 private:
  PixelPlane three(const PixelPlanes& planes, double low, double high) {
    return planes({uniform(low, high), uniform(low, high), uniform(low, high)});
  }
  void addPixels(EvaluatedTriangle& e, const PixelPlanes& planes, bool textured) {
    e.i0 = planes.i0(), e.j0 = planes.j0();
    if (textured) {
      e.texture = &texture_;
      e.texels = texture_.gray.data();
      e.repeats = uniform(0, 1) < 0.5;
      const double most = e.repeats ? 3 : 0.5;  // over w, which is at most 2
      e.u = three(planes, 0, most), e.v = three(planes, 0, most), e.q = three(planes, 0.5, 1);
    }
    e.ramp = kChannelRamp;
    e.clamped = &clamped;
  }

  std::mt19937 rng_;
  std::vector<Light> lights_;
  Lighting lighting_;
  Texture texture_;
};

[[nodiscard]] inline AffineValue affineOver(const glm::ivec3* p, const std::array<double, 3>& v) {
  return AffineOver{p}(v);
}

}  // namespace xnewell
