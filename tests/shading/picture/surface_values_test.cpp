#include "shading/picture/surface_values.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "depthsort/oracle.h"
#include "geometry/model/solids.h"
#include "shading/picture/picture_cache.h"
#include "shading/scene/units.h"

namespace xnewell::THIS_FILE {

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
// on the screen. An unnormalized mean stays as short as it is, and its shares are those on the screen. A lamp
// near the ball has another L at each place.
TEST(SurfaceValues, AreTheEquationAtEverySample) {
  struct Case {
    Shading shading;
    TextureMapping mapping = {};
    bool unnormalized = false, lamp = false;
  };
  for (const auto& [shading, mapping, unnormalized, lamp] :
       {Case{Shading::Flat}, Case{Shading::Gouraud}, Case{Shading::Phong, TextureMapping::Perspective},
        Case{Shading::Phong, TextureMapping::Affine}, Case{.shading = Shading::Phong, .unnormalized = true},
        Case{.shading = Shading::Phong, .lamp = true},
        Case{.shading = Shading::Phong, .unnormalized = true, .lamp = true}}) {
    SCOPED_TRACE(testing::Message() << rowOf(shading).name << unnormalized << lamp);
    PictureCache ball{makeScene("ball", sphere(18, 9), UpAxis::Z)};
    PictureSettings s = small(shading);
    s.light.constantV = true;
    s.mapping = mapping;
    s.unnormalized = unnormalized;
    s.camera.fov = 70;
    const glm::dvec3 lampAt = 1.5 * s.light.light;
    if (lamp) s.light.lightPosition = inFileUnits(lampAt, ball.scene());
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
        double mean = 0, weights = 0;
        glm::dvec3 normal{0}, where{0};
        for (int c = 0; c < 3; ++c) {
          const glm::dvec3 corner = vertices.vertices[vertices.ofCorner[place.corner[c]]].N;
          mean += place.share[c] * equation(s.light, corner, L, V);
          const glm::dvec3& at = ball.scene().mesh.points[ball.scene().mesh.corners[place.corner[c]]];
          const double weight = place.share[c] / dot(ball.last().camera().eye - at, V);
          const bool onSurface =
              shading == Shading::Phong && mapping == TextureMapping::Perspective && !unnormalized;
          normal += (onSurface ? weight : place.share[c]) * corner;
          where += weight * at, weights += weight;
        }
        if (shading == Shading::Flat) normal = ball.last().shading().points().N[face.number];
        if (!unnormalized) normal = normalize(normal);
        const glm::dvec3 towards = lamp ? normalize(lampAt - where / weights) : L;
        const double expected = shading == Shading::Gouraud ? mean : equation(s.light, normal, towards, V);
        ASSERT_NEAR(I[k], expected, 1e-9) << i << ", " << j;
        ASSERT_NEAR(distance(N[k], normalize(normal)), 0, 1e-9);
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
  struct Case {
    Polygons polygons;
    bool unnormalized;
  };
  for (const ShadingRow& row : kShadings)
    for (const auto& [polygons, unnormalized] :
         {Case{Polygons::Triangles, false}, Case{Polygons::Rows, false}, Case{Polygons::Triangles, true}}) {
      SCOPED_TRACE(row.name);
      PictureCache teapot{readScene("teapot", 3)};
      PictureSettings s = small(row.id);
      s.polygons = polygons, s.unnormalized = unnormalized;
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

// Where cell numbers are interpolated, each pixel has the mean of the cells at the vertices, weighted by
// their shares and rounded. In a linear table that is within one cell of the interpolated intensity. In a
// corrected table it is another picture.
TEST(SurfaceValues, InterpolatedCellsAreMeansOfCells) {
  for (const TableKind kind : {TableKind::Linear, TableKind::Corrected}) {
    PictureSettings s = small(Shading::Gouraud);
    s.light.constantV = true;
    s.table.kind = kind, s.table.pick = Pick::Log;
    PictureCache ball{makeScene("ball", sphere(18, 9), UpAxis::Z)};
    const IndexImage intensities = ball.make(s, 3).image();
    s.interpolated = Interpolated::Cell;
    const Picture picture = ball.make(s, 3);
    const glm::dvec3 L = normalize(s.light.light),
                     V = normalize(picture.camera().eye - picture.camera().lookAt);
    const Vertices& vertices = picture.shading().vertices();
    // The cell of an intensity, and whether it is far from the next one; the brief's formulas.
    const auto cellOf = [&](double I, bool& sure) {
      const double j =
          kind == TableKind::Linear ? 239 * I : 239 * std::log(std::max(I, 0.02) / 0.02) / std::log(1 / 0.02);
      sure = sure && std::abs(j - std::floor(j) - 0.5) > 0.01;
      return 11 + std::round(j);
    };
    const SeenRows seen = picture.seen(0, s.height);
    int compared = 0, differ = 0, most = 0;
    for (std::size_t k = 0; k < seen.faces.size(); ++k) {
      if (seen.faces[k] == kNothing) continue;
      const Place place = placeIn(picture.snapped(), picture.snapped().faces[seen.faces[k]],
                                  static_cast<int>(k) % s.width, static_cast<int>(k) / s.width);
      double mean = 0;
      bool sure = true;
      for (int c = 0; c < 3; ++c)
        mean +=
            place.share[c] *
            cellOf(equation(s.light, vertices.vertices[vertices.ofCorner[place.corner[c]]].N, L, V), sure);
      const int cell = picture.image().pixels[k], apart = std::abs(cell - intensities.pixels[k]);
      differ += apart > 0, most = std::max(most, apart);
      if (!sure || std::abs(mean - std::floor(mean) - 0.5) < 1e-3) continue;
      ASSERT_EQ(cell, std::round(mean)) << k;
      ++compared;
    }
    EXPECT_GT(compared, 4000);
    EXPECT_GT(differ, 100);
    if (kind == TableKind::Linear)
      EXPECT_EQ(most, 1);
    else
      EXPECT_GT(most, 5);
  }
}

// A face keeps its cells where a front plane cuts it: the cells at the vertices that clipping makes are
// interpolated too.
TEST(SurfaceValues, InterpolatedCellsStayWhereFacesAreClipped) {
  PictureSettings s = small(Shading::Gouraud);
  s.table.kind = TableKind::Corrected, s.interpolated = Interpolated::Cell;
  s.camera.parallel = true, s.camera.height = 2.0;
  // Of triangles: a polygon with more corners has another fan when it is cut.
  const Mesh quads = sphere(18, 9);
  Mesh triangles;
  triangles.points = quads.points, triangles.groupNames = {""};
  for (int f = 0; f < quads.faceCount(); ++f)
    for (std::size_t c = 2; c < quads.face(f).size(); ++c)
      triangles.addFace(std::array{quads.face(f)[0], quads.face(f)[c - 1], quads.face(f)[c]}, 0);
  PictureCache ball{makeScene("ball", triangles, UpAxis::Z)};
  const Picture whole = ball.make(s, 3);
  s.camera.front = 0.3;
  const Picture cut = ball.make(s, 3);
  ASSERT_FALSE(cut.snapped().between.empty());
  const SeenRows before = whole.seen(0, s.height), after = cut.seen(0, s.height);
  int same = 0, off = 0;
  for (std::size_t k = 0; k < after.faces.size(); ++k) {
    if (after.faces[k] == kNothing || before.faces[k] == kNothing) continue;
    if (cut.snapped().faces[after.faces[k]].number != whole.snapped().faces[before.faces[k]].number) continue;
    ++same;
    off += std::abs(cut.image().pixels[k] - whole.image().pixels[k]) > 1;
  }
  EXPECT_GT(same, 1000);
  EXPECT_EQ(off, 0);
}

// Any rows have the values of the whole picture there, and pieces have the values of their faces: the depth
// sort's picture equals the oracle's.
TEST(SurfaceValues, DependOnTheSampleAlone) {
  PictureCache split{readScene("penetrate")}, whole{readScene("penetrate")};
  for (const ShadingRow& row : kShadings) {
    SCOPED_TRACE(row.name);
    PictureSettings s = small(row.id);
    s.camera = completed({}, split.scene().camera);
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

}  // namespace xnewell::THIS_FILE
