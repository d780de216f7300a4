#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>
#include <set>
#include <string>

#include "depthsort/oracle.h"
#include "geometry/exact/scale.h"
#include "shading/color/color_table.h"
#include "shading/explain/explain.h"
#include "shading/explain/pixel_history.h"
#include "shading/explain/scanline_run.h"
#include "shading/explain/viewing_story.h"
#include "shading/light/equation.h"
#include "shading/picture/picture_cache.h"
#include "tests/support/extended.h"
#include "tests/support/model_view.h"
#include "tests/support/seeds.h"
#include "tests/support/small_picture.h"

namespace xnewell::THIS_FILE {

namespace {

/// ---- By hand

// Values computed by hand from the papers that the program follows. The numbers below are theirs, or follow
// from theirs in a line of arithmetic that stands beside them.
//   assignment: "Implementing shading", the handout for the teapot: Ia, Ip, ka, kd, color(I), I0 and r.
//   notes: lecture notes on the lighting equation: I = A kA + L kD cos(theta) + L kS [(2N(N.L) - L).V]^p.
//   tutorial: the demo coders' tutorial: c = ambient + cos x diffuse + (cos x)^n specular.

/// A square that faces the viewer, from z = 0.
Mesh card() {
  Mesh mesh;
  mesh.groupNames = {"card"};
  mesh.points = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  mesh.addFace(std::array{0, 1, 2, 3}, 0);
  return mesh;
}

/// N and V are (0, 0, 1) in its middle.
Picture squareLitFrom(const glm::dvec3& L, const Illumination& light, TableKind table) {
  PictureSettings s;
  s.width = s.height = 40;
  s.shading = Shading::Flat;
  s.camera.eye = glm::dvec3{0, 0, 20};
  s.camera.lookAt = glm::dvec3{0, 0, 0};
  s.camera.parallel = true;
  s.camera.height = 4.0;
  s.light = light;
  s.light.light = L;
  s.table.kind = table;
  return makePicture(makeScene("square", card(), UpAxis::Y), s, 8);
}

// The intensity in the middle, as it is explained. The cell of the explanation is the picture's.
double litFrom(const glm::dvec3& L, const Illumination& light, int cell,
               TableKind table = TableKind::Linear) {
  const Picture picture = squareLitFrom(L, light, table);
  const Explanation e = PixelExplainer{picture}(picture.seen(20, 21).faces[20], 20, 20);
  EXPECT_EQ(e.value[0], cell);
  EXPECT_EQ(picture.image().row(20)[20], cell);
  return e.intensity;
}
const glm::dvec3 kFacing{0, 0, 1}, kSlanted{std::sqrt(3.0), 0, 1}, kBehind{0, 0, -1};

// assignment: "set Ia = .5 and Ip = .5. Or possibly Ia = .2 and Ip = .8", "choose Ka and Kd to be near 1.
// Perhaps .9", "color(I) = round(11 + 239*I)". A polygon that faces the light has N.L = 1, so without a
// highlight I = 0.9 (Ia + Ip) = 0.9 in both, and color = round(11 + 215.1) = 226. At 60 degrees N.L = 0.5.
// "The cases Ia = 1 or Ip = 1 should look very different". Ia = 1: 0.9 from any side. Ip = 1: 0.9 N.L, and 0
// from behind.
TEST(ByHand, TheAssignmentsSquare) {
  const auto I = [](const glm::dvec3& L, double Ia, int cell) {
    return litFrom(L, {.Ia = Ia, .Ip = 1 - Ia, .ka = 0.9, .kd = 0.9, .ks = 0.0}, cell);
  };
  EXPECT_NEAR(I(kFacing, 0.5, 226), 0.9, 1e-12);
  EXPECT_NEAR(I(kFacing, 0.2, 226), 0.9, 1e-12);
  EXPECT_NEAR(I(kSlanted, 0.5, 172), 0.675, 1e-12);  // 0.45 + 0.5 0.9 0.5; 11 + 161.325
  EXPECT_NEAR(I(kSlanted, 0.2, 140), 0.54, 1e-12);   // 0.18 + 0.8 0.9 0.5; 11 + 129.06
  for (const glm::dvec3& L : {kFacing, kSlanted, kBehind}) EXPECT_NEAR(I(L, 1.0, 226), 0.9, 1e-12);
  EXPECT_NEAR(I(kFacing, 0.0, 226), 0.9, 1e-12);
  EXPECT_NEAR(I(kSlanted, 0.0, 119), 0.45, 1e-12);  // 11 + 107.55
  EXPECT_EQ(I(kBehind, 0.0, 11), 0.0);
}

// assignment: "I0 = .02", "r = (1./.02)**(1./239.)", "j = round(log (I/I0))", "setting color 11+i". For I =
// 0.54, log 27 / log r = 3.2958 / 0.016368 = 201.35, so cell 11 + 201; for I = 0.9 it is 232.56, cell 244.
TEST(ByHand, TheCorrectedTable) {
  const Illumination fifth{.Ia = 0.2, .Ip = 0.8, .ka = 0.9, .kd = 0.9, .ks = 0.0};
  (void)litFrom(kSlanted, fifth, 212, TableKind::Corrected);
  (void)litFrom(kFacing, fifth, 244, TableKind::Corrected);
}

// notes: R = 2P - L with P = N (N.L), "if it is negative, change it to 0". N = (0, 0, 1), L = (0.6, 0, 0.8):
// N.L = 0.8, P = (0, 0, 0.8), R = (-0.6, 0, 0.8). V = (0, 0, 1): cos(phi) = 0.8. With A = 51 of 255, L = 204
// of 255, kA = kD = 0.9, kS = 0.4, p = 2: 45.9 + 146.88 + 52.224 = 245.004 of 255.
TEST(ByHand, TheNotesReflection) {
  const EquationVectors at{{0, 0, 1}, {0.6, 0, 0.8}, {0, 0, 1}};
  const LightTerms terms =
      lightTerms(Mistake::None, 1.0, 204.0 / 255.0, {0.9, 0.9, 0.4, 2}, at, Form::Textbook);
  EXPECT_NEAR(terms.NdotL, 0.8, 1e-15);
  EXPECT_NEAR(terms.R.x, -0.6, 1e-15);
  EXPECT_NEAR(terms.R.z, 0.8, 1e-15);
  EXPECT_NEAR(terms.cosine, 0.8, 1e-15);
  EXPECT_NEAR(terms.diffuse, 146.88 / 255.0, 1e-15);
  EXPECT_NEAR(terms.specular, 52.224 / 255.0, 1e-15);
  const Illumination light{.Ia = 0.2, .Ip = 0.8, .ka = 0.9, .kd = 0.9, .ks = 0.4, .n = 2};
  EXPECT_NEAR(litFrom({0.6, 0, 0.8}, light, 241), 245.004 / 255.0, 1e-12);  // 11 + 229.63
  // The eye on the other side of N: R.V = -0.6 0.8 + 0.8 0.6 = 0, and beyond that it is changed to 0.
  const EquationVectors away{{0, 0, 1}, {0.6, 0, 0.8}, {1, 0, 0}};
  const LightTerms none = lightTerms(Mistake::None, 1.0, 0.8, {0.9, 0.9, 0.4, 2}, away, Form::Textbook);
  EXPECT_NEAR(none.cosine, -0.6, 1e-15);
  EXPECT_EQ(none.specular, 0.0);
}

// tutorial: "when the angle is over 90 degrees ... the color getting the value ambient". At 60 degrees with n
// = 3: 0.1 + 0.5 0.6 + 0.125 0.3 = 0.4375.
TEST(ByHand, TheTutorialsColor) {
  const Illumination light{
      .Ia = 0.25, .Ip = 0.75, .ka = 0.4, .kd = 0.8, .ks = 0.4, .n = 3, .form = Form::Tutorial};
  EXPECT_NEAR(litFrom(kSlanted, light, 116), 0.4375, 1e-12);             // 11 + 104.56
  EXPECT_NEAR(litFrom({std::sqrt(3.0), 0, -1}, light, 35), 0.1, 1e-12);  // 11 + 23.9
}

/// ---- The run of a scanline

struct Count {
  std::set<std::string_view> methods, scenes;
  int polygons = 0, samples = 0, shown = 0, differing = 0, byRows = 0, textured = 0;
};

/// Picture k takes the k-th row of each list.
Picture pictureOf(unsigned k, Count& count) {
  constexpr std::array kScenes{"teapot", "textured-cube", "pinwheel", "room", "colored-lights"};
  const char* const name = kScenes[k % kScenes.size()];
  PictureCache pictures{readScene(name, 3)};
  PictureSettings s = setUpOf(pictures.scene(), kSanitized ? 30 : 90, kSanitized ? 24 : 70);
  s.shading = kShadings[(k + 2 * (k / 5)) % kShadings.size()].id;
  s.polygons = k % 4 < 2 ? Polygons::Triangles : Polygons::Rows;
  s.mapping = k % 3 == 0 ? TextureMapping::Affine : TextureMapping::Perspective;
  s.table.kind = kTables[k % kTables.size()].id;
  s.interpolated = k % 7 == 3 ? Interpolated::Cell : Interpolated::Intensity;
  s.colors = ColorPlan::OneHue;
  count.methods.insert(rowOf(s.shading).name), count.scenes.insert(name);
  return pictures.make(s, 8);
}

/// Its value at the sample by Cramer's rule with 64 bits, from values and places at the corners.
Extended directly(const ScanPart& part, const std::vector<double>& v, int i, int j) {
  const auto x = [&](int k) { return Extended(part.outline[k].x) - (i + 0.5) * 65536; };
  const auto y = [&](int k) { return Extended(part.outline[k].y) - (j + 0.5) * 65536; };
  const auto area = [](Extended ax, Extended ay, Extended bx, Extended by) { return ax * by - bx * ay; };
  const Extended a = area(x(1), y(1), x(2), y(2)), b = area(x(2), y(2), x(0), y(0)),
                 c = area(x(0), y(0), x(1), y(1));
  return (a * v[0] + b * v[1] + c * v[2]) / (a + b + c);
}

// The run visits each sample of the polygon once, and its last value by steps is the cell that the picture
// has wherever the polygon shows: for every polygon of twenty pictures of all methods.
TEST(ScanlineRun, EndsInTheStoredCells) {
  Count count;
  for (unsigned k = 0; k < 20; ++k) {
    SCOPED_TRACE(k);
    const Picture picture = pictureOf(k, count);
    const PictureSettings& settings = picture.settings();
    const SeenRows seen = picture.seen(0, settings.height);
    std::vector<int> shows(picture.snapped().faces.size(), 0);
    for (const int face : seen.faces)
      if (face != kNothing) ++shows[static_cast<std::size_t>(face)];
    for (int face = 0; face < static_cast<int>(shows.size()); ++face) {
      const ScanlineRun run{picture, face};
      std::set<std::pair<int, int>> visited;
      int shown = 0;
      for (const ScanSample& sample : run.samples()) {
        const int j = run.spanOf(sample).row;
        ASSERT_TRUE(visited.insert({sample.column, j}).second);
        if (seen.faces[std::size_t(j) * settings.width + sample.column] != face) continue;
        ++shown;
        ASSERT_EQ(sample.steppedCell, picture.image().row(j)[sample.column])
            << face << ": " << sample.column << ", " << j;
      }
      ASSERT_EQ(shown, shows[static_cast<std::size_t>(face)]) << face;
      ++count.polygons, count.samples += run.steps(), count.shown += shown,
          count.differing += run.differing();
      count.byRows += run.stepsValues() && run.parts().front().outline.size() > 3;
      count.textured += run.isTextured();
    }
  }
  EXPECT_EQ(count.methods.size(), kShadings.size());
  EXPECT_EQ(count.scenes.size(), 5u);
  if (kSanitized) return;
  EXPECT_GT(count.polygons, 1'000);
  EXPECT_GT(count.shown, 30'000);
  EXPECT_GT(count.byRows, 10);
  EXPECT_GT(count.textured, 5);
  EXPECT_LT(count.differing, count.samples / 500) << "24 bits hardly ever change a cell";
}

// The drift that the run states is that of a second computation with 64 bits. It stays within the bound of
// affine.h, and with fewer bits it grows.
TEST(ScanlineRun, DriftsAsASecondComputation) {
  PictureCache pictures{readScene("teapot", 4)};
  PictureSettings s = setUpOf(pictures.scene(), 200, 150);
  s.shading = Shading::Gouraud;
  const Picture picture = pictures.make(s, 8);
  int samples = 0, differing = 0;
  for (int face = 0; face < static_cast<int>(picture.snapped().faces.size()); face += kSanitized ? 40 : 5) {
    for (const int bits : {8, 16, 24}) {
      const ScanlineRun run{picture, face, bits};
      double largest = 0;
      for (const ScanSample& sample : run.samples()) {
        const int j = run.spanOf(sample).row;
        const auto part = static_cast<std::size_t>(sample.part);
        const SteppedPlane& plane = run.plane(sample.part);
        // By additions, from the sample of the first row and column of the part.
        const ScanSpan& first = run.parts()[part].spans.front();
        std::int64_t steps = plane.at(first.from, first.row);
        for (int row = first.row; row < j; ++row) steps += plane.perRow;
        for (int i = first.from; i < sample.column; ++i) steps += plane.perColumn;
        for (int i = sample.column; i < first.from; ++i) steps -= plane.perColumn;
        const double stepped = static_cast<double>(steps) * std::ldexp(1.0, -bits);
        ASSERT_EQ(stepped, sample.stepped);
        const Extended direct =
            directly(run.parts()[part], run.quantities(sample.part).back().atVertex, sample.column, j);
        ASSERT_NEAR(static_cast<double>(direct), sample.direct, 1e-11);
        largest = std::max(largest, std::abs(static_cast<double>(stepped - direct)));
        ++samples;
      }
      ASSERT_NEAR(run.mostDrift(), largest, 1e-11);
      if (bits == 8) differing += run.differing();
      // The bound of affine.h: half a step a pixel along both sides of the box, and one step.
      double bound = 1;
      for (const ScanPart& part : run.parts()) {
        const auto [left, right] = std::ranges::minmax(part.outline, {}, &glm::ivec3::x);
        const auto [top, bottom] = std::ranges::minmax(part.outline, {}, &glm::ivec3::y);
        bound = std::max(bound, 1 + (0.5 + 0x1p-7) * (right.x - left.x + bottom.y - top.y) / 65536.0);
      }
      ASSERT_LE(run.mostDrift(), bound * std::ldexp(1.0, -bits) + 1e-11);
    }
  }
  EXPECT_GT(samples, kSanitized ? 500 : 5'000);
  EXPECT_GT(differing, kSanitized ? 0 : 20) << "eight bits change cells";
}

/// ---- The story of the viewing transformation

FaceCorner randomCorner(const Mesh& mesh, std::mt19937& rng) {
  const int face = static_cast<int>(rng() % static_cast<unsigned>(mesh.faceCount()));
  return {face, static_cast<int>(rng() % mesh.face(face).size())};
}

glm::dvec3 dividedAt(const ViewingStory& story, ViewStage stage, const glm::dvec3& place) {
  const glm::dvec4 h = story.stages.at(stage, place);
  return glm::dvec3{h} / h.w;
}

/// The card, lit along L.
Picture cardLitFrom(const glm::dvec3& L, const CameraSettings& camera, double Ia = 0.0, double Ip = 1.0) {
  PictureSettings s;
  s.width = s.height = 64;
  s.shading = Shading::Flat;
  s.camera = camera;
  s.light.light = L, s.light.Ia = Ia, s.light.Ip = Ip;
  s.light.kd = 1.0, s.light.ks = 0.0;
  return makePicture(makeScene("card", card(), UpAxis::Y), s, 8);
}

/// The eye is 4 in front of the card and 4 to the left of the middle of its window.
CameraSettings offAxis() {
  CameraSettings c;
  c.vrp = glm::dvec3{0, 0, 0}, c.vpn = glm::dvec3{0, 0, 1}, c.vup = glm::dvec3{0, 1, 0};
  c.prp = glm::dvec3{-4, 0, 4};
  c.window = glm::dvec4{-2, 2, -2, 2};
  c.front = 1.0, c.back = -1.0;
  return c;
}

// The stages end in the vertex that the picture has, for every kind of view and every vertex that it shows.
TEST(ViewingStory, EndsInThePicturesOwnVertex) {
  int compared = 0;
  for (const char* name : {"teapot", "cubes", "room", "tori"}) {
    const Scene scene = readScene(name);
    PictureCache pictures{scene};
    const Seeds seeds{40};
    for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
      SCOPED_TRACE(std::string{name} + ", seed " + std::to_string(seed));
      const Picture picture = pictures.make(randomView(scene, seed, 320, 240), 8);
      std::mt19937 rng{seed};
      for (int k = 0; k < 30; ++k) {
        const ViewingStory story{picture, randomCorner(scene.mesh, rng)};
        EXPECT_TRUE(story.agrees) << textOf(story.vertex);
        compared += story.ofPicture;
      }
    }
  }
  if (!Seeds{40}.all()) return;
  EXPECT_GT(compared, 300);
}

// N.L and I of a stage by a second way: N from where two steps along the plane go, L and V from where small
// steps along them go, and the textbook's equation with these.
TEST(ViewingStory, HasTheEquationWithCarriedVectors) {
  constexpr double kStep = 1e-6;
  const Scene scene = readScene("teapot");
  PictureCache pictures{scene};
  int compared = 0, differ = 0;
  const Seeds seeds{60};
  for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
    SCOPED_TRACE(seed);
    const Picture picture = pictures.make(randomView(scene, seed, 320, 240), 8);
    std::mt19937 rng{seed};
    const ViewingStory story{picture, randomCorner(scene.mesh, rng)};
    if (story.outside != 0 || !story.ofPicture) continue;
    const Illumination& light = picture.settings().light;
    const glm::dvec3 P = story.place, N = story.world().N, L = unit(light.light);
    const glm::dvec3 V = unit(picture.camera().eye - P);
    const glm::dvec3 along =
        unit(glm::cross(N, std::abs(N.x) < 0.5 ? glm::dvec3{1, 0, 0} : glm::dvec3{0, 1, 0}));
    const glm::dvec3 across = glm::cross(N, along);
    for (const ViewStageRow& row : kViewStages) {
      const auto goes = [&](const glm::dvec3& d) {
        return unit(dividedAt(story, row.id, P + kStep * d) - dividedAt(story, row.id, P - kStep * d));
      };
      glm::dvec3 there = unit(glm::cross(goes(along), goes(across)));
      if (glm::dot(there, goes(N)) < 0.0) there = -there;  // the viewport mirrors
      const Reflection surface{.ka = light.ka, .kd = light.kd, .ks = light.ks, .n = light.n};
      const double NdotL = glm::dot(there, goes(L));
      const double cosine = specularCosine(Form::Textbook, there, goes(L), goes(V));
      const double I = termsOf(light.Ia, light.Ip, 1, 1, surface, NdotL, cosine).I;
      EXPECT_NEAR(*story.of(row.id).NdotL, NdotL, 1e-6) << row.name;
      EXPECT_NEAR(story.of(row.id).I, I, 2e-5) << row.name;
      ++compared;
      differ += story.differsInNdotL(row.id);
    }
  }
  if (!seeds.all()) return;
  EXPECT_GT(compared, 100);
  EXPECT_GT(differ, 50);
}

// A plane that cuts the face is named; a face outside is gone; a vertex outside has no place on the grid.
TEST(ViewingStory, SaysWhatClippingDoes) {
  CameraSettings camera = offAxis();
  camera.vpn = glm::dvec3{1, 0, 1};  // the card now runs through the front plane
  camera.front = 0.5;
  const ViewingStory right{cardLitFrom({0, 0, 1}, camera), {0, 1}};  // (1, -1, 0): n is 0.7071
  EXPECT_EQ(right.cut, 1u);
  EXPECT_EQ(right.outside, 1u);
  EXPECT_EQ(clipPlaneName(0), "front");
  EXPECT_TRUE(right.stages.outside({0, 1e6, 0}) >> 4 & 1u);
  EXPECT_EQ(clipPlaneName(4), "top");
  EXPECT_FALSE(right.snapped);
  EXPECT_FALSE(right.faceGone);
  const ViewingStory left{cardLitFrom({0, 0, 1}, camera), {0, 0}};
  EXPECT_EQ(left.cut, 1u);
  EXPECT_EQ(left.outside, 0u);
  EXPECT_TRUE(left.snapped && left.ofPicture && left.agrees);
  camera.front = -0.8, camera.back = -0.9;
  EXPECT_TRUE(ViewingStory(cardLitFrom({0, 0, 1}, camera), {0, 1}).faceGone);
}

// Where all light is ambient no N and no L is asked for, and I is the same at every stage.
TEST(ViewingStory, AmbientLightKnowsNoAngles) {
  const ViewingStory story{cardLitFrom({0, 0, 1}, offAxis(), 0.5, 0.0), {0, 0}};
  for (const ViewStageRow& row : kViewStages) {
    EXPECT_FALSE(story.of(row.id).NdotL) << row.name;
    EXPECT_EQ(story.of(row.id).I, story.world().I) << row.name;
    EXPECT_FALSE(story.differsInI(row.id)) << row.name;
  }
}

// A method that uses no light has the same story: the light on the vertex is that of flat shading.
TEST(ViewingStory, EveryMethodHasTheLightOfTheWorld) {
  PictureCache pictures{readScene("hues")};
  PictureSettings s = pictures.scene().settings;
  s.width = s.height = 64;
  s.colors = ColorPlan::Chosen;
  for (const ShadingRow& method : kShadings) {
    SCOPED_TRACE(method.name);
    s.shading = Shading::Flat;
    const ViewingStory flat{pictures.make(s), {0, 0}};
    s.shading = method.id;
    const ViewingStory story{pictures.make(s), {0, 0}};
    EXPECT_GT(flat.world().I, 0.0);
    for (const ViewStageRow& row : kViewStages) {
      EXPECT_EQ(story.of(row.id).NdotL, flat.of(row.id).NdotL) << row.name;
      EXPECT_EQ(story.of(row.id).I, flat.of(row.id).I) << row.name;
    }
  }
}

// Corners are named by face and corner, from 1, or by the vertex; what the mesh does not have is refused.
TEST(ViewingStory, ReadsTheNamesOfVertices) {
  const Scene scene = readScene("cubes");
  const Mesh& mesh = scene.mesh;
  for (int face = 0; face < mesh.faceCount(); ++face)
    for (int k = 0; k < static_cast<int>(mesh.face(face).size()); ++k) {
      const FaceCorner vertex{face, k};
      EXPECT_EQ(cornerOf(mesh, textOf(vertex)), vertex);
      const std::optional<FaceCorner> byPoint = cornerOf(mesh, std::to_string(mesh.face(face)[k]));
      ASSERT_TRUE(byPoint);
      EXPECT_EQ(mesh.face(byPoint->face)[byPoint->corner], mesh.face(face)[k]);
      EXPECT_LE(byPoint->face, face);
    }
  const std::string faces = std::to_string(mesh.faceCount());
  for (const std::string& wrong :
       {std::string{""}, std::string{"x"}, std::string{"1."}, std::string{"0.0"}, std::string{"0.9"},
        faces + ".1", std::string{"-1"}, std::string{"999999"}, std::string{"1.1.1"}})
    EXPECT_FALSE(cornerOf(mesh, wrong)) << wrong;
}

// The first vertex is near the middle, on what shows there.
TEST(ViewingStory, BeginsInTheMiddle) {
  for (const char* name : {"teapot", "cubes", "tori"}) {
    const Picture picture = makePicture(readScene(name), PictureSettings{}, 8);
    const FaceCorner vertex = middleCorner(picture);
    const ViewingStory story{picture, vertex};
    const glm::dvec4 at = story.of(ViewStage::Viewport).at;
    EXPECT_LT(std::abs(at.x - picture.settings().width / 2.0), picture.settings().width / 4.0) << name;
    EXPECT_LT(std::abs(at.y - picture.settings().height / 2.0), picture.settings().height / 4.0) << name;
  }
}

}  // namespace

}  // namespace xnewell::THIS_FILE
