#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <random>
#include <tuple>
#include <vector>

#include "geometry/exact/scale.h"
#include "geometry/exact/trig.h"
#include "geometry/model/solids.h"
#include "shading/laboratory/errors.h"
#include "shading/picture/picture_cache.h"
#include "shading/picture/refine.h"
#include "shading/scene/picture_settings.h"
#include "shading/scene/scene.h"
#include "shading/scene/units.h"
#include "tests/support/seeds.h"
#include "tests/support/small_picture.h"
#include "tests/support/triangle_soup.h"

namespace xnewell::THIS_FILE {

namespace {

/// ---- Refined meshes

/// Coarse floors under light that is narrower than their polygons, so that flat and Gouraud shading miss it.

/// The square |x|, |y| <= 1 in z = 0 as n by n squares, seen from above. The texture's (0, 0) and (1, 1) are
/// its corners.
Mesh floorOf(int n) {
  Mesh mesh;
  mesh.groupNames = {"floor"};
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      mesh.uv.push_back({double(i) / n, double(j) / n});
      mesh.points.emplace_back(2.0 * mesh.uv.back() - 1.0, 0.0);
    }
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i;
      const std::array corners{a, a + 1, a + n + 2, a + n + 1};
      mesh.addFace(corners, 0, -1, corners);
    }
  return mesh;
}

/// A scene with a spotlight above the floor. Angles are in degrees.
Scene underSpot(Mesh mesh, double inner = 14, double outer = 20) {
  Scene scene = makeScene("spot", std::move(mesh), UpAxis::Z);
  scene.light.lights = {{.kind = LightKind::Spot,
                         .Ip = glm::dvec3{0.7},
                         .direction = {0.2, 0.3, -1.0},
                         .position = inSceneUnits(glm::dvec3{-0.1, -0.2, 1.3}, scene),
                         .inner = inner,
                         .outer = outer}};
  return scene;
}

/// A parallel view straight from above: interpolated places are those of the floor.
PictureSettings fromAbove(Shading shading) {
  PictureSettings s;
  s.width = s.height = 480;
  s.shading = shading;
  s.camera.eye = glm::dvec3{0.0, 0.0, 2.0};
  s.camera.lookAt = glm::dvec3{0.0};
  s.camera.up = glm::dvec3{0, 1, 0};
  s.camera.parallel = true;
  s.camera.height = 2.1;
  s.light.kd = 0.8;
  s.light.ks = 0.0;
  return s;
}

/// Random closed solids under light that is narrower than their polygons.

/// The methods that divide polygons.
constexpr std::array kMethods{Shading::Flat, Shading::Gouraud};

/// A prism with polygons of twelve corners at its ends.
Mesh drum() {
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
Mesh solid(unsigned seed) {
  if (seed % 5 < 4) return std::array{sphere(9, 5), torus(8, 5), cube(), drum()}[seed % 5];
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

/// Spotlights from all sides and of all widths, aimed at solids about the origin, and highlights.
Scene litAtRandom(Mesh mesh, Illumination& light, unsigned seed) {
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

/// ---- Their pictures

// Refined polygons have no crack and no overlap on the screen: every sample is covered exactly as often as in
// the undivided scene, and in pairs by closed solids. This holds for random triangles too, which have
// borders.
TEST(RefinePicture, CoversEachSampleAsBefore) {
  long long samples = 0, more = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    PictureSettings s;
    s.width = 240, s.height = 180;
    s.shading = kMethods[seed / 5 % 2];
    const bool soup = seed % 7 == 6;
    PictureCache pictures{litAtRandom(soup ? triangleSoup(20, 0.5, seed) : solid(seed), s.light, seed)};
    s.camera.parallel = seed % 3 == 0;
    pictures.make(s);
    s.camera = moved(s.camera, pictures.last().camera(), pictures.last().scene(), 17.0 * seed,
                     7.0 * seed - 100, 1.3);
    pictures.make(s);
    const std::vector<int> before = timesPainted(pictures.last().snapped(), s.width, s.height);
    const int polygons = pictures.last().snapped().polygons;
    s.adapt = 0.05;
    pictures.make(s);
    ASSERT_EQ(timesPainted(pictures.last().snapped(), s.width, s.height), before);
    for (const int n : before) {
      if (!soup) {
        ASSERT_EQ(n % 2, 0);
      }
      samples += n > 0;
    }
    more += pictures.last().snapped().polygons - polygons;
  }
  EXPECT_GT(samples, 300'000);
  EXPECT_GT(more, 5'000);
}

// The refined picture comes near to shading at every pixel. Nowhere on the floor is a cell farther off than
// the tolerance and its own rounding, except where a rim passes between samples. Undivided, many are. This
// holds with a texture too.
TEST(RefinePicture, PaintsWhatPixelsShow) {
  constexpr double kTolerance = 0.05;
  for (const Shading method : kMethods)
    for (const bool textured : {false, true}) {
      SCOPED_TRACE(textured);
      Scene scene = underSpot(floorOf(8));
      if (textured) {
        Texture stripes;
        stripes.width = 32, stripes.height = 1;
        for (int k = 0; k < 32; ++k) stripes.gray.push_back(k % 2 ? 255 : 100);
        stripes.channel = {stripes.gray, stripes.gray, stripes.gray};
        wear(scene, stripes);
      }
      PictureSettings s = fromAbove(Shading::Phong);
      s.table.kind = TableKind::Linear;
      PictureCache pictures{scene};
      const IndexImage exact = painted(pictures, s);
      const auto farOff = [&](double adapt) {
        s.shading = method;
        s.adapt = adapt;
        const IndexImage image = painted(pictures, s);
        int count = 0;
        for (std::size_t k = 0; k < image.pixels.size(); ++k)
          count += std::abs(image.pixels[k] - exact.pixels[k]) > 240 * kTolerance + 1;
        return count;
      };
      EXPECT_GT(farOff(0.0), 5'000);
      EXPECT_LT(farOff(kTolerance), 50);
    }
}

// Refining does not change which face is seen where. The depth sort stays exact: it paints what the oracle
// sees in every pixel.
TEST(RefinePicture, KeepsFacesAndOrder) {
  int divided = 0, samples = 0;
  for (const char* const name : {"penetrate", "cycle", "decals", "room"})
    for (const Shading method : kMethods) {
      SCOPED_TRACE(name);
      Scene scene = readScene(name);
      const Mesh& mesh = scene.mesh;
      glm::dvec3 centre{0};
      for (const glm::dvec3& p : mesh.points) centre += p / double(mesh.points.size());
      PictureSettings s;
      s.width = 320, s.height = 240;
      s.shading = method;
      PictureCache plain{scene};
      plain.make(s);
      const glm::dvec3 eye = plain.last().camera().eye;
      scene.light.lights = {{.kind = LightKind::Spot,
                             .Ip = glm::dvec3{0.7},
                             .direction = centre - eye,
                             .position = eye,
                             .inner = 3,
                             .outer = 6}};
      PictureCache pictures{scene};
      pictures.make(s);
      const std::vector<std::uint32_t> ids = pictures.last().faceImage();
      const int polygons = pictures.last().snapped().polygons;
      s.adapt = 0.05;
      const IndexImage image = painted(pictures, s);
      EXPECT_EQ(pictures.last().faceImage(), ids);
      EXPECT_EQ(exactnessOf(pictures.last()).wrong, 0);
      samples += exactnessOf(pictures.last()).samples;
      divided += pictures.last().snapped().polygons > polygons;
      s.order = Order::Oracle;
      EXPECT_EQ(painted(pictures, s), image);
    }
  EXPECT_EQ(divided, 8);
  EXPECT_GT(samples, 100'000);
}

}  // namespace

}  // namespace xnewell::THIS_FILE
