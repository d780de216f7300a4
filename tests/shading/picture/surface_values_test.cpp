#include "shading/picture/surface_values.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "depthsort/oracle.h"
#include "geometry/model/solids.h"
#include "shading/picture/picture_cache.h"

namespace xnewell {

namespace {

PictureSettings small(Shading shading) {
  PictureSettings s;
  s.width = 160;
  s.height = 120;
  s.shading = shading;
  return s;
}

/// The place of a sample in one of the triangles of a face, as shares of its corners.
struct Place {
  std::array<int, 3> corner;
  std::array<double, 3> share;
};

/// By areas, in doubles; the triangle is the one whose smallest share is largest. Nothing is clipped.
Place placeIn(const SnappedScene& scene, const SnappedFace& face, int i, int j) {
  Place best{{}, {-1e300, -1e300, -1e300}};
  const glm::dvec2 p{(i + 0.5) * kGrid, (j + 0.5) * kGrid};
  forEachTriangle(scene, face, [&](const FaceTriangle& t) {
    const auto area = [](glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
      return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    };
    std::array<glm::dvec2, 3> v;
    for (int k = 0; k < 3; ++k) v[k] = {t.p[k].x, t.p[k].y};
    const double whole = area(v[0], v[1], v[2]);
    const Place place{
        {scene.source[t.vertex[0]], scene.source[t.vertex[1]], scene.source[t.vertex[2]]},
        {area(p, v[1], v[2]) / whole, area(v[0], p, v[2]) / whole, area(v[0], v[1], p) / whole}};
    if (std::ranges::min(place.share) > std::ranges::min(best.share)) best = place;
  });
  return best;
}

/// The equation as the book has it, for one distant light, both constant.
double equation(const Illumination& user, glm::dvec3 N, glm::dvec3 L, glm::dvec3 V) {
  const double NL = dot(N, L), RV = dot(2.0 * N * NL - L, V);
  const double lit = NL > 0 ? user.kd * NL + user.ks * std::pow(std::max(0.0, RV), user.n) : 0.0;
  return std::min(1.0, user.ka * user.Ia + user.Ip * lit);
}

}  // namespace

// At every sample the value is that of the illumination equation. Flat shading uses the face's normal.
// Gouraud shading takes the mean of the vertices' values, weighted by their shares. Phong shading makes the
// weighted mean of the normals a unit vector. Shares are those on the surface or, as in the first programs,
// on the screen.
TEST(SurfaceValues, AreTheEquationAtEverySample) {
  struct Case {
    Shading shading;
    TextureMapping mapping;
  };
  for (const auto& [shading, mapping] :
       {Case{Shading::Flat, {}}, Case{Shading::Gouraud, {}},
        Case{Shading::Phong, TextureMapping::Perspective}, Case{Shading::Phong, TextureMapping::Affine}}) {
    SCOPED_TRACE(rowOf(shading).name);
    PictureCache ball{makeScene("ball", sphere(18, 9), UpAxis::Z)};
    PictureSettings s = small(shading);
    s.light.constantV = true;
    s.mapping = mapping;
    s.camera.fov = 70;
    ball.make(s);
    const glm::dvec3 L = normalize(s.light.light),
                     V = normalize(ball.last().camera().eye - ball.last().camera().lookAt);
    const SeenRows seen = ball.last().seen(0, s.height);
    const std::vector<double> I = ball.last().intensities(seen);
    const std::vector<glm::dvec3> N = ball.last().normals(seen);
    PictureCache corners{makeScene("ball", sphere(18, 9), UpAxis::Z)};
    corners.make(small(Shading::Phong));
    const Vertices& vertices = corners.last().shading().vertices();
    double lowest = 1, highest = 0;
    int samples = 0;
    for (int j = 0; j < s.height; ++j)
      for (int i = 0; i < s.width; ++i) {
        const std::size_t k = std::size_t(j) * s.width + i;
        ASSERT_EQ(std::isnan(I[k]), seen.faces[k] == kNothing);
        if (seen.faces[k] == kNothing) continue;
        const SnappedFace& face = ball.last().snapped().faces[seen.faces[k]];
        const Place place = placeIn(ball.last().snapped(), face, i, j);
        double mean = 0;
        glm::dvec3 normal{0};
        for (int c = 0; c < 3; ++c) {
          const glm::dvec3 corner = vertices.vertices[vertices.ofCorner[place.corner[c]]].N;
          mean += place.share[c] * equation(s.light, corner, L, V);
          const glm::dvec3& at = ball.scene().mesh.points[ball.scene().mesh.corners[place.corner[c]]];
          const bool onSurface = shading == Shading::Phong && mapping == TextureMapping::Perspective;
          normal += place.share[c] / (onSurface ? dot(ball.last().camera().eye - at, V) : 1.0) * corner;
        }
        if (shading == Shading::Flat) normal = ball.last().shading().points().N[face.number];
        normal = normalize(normal);
        const double expected = shading == Shading::Gouraud ? mean : equation(s.light, normal, L, V);
        ASSERT_NEAR(I[k], expected, 1e-9) << i << ", " << j;
        ASSERT_NEAR(distance(N[k], normal), 0, 1e-9);
        lowest = std::min(lowest, I[k]), highest = std::max(highest, I[k]), ++samples;
      }
    EXPECT_GT(samples, 5000);
    EXPECT_LT(lowest, 0.2);
    EXPECT_GT(highest, 0.8);
  }
}

// A picture shows the shade nearest to the value: fixed point and single precision add a small part of a
// shade. A place in an environment may be off by one where a normal lies between two.
TEST(SurfaceValues, ArePaintedToHalfAShade) {
  for (const ShadingRow& row : kShadings)
    for (const Polygons polygons : {Polygons::Triangles, Polygons::Rows}) {
      SCOPED_TRACE(row.name);
      PictureCache teapot{readScene("teapot", 3)};
      PictureSettings s = small(row.id);
      s.polygons = polygons;
      const IndexImage image = teapot.make(s, 8).image();
      const SeenRows seen = teapot.last().seen(0, s.height);
      const std::vector<double> I = teapot.last().intensities(seen);
      const ColorTable& table = teapot.last().table();
      int samples = 0, off = 0;
      for (std::size_t k = 0; k < I.size(); ++k) {
        if (seen.faces[k] == kNothing) continue;
        ++samples;
        const double shades = image.pixels[k] - table.first() - (table.shades() - 1) * I[k];
        off += std::abs(shades) > 0.51;
      }
      EXPECT_GT(samples, 5000);
      EXPECT_LE(off, row.id == Shading::Environment ? samples / 500 : 0);
    }
}

// Any rows have the values of the whole picture there, and pieces have the values of their faces: the depth
// sort's picture equals the oracle's.
TEST(SurfaceValues, DependOnTheSampleAlone) {
  PictureCache split{readScene("penetrate")}, whole{readScene("penetrate")};
  for (const ShadingRow& row : kShadings) {
    SCOPED_TRACE(row.name);
    PictureSettings s = small(row.id);
    s.camera = inSceneUnits(completed({}, split.scene().camera), split.scene());
    split.make(s);
    s.order = Order::Oracle;
    whole.make(s);
    ASSERT_GT(split.last().sorted().statistics.splits, 0);
    const auto same = [](const std::vector<double>& a, const std::vector<double>& b) {
      return std::ranges::equal(a, b, [](double x, double y) { return x == y || (x != x && y != y); });
    };
    const std::vector<double> all = whole.last().intensities(whole.last().seen(0, s.height));
    EXPECT_GT(std::ranges::count_if(all, [](double v) { return v > 0; }), 1000);
    EXPECT_TRUE(same(split.last().intensities(split.last().seen(0, s.height)), all));
    EXPECT_EQ(split.last().normals(split.last().seen(0, s.height)),
              whole.last().normals(whole.last().seen(0, s.height)));
    for (const int j : {0, 59, 119})
      EXPECT_TRUE(same(split.last().intensities(split.last().seen(j, j + 1)),
                       {all.begin() + j * s.width, all.begin() + (j + 1) * s.width}));
  }
}

}  // namespace xnewell
