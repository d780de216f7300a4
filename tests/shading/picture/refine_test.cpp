#include "shading/picture/refine.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <random>
#include <tuple>

#include "geometry/exact/unit.h"
#include "geometry/model/solids.h"
#include "tests/support/lit_floor.h"
#include "tests/support/lit_solids.h"
#include "tests/support/seeds.h"
#include "tests/support/triangle_soup.h"

namespace xnewell::THIS_FILE {

namespace {

/// A scene with its light resolved and divided.
struct Divided {
  Scene scene;
  Lighting lighting;
  Vertices vertices;
  Refined refined;

  Divided(Scene made, const Illumination& light, Shading method, const RefineSettings& settings,
          glm::dvec3 eye = {0.1, -0.2, 1.0})
      : scene{std::move(made)},
        lighting{resolve(scene.mesh, scene.light, light, Channels::Luminance, eye, {0, 0, 0})},
        vertices{smoothVertices(scene.mesh, NormalRule::Distinct)},
        refined{method == Shading::Flat
                    ? refineFlat(scene.mesh, scene.parts, facePoints(scene.mesh), lighting, settings)
                    : refineSmooth(scene.mesh, scene.parts, vertices, lighting, settings)} {}
};

Intensities intensitiesAt(const ShadingPoints& points, const Lighting& lighting) {
  Terms diffuse, specular;
  Intensities intensities;
  diffuseIntensities(diffuse, points, lighting, 0);
  specularIntensities(specular, points, lighting, 0);
  addTerms(intensities, diffuse, specular, points, lighting, 0);
  return intensities;
}

using Place = std::tuple<double, double, double>;
Place placeOf(const glm::dvec3& p) { return {p.x, p.y, p.z}; }

/// How often each edge between two places runs from the first to the second.
std::map<std::pair<Place, Place>, int> edgesOf(const Mesh& mesh, const ConvexParts& parts) {
  std::map<std::pair<Place, Place>, int> edges;
  for (int k = 0; k < parts.count(); ++k) {
    const auto corners = parts.part(k);
    for (std::size_t c = 0; c < corners.size(); ++c)
      ++edges[{placeOf(mesh.points[corners[c]]), placeOf(mesh.points[corners[(c + 1) % corners.size()]])}];
  }
  return edges;
}

double leastAngle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const auto at = [](glm::dvec3 u, glm::dvec3 v) {
    return std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v));
  };
  return std::min({at(b - a, c - a), at(c - b, a - b), at(a - c, b - c)});
}

double leastAngle(const Mesh& mesh, std::span<const int> triangle) {
  const auto& p = mesh.points;
  return leastAngle(p[triangle[0]], p[triangle[1]], p[triangle[2]]);
}

Mesh oneTriangle() {
  Mesh mesh;
  mesh.groupNames = {""};
  mesh.points = {{-1, -1, 0}, {1, -1, 0}, {-0.2, 1, 0}};
  mesh.addFace(std::array{0, 1, 2}, 0);
  return mesh;
}

}  // namespace

// Closed solids stay closed: each edge of a piece has one neighbour, which has the edge the other way round.
// This holds also if faces share only places, and neither points nor normals.
TEST(Refine, ClosedSolidsStayClosed) {
  int divided = 0;
  for (unsigned seed = 0; seed < (kSanitized ? 5u : 40u); ++seed)
    for (const Shading method : kMethods) {
      SCOPED_TRACE(seed);
      Illumination light;
      Scene scene = litAtRandom(solid(seed), light, seed);
      const Divided d{std::move(scene), light, method, {.tolerance = 0.05}};
      const auto edges = edgesOf(d.refined.mesh, d.refined.parts);
      for (const auto& [edge, times] : edges) {
        ASSERT_EQ(times, 1);
        ASSERT_TRUE(edges.contains({edge.second, edge.first}));
      }
      divided += d.refined.parts.count() > d.scene.parts.count();
    }
  EXPECT_GT(divided, kSanitized ? 7 : 60);
}

// At its corners a flat piece is within the tolerance of its own centroid, without exception. This includes
// the rest of a polygon that lost only a corner, which was within the tolerance of the polygon's centroid.
TEST(Refine, FlatPartsKeepToTheToleranceAtCorners) {
  int divided = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 rng{seed};
    std::uniform_real_distribution<double> oneEach{-1, 1};
    const Illumination light{.Ip = 0.8,
                             .kd = 1,
                             .ks = 0,
                             .lightPosition = glm::dvec3{oneEach(rng), oneEach(rng), 1 + 0.4 * oneEach(rng)}};
    const double tolerance = 0.1 * std::pow(4.0, oneEach(rng));
    const Divided d{makeScene("drum", drum(), UpAxis::Z), light, Shading::Flat, {.tolerance = tolerance}};
    ASSERT_EQ(d.refined.limit, RefineLimit::None);
    const Intensities centres = intensitiesAt(d.refined.points, d.lighting);
    for (int k = 0; k < d.refined.parts.count(); ++k) {
      ShadingPoints corners;
      for (const int p : d.refined.parts.part(k)) {
        corners.at.push_back(d.refined.mesh.points[p]);
        corners.N.push_back(d.refined.points.N[k]);
        corners.material.push_back(-1);
      }
      for (const FrontBack<double>& I : intensitiesAt(corners, d.lighting).I)
        ASSERT_LE(std::abs(I.front - centres.I[k].front), tolerance);
    }
    divided += d.refined.parts.count() > d.scene.parts.count();
  }
  EXPECT_GT(divided, 100);
}

// Polygons within the tolerance stay as they are, corner by corner, as do those of the floor far from the
// light. Pieces of the others keep face and plane. A directional light divides nothing.
TEST(Refine, LeavesTheRestAsItIs) {
  for (const Shading method : kMethods) {
    const Divided d{underSpot(floorOf(8)), {.ks = 0}, method, {.tolerance = 0.1}};
    const ConvexParts &parts = d.refined.parts, &before = d.scene.parts;
    std::vector<int> ofFace(64, 0);
    int whole = 0;
    for (int k = 0; k < parts.count(); ++k) {
      ASSERT_EQ(parts.plane[k], before.plane[parts.face[k]]);
      ++ofFace[parts.face[k]];
      if (parts.part(k).size() == 4) {
        ASSERT_TRUE(std::ranges::equal(parts.part(k), before.part(parts.face[k])));
        ++whole;
      }
    }
    EXPECT_TRUE(std::ranges::is_sorted(parts.face));
    EXPECT_GT(std::ranges::max(ofFace), 4);
    EXPECT_GT(whole, 20);
    EXPECT_EQ(std::ranges::count(ofFace, 1), whole);

    const Divided even{makeScene("floor", floorOf(8), UpAxis::Z), {.ks = 0}, method, {.tolerance = 1e-6}};
    EXPECT_EQ(even.refined.parts.corners, even.scene.parts.corners);
    EXPECT_EQ(even.refined.mesh.points, even.scene.mesh.points);
  }
}

// A spot wholly inside one large triangle is found wherever it lies, if a sample lies in it, and so is a
// highlight. Neither shows at any corner or at the middle of any edge.
TEST(Refine, FindsLightInsideOneTriangle) {
  const Seeds seeds{200};
  for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 rng{seed};
    std::uniform_real_distribution<double> zeroToOne{0, 1};
    const double r = 0.4 + 0.2 * zeroToOne(rng), q = 0.4 + 0.2 * zeroToOne(rng);
    Scene scene = makeScene("triangle", oneTriangle(), UpAxis::Z);
    const auto& p = scene.mesh.points;
    const glm::dvec3 place = (1 - r) * p[0] + r * (1 - q) * p[1] + r * q * p[2];
    const auto expectFound = [&](const Divided& d) {
      ASSERT_GT(d.refined.parts.count(), 10);
      const Intensities intensities = intensitiesAt(d.refined.points, d.lighting);
      const auto [least, most] =
          std::ranges::minmax(intensities.I, {}, [](const FrontBack<double>& I) { return I.front; });
      EXPECT_GT(most.front, least.front + 0.1);
    };
    const glm::dvec3 eye = place + glm::dvec3{0, 0, 0.3};
    const Scene dark = scene;
    scene.light.lights = {{.kind = LightKind::Spot,
                           .Ip = glm::dvec3{0.7},
                           .direction = {0, 0, -1},
                           .position = eye,
                           .inner = 16,
                           .outer = 18}};
    for (const Shading method : kMethods) {
      expectFound({scene, {.ks = 0}, method, {.tolerance = 0.1}});
      expectFound(
          {dark, {.kd = 0.3, .ks = 0.5, .n = 20, .light = {0, 0, 1}}, method, {.tolerance = 0.1}, eye});
    }
  }
}

// The smaller the tolerance, the more parts.
TEST(Refine, DividesMoreForLessTolerance) {
  const Seeds seeds{12};
  for (unsigned seed = seeds.from; seed < seeds.end; ++seed)
    for (const Shading method : kMethods) {
      SCOPED_TRACE(seed);
      int last = 0;
      for (const double tolerance : {1.0, 0.2, 0.1, 0.05, 0.02}) {
        Illumination light;
        Scene scene = litAtRandom(solid(seed), light, seed);
        const Divided d{std::move(scene), light, method, {.tolerance = tolerance}};
        if (tolerance == 1.0) {
          EXPECT_EQ(d.refined.parts.count(), d.scene.parts.count());
        }
        EXPECT_GE(d.refined.parts.count(), last);
        last = d.refined.parts.count();
      }
      EXPECT_GT(last, 100);
    }
}

// Pieces are not needles: no angle is less than half the smallest angle of the face.
TEST(Refine, KeepsAnglesWide) {
  int parts = 0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    Illumination light;
    Scene scene = litAtRandom(triangleSoup(20, 0.7, seed), light, seed);
    const Divided d{std::move(scene), light, kMethods[seed % 2], {.tolerance = 0.01}};
    for (int k = 0; k < d.refined.parts.count(); ++k) {
      const double before = leastAngle(d.scene.mesh, d.scene.mesh.face(d.refined.parts.face[k]));
      ASSERT_GE(leastAngle(d.refined.mesh, d.refined.parts.part(k)), 0.5 * before * (1 - 1e-9));
    }
    parts += d.refined.parts.count();
  }
  EXPECT_GT(parts, 20'000);
}

// A cone without a soft rim is a step that no interpolation can follow: the limits stop the division, and the
// result says so. No piece is smaller than the halvings allow, except those that neighbours cut.
TEST(Refine, EndsAtItsLimits) {
  for (const Shading method : kMethods) {
    const auto divided = [&](RefineSettings settings) {
      return Divided{underSpot(floorOf(1), 20, 20), {.ks = 0}, method, settings}.refined;
    };
    const Refined deep = divided({.tolerance = 0.05, .halvings = 9});
    EXPECT_EQ(deep.limit, RefineLimit::Halvings);
    EXPECT_GT(deep.parts.count(), 100);
    double least = 1;
    for (int k = 0; k < deep.parts.count(); ++k) {
      const auto p = deep.parts.part(k);
      const auto& at = deep.mesh.points;
      least = std::min(least, glm::length(glm::cross(at[p[1]] - at[p[0]], at[p[2]] - at[p[0]])));
    }
    EXPECT_EQ(least, std::ldexp(1.0, -9));  // relative to twice the area of half the square, which is 1
    const Refined few = divided({.tolerance = 0.05, .parts = 300});
    EXPECT_EQ(few.limit, RefineLimit::Parts);
    EXPECT_LE(few.parts.count(), 300);
    EXPECT_GT(few.parts.count(), 100);
    EXPECT_EQ(divided({.tolerance = 1}).limit, RefineLimit::None);
  }
}

// New corners lie on the face. Their texture coordinates are those of their place, and their normals are
// those that Phong shading makes unit vectors there.
TEST(Refine, InterpolatesAtNewCorners) {
  const Divided floor{underSpot(floorOf(4)), {.ks = 0}, Shading::Gouraud, {.tolerance = 0.02}};
  const Mesh& mesh = floor.refined.mesh;
  ASSERT_GT(mesh.corners.size(), floor.scene.mesh.corners.size() + 100);
  ASSERT_EQ(mesh.uvOfCorner.size(), mesh.corners.size());
  for (std::size_t c = 0; c < mesh.corners.size(); ++c) {
    const glm::dvec3 p = mesh.points[mesh.corners[c]];  // at half the size
    ASSERT_EQ(mesh.uv[mesh.uvOfCorner[c]], glm::dvec2(p.x + 0.5, p.y + 0.5));
  }

  Scene scene = makeScene("bent", oneTriangle(), UpAxis::Z);
  scene.light.lights = underSpot(floorOf(1)).light.lights;
  Vertices vertices = smoothVertices(scene.mesh, NormalRule::Distinct);
  const std::array N{unit({0.8, 0, 1}), unit({-0.5, 0.6, 1}), unit({0, -0.9, 0.4})};
  for (int v = 0; v < 3; ++v) vertices.vertices[v].N = N[v];
  const Lighting lighting = resolve(scene.mesh, scene.light, {}, Channels::Luminance, {0, 0, 1}, {0, 0, 0});
  const Refined bent = refineSmooth(scene.mesh, scene.parts, vertices, lighting, {.tolerance = 0.01});
  ASSERT_GT(bent.vertices.vertices.size(), 100u);
  const auto& p = scene.mesh.points;
  const auto area = [](glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) { return glm::cross(b - a, c - a).z; };
  for (const Vertex& v : bent.vertices.vertices) {
    const glm::dvec3 at = bent.mesh.points[v.point];
    const glm::dvec3 sum =
        area(at, p[1], p[2]) * N[0] + area(p[0], at, p[2]) * N[1] + area(p[0], p[1], at) * N[2];
    ASSERT_LT(glm::length(v.N - unit(sum)), 1e-14);
  }
}

}  // namespace xnewell::THIS_FILE
