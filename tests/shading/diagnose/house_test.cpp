#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include "shading/diagnose/diagnose.h"
#include "shading/scene/scene.h"
#include "shading/scene/units.h"
#include "tests/support/small_picture.h"
#include "tests/support/student_world.h"

namespace xnewell::THIS_FILE {

namespace {

/// ---- The house

/// The house that the assignment begins with: three different values are in its picture, so most mistakes
/// look like another one. Flat shading, 640 x 480.
class House {
 public:
  explicit House(TableKind table = TableKind::Linear) {
    Scene scene = readScene(XNEWELL_DATA_DIR "/../x11/example/house.obj");
    PictureSettings settings = setUpOf(scene, 640, 480);
    settings.camera.eye = glm::dvec3{4, 3, 6}, settings.camera.lookAt = glm::dvec3{0, 0.4, 0};
    settings.light.light = glm::dvec3{-0.5, 0.6, -0.4};
    settings.light.n = 4, settings.table.kind = table;
    diagnoser.emplace(std::move(scene), settings);
    world = studentsWorld(diagnoser->picture());
    program.table = kTables[static_cast<std::size_t>(table)].name[0];
  }
  [[nodiscard]] Diagnosis diagnosed() { return (*diagnoser)(handedInBy(student::draw(world, program))); }

  std::optional<Diagnoser> diagnoser;
  student::World world;
  student::Program program;
};

std::set<std::string_view> keysOf(const Diagnosis& d) {
  std::set<std::string_view> keys;
  for (const Fit& f : d.found) keys.insert(f.first->key);
  return keys;
}

// Another n is found, and it is neither what the course allows nor two mistakes: the values of n = 5 are one
// step from those of a constant V, and those of n = 10 one step from two rows at once.
TEST(House, FindsAnotherN) {
  House house;
  EXPECT_EQ(house.diagnosed().verdict, Marking::Right);
  for (const int n : {2, 3, 5, 6, 8, 10, 16, 20}) {
    SCOPED_TRACE(n);
    for (student::Surface& s : house.world.surfaces) s.n = n;
    const Diagnosis d = house.diagnosed();
    ASSERT_EQ(d.verdict, Marking::Numbers);
    ASSERT_TRUE(d.found[0].number);
    EXPECT_EQ(d.found[0].number->which, NumberOf::n);
    EXPECT_EQ(d.found[0].number->is, n);
    EXPECT_EQ(d.found[0].number->was, 4);
    ASSERT_TRUE(d.pixel);
    EXPECT_EQ(d.pixel->yours[0], d.pixel->mistaken[0]);
    EXPECT_NE(d.pixel->yours[0], d.pixel->right[0]);
  }
}

// Each other number of the equation is found, or is one of those that the picture cannot tell apart.
TEST(House, FindsOtherNumbers) {
  House house;
  const student::World right = house.world;
  const auto finds = [&](NumberOf which, double is) {
    const Diagnosis d = house.diagnosed();
    return d.verdict == Marking::Numbers && std::ranges::any_of(d.found, [&](const Fit& f) {
             return f.number && f.number->which == which && std::abs(f.number->is - is) < 0.006;
           });
  };
  const auto with = [&](double student::Surface::*number, double is) {
    house.world = right;
    for (student::Surface& s : house.world.surfaces) s.*number = is;
  };
  with(&student::Surface::kd, 0.6);
  EXPECT_TRUE(finds(NumberOf::kd, 0.6));
  for (const double ks : {0.25, 0.32}) {  // in steps of 1/100
    with(&student::Surface::ks, ks);
    EXPECT_TRUE(finds(NumberOf::ks, ks)) << ks;
  }
  with(&student::Surface::ka, 0.5);
  EXPECT_TRUE(finds(NumberOf::ka, 0.5));
  house.world = right;
  house.world.Ia = 0.3;
  EXPECT_TRUE(finds(NumberOf::Ia, 0.3));
  house.world.Ia = 0.2, house.world.Ip = 0.5;
  EXPECT_TRUE(finds(NumberOf::Ip, 0.5));
}

// What a program computes once and uses twice carries a mistake on: N.L into R, V into the turning of N.
TEST(House, NamesMistakesThatFlowOn) {
  House house;
  house.program.flows = true;
  EXPECT_EQ(house.diagnosed().verdict, Marking::Right);
  for (const std::string key : {"NL-abs", "NL-unclamped", "NL-angle", "V-sign"}) {
    house.program.mistake = key;
    const Diagnosis d = house.diagnosed();
    EXPECT_TRUE(keysOf(d).contains(key)) << key << ": " << d.found.size();
  }
}

// A picture upside down shows something else than the right one at the pixel that is told.
TEST(House, TellsAPixelThatDiffers) {
  House house;
  for (const std::string key :
       {"flip-y", "flip-x", "turned-180", "L-sign", "R-without-2", "order-reversed"}) {
    house.program.mistake = key;
    const Diagnosis d = house.diagnosed();
    ASSERT_TRUE(d.pixel) << key;
    EXPECT_GT(std::abs(d.pixel->yours[0] - d.pixel->right[0]), 1) << key;
    EXPECT_NEAR(d.pixel->yours[0], d.pixel->mistaken[0], 1) << key;
  }
}

// With the corrected table: a program of the linear table, another I0 and 240 steps are told from what the
// course allows. A cell that is cut off is the same picture here, and that can be asked for.
TEST(House, TellsTablesApart) {
  House house{TableKind::Corrected};
  EXPECT_EQ(house.diagnosed().verdict, Marking::Right);
  house.program.table = 'l';
  EXPECT_EQ(keysOf(house.diagnosed()), std::set<std::string_view>{"table-linear"});
  house.program.table = 'c', house.program.I0 = 0.05;
  const Diagnosis d = house.diagnosed();
  EXPECT_EQ(d.verdict, Marking::Numbers);
  EXPECT_TRUE(keysOf(d).contains("I0"));
  house.program.I0 = 0.02, house.program.flows = true, house.program.mistake = "table-r-240-steps";
  EXPECT_TRUE(keysOf(house.diagnosed()).contains("table-r-240-steps"));
  house.program.flows = false, house.program.mistake = "cell-floor";
  EXPECT_EQ(house.diagnosed().verdict, Marking::Right);
  const auto hidden = house.diagnoser->whatCannotBeSeen();
  EXPECT_TRUE(std::ranges::find(hidden, "cell-floor") != hidden.end());
  EXPECT_TRUE(std::ranges::find(hidden, "L-sign") == hidden.end());
}

// Right shades at the wrong places are wrong: an eye that is a little off, and a picture three pixels too
// low. One pixel may come from another edge rule. A mistake is named all the same.
TEST(House, SeesThatFacesLieElsewhere) {
  House house;
  const auto lower = [&](int by) {
    const HandedIn drawn = handedInBy(student::draw(house.world, house.program));
    HandedIn moved = drawn;
    const auto row = std::ptrdiff_t{3} * drawn.picture.width;
    std::copy(drawn.picture.rgb.begin(), drawn.picture.rgb.end() - by * row,
              moved.picture.rgb.begin() + by * row);
    moved.cells.reset();
    return (*house.diagnoser)(moved);
  };
  EXPECT_EQ(lower(0).verdict, Marking::Right);
  EXPECT_EQ(lower(0).outlines.apart, 0);
  EXPECT_EQ(lower(1).verdict, Marking::Right);
  const Diagnosis d = lower(3);
  EXPECT_EQ(d.verdict, Marking::Outlines);
  EXPECT_EQ(d.outlines.farthest, 3);
  house.world.eye[0] += 0.2;
  EXPECT_EQ(house.diagnosed().verdict, Marking::Outlines);
  house.world.eye[0] -= 0.2, house.program.mistake = "NL-abs";
  EXPECT_EQ(lower(3).verdict, Marking::Mistake);
  EXPECT_TRUE(lower(3).outlines.areOff());
}

// A row that changes no light of the scene computes what is right there. It is no mistake that is hidden.
TEST(House, NamesOnlyWhatAScenesLightsCanShow) {
  const auto hides = [](Diagnoser& diagnoser, std::string_view key) {
    const auto hidden = diagnoser.whatCannotBeSeen();
    return std::ranges::find(hidden, key) != hidden.end();
  };
  House house;  // a light far away
  for (const char* key : {"f-forgotten", "f-1/d", "f-1/d2", "f-above-1", "f-on-ambient"})
    EXPECT_FALSE(hides(*house.diagnoser, key)) << key;
  EXPECT_TRUE(hides(*house.diagnoser, "RV-abs"));
  Scene scene = readScene("bench");  // one light at a place, which fades by 1/d^2
  const PictureSettings settings = setUpOf(scene, 320, 240);
  Diagnoser bench{std::move(scene), settings};
  EXPECT_FALSE(hides(bench, "f-1/d2"));
  EXPECT_FALSE(hides(bench, "L-direction-as-place"));
}

/// ---- The bench

constexpr const char* kBenchObj = XNEWELL_DATA_DIR "/../x11/example/bench.obj";

/// "0.25": at most seven decimals.
std::string decimal(double v) {
  char text[32];
  std::snprintf(text, sizeof text, "%.7f", v);
  std::string all{text};
  while (all.ends_with('0')) all.pop_back();
  if (all.ends_with('.')) all.pop_back();
  return all == "-0" ? "0" : all;
}

/// What a student of this scene is given.
student::World worldOf(const std::string& name) {
  const Scene scene = readScene(name);
  return studentsWorld(makePicture(scene, setUpOf(scene, 320, 240)));
}

/// The scene as a file that a student's program reads: places in the world, and faces in the scene's order.
std::string benchAsObj(const std::vector<int>& materials) {
  const auto numbers = [](const student::Triple& t) {
    return ' ' + decimal(t[0]) + ' ' + decimal(t[1]) + ' ' + decimal(t[2]);
  };
  const student::World bench = worldOf("bench");
  std::string obj =
      "# The scenes bench and bench-n3 for programs that read .obj files. Faces have the scene's numbers.\n"
      "# Camera: eye" +
      numbers(bench.eye) + ", look-at" + numbers(bench.at) + ", up" + numbers(bench.up) + ", " +
      decimal(bench.fov) + " degrees high.\n# Light: Ia " + decimal(bench.Ia) + "; a lamp at" +
      numbers(bench.light) + " with Ip " + decimal(bench.Ip) +
      ", which fades by min(1, 1/d^2).\n# Materials: n is " + decimal(bench.surfaces[0].n) +
      " in bench and " + decimal(worldOf("bench-n3").surfaces[0].n) + " in bench-n3.\n";
  for (int m = 0; m <= std::ranges::max(materials); ++m) {
    const student::Surface& s = bench.surfaces[std::ranges::find(materials, m) - materials.begin()];
    obj += "#   m" + std::to_string(m) + ": ka " + decimal(s.ka) + ", kd " + decimal(s.kd) + ", ks " +
           decimal(s.ks) + "\n";
  }
  for (const student::Triple& p : bench.points) obj += 'v' + numbers(p) + '\n';
  int material = -1;
  for (std::size_t f = 0; f < bench.faces.size(); ++f) {
    if (materials[f] != material) obj += "usemtl m" + std::to_string(material = materials[f]) + '\n';
    obj += 'f';
    for (const int point : bench.faces[f]) obj += ' ' + std::to_string(point + 1);
    obj += '\n';
  }
  return obj;
}

// The file for students is the scene, to the letter. After a change of the scene, copy the new text from the
// file that a failure names.
TEST(BenchObj, IsTheScene) {
  const Scene bench = readScene("bench");
  EXPECT_EQ(bench.light.lights.at(0).attenuation, Attenuation::InverseSquare);
  const std::string obj = benchAsObj(bench.mesh.material);
  std::ostringstream stored;
  stored << std::ifstream{kBenchObj}.rdbuf();
  const std::string fresh = ::testing::TempDir() + "bench.obj";
  if (stored.str() != obj) std::ofstream{fresh} << obj;
  EXPECT_TRUE(stored.str() == obj) << "see " << fresh;
  const Scene n3 = readScene("bench-n3"), read = readScene(kBenchObj);
  EXPECT_EQ(read.mesh.faceCount(), n3.mesh.faceCount());
  EXPECT_EQ(read.mesh.corners, n3.mesh.corners);
}

}  // namespace

}  // namespace xnewell::THIS_FILE
