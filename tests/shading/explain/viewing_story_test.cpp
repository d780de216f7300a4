#include "shading/explain/viewing_story.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "geometry/exact/unit.h"
#include "shading/light/equation.h"
#include "shading/picture/picture_cache.h"
#include "tests/support/model_view.h"
#include "tests/support/seeds.h"

namespace xnewell::THIS_FILE {

namespace {

FaceCorner randomCorner(const Mesh& mesh, std::mt19937& rng) {
  const int face = static_cast<int>(rng() % static_cast<unsigned>(mesh.faceCount()));
  return {face, static_cast<int>(rng() % mesh.face(face).size())};
}

glm::dvec3 dividedAt(const ViewingStory& story, ViewStage stage, const glm::dvec3& place) {
  const glm::dvec4 h = story.stages.at(stage, place);
  return glm::dvec3{h} / h.w;
}

/// A card at z = 0 that faces the eye at (0, 0, 5), lit along L.
Picture cardLitFrom(const glm::dvec3& L, const CameraSettings& camera, double Ia = 0.0, double Ip = 1.0) {
  Mesh mesh;
  mesh.groupNames = {"card"};
  mesh.points = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  mesh.addFace(std::array{0, 1, 2, 3}, 0);
  PictureSettings s;
  s.width = s.height = 64;
  s.shading = Shading::Flat;
  s.camera = camera;
  s.light.light = L, s.light.Ia = Ia, s.light.Ip = Ip;
  s.light.kd = 1.0, s.light.ks = 0.0;
  return makePicture(makeScene("card", mesh, UpAxis::Y), s, 8);
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

}  // namespace

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

// By hand: the card's N is z, and the light is at 45 degrees to the left, so N.L is 0.7071. The eye is as far
// to the left as before the card: the shear x + z makes the line of sight stand straight. L = (-1, 0, 1) goes
// to (0, 0, 1), N stays: it is the plane's, which lies in z = 0. N.L becomes 1.
TEST(ViewingStory, TheShearByHand) {
  const ViewingStory story{cardLitFrom({-1, 0, 1}, offAxis()), {0, 2}};
  EXPECT_NEAR(*story.world().NdotL, std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(*story.of(ViewStage::Vrc).NdotL, std::sqrt(0.5), 1e-12);
  EXPECT_TRUE(story.of(ViewStage::Vrc).keepsAngles);
  EXPECT_NEAR(*story.of(ViewStage::Sheared).NdotL, 1.0, 1e-12);
  EXPECT_NEAR(story.of(ViewStage::Sheared).I, 1.0, 1e-12);
  EXPECT_FALSE(story.of(ViewStage::Sheared).keepsAngles);
  EXPECT_TRUE(story.differsInNdotL(ViewStage::Sheared));
  EXPECT_FALSE(story.differsInNdotL(ViewStage::Vrc));
  EXPECT_EQ(story.cut, 0u);
  EXPECT_EQ(story.at.size(), 7u);
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

}  // namespace xnewell::THIS_FILE
