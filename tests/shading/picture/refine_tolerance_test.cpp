#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>
#include <vector>

#include "shading/picture/refine.h"
#include "tests/support/illuminate.h"
#include "tests/support/lit_solids.h"
#include "tests/support/seeds.h"

namespace xnewell::THIS_FILE {

// RefineLimit::None is a promise: no place of any part is off by more than the tolerance. It is held against
// the equation as the book has it, at many places, of the normal that Phong shading interpolates over the
// polygon before the division.

namespace {

/// The shares of the corners a, b, c at the place p in their plane.
std::array<double, 3> sharesOf(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b,
                               const glm::dvec3& c) {
  const glm::dvec3 n = glm::cross(b - a, c - a);
  const double whole = glm::dot(n, n);
  const double u = glm::dot(glm::cross(c - b, p - b), n) / whole,
               v = glm::dot(glm::cross(a - c, p - c), n) / whole;
  return {u, v, 1.0 - u - v};
}

/// The corner of a part from which its fan goes.
int apexOf(const ConvexParts& parts, int k) {
  const auto from = parts.from.begin() + parts.firstCorner[k];
  return static_cast<int>(std::min_element(from, from + static_cast<int>(parts.part(k).size())) - from);
}

/// The unit normal that Phong shading has at a place of a face: that of the fan triangle in which it lies.
glm::dvec3 normalAt(const glm::dvec3& p, int face, const Scene& scene, const Vertices& vertices) {
  const ConvexParts& parts = scene.parts;
  glm::dvec3 N{0};
  double best = -1e300;
  for (int k = 0; k < parts.count(); ++k) {
    if (parts.face[k] != face) continue;
    const int first = parts.firstCorner[k], count = static_cast<int>(parts.part(k).size());
    for (int c = 1, apex = apexOf(parts, k); c + 1 < count; ++c) {
      const std::array at{first + apex, first + (apex + c) % count, first + (apex + c + 1) % count};
      const auto place = [&](int v) { return scene.mesh.points[parts.corners[at[v]]]; };
      const auto shares = sharesOf(p, place(0), place(1), place(2));
      if (std::ranges::min(shares) <= best) continue;
      best = std::ranges::min(shares);
      N = glm::dvec3{0};
      for (int v = 0; v < 3; ++v) N += shares[v] * vertices.vertices[vertices.ofCorner[parts.from[at[v]]]].N;
    }
  }
  return unit(N);
}

/// Light of any kind from outside and from near by, beside the two spots of litAtRandom().
void addLights(Scene& scene, Illumination& light, std::mt19937& rng) {
  std::uniform_real_distribution<double> oneEach{-1, 1};
  const auto direction = [&] { return unit({oneEach(rng), oneEach(rng), oneEach(rng) + 0.01}); };
  if (rng() % 2) scene.light.lights.clear();
  for (auto k = rng() % 3 + scene.light.lights.empty(); k > 0; --k) {
    Light& added = scene.light.lights.emplace_back();
    added.kind = kLights[rng() % 3].id;
    added.Ip = glm::dvec3{0.2 + 0.15 * oneEach(rng)};
    added.position = (1.3 + 0.5 * oneEach(rng)) * direction();
    added.direction = added.kind == LightKind::Spot ? -added.position + 0.3 * direction() : direction();
    added.attenuation = kAttenuations[rng() % kAttenuations.size()].id;
    added.range = 2.5 + oneEach(rng);
    added.c = {0.8, 0.3, 0.4};
    added.inner = 12 + 8 * oneEach(rng), added.outer = added.inner + 8 + 4 * oneEach(rng);
    added.falloff = 1 + static_cast<int>(rng() % 3);
  }
  light.form = kForms[rng() % 3].id;
  light.n = std::array{1, 2, 5, 30, 120}[rng() % 5];
  light.ks = rng() % 3 ? 0.3 : 0.0;
}

}  // namespace

TEST(RefineTolerance, NoPlaceIsOffByMore) {
  const Seeds seeds{40};
  int reached = 0;
  long long places = 0;
  double nearest = 0;  // to the tolerance, as a share of it
  for (unsigned seed = seeds.from; seed < seeds.end; ++seed)
    for (const Shading method : kMethods) {
      SCOPED_TRACE(testing::Message() << seed << (method == Shading::Flat ? " flat" : " smooth"));
      std::mt19937 rng{seed};
      std::uniform_real_distribution<double> zeroToOne{0, 1};
      const double tolerance = std::array{0.02, 0.05, 0.1, 0.2}[seed % 4];
      Illumination light;
      Scene scene = litAtRandom(solid(seed), light, seed);
      addLights(scene, light, rng);
      const glm::dvec3 eye = 3.0 * unit({zeroToOne(rng) - 0.5, zeroToOne(rng) - 0.5, zeroToOne(rng) - 0.5});
      const Lighting lighting = resolve(scene.mesh, scene.light, light, Channels::Luminance, eye, {0, 0, 0});
      const Vertices vertices = smoothVertices(scene.mesh, NormalRule::Distinct);
      const ShadingPoints faces = facePoints(scene.mesh);
      const RefineSettings settings{.tolerance = tolerance, .parts = 60'000};
      const Refined refined = method == Shading::Flat
                                  ? refineFlat(scene.mesh, scene.parts, faces, lighting, settings)
                                  : refineSmooth(scene.mesh, scene.parts, vertices, lighting, settings);
      if (refined.limit != RefineLimit::None) continue;
      ++reached;

      /// The equation for the front or the back at a place.
      const auto exact = [&](const glm::dvec3& p, const glm::dvec3& N) {
        const Reflection surface{light.ka, light.kd, light.ks, light.n};
        double I = light.ka * light.Ia;
        for (const Light& each : scene.light.lights)
          I += illuminate(0.0, each.Ip.r, each, surface, N, unit(eye - p), p, light.form, scene.light.unit).I;
        return std::min(1.0, I);
      };
      const std::vector<glm::dvec3>& at = refined.mesh.points;
      const auto compare = [&](const glm::dvec3& p, const glm::dvec3& N, double front, double back) {
        const double off = std::max(std::abs(front - exact(p, N)), std::abs(back - exact(p, -N)));
        ASSERT_LE(off, tolerance + 1e-9);
        nearest = std::max(nearest, off / tolerance);
        ++places;
      };
      for (int k = 0; k < refined.parts.count(); ++k) {
        const std::span<const int> part = refined.parts.part(k);
        const int face = refined.parts.face[k];
        const int apex = apexOf(refined.parts, k), count = static_cast<int>(part.size());
        for (int c = 1; c + 1 < count; ++c) {
          const std::array corner{apex, (apex + c) % count, (apex + c + 1) % count};
          const auto place = [&](int v) { return at[part[corner[v]]]; };
          const int trials = refined.parts.count() > 5000 ? 12 : 60;
          for (int trial = 0; trial < trials; ++trial) {
            const double r = std::sqrt(zeroToOne(rng)), q = trial % 4 ? zeroToOne(rng) : trial % 8 / 4;
            const std::array weights{1 - r, r * (1 - q), r * q};
            const glm::dvec3 p = weights[0] * place(0) + weights[1] * place(1) + weights[2] * place(2);
            if (method == Shading::Flat) {
              const glm::dvec3& centre = refined.points.at[k];
              const glm::dvec3 N = faces.N[face];
              compare(p, N, exact(centre, N), exact(centre, -N));
              continue;
            }
            const glm::dvec3 N = normalAt(p, face, scene, vertices);
            FrontBack<double> I{0, 0};
            for (int v = 0; v < 3; ++v) {
              const int from = refined.parts.from[refined.parts.firstCorner[k] + corner[v]];
              const glm::dvec3 ofVertex = refined.vertices.vertices[refined.vertices.ofCorner[from]].N;
              I.front += weights[v] * exact(place(v), ofVertex);
              I.back += weights[v] * exact(place(v), -ofVertex);
            }
            compare(p, N, I.front, I.back);
          }
          if (testing::Test::HasFatalFailure()) break;
        }
        if (testing::Test::HasFatalFailure()) return;
      }
    }
  if (!seeds.all()) return;
  EXPECT_GT(reached, 40);
  EXPECT_GT(places, 1'000'000);
  EXPECT_GT(nearest, 0.9);  // the bound is not far too careful
}

}  // namespace xnewell::THIS_FILE
