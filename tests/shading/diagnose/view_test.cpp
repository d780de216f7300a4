#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <set>
#include <string>
#include <vector>

#include "shading/diagnose/diagnose.h"
#include "tests/support/seeds.h"
#include "tests/support/student_world.h"

namespace xnewell::THIS_FILE {

namespace {

/// A camera whose window is not centred, in the textbook's words and in the student's.
struct Looks {
  std::string scene;
  glm::dvec3 eye, at, up;
  double fov;
  std::array<double, 2> shift;
};
const std::vector<Looks> kLooks{
    {"bench-n3", {2.85, -2.87, 3.01}, {0.27, 0.12, 0.25}, {0, 0, 1}, 44, {0.3, 0.2}},
    {XNEWELL_DATA_DIR "/../x11/example/house.obj", {4, 3, 6}, {0, 0.4, 0}, {0, 1, 0}, 30, {-0.2, 0.25}},
    {"bench-n3", {0.9, -1.5, 0.7}, {0.35, 0.12, 0.35}, {0, 0, 1}, 60, {0.2, -0.1}},
};

/// The student of support/student_view.cpp, with 4 x 4 matrices of its own and a z-buffer.
class Viewer {
 public:
  explicit Viewer(const Looks& looks, bool centred = false) {
    Scene scene = readScene(looks.scene);
    PictureSettings s = scene.settings;
    s.width = 320, s.height = 240, s.shading = Shading::Flat;
    if (looks.scene.ends_with("obj")) s.light.light = glm::dvec3{-0.5, 0.6, 0.4};
    CameraSettings& camera = s.camera;
    const double D = glm::length(looks.eye - looks.at), high = D * std::tan(glm::radians(looks.fov / 2));
    const double x = centred ? 0 : looks.shift[0] * high, y = centred ? 0 : looks.shift[1] * high,
                 wide = high * s.width / s.height;
    camera.vrp = looks.at, camera.vpn = looks.eye - looks.at, camera.vup = looks.up;
    camera.prp = glm::dvec3{0, 0, D};
    camera.window = glm::dvec4{x - wide, x + wide, y - high, y + high};
    camera.front = D - 0.05, camera.back = D - 40;
    diagnoser.emplace(std::move(scene), s);
    world = studentsWorld(diagnoser->picture());
    const auto triple = [](const glm::dvec3& v) { return student::Triple{v.x, v.y, v.z}; };
    world.eye = triple(looks.eye), world.at = triple(looks.at), world.up = triple(looks.up);
    world.fov = looks.fov, world.front = 0.05, world.back = 40;
    if (!centred) world.shift = looks.shift;
    program.byMatrices = true, program.width = s.width, program.height = s.height;
  }
  [[nodiscard]] Diagnosis diagnosed(const std::string& mistake, const std::string& variant = "") {
    program.mistake = mistake, program.variant = variant;
    return (*diagnoser)(handedInBy(student::draw(world, program)));
  }

  std::optional<Diagnoser> diagnoser;
  student::World world;
  student::Program program;
};

const std::vector<std::string> kPlanted{"view-T-after-R",
                                        "view-S-first",
                                        "R-angles-negated",
                                        "R-in-degrees",
                                        "fov-in-degrees",
                                        "R-transposed",
                                        "view-transposed",
                                        "rows-for-columns",
                                        "R-wrong-axis",
                                        "w-not-divided",
                                        "divided-before-clipping",
                                        "aspect-inverted",
                                        "aspect-forgotten",
                                        "fov-not-halved",
                                        "fov-horizontal",
                                        "v-is-VUP",
                                        "VPN-reversed",
                                        "u-left-handed",
                                        "eye-and-look-at-exchanged",
                                        "shear-forgotten",
                                        "shear-negated",
                                        "window-centre-forgotten",
                                        "viewport-half-pixel",
                                        "viewport-one-short",
                                        "flip-y",
                                        "near-plane-negated",
                                        "z-not-kept",
                                        "N-not-turned",
                                        "N-by-M",
                                        "N-scaled",
                                        "L-not-moved"};

}  // namespace

// Each mistake of the viewing transformation, planted on three scenes, gets its name or a class with it, and
// none a wrong name. A mistake that changes no pixel is right.
TEST(View, NamesThePlantedMistake) {
  int planted = 0, named = 0;
  std::string others;
  for (const Looks& looks : kLooks) {
    Viewer viewer{looks};
    const auto right = student::draw(viewer.world, viewer.program).cell;
    for (const std::string& key : kPlanted) {
      const Diagnosis d = viewer.diagnosed(key);
      if (student::draw(viewer.world, viewer.program).cell == right) continue;
      ++planted;
      const bool isNamed = std::ranges::any_of(d.found, [&](const Fit& f) {
        return f.first->key == (key == "z-not-kept" ? "order-none" : key) && !f.second;
      });
      named += isNamed;
      std::string names;
      for (const Fit& f : d.found)
        names += ' ' + std::string{f.first->key} + (f.second ? "+" + std::string{f.second->key} : "");
      if (!isNamed)
        others += looks.scene + ' ' + key + ':' + names + " overlap " + std::to_string(d.outlines.overlap) +
                  " verdict " + std::to_string(int(d.verdict)) + '\n';
      const bool accuses =
          d.verdict == Marking::Mistake || d.verdict == Marking::OneOf || d.verdict == Marking::Numbers;
      EXPECT_TRUE(isNamed || !accuses) << looks.scene << ' ' << key << ':' << names;
    }
  }
  RecordProperty("planted", planted);
  RecordProperty("named", named);
  EXPECT_GE(named * 100, planted * 92) << planted << '\n' << others;
}

// A camera that is a little off is none of the mistakes, and neither is a light that is.
TEST(View, HasNoNameForACameraThatIsOff) {
  int pictures = 0, named = 0;
  std::string misnamed;
  for (const Looks& looks : someOf(kLooks, 1))
    for (const double by : {-0.006, 0.01, 0.05})
      for (int what = 0; what < 4; ++what) {
        Viewer viewer{looks};
        student::World& w = viewer.world;
        if (what == 0) w.fov *= 1 + by;
        if (what == 1) w.eye[0] += 3 * by, w.eye[2] -= by;
        if (what == 2) w.at[1] += 2 * by;
        if (what == 3) w.up[0] += by, w.up[1] += 2 * by;
        const Diagnosis d = viewer.diagnosed("");
        ++pictures;
        if (d.verdict != Marking::Mistake && d.verdict != Marking::OneOf) continue;
        ++named;
        misnamed += looks.scene + ' ' + std::to_string(what) + ' ' + std::to_string(by) + ' ' +
                    std::string{d.found[0].first->key} + '\n';
      }
  EXPECT_EQ(named, 0) << pictures << '\n' << misnamed;
}

// Where the shades are wrong in a way that no list has, the outlines tell the view alone.
TEST(View, IsToldWhateverTheShades) {
  Viewer viewer{kLooks[0]};
  for (const std::string key :
       {"flip-y", "aspect-forgotten", "fov-not-halved", "shear-negated", "fov-horizontal"})
    for (const std::string shades : {"off-minnaert", "off-fog", "off-half-lambert"}) {
      viewer.program.second = shades;
      const Diagnosis d = viewer.diagnosed(key);
      EXPECT_TRUE(std::ranges::any_of(d.found, [&](const Fit& f) { return f.first->key == key; }))
          << key << ' ' << shades << ' ' << (d.found.empty() ? "" : d.found[0].first->key);
      EXPECT_EQ(std::ranges::count(d.found, key, [](const Fit& f) { return f.first->key; }), 1) << key;
    }
  viewer.program.second = "";  // as with the matrices of OpenGL
  const Diagnosis d = viewer.diagnosed("w-not-divided", "opengl");
  ASSERT_EQ(d.verdict, Marking::Mistake);
  EXPECT_EQ(d.found[0].first->key, "w-not-divided");
}

// Other conventions that give the same picture are right: with a centred window, too.
TEST(View, AccusesNoOtherConvention) {
  for (const Looks& looks : kLooks)
    for (const bool centred : {false, true}) {
      Viewer viewer{looks, centred};
      for (const std::string variant :
           {"", "by-angles", "other-VUP", "viewport-half-pixel", "triangles-apart"})
        for (const double front : {0.05, 0.02}) {
          viewer.world.front = front;
          const Diagnosis d = viewer.diagnosed("", variant);
          EXPECT_TRUE(d.verdict == Marking::Right || d.verdict == Marking::Allowed)
              << looks.scene << ' ' << variant << ' ' << static_cast<int>(d.verdict) << ' '
              << (d.found.empty() ? "" : d.found[0].first->key);
        }
    }
}

}  // namespace xnewell::THIS_FILE
