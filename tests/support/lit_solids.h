#pragma once

#include <array>
#include <glm/geometric.hpp>
#include <random>
#include <vector>

#include "geometry/exact/trig.h"
#include "geometry/exact/unit.h"
#include "geometry/model/solids.h"
#include "shading/scene/picture_settings.h"
#include "shading/scene/scene.h"

namespace xnewell {

/// Random closed solids under light that is narrower than their polygons.

/// The methods that divide polygons.
inline constexpr std::array kMethods{Shading::Flat, Shading::Gouraud};

/// A prism with polygons of twelve corners at its ends.
inline Mesh drum() {
  constexpr int kAround = 12;
  Mesh mesh;
  mesh.groupNames = {""};
  std::vector<int> top, bottom;
  for (int k = 0; k < kAround; ++k) {
    const SinCos turn = sinCosDegrees(30.0 * k);
    mesh.points.emplace_back(turn.cos, turn.sin, -0.6);
    mesh.points.emplace_back(turn.cos, turn.sin, 0.6);
    top.push_back(2 * k + 1);
    bottom.insert(bottom.begin(), 2 * k);
    const int next = 2 * ((k + 1) % kAround);
    mesh.addFace(std::array{2 * k, next, next + 1, 2 * k + 1}, 0);
  }
  mesh.addFace(top, 0);
  mesh.addFace(bottom, 0);
  return mesh;
}

/// A closed solid; the kinds take turns. Every fifth is a cube whose faces share no point.
inline Mesh solid(unsigned seed) {
  switch (seed % 5) {
    case 0:
      return sphere(9, 5);
    case 1:
      return torus(8, 5);
    case 2:
      return cube();
    case 3:
      return drum();
    default: {
      const Mesh shared = cube();
      Mesh apart;
      apart.groupNames = {""};
      for (int f = 0; f < shared.faceCount(); ++f) {
        std::vector<int> corners;
        for (const int c : shared.face(f)) {
          corners.push_back(static_cast<int>(apart.points.size()));
          apart.points.push_back(shared.points[c]);
        }
        apart.addFace(corners, 0);
      }
      return apart;
    }
  }
}

/// Spotlights from all sides and of all widths, aimed at solids about the origin, and highlights.
inline Scene litAtRandom(Mesh mesh, Illumination& light, unsigned seed) {
  std::mt19937 rng{seed};
  std::uniform_real_distribution<double> oneEach{-1, 1};
  Scene scene = makeScene("solid", std::move(mesh), UpAxis::Z);
  const auto direction = [&] { return unit({oneEach(rng), oneEach(rng), oneEach(rng) + 0.01}); };
  for (int k = 0; k < 2; ++k) {
    const glm::dvec3 from = direction();
    const double inner = 10 + 8 * oneEach(rng);
    scene.light.lights.push_back({.kind = LightKind::Spot,
                                  .Ip = glm::dvec3{0.4},
                                  .direction = -from + 0.2 * direction(),
                                  .position = 2.0 * from,
                                  .inner = inner,
                                  .outer = inner + 6 + 4 * oneEach(rng),
                                  .falloff = 1 + k});
  }
  light.kd = 0.7;
  light.ks = 0.3;
  light.n = 30;
  return scene;
}

}  // namespace xnewell
