#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "depthsort/oracle.h"
#include "geometry/exact/scale.h"
#include "geometry/model/solids.h"
#include "shading/laboratory/ground_truth.h"
#include "shading/laboratory/profile.h"
#include "shading/picture/picture_cache.h"
#include "shading/scene/scene_file.h"
#include "shading/scene/settings.h"
#include "tests/bench/triangulated.h"
#include "tests/support/brief_light.h"
#include "tests/support/seeds.h"
#include "tests/support/small_picture.h"

namespace xnewell::THIS_FILE {

namespace {

/// ---- The reference

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

PictureSettings settingsOf(const Scene& scene) { return setUpOf(scene, kWidth, kHeight); }

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

// The user's attenuation takes the place of that of the scene's lights at places, with defaults and without;
// a directional light stays.
TEST(Reference, FadesTheScenesLightsAsTheUserSays) {
  Scene scene = everything();
  scene.light.lights = {{.Ip = glm::dvec3{0.2}, .direction = {1, -1, 0.4}},
                        lamp(LightKind::Point, Attenuation::Inverse, scene),
                        lamp(LightKind::Spot, Attenuation::None, scene)};
  const IndexImage asItIs = makePicture(scene, settingsOf(scene), 0).image();
  for (const AttenuationRow& row : kAttenuations)
    for (const bool given : {false, true}) {
      SCOPED_TRACE(row.name);
      PictureSettings s = settingsOf(scene);
      s.light.attenuation = row.id;
      if (given && row.id == Attenuation::Linear) s.light.range = 9;
      if (given && row.id == Attenuation::Textbook) s.light.c = {0.2, 0.1, 0.02};
      EXPECT_NE(makePicture(scene, s, 0).image(), asItIs);
      expectAgreement(scene, s);
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

/// ---- Profiles

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

PictureSettings wide(int width) {
  PictureSettings s;
  s.width = width;
  s.height = width / 2;
  s.light.n = 5;  // a highlight that some vertex has a part of
  return s;
}

/// The scanline of a ball of triangles, and which of its faces each pixel shows.
struct BallLine {
  Scanline line;
  std::vector<int> faces;

  explicit BallLine(int width) {
    const PictureSettings s = wide(width);
    const Picture picture = makePicture(makeScene("ball", triangulated(sphere(14, 9)), UpAxis::Z), s);
    line = scanlineOf(picture, s.height / 2, 8);
    faces = picture.seen(line.row, line.row + 1).faces;
  }
  [[nodiscard]] const Profile& of(Shading method) const {
    return *std::ranges::find(line.profiles, method, &Profile::method);
  }
};

Profile sloped(const std::vector<double>& I) {
  Profile profile;
  profile.I = I;
  std::vector<bool> joined(I.size() - 1);
  for (std::size_t i = 0; i + 1 < I.size(); ++i) joined[i] = !std::isnan(I[i]) && !std::isnan(I[i + 1]);
  addSlopes(profile, joined);
  return profile;
}

// On a ball the profiles of the three methods are as they should be. Flat shading has one value for each
// face. Gouraud shading is a straight line within a face, and its step from one face to the next lies between
// the slopes of the two, so it is continuous. Phong shading bends within a face. The whole ball is one
// surface.
TEST(Profile, MethodsAreWhatTheyInterpolate) {
  const BallLine ball{500};
  const Profile &flat = ball.of(Shading::Flat), &gouraud = ball.of(Shading::Gouraud),
                &phong = ball.of(Shading::Phong);
  EXPECT_EQ(ball.line.outlines, 0);
  EXPECT_GT(ball.line.samples, 150);
  int within = 0, across = 0;
  double bend = 0;
  for (std::size_t i = 2; i + 2 < ball.faces.size(); ++i) {
    const int* const f = &ball.faces[i];
    if (f[-2] < 0 || f[2] < 0) continue;
    if (f[0] == f[1]) {
      EXPECT_EQ(flat.slope[i], 0.0);
    }
    if (f[-1] == f[0] && f[0] == f[1]) {
      ++within;
      EXPECT_NEAR(gouraud.slope[i - 1], gouraud.slope[i], 1e-12);
      bend = std::max(bend, std::abs(phong.slope[i] - phong.slope[i - 1]));
    }
    if (f[-1] == f[0] && f[0] != f[1] && f[1] == f[2]) {
      ++across;
      const auto [low, high] = std::minmax(gouraud.slope[i - 1], gouraud.slope[i + 1]);
      EXPECT_GE(gouraud.slope[i], low - 1e-12);
      EXPECT_LE(gouraud.slope[i], high + 1e-12);
    }
  }
  EXPECT_GT(within, 100);
  EXPECT_GT(across, 5);
  EXPECT_GT(bend, 1e-5);
}

// Known slopes: a staircase has jumps, an even bend has one kink, and nothing is measured across a gap.
TEST(Profile, MeasuresJumpsAndKinks) {
  std::vector<double> steps, bend, roof;
  for (int i = 0; i < 60; ++i) {
    steps.push_back(0.1 * (i / 12));
    bend.push_back(0.001 * i * i);
  }
  Profile p = sloped(steps);
  EXPECT_NEAR(p.largestJump, 0.1, 1e-12);
  EXPECT_NEAR(p.largestKink, 0.1, 1e-12);
  p = sloped(bend);
  EXPECT_NEAR(p.largestJump, 0.001 * (59 * 59 - 58 * 58), 1e-12);
  EXPECT_NEAR(p.largestKink, 0.002, 1e-12);
  for (int i = 0; i < 41; ++i) roof.push_back(0.01 * (20 - std::abs(i - 20)));
  EXPECT_NEAR(sloped(roof).largestKink, 0.02, 1e-12);
  roof[20] = kNone;
  EXPECT_TRUE(std::isnan(sloped(roof).slope[19]) && std::isnan(sloped(roof).slope[20]));
  EXPECT_FALSE(std::isnan(sloped(roof).slope[18]));
}

// Known bands: one for each jump of 1/240 or more, and one for each change of slope of 1/2 or more over the
// whole row, at the very edge between two faces. There is none between two surfaces, and a bend within a face
// counts for nothing.
TEST(Profile, BandsAreAtEdgesOfFaces) {
  constexpr int kFace = 20, kFaces = 5, kAll = kFace * kFaces;
  std::vector<FaceRun> runs;
  for (int f = 0; f < kFaces; ++f) runs.push_back({f * kFace, (f + 1) * kFace, f + 1 < kFaces});
  const auto bands = [&](auto&& I) {
    std::vector<double> row;
    for (int i = 0; i < kAll; ++i) row.push_back(I(i + 0.5));
    return bandsOf(row, runs, kAll);
  };
  const auto stairs = [&](double step) { return [=](double x) { return step * std::floor(x / kFace); }; };
  EXPECT_EQ(bands(stairs(1.01 / 240)), (std::vector<double>{20, 40, 60, 80}));
  EXPECT_EQ(bands(stairs(0.99 / 240)), std::vector<double>{});
  const auto roof = [&](double slope) {
    return [=](double x) { return slope / kAll * (x < 40 ? x : 80 - x); };
  };
  EXPECT_EQ(bands(roof(0.251)), std::vector<double>{40});
  EXPECT_EQ(bands(roof(0.249)), std::vector<double>{});
  EXPECT_EQ(bands([](double x) { return std::abs(x - 50) / 50; }), std::vector<double>{});
  EXPECT_EQ(bands([](double x) { return 1.5 * x * x / kAll / kAll; }), std::vector<double>{});
  // A steep smooth curve, as of a highlight, has none, however many faces it is made of.
  EXPECT_EQ(bands([](double x) { return std::exp(-(x - 50) * (x - 50) / 200); }), std::vector<double>{});
  runs[1].joinsNext = false;
  EXPECT_EQ(bands(stairs(0.1)), (std::vector<double>{20, 60, 80}));
}

// The flat ball has a band wherever the face changes and its intensity does, counted here from the picture's
// own row, as wide as the row of bands.
TEST(Profile, AFlatBandForEachVisibleEdge) {
  const BallLine ball{kFineWidth};
  const Profile& flat = ball.of(Shading::Flat);
  int edges = 0, visible = 0;
  for (std::size_t i = 1, since = 0; i < ball.faces.size(); ++i) {
    if (ball.faces[i] == ball.faces[since]) continue;
    ASSERT_TRUE(ball.faces[since] < 0 || i - since >= 3);
    since = i;
    if (ball.faces[i - 1] < 0 || ball.faces[i] < 0) continue;
    ++edges;
    visible += std::abs(flat.I[i] - flat.I[i - 1]) >= 1.0 / 240;
  }
  EXPECT_EQ(ball.line.edges, edges);
  EXPECT_EQ(std::ssize(flat.bands), visible);
  EXPECT_GT(visible, 5);
}

// A larger picture has the same bands in the same places. Smoother methods have fewer.
TEST(Profile, BandsAreTheSameAtEverySize) {
  for (const char* name : {"teapot", "hues", "mach-bands"}) {
    SCOPED_TRACE(name);
    PictureCache pictures{readScene(name)};
    std::array<std::vector<int>, 3> first;
    for (const int width : {2102, 422, 702}) {
      PictureSettings s = wide(width);
      s.camera = completed({}, pictures.scene().camera);
      s.colors = ColorPlan::OneHue;
      const Scanline line = scanlineOf(pictures.make(s), s.height / 2, 8);
      for (std::size_t k = 0; k < 3; ++k) {
        const std::vector<int>& bands = line.profiles[k].bands;
        if (width == 2102) first[k] = bands;
        ASSERT_EQ(bands.size(), first[k].size()) << width << ' ' << k;
        for (std::size_t i = 0; i < bands.size(); ++i)
          EXPECT_NEAR((bands[i] + 0.5) / width, (first[k][i] + 0.5) / 2102, 1.5 / width);
      }
    }
    EXPECT_GT(first[0].size(), 5U);
    EXPECT_GE(first[0].size(), first[1].size());
    EXPECT_GE(first[1].size(), first[2].size());
  }
}

// Where one torus is in front of the other there is an outline and no band. A cube's faces are one surface if
// their normals are averaged, but not if a crease parts them.
TEST(Profile, CountsWithinOneSurface) {
  PictureSettings s = wide(300);
  PictureCache tori{readScene("tori")};
  s.camera = completed({}, tori.scene().camera);
  const Scanline both = scanlineOf(tori.make(s), 75, 8);
  EXPECT_GE(both.outlines, 1);
  for (const Profile& p : both.profiles)
    for (const double slope : p.slope) EXPECT_TRUE(std::isnan(slope) || std::abs(slope) < 0.4);

  PictureCache box{makeScene("box", cube(), UpAxis::Z)};
  s.camera = {};
  s.camera.eye = glm::dvec3{3, -2, 1};
  EXPECT_EQ(scanlineOf(box.make(s), 75, 8).outlines, 0);
  s.crease = 30;
  const Scanline creased = scanlineOf(box.make(s), 75, 8);
  EXPECT_EQ(creased.outlines, 1);
  EXPECT_EQ(creased.profiles[0].largestJump, 0.0);
}

// Where one looks into a tube, the near wall's outside ends at the far walls' inside. This is an outline,
// although all three walls meet in their corners.
TEST(Profile, TheTwoSidesAreTwoSurfaces) {
  Mesh tube;
  tube.points = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}, {-1, -1, 1}, {1, -1, 1}, {0, 1, 1}};
  for (const auto& wall : {std::array{0, 1, 4, 3}, std::array{1, 2, 5, 4}, std::array{2, 0, 3, 5}})
    tube.addFace(wall, 0);
  PictureSettings s = wide(300);
  s.camera.eye = glm::dvec3{2, -3, 4};
  const Picture picture = makePicture(makeScene("tube", tube, UpAxis::Z), s);
  int edges = 0, samples = 0;
  for (int row = 0; row < s.height; ++row) {
    const Scanline line = scanlineOf(picture, row, 8);
    const std::vector<int> seen = picture.seen(row, row + 1).faces;
    int sides = 0;  // neighbours of which one shows its front and one its back
    for (std::size_t i = 1; i < seen.size(); ++i)
      if (seen[i - 1] >= 0 && seen[i] >= 0)
        sides += picture.snapped().faces[seen[i - 1]].back != picture.snapped().faces[seen[i]].back;
    EXPECT_EQ(line.outlines, sides);
    edges += sides, samples += line.samples;
  }
  EXPECT_GT(edges, 10);
  EXPECT_GT(samples, 500);
}

// The strip is the row of the method's picture, whatever method the given picture is in.
TEST(Profile, ShowsTheRowOfEachMethod) {
  PictureCache pictures{readScene("teapot", 4)};
  PictureSettings s = wide(200);
  s.shading = Shading::Gouraud;
  const Scanline line = scanlineOf(pictures.make(s), 60, 8);
  for (const Profile& p : line.profiles) {
    s.shading = p.method;
    const IndexImage image = pictures.make(s, 8).image();
    EXPECT_TRUE(std::equal(p.cells.begin(), p.cells.end(), image.row(60), image.row(61)));
  }
  EXPECT_NE(line.profiles[0].cells, line.profiles[1].cells);
}

// The default is the middle row, unless it shows nothing.
TEST(Profile, DefaultScanlineShowsSomething) {
  const Scene scene = parseSceneFile(
      R"({"objects": [{"polygons": [[[-1, 0.5, 0], [1, 0.5, 0], [0, 0.9, 0]]]}],
          "camera": {"eye": [0, 0, 3], "look_at": [0, 0, 0], "parallel": 2}})",
      "above", ".");
  PictureSettings s = wide(100);
  s.camera = scene.camera;
  const Picture above = makePicture(scene, s);
  const SeenRows middle = above.seen(25, 26);
  const SeenRows chosen = above.seen(defaultScanline(above), defaultScanline(above) + 1);
  const auto shown = [](const SeenRows& r) {
    return std::ranges::count_if(r.faces, [](int f) { return f >= 0; });
  };
  EXPECT_EQ(shown(middle), 0);
  EXPECT_GT(shown(chosen), 10);
  EXPECT_EQ(defaultScanline(makePicture(readScene("teapot", 3), wide(100))), 25);
}

// The cells of every strip are those of the picture's plan, whatever method the picture has: cell by cell,
// the ramp of the surface's hue. The method of the picture has its own row.
TEST(Profile, CellsAreOfThePicturesPlan) {
  for (const Shading shading : {Shading::Full, Shading::Depth, Shading::Flat, Shading::Gouraud,
                                Shading::Phong, Shading::Environment}) {
    const Scene scene = readScene("hues");
    PictureSettings settings = setUpOf(scene, 200, 150);
    settings.shading = shading;
    const Picture picture = makePicture(scene, settings, 8);
    for (const int row : {60, 80, 100}) {
      const Scanline line = scanlineOf(picture, row, 8);
      const SeenRows seen = picture.seen(row, row + 1);
      for (const Profile& p : line.profiles) {
        SCOPED_TRACE(testing::Message() << static_cast<int>(shading) << ' ' << row);
        if (p.method == shading) {
          EXPECT_TRUE(std::equal(p.cells.begin(), p.cells.end(), picture.image().row(row)));
        }
        for (int i = 0; i < 200; ++i) {
          if (seen.faces[i] < 0) {
            ASSERT_EQ(p.cells[i], 8);
            continue;
          }
          const int face = picture.snapped().faces[seen.faces[i]].number;
          const ColorTable& table = picture.colors().tableOf(picture.scene().mesh.material[face]);
          ASSERT_GE(p.cells[i], table.first());
          ASSERT_LT(p.cells[i], table.first() + table.shades());
          ASSERT_NEAR(picture.colors().intensityOf(p.cells[i]), p.I[i], 2.0 / table.shades());
        }
      }
    }
  }
}

}  // namespace

}  // namespace xnewell::THIS_FILE
