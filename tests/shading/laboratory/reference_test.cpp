#include "shading/laboratory/ground_truth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "depthsort/oracle.h"
#include "geometry/exact/scale.h"
#include "shading/picture/picture_cache.h"
#include "shading/scene/scene_file.h"
#include "shading/scene/settings.h"
#include "tests/support/brief_light.h"
#include "tests/support/seeds.h"

namespace xnewell::THIS_FILE {

namespace {

constexpr int kWidth = 48, kHeight = 36;

/// The scene in another place and of another size, with its lights and its camera: each coordinate of the
/// file becomes scale times it, plus shift.
Scene moved(const Scene& scene, double scale, double shift) {
  const auto file = [&](const glm::dvec3& p) { return scaled(p, scene.exponent); };
  const auto there = [&](const glm::dvec3& p) { return scale * p + glm::dvec3{shift, -shift, shift}; };
  Mesh mesh = scene.mesh;
  for (glm::dvec3& p : mesh.points) p = there(file(p));
  for (double& u : mesh.rounding)
    u = std::ldexp(u, scene.exponent) * scale + (shift != 0 ? std::abs(shift) * 0x1p-52 : 0.0);
  Scene result = makeScene(scene.name, std::move(mesh), scene.up, scene.divisions);
  result.settings = scene.settings;
  result.textures = scene.textures;
  result.light.Ia = scene.light.Ia;
  result.patches = scene.patches;
  for (PatchRun& run : result.patches)
    for (BezierPatch& patch : run.patches)
      for (glm::dvec3& p : patch.p) p = there(p);
  result.rounds = scene.rounds;
  for (RoundRun& run : result.rounds) run.axes *= scale, run.centre = there(run.centre);
  for (Light light : scene.light.lights) {
    light.position = scaled(there(file(light.position)), -result.exponent);
    const double grown = scale * std::ldexp(1.0, scene.exponent - result.exponent);
    light.range *= grown;
    light.c = {light.c.x, light.c.y / grown, light.c.z / (grown * grown)};
    result.light.lights.push_back(light);
  }
  result.camera = scene.camera;
  for (std::optional<glm::dvec3>* p : {&result.camera.eye, &result.camera.lookAt, &result.camera.vrp})
    if (*p) *p = there(**p);
  for (std::optional<double>* d : {&result.camera.height, &result.camera.front, &result.camera.back})
    if (*d) **d *= scale;
  if (result.camera.prp) *result.camera.prp *= scale;
  if (result.camera.window) *result.camera.window *= scale;
  return result;
}

PictureSettings settingsOf(const Scene& scene) {
  PictureSettings s = scene.settings;
  s.width = kWidth;
  s.height = kHeight;
  s.camera = completed({}, scene.camera);
  return s;
}

struct Agreement {
  int compared = 0, unsure = 0;   ///< samples that show a face
  int clear = 0, wrongFaces = 0;  ///< samples at which the ray clearly meets one part first, or none
  double largest = 0;             ///< error of an intensity
};

/// Compares the reference with the evaluation with 64 bits at every sample. Where the ray through a sample
/// clearly meets one part first, the reference must show it.
Agreement agreement(const Scene& scene, const PictureSettings& settings) {
  const Picture picture = makePicture(scene, settings);
  const Reference reference{picture};
  const BriefLight brief{scene, picture.camera(), settings.light, kWidth, kHeight};
  Agreement result;
  for (int j = 0; j < kHeight; ++j)
    for (int i = 0; i < kWidth; ++i) {
      const std::size_t k = std::size_t(j) * kWidth + i;
      const int face = reference.faces()[k];
      const int part = face == kNothing ? -1 : reference.picture().snapped().faces[face].part;
      bool clear = true;
      int sees = -2;
      for (const auto& [dx, dy] : {std::pair{0, 0}, {1, 1}, {1, -1}, {-1, 1}, {-1, -1}}) {
        const BriefLight::Seen s = brief.seen(i + 0.5 + dx * 0x1p-12, j + 0.5 + dy * 0x1p-12);
        clear = clear && (sees == -2 || s.part == sees) && s.gap > 1e-6;
        sees = s.part;
      }
      if (clear) ++result.clear, result.wrongFaces += sees != part;
      if (part < 0) continue;
      const BriefLight::Lit lit = brief.light(part, i, j);
      if (!lit.sure) {
        ++result.unsure;
        continue;
      }
      ++result.compared;
      const glm::dvec3 I = reference.I(k);
      using std::abs;  // and that of two doubles
      for (int c = 0; c < 3; ++c)
        result.largest = std::max(result.largest, static_cast<double>(abs(I[c] - lit.I[c])));
    }
  return result;
}

void expectAgreement(const Scene& scene, const PictureSettings& settings) {
  const Agreement a = agreement(scene, settings);
  EXPECT_LE(a.largest, 1e-12);
  EXPECT_GE(a.compared, 50);
  EXPECT_LE(a.unsure, a.compared / 10);
  EXPECT_EQ(a.wrongFaces, 0);
  EXPECT_GE(a.clear, kWidth * kHeight * 3 / 4);
}

/// A sphere and a torus of unequal axes, patches, a bent polygon, a concave one that turns its
/// back, and a texture.
constexpr std::string_view kEverything = R"({
  "up": "z", "camera": {"eye": [1, -9, 6], "look_at": [0, 0, 0.4], "fov": 36},
  "materials": {"checks": {"texture": "textures/checks.png"},
                "brass": {"color": [0.8, 0.6, 0.2], "specular": [1, 0.9, 0.6], "ka": 0.3, "kd": 0.6, "ks": 0.5, "n": 12}},
  "objects": [
    {"solid": "sphere", "around": 12, "down": 7, "scale": [1.2, 0.8, 1], "rotate": [20, 30, 40],
     "move": [-1.6, 0.2, 0.5], "material": "brass"},
    {"solid": "torus", "around": 14, "across": 9, "scale": [1, 1.3, 0.9], "rotate": [70, 0, 15],
     "move": [1.6, 0.6, 0.7]},
    {"solid": "cube", "scale": 0.5, "rotate": [0, 0, 30], "move": [0, -1.8, 0.3], "material": "checks"},
    {"file": "teapot.bpt", "divisions": 3, "scale": 0.3, "move": [0, 1.5, 0]},
    {"polygons": [[[-4, -3, -0.4], [4, -3, -0.4], [4, 3, -0.2], [-4, 3, -0.4]],
                  [[-3.4, -2, 0.2], [-2.1, -0.8, 0.2], [-2.4, -2.2, 0.2], [-2, -2.8, 0.2]]]}
  ]})";

Scene everything() { return parseSceneFile(kEverything, "everything", XNEWELL_DATA_DIR); }

Light lamp(LightKind kind, Attenuation attenuation, const Scene& scene) {
  const auto length = [&](double file) { return std::ldexp(file, -scene.exponent); };
  const glm::dvec3 at = scaled({-1.5, -4, 5}, -scene.exponent);
  return {.kind = kind,
          .Ip = {0.4, 0.25, 0.3},
          .direction = kind == LightKind::Spot ? -at : at,
          .position = at,
          .attenuation = attenuation,
          .range = length(9),
          .c = {0.2, 0.1 / length(1), 0.02 / (length(1) * length(1))},
          .inner = 8,
          .outer = 24,
          .falloff = 3};
}

}  // namespace

// The reference is the illumination equation: an evaluation with 64 bits that shares no code with it agrees
// to 1e-12 at every sample of every built-in scene, where it is, 1,000,000 away from the origin, and a
// millionth in size.
TEST(Reference, IsTheEquationInEveryScene) {
  const std::vector<BuiltInScene> all = builtInScenes();
  for (const BuiltInScene& builtIn : someOf(all, 8)) {
    SCOPED_TRACE(builtIn.name);
    const Scene scene = readScene(builtIn.name, 4);
    for (const auto& [scale, shift] : someOf({std::pair{1.0, 0.0}, {1.0, 1e6}, {1e-6, 0.0}}, 1)) {
      SCOPED_TRACE(scale);
      SCOPED_TRACE(shift);
      const Scene there = moved(scene, scale, shift);
      expectAgreement(there, settingsOf(there));
    }
  }
}

// The same for every form of the equation, every kind of light and attenuation, both choices of lit sides,
// every projection, and surfaces of every kind.
TEST(Reference, IsTheEquationOfEveryModel) {
  Scene scene = everything();
  PictureSettings s = settingsOf(scene);
  s.light.ka = 0.7, s.light.kd = 0.8, s.light.ks = 0.6, s.light.n = 7;
  int model = 0;
  for (const FormRow& form : kForms)
    for (const LightRow& light : kLights)
      for (const AttenuationRow& attenuation : someOf(kAttenuations, 1)) {
        if (light.id == LightKind::Directional && attenuation.id != Attenuation::None) continue;
        SCOPED_TRACE(form.name);
        SCOPED_TRACE(light.name);
        SCOPED_TRACE(attenuation.name);
        scene.light.Ia = glm::dvec3{0.1, 0.2, 0.15};
        scene.light.lights = {lamp(light.id, attenuation.id, scene),
                              {.Ip = glm::dvec3{0.3}, .direction = {1, -1, 0.4}}};
        s.light.form = form.id;
        s.light.twoSided = ++model % 2 == 0;
        s.camera.parallel = model % 3 == 1;
        s.camera.oblique = model % 3 == 2 ? std::optional{Oblique{0.4, 30}} : std::nullopt;
        expectAgreement(scene, s);
      }
}

// The same for the user's light, whose range and coefficients follow from the scene unless they are given.
TEST(Reference, IsTheEquationOfTheUsersLight) {
  const Scene scene = everything();
  PictureSettings s = settingsOf(scene);
  s.light.lightPosition = glm::dvec3{-3, -2, 4};
  for (const bool given : {false, true})
    for (const AttenuationRow& attenuation : someOf(kAttenuations, 1)) {
      SCOPED_TRACE(attenuation.name);
      s.light.attenuation = attenuation.id;
      if (given) s.light.range = 14, s.light.c = glm::dvec3{0.5, 0.02, 0.004};
      expectAgreement(scene, s);
    }
}

// The user's attenuation takes the place of that of the scene's lights at places. The file with the same
// words at each of these lights shows the same, bit by bit, with defaults and without; a directional light
// stays.
TEST(Reference, FadesTheScenesLightsAsTheUserSays) {
  const auto withLights = [](const std::string& point, const std::string& spot) {
    const std::string lights = R"("lights": [{"Ip": 0.2, "towards": [1, -1, 0.4]},
      {"kind": "point", "color": [0.3, 0.1, 0.2], "at": [-3, -2, 4])" +
                               point + R"(}, {"kind": "spot", "Ip": 0.3, "at": [2, -4, 5])" + spot + "}], ";
    return parseSceneFile('{' + lights + std::string{kEverything}.substr(1), "faded", XNEWELL_DATA_DIR);
  };
  const Scene own = withLights(R"(, "attenuation": "inverse")", "");
  for (const AttenuationRow& row : kAttenuations)
    for (const bool given : {false, true}) {
      SCOPED_TRACE(row.name);
      std::string words = R"(, "attenuation": ")" + std::string{row.name} + '"';
      PictureSettings s = settingsOf(own);
      const PictureSettings asItIs = s;
      s.light.attenuation = row.id;
      if (given && row.id == Attenuation::Linear) words += R"(, "range": 9)", s.light.range = 9;
      if (given && row.id == Attenuation::Textbook)
        words += R"(, "c": [0.2, 0.1, 0.02])", s.light.c = {0.2, 0.1, 0.02};
      const Scene said = withLights(words, words);
      const Picture faded = makePicture(own, s, 0), written = makePicture(said, asItIs, 0);
      EXPECT_EQ(faded.image(), written.image());
      EXPECT_NE(faded.image(), makePicture(own, asItIs, 0).image());
      const Reference one{faded}, other{written};
      for (std::size_t k = 0; k < one.faces().size(); ++k) ASSERT_EQ(one.I(k), other.I(k));
      expectAgreement(own, s);
    }
}

// Short cuts change nothing, one by one or all together.
TEST(Reference, KnowsNoShortCut) {
  const Scene scene = everything();
  const PictureSettings exact = withoutShortCuts(settingsOf(scene));
  const Reference reference{makePicture(scene, exact)};
  const auto expectSame = [&](const PictureSettings& s) {
    const Reference other{makePicture(scene, s)};
    for (std::size_t k = 0; k < reference.faces().size(); ++k) {
      ASSERT_EQ(other.faces()[k], reference.faces()[k]);
      ASSERT_EQ(other.I(k), reference.I(k));
    }
  };
  PictureSettings all = exact;
  int shortCuts = 0;
  for (const Setting& setting : settingRows()) {
    if (!setting.role.isShortCut()) continue;
    SCOPED_TRACE(setting.key);
    PictureSettings one = exact;
    const Value was = setting.field.get(exact);
    const Value value = setting.field.kind == ValueKind::Choice
                            ? Value{std::get<double>(was) == 0 ? 1.0 : 0.0}
                        : setting.key == "table.shades" ? Value{100.0}
                        : setting.key == "table.i0"     ? Value{0.1}
                        : setting.key == "crease"       ? Value{90.0}
                                                        : Value{1.0};
    ASSERT_NE(value, was);
    setting.field.set(one, value);
    setting.field.set(all, value);
    expectSame(one);
    ++shortCuts;
  }
  EXPECT_GE(shortCuts, 19);
  expectSame(all);
}

// The runs of round solids are right: all corners of their faces lie on the solid, and no others do.
TEST(Reference, KnowsWhichFacesAreRound) {
  const Scene scene = everything();
  ASSERT_EQ(scene.rounds.size(), 2u);
  for (const RoundRun& run : scene.rounds)
    for (int f = 0; f < scene.mesh.faceCount(); ++f) {
      const bool inRun = f >= run.firstFace && f < run.firstFace + run.faces;
      double farthest = 0;
      for (const int c : scene.mesh.face(f)) {
        const glm::dvec3 p =
            glm::inverse(run.axes) * (scaled(scene.mesh.points[c], scene.exponent) - run.centre);
        const double ring = run.solid == RoundSolid::Sphere ? 0.0 : std::hypot(p.x, p.y) - 1;
        const double off = run.solid == RoundSolid::Sphere ? glm::length(p) - 1 : std::hypot(ring, p.z) - 0.4;
        farthest = std::max(farthest, std::abs(off));
      }
      ASSERT_EQ(farthest < 1e-12, inRun) << f;
    }
}

// Where a file has normals, the truth lies between them, so Phong shading with them is right, and with those
// of the faces it is not.
TEST(Reference, TakesTheNormalsOfAFile) {
  Mesh mesh;
  mesh.points = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  std::vector<glm::dvec3> N;
  for (const glm::dvec3& p : mesh.points) N.push_back(glm::normalize(p + glm::dvec3{0, 0, 2}));
  mesh.groupNames = {"square"};
  mesh.addFace(std::array{0, 1, 2, 3}, 0, -1, {}, N);
  const Scene scene = makeScene("square", std::move(mesh), UpAxis::Y);
  const auto largestError = [&](NormalRule rule) {
    PictureSettings s = settingsOf(scene);
    s.shading = Shading::Phong, s.normals = rule;
    const Picture picture = makePicture(scene, s);
    const Reference reference{picture};
    const SeenRows rows = picture.seen(0, kHeight);
    const std::vector<double> I = picture.intensities(rows, 0);
    double largest = 0;
    for (std::size_t k = 0; k < I.size(); ++k)
      if (rows.faces[k] >= 0) largest = std::max(largest, std::abs(I[k] - reference.I(k)[0]));
    return largest;
  };
  EXPECT_LT(largestError(scene.settings.normals), 1e-3);
  EXPECT_GT(largestError(NormalRule::Exact), 0.05);
}

}  // namespace xnewell::THIS_FILE
