#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

#include "depthsort/oracle.h"
#include "geometry/model/solids.h"
#include "shading/fill/intensities.h"
#include "shading/picture/picture_cache.h"
#include "shading/picture/required.h"
#include "shading/picture/surface_evaluator.h"
#include "shading/scene/scene_file.h"
#include "shading/scene/units.h"
#include "shading/trade/measure.h"
#include "tests/support/model_view.h"

namespace xnewell::THIS_FILE {

namespace {

/// ---- Values of a surface

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

// Any rows have the values of the whole picture there, and pieces have the values and the cells of their
// faces: the depth sort's picture equals the oracle's, with every method. In flat shading the cell is that of
// the face's stored intensity.
TEST(SurfaceValues, DependOnTheSampleAlone) {
  for (const char* const name : {"penetrate", "cycle", "pinwheels", "tori"}) {
    PictureCache split{readScene(name)}, whole{split.scene()};
    std::int64_t splits = 0, lit = 0;
    for (unsigned k = 0; k < 4 * kShadings.size(); ++k) {
      const ShadingRow& row = kShadings[k / 4];
      SCOPED_TRACE(testing::Message() << name << ' ' << row.name << ' ' << k % 4);
      PictureSettings s = randomView(split.scene(), k % 4, 160, 120);
      s.shading = row.id;
      const Picture sorted = split.make(s, 0);
      s.order = Order::Oracle;
      const Picture oracle = whole.make(s, 0);
      splits += sorted.sorted().statistics.splits;
      EXPECT_EQ(sorted.image(), oracle.image());
      const auto same = [](const std::vector<double>& a, const std::vector<double>& b) {
        return std::ranges::equal(a, b, [](double x, double y) { return x == y || (x != x && y != y); });
      };
      const SeenRows seen = oracle.seen(0, s.height);
      const std::vector<double> all = oracle.intensities(seen);
      lit += std::ranges::count_if(all, [](double v) { return v > 0; });
      EXPECT_TRUE(same(sorted.intensities(sorted.seen(0, s.height)), all));
      EXPECT_EQ(sorted.normals(sorted.seen(0, s.height)), oracle.normals(seen));
      for (std::size_t at = 0; at < all.size() && row.id == Shading::Flat; ++at) {
        if (seen.faces[at] == kNothing) continue;
        const SnappedFace& f = oracle.snapped().faces[seen.faces[at]];
        const double I = oracle.shading().intensities(0).I[f.number].seen(f.back);
        ASSERT_EQ(sorted.image().pixels[at], oracle.table().cell(I));
      }
      for (const int j : {0, 59, 119})
        EXPECT_TRUE(same(sorted.intensities(sorted.seen(j, j + 1)),
                         {all.begin() + j * s.width, all.begin() + (j + 1) * s.width}));
    }
    EXPECT_GT(splits, 0) << name;
    EXPECT_GT(lit, 24'000) << name;
  }
}

/// ---- What a picture requires

/// A ball and a card of two materials, one of them unused, and a light.
std::string scene(const std::string& light, const std::string& used = "") {
  return R"({"up": "z", "ambient": 0.1, "lights": [)" + light + R"(],
    "materials": {"unused": {"ks": 0.5}, "used": {)" +
         used + R"(}},
    "objects": [{"solid": "sphere", "material": "used"}]})";
}

constexpr std::string_view kSun = R"({"Ip": 0.8, "towards": [0, -1, 1]})";

std::map<std::string_view, Required> requiredOf(const std::string& text, PictureSettings s = {}) {
  s.width = 40, s.height = 30;
  if (s.shading == Shading::Flat) s.shading = Shading::Gouraud;
  std::map<std::string_view, Required> byName;
  for (Required& r : requiredBy(makePicture(parseSceneFile(text, "scene", XNEWELL_DATA_DIR), s))) {
    EXPECT_FALSE(r.why.empty()) << r.name;
    byName.emplace(r.name, std::move(r));
  }
  return byName;
}

bool needs(const std::map<std::string_view, Required>& required, std::string_view name) {
  return std::get<bool>(required.at(name).what);
}
std::int64_t count(const std::map<std::string_view, Required>& required, std::string_view name) {
  return std::get<std::int64_t>(required.at(name).what);
}

// A highlight is needed if a surface that shows one is lit. A material that no face has does not count, and
// neither does the user's ks if all surfaces have their own.
TEST(Required, HighlightsOfSurfacesInUse) {
  PictureSettings user;
  user.light.ks = 0.4;
  const std::string sun{kSun};
  auto required = requiredOf(scene(sun, R"("ks": 0.3)"), user);
  EXPECT_TRUE(needs(required, "specular") && needs(required, "eye") && needs(required, "places"));
  EXPECT_EQ(required.at("specular").why,
            "a surface has ks above 0, and a light of its colour reaches the scene");
  required = requiredOf(scene(sun, R"("ks": 0)"), user);
  EXPECT_FALSE(needs(required, "specular") || needs(required, "eye") || needs(required, "places"));
  EXPECT_EQ(required.at("specular").why, "no surface has ks above 0");
  EXPECT_EQ(required.at("eye").why, "nothing has a highlight");
  EXPECT_EQ(count(required, "lights"), 1);
  // A highlight without a colour that the light has is none.
  required = requiredOf(scene(R"({"color": [0.5, 0, 0]})", R"("ks": 0.5, "specular": [0, 1, 1])"), user);
  EXPECT_FALSE(needs(required, "specular"));
  EXPECT_EQ(required.at("specular").why,
            "a surface has ks above 0, but no light of its colour reaches the scene");
}

// With n = 0 a highlight is as bright from everywhere. So it asks neither for the eye nor, under a light far
// away, for places; and another eye changes no intensity.
TEST(Required, NoEyeWhereNIsZero) {
  const std::string sun{kSun};
  for (const int n : {0, 1}) {
    const std::string text = scene(sun, R"("ks": 0.3, "n": )" + std::to_string(n));
    const auto required = requiredOf(text);
    EXPECT_TRUE(needs(required, "specular"));
    EXPECT_EQ(needs(required, "eye"), n > 0);
    EXPECT_EQ(needs(required, "places"), n > 0);
    const Scene ball = parseSceneFile(text, "scene", XNEWELL_DATA_DIR);
    const auto intensities = [&](const glm::dvec3& eye) {
      const Lighting lighting = resolve(ball.mesh, ball.light, {}, Channels::Luminance, eye, {0, 0, 0});
      Terms specular;
      specularIntensities(specular, facePoints(ball.mesh), lighting, 0);
      std::vector<double> front;
      for (const FrontBack<double>& I : specular) front.push_back(I.front);
      return front;
    };
    EXPECT_EQ(intensities({0, -4, 1}) == intensities({3, 2, 5}), n == 0);
  }
  EXPECT_EQ(requiredOf(scene(sun, R"("ks": 0.3, "n": 0)")).at("eye").why,
            "n is 0: a highlight is the same from everywhere");
}

// A large scene keeps no terms that nothing asks for. Its light is computed part by part, and is the same.
TEST(Required, ALargeSceneIsLitInParts) {
  const std::string torus = R"({"lights": [)" + std::string{kSun} +
                            R"(], "objects": [{"solid": "torus", "around": 500, "across": 300}]})";
  PictureSettings s;
  s.width = 8, s.height = 6, s.shading = Shading::Flat, s.light.ks = 0.9;
  const Picture picture = makePicture(parseSceneFile(torus, "scene", XNEWELL_DATA_DIR), s);
  const SceneShading& shading = picture.shading();
  EXPECT_TRUE(shading.diffuse(0).empty() && shading.specular(0).empty());
  Terms diffuse, specular;
  Intensities whole;
  diffuseIntensities(diffuse, shading.points(), shading.lighting(), 0);
  specularIntensities(specular, shading.points(), shading.lighting(), 0);
  addTerms(whole, diffuse, specular, shading.points(), shading.lighting(), 0);
  const Intensities& parts = shading.intensities(0);
  ASSERT_EQ(parts.I.size(), 150'000u);
  EXPECT_EQ(parts.clamped, whole.clamped);
  EXPECT_GT(whole.clamped, 0);
  for (std::size_t k = 0; k < whole.I.size(); ++k)
    ASSERT_TRUE(parts.I[k].front == whole.I[k].front && parts.I[k].back == whole.I[k].back) << k;
}

// A light that no surface reflects is not needed.
TEST(Required, LightsThatAreReflected) {
  const std::string sun{kSun};
  auto required = requiredOf(scene(sun, R"("kd": 0, "ks": 0)"));
  EXPECT_EQ(count(required, "lights"), 0);
  EXPECT_FALSE(needs(required, "places"));
  required = requiredOf(scene(sun, R"("kd": 0, "ks": 0.1)"));
  EXPECT_EQ(count(required, "lights"), 1);
  required = requiredOf(
      scene(R"({"color": [0.5, 0, 0]}, {"color": [0, 0, 0.4]})", R"("color": [0, 0, 1], "ks": 0)"));
  EXPECT_EQ(count(required, "lights"), 1);  // red on blue
  EXPECT_NE(required.at("lights").why.find("1 of 2 does not count"), std::string::npos)
      << required.at("lights").why;
}

// A spot that shines away is not needed, and it makes no difference to the picture. One whose cone only
// touches the scene is needed.
TEST(Required, SpotsThatReachTheScene) {
  const auto spot = [](const std::string& shines, int outer) {
    return R"({"kind": "spot", "Ip": 0.8, "at": [0, 0, 4], "shines": )" + shines +
           R"(, "inner": 5, "outer": )" + std::to_string(outer) + "}";
  };
  EXPECT_EQ(count(requiredOf(scene(spot("[0, 0, -1]", 10))), "lights"), 1);
  EXPECT_EQ(count(requiredOf(scene(spot("[0, 0, 1]", 10))), "lights"), 0);
  EXPECT_FALSE(needs(requiredOf(scene(spot("[0, 0, 1]", 10))), "spots"));
  EXPECT_EQ(count(requiredOf(scene(spot("[0, 0, 1]", 180))), "lights"), 1);
  EXPECT_EQ(count(requiredOf(scene(spot("[1, 0, 0]", 60))), "lights"), 0);
  EXPECT_EQ(count(requiredOf(scene(spot("[1, 0, 0]", 80))), "lights"),
            1);  // the ball's edge is 14.5 degrees off
  // A spot that is left out lights no vertex: turned by a degree at a time, its light is either counted or
  // dark.
  int out = 0, in = 0;
  for (int degrees = 0; degrees < 180; degrees += 5) {
    const double a = degrees * 3.14159265358979 / 180;
    const std::string text =
        scene(spot("[" + std::to_string(std::sin(a)) + ", 0, " + std::to_string(-std::cos(a)) + "]", 20));
    const bool counted = count(requiredOf(text), "lights") == 1;
    ++(counted ? in : out);
    const Scene ball = parseSceneFile(text, "scene", XNEWELL_DATA_DIR);
    const Light& light = ball.light.lights.front();
    for (const glm::dvec3& p : ball.mesh.points) {
      const double along = glm::dot(glm::normalize(light.direction), glm::normalize(p - light.position));
      ASSERT_TRUE(counted || along <= std::cos(20 * 3.14159265358979 / 180)) << degrees;
    }
  }
  EXPECT_GT(out, 20);
  EXPECT_GT(in, 5);
}

// If nothing reflects a light, no normal is computed, at faces or at vertices.
TEST(Required, NormalsOnlyForLights) {
  const std::string sun{kSun};
  for (const Shading method : {Shading::Gouraud, Shading::Phong, Shading::Environment}) {
    PictureSettings s;
    s.shading = method;
    EXPECT_GT(count(requiredOf(scene(sun, R"("kd": 0.1, "ks": 0)"), s), "vertex_normals"), 0);
    const auto required = requiredOf(scene(sun, R"("kd": 0, "ks": 0)"), s);
    // A map is looked up by a normal, whatever it holds.
    EXPECT_EQ(count(required, "vertex_normals") > 0, method == Shading::Environment);
    EXPECT_EQ(count(required, "face_normals"), 0);
  }
  for (const auto& [kd, normals] : {std::pair{"0.1", 24 * 12}, {"0", 0}}) {
    const std::string text = scene(sun, R"("ks": 0, "kd": )" + std::string{kd});
    const std::vector<Required> all =
        requiredBy(makePicture(parseSceneFile(text, "scene", XNEWELL_DATA_DIR), small(Shading::Flat)));
    EXPECT_EQ(std::get<std::int64_t>(std::ranges::find(all, "face_normals", &Required::name)->what), normals);
  }
}

// What an item costs is measured by a picture that does not require it, or by the step alone. Each item has
// one of these, and no picture without an item requires it.
TEST(Required, EachItemCanBeTakenAway) {
  const std::string text = R"({"up": "z", "ambient": [0.1, 0.05, 0], "lights": [
      {"kind": "spot", "color": [0.5, 0.2, 0], "at": [0, 0, 4], "shines": [0, 0, -1], "inner": 5, "outer": 40,
       "attenuation": "inverse"}, {"color": [0, 0.2, 0.2], "towards": [0, -1, 1]}],
    "materials": {"shiny": {"ks": 0.5, "color": [1, 0.5, 0.5]}, "checks": {"texture": "textures/checks.png"}},
    "objects": [{"solid": "sphere", "material": "shiny"},
      {"polygons": [[[-1, -1, 2], [1, -1, 2], [1, 1, 2], [-1, 1, 2]]], "uv": [[[0, 0], [1, 0], [1, 1], [0, 1]]],
       "material": "checks"}]})";
  const Scene all = parseSceneFile(text, "scene", XNEWELL_DATA_DIR);
  const auto itemOf = [](const Scene& scene, const PictureSettings& s, std::string_view name) {
    const std::vector<Required> items = requiredBy(makePicture(scene, s));
    EXPECT_EQ(items.size(), itemRows().size());
    const auto item = std::ranges::find(items, name, &Required::name);
    return std::visit([](auto what) { return static_cast<std::int64_t>(what); }, item->what);
  };
  for (const ItemRow& row : itemRows()) {
    SCOPED_TRACE(row.name);
    ASSERT_NE(row.without == nullptr, row.alone == nullptr);
    Scene scene = all;
    PictureSettings s;
    s.width = 40, s.height = 30;
    s.shading = row.name == "face_normals" ? Shading::Flat : Shading::Phong;
    const bool ramps = row.name == "ramps";  // only white light has ramps of several hues
    if (ramps) {
      s.colors = ColorPlan::Hues;
      for (Light& light : scene.light.lights) light.Ip = glm::dvec3{0.4};
      scene.light.Ia = glm::dvec3{0.1};
    }
    const std::int64_t least = row.name == "channels" || ramps ? 1 : 0;
    EXPECT_TRUE(row.name == "cuts_of_concave_faces" || itemOf(scene, s, row.name) > least);
    if (row.alone != nullptr) {
      row.alone(makePicture(scene, s))();
      continue;
    }
    row.without(scene, s);
    EXPECT_EQ(itemOf(scene, s, row.name), least);
  }
}

// Each item says why, also for methods without light.
TEST(Required, SaysWhy) {
  PictureSettings s;
  s.shading = Shading::Depth;
  const auto required = requiredOf(scene(std::string{kSun}), s);
  EXPECT_FALSE(needs(required, "illumination"));
  EXPECT_EQ(required.at("specular").why, "depth shading uses no light");
}

}  // namespace

}  // namespace xnewell::THIS_FILE
