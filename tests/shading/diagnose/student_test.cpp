#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "shading/diagnose/diagnose.h"
#include "tests/support/seeds.h"
#include "tests/support/small_picture.h"
#include "tests/support/student.h"
#include "tests/support/student_world.h"

namespace xnewell::THIS_FILE {

namespace {

/// ---- A student's pictures

/// The pictures of the student in support/student.cpp, by name of what is planted.
class Students {
 public:
  Students(const std::string& name, Shading method, TableKind table) : method_{method}, table_{table} {
    Scene scene = readScene(name, 4);
    settings_ = setUpOf(scene, 320, 240);
    settings_.shading = method, settings_.table.kind = table, settings_.normals = NormalRule::Sum;
    diagnoser.emplace(std::move(scene), settings_);
    world = studentsWorld(diagnoser->picture());
  }

  [[nodiscard]] Diagnosis diagnosed(student::Program program, bool indexed = false) {
    program.method = static_cast<char>(std::tolower(rowOf(method_).label[0]));
    program.table = kTables[static_cast<std::size_t>(table_)].name[0];
    program.width = settings_.width, program.height = settings_.height;
    return (*diagnoser)(handedInBy(student::draw(world, program), indexed));
  }

  /// True if no sample shows the mistake: each is within `most` shades of right.
  [[nodiscard]] bool isInvisible(const std::string& key, double most) {
    const auto right = diagnoser->predicted(diagnoser->approachWith(hypotheses().front()));
    const auto other = diagnoser->predicted(diagnoser->approachWith(*hypothesisNamed(key)));
    for (std::size_t k = 0; k < right.size(); ++k)
      if (right[k].shows != other[k].shows || std::abs(right[k].value[0] - other[k].value[0]) > most)
        return false;
    return true;
  }

  /// The keys that the student can plant here.
  [[nodiscard]] std::vector<std::string> keys(Meaning meaning) const {
    // Pictures without a table, and black ones, have tests of their own; corners that are half a pixel off
    // hide which it is.
    static const std::set<std::string_view> kNotPlanted{
        "by-rows",      "VN-sum",       "VN-distinct",  "VN-angle",          "VN-patch",
        "stores-255-I", "stores-256-I", "stores-gamma", "table-8-bit-in-16", "I-whole",
        "N-not-turned", "N-by-M",       "N-scaled",     "L-not-moved"};
    std::vector<std::string> all;
    std::set<std::string_view> seen;
    for (const Hypothesis& h : hypotheses()) {
      if (h.way.view) continue;  // below
      const bool lamps = h.key.starts_with("f-") || h.key == "L-place-as-direction";
      const bool here = world.lamp ? h.key != "L-direction-as-place" && h.key != "f-1/d2" : !lamps;
      if (h.meaning == meaning && here && (!h.applies || h.applies(settings_)) &&
          !kNotPlanted.contains(h.key) && seen.insert(h.key).second)
        all.emplace_back(h.key);
    }
    return all;
  }

  std::optional<Diagnoser> diagnoser;
  student::World world;

 private:
  Shading method_;
  TableKind table_;
  PictureSettings settings_;
};

bool isRight(const Diagnosis& d) { return d.verdict == Marking::Right || d.verdict == Marking::Allowed; }

std::string namesOf(const Diagnosis& d) {
  std::string names;
  for (const Fit& f : d.found)
    names += ' ' + std::string{f.first->key} + (f.second ? '+' + std::string{f.second->key} : "");
  return names;
}

/// How often a planted mistake is named.
struct Confusion {
  int planted = 0, invisible = 0, oneName = 0, unknown = 0, wrongName = 0;
  int oneNameByCells = 0;  ///< of those in a class, where the file has the cells
  std::string misnamed, unclear;

  void count(const std::string& key, const Diagnosis& d) {
    ++planted;
    const bool named = std::ranges::any_of(
        d.found, [&](const Fit& f) { return f.first->key == key || (f.second && f.second->key == key); });
    const std::string names = namesOf(d);
    if (d.verdict != Marking::Mistake && !isRight(d)) unclear += key + ':' + names + "; ";
    if (isRight(d)) return;
    if (d.verdict != Marking::Mistake && d.verdict != Marking::OneOf)
      ++unknown;
    else if (!named)
      ++wrongName, misnamed += key + " was called" + names + "; ";
    else
      oneName += d.verdict == Marking::Mistake;
  }
};

/// Flat shading with two tables; Gouraud and Phong shading with one.
Confusion confusionOn(const std::string& scene) {
  Confusion all;
  for (const TableKind table : {TableKind::Linear, TableKind::Corrected})
    for (const Shading method : someOf({Shading::Flat, Shading::Gouraud, Shading::Phong}, 1)) {
      if (table == TableKind::Corrected && method != Shading::Flat) continue;
      Students students{scene, method, table};
      for (const std::string& key : students.keys(Meaning::Wrong)) {
        const Diagnosis d = students.diagnosed({.mistake = key});
        all.count(key, d);
        if (d.verdict == Marking::OneOf)
          all.oneNameByCells += students.diagnosed({.mistake = key}, true).verdict == Marking::Mistake;
        all.invisible += students.isInvisible(key, 0.5);
      }
    }
  return all;
}

// The confusion table on the bench: a second program plants each mistake, and none gets a wrong name. A class
// of two stands where both are the same picture: V-sign and R-sign by algebra, cell-off-by-one and table-i-11
// in files without cells, cell-natural-log and cell-I0-forgotten, which are both nearly black; and, where the
// program turns N by V, L-sign and V-sign by algebra. Cells part what colours do not: with them 95 % have one
// name, and what is left is the same picture.
TEST(Diagnose, NamesThePlantedMistakeOnTheBench) {
  const Confusion c = confusionOn("bench-n3");
  EXPECT_EQ(c.wrongName, 0) << c.misnamed;
  if (kSanitized) return;
  EXPECT_GE(c.planted, 200);
  EXPECT_GE(c.oneName, (c.planted - c.invisible) * 91 / 100) << c.unclear;
  EXPECT_GE(c.oneName + c.oneNameByCells, (c.planted - c.invisible) * 95 / 100);
  EXPECT_EQ(c.unknown, 0);
}

// On the teapot fewer mistakes show. What shows at no sample is the right picture, and counts for neither.
TEST(Diagnose, NamesThePlantedMistakeOnTheTeapot) {
  const Confusion c = confusionOn("teapot");
  EXPECT_EQ(c.wrongName, 0) << c.misnamed;
  if (kSanitized) return;
  EXPECT_GE(c.planted, 150);
  EXPECT_GE(c.oneName, (c.planted - c.invisible) * 80 / 100) << c.unclear;
}

// A mistake that is in no list gets no name. Where it is a number that is another one, that may be told. Each
// scene has each of them, by one of the methods; all of them by all methods with XNEWELL_SEED.
TEST(Diagnose, HasNoNameForWhatIsNotInTheList) {
  int pictures = 0, wrongNames = 0;
  std::string misnamed;
  const bool all = std::getenv("XNEWELL_SEED") != nullptr;
  for (const std::string scene : someOf({"bench-n3", "teapot"}, 1))
    for (const int turn : {0, 1, 2}) {
      Students students{scene, std::array{Shading::Flat, Shading::Gouraud, Shading::Phong}[turn],
                        TableKind::Linear};
      for (std::size_t k = 0; k < student::offListKeys().size(); ++k) {
        if (!all && static_cast<int>(k % 3) != turn) continue;
        const std::string& key = student::offListKeys()[k];
        const Diagnosis d = students.diagnosed({.mistake = key});
        const bool isNumber = d.verdict == Marking::Numbers && key.starts_with("off-number");
        const bool isNamed = (d.verdict == Marking::Mistake || d.verdict == Marking::Numbers) && !isNumber;
        ++pictures, wrongNames += isNamed && d.found.size() == 1;
        if (isNamed) misnamed += scene + ' ' + std::to_string(turn) + ' ' + key + ':' + namesOf(d) + '\n';
      }
    }
  EXPECT_LE(wrongNames * 100, pictures) << misnamed;
}

// A right picture is right: with the course's variants, orders and other rules for edges.
TEST(Diagnose, AccusesNoRightPicture) {
  for (const std::string scene : someOf({"bench-n3", "teapot"}, 1))
    for (const Shading method : someOf({Shading::Flat, Shading::Gouraud, Shading::Phong}, 1)) {
      Students students{scene, method, TableKind::Linear};
      std::vector<std::string> keys = students.keys(Meaning::Allowed);
      keys.emplace_back("");
      for (const std::string& key : keys)
        for (const bool half : {false, true}) {
          const Diagnosis d = students.diagnosed({.variant = key, .half = half, .zbuffer = half});
          EXPECT_TRUE(isRight(d)) << scene << ' ' << rowOf(method).name << ' ' << key << half << namesOf(d);
        }
      if (method != Shading::Flat) continue;
      student::Program program{.variant = "zmean"};
      EXPECT_TRUE(isRight(students.diagnosed(program)));
    }
}

// A picture without a table is right, and the verdict says what it holds instead.
TEST(Diagnose, SaysWhatIsStoredInPlaceOfTheTable) {
  for (const Shading method : someOf({Shading::Flat, Shading::Gouraud, Shading::Phong}, 1)) {
    Students students{"bench-n3", method, TableKind::Linear};
    for (const std::string key : {"stores-255-I", "stores-256-I", "stores-gamma"}) {
      const Diagnosis d = students.diagnosed({.variant = key});
      ASSERT_EQ(d.verdict, Marking::Allowed) << key;
      EXPECT_TRUE(d.found[0].first->key == key || (d.found[0].second && d.found[0].second->key == key))
          << key;
    }
  }
}

// The cells of an indexed picture tell a mistake in color(I) from one in the table.
TEST(Diagnose, ReadsCells) {
  Students students{"bench-n3", Shading::Flat, TableKind::Linear};
  for (const std::string key : {"cell-off-by-one", "table-i-11"}) {
    const Diagnosis d = students.diagnosed({.mistake = key}, true);
    EXPECT_TRUE(d.readsCells);
    ASSERT_EQ(d.found.size(), 1u) << key;
    EXPECT_EQ(d.found[0].first->key, key);
  }
}

// With n = 2, half of n is another name for an exponent that is forgotten, and adds no second answer.
TEST(Diagnose, GivesOneNameForOneThing) {
  Students students{"bench", Shading::Flat, TableKind::Linear};
  const Diagnosis d = students.diagnosed({.mistake = "n-forgotten"});
  ASSERT_EQ(d.found.size(), 1u);
  EXPECT_EQ(d.found[0].first->key, "n-forgotten");
}

// A mistake together with what the course allows, and two mistakes, are told.
TEST(Diagnose, TellsTwoAtOnce) {
  Students students{"bench-n3", Shading::Flat, TableKind::Linear};
  Diagnosis d = students.diagnosed({.mistake = "R-without-2", .variant = "V-constant"});
  ASSERT_EQ(d.verdict, Marking::Mistake);
  EXPECT_EQ(d.found[0].first->key, "R-without-2");
  EXPECT_EQ(d.found[0].second->key, "V-constant");
  d = students.diagnosed({.mistake = "L-sign", .second = "Ia-twice"});
  ASSERT_EQ(d.verdict, Marking::OneOf);  // a V that is reversed before it turns N is the same by algebra
  std::set<std::set<std::string_view>> pairs;
  for (const Fit& f : d.found) pairs.insert({f.first->key, f.second->key});
  EXPECT_EQ(pairs, (std::set<std::set<std::string_view>>{{"L-sign", "Ia-twice"}, {"V-sign", "Ia-twice"}}));
  d = students.diagnosed({.mistake = "R-without-2", .second = "Ia-twice"});
  ASSERT_EQ(d.verdict, Marking::Mistake);
  EXPECT_EQ((std::set{d.found[0].first->key, d.found[0].second->key}),
            (std::set<std::string_view>{"R-without-2", "Ia-twice"}));
  d = students.diagnosed({.variant = "V-constant", .second = "mean-of-corners"});
  EXPECT_TRUE(isRight(d));
}

// Another camera, another size and an empty picture are another scene; the pixel where a mistake shows has
// the picture's own value.
TEST(Diagnose, LooksAtOutlinesFirst) {
  Students students{"bench-n3", Shading::Flat, TableKind::Linear};
  Diagnoser& diagnoser = *students.diagnoser;
  student::World& world = students.world;
  student::Program program{.mistake = "L-sign", .width = 320, .height = 240};
  const student::Result drawn = student::draw(world, program);
  const Diagnosis wrong = diagnoser(handedInBy(drawn));
  ASSERT_TRUE(wrong.pixel);
  EXPECT_EQ(wrong.pixel->yours[0],
            drawn.red[static_cast<std::size_t>(wrong.pixel->j) * 320 + wrong.pixel->i]);
  EXPECT_EQ(wrong.pixel->yours[0], wrong.pixel->mistaken[0]);
  EXPECT_NE(wrong.pixel->right[0], wrong.pixel->mistaken[0]);
  world.eye[0] += 0.5;
  EXPECT_EQ(diagnoser(handedInBy(student::draw(world, program))).verdict, Marking::OtherScene);
  program.width = 300;
  const Diagnosis narrow = diagnoser(handedInBy(student::draw(world, program)));
  EXPECT_EQ(narrow.verdict, Marking::OtherScene);
  EXPECT_TRUE(narrow.isOtherSize);
  HandedIn empty{.picture = RgbImage{320, 240}, .cells = {}, .held = {}};
  std::ranges::fill(empty.picture.rgb, std::uint8_t{128});
  const Diagnosis gray = diagnoser(empty);
  EXPECT_EQ(gray.verdict, Marking::OtherScene);
  EXPECT_TRUE(gray.isOneColor && !gray.isOtherSize);
  // All black may come from values of 8 bits where the server takes 16, or from much else.
  std::ranges::fill(empty.picture.rgb, std::uint8_t{0});
  const Diagnosis black = diagnoser(empty);
  EXPECT_TRUE(black.isBlack);
  EXPECT_TRUE(std::ranges::all_of(black.found, [](const Fit& f) { return f.first->way.view != nullptr; }));
}

// Other numbers are told as numbers: y and z of the light swapped.
TEST(Diagnose, TriesLikelyNumbers) {
  Students students{"bench-n3", Shading::Flat, TableKind::Linear};
  std::swap(students.world.light[1], students.world.light[2]);
  const Diagnosis d = students.diagnosed({});
  ASSERT_EQ(d.verdict, Marking::Numbers);
  EXPECT_EQ(d.found[0].first->key, "light-yz");
}

/// ---- Mistakes of the view

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

constexpr const char* kPlanted =
    "view-T-after-R view-S-first R-angles-negated R-in-degrees fov-in-degrees R-transposed "
    "view-transposed rows-for-columns R-wrong-axis w-not-divided divided-before-clipping "
    "aspect-inverted aspect-forgotten fov-not-halved fov-horizontal v-is-VUP VPN-reversed "
    "u-left-handed eye-and-look-at-exchanged shear-forgotten shear-negated "
    "window-centre-forgotten viewport-half-pixel viewport-one-short flip-y near-plane-negated "
    "z-not-kept N-not-turned N-by-M N-scaled L-not-moved";

// Each mistake of the viewing transformation, planted on three scenes, gets its name or a class with it, and
// none a wrong name. A mistake that changes no pixel is right.
TEST(View, NamesThePlantedMistake) {
  int planted = 0, named = 0;
  std::string others;
  for (const Looks& looks : kLooks) {
    Viewer viewer{looks};
    const auto right = student::draw(viewer.world, viewer.program).cell;
    std::istringstream keys{kPlanted};
    for (std::string key; keys >> key;) {
      const Diagnosis d = viewer.diagnosed(key);
      if (student::draw(viewer.world, viewer.program).cell == right) continue;
      ++planted;
      const bool isNamed = std::ranges::any_of(d.found, [&](const Fit& f) {
        return f.first->key == (key == "z-not-kept" ? "order-none" : key) && !f.second;
      });
      named += isNamed;
      const std::string names = namesOf(d);
      if (!isNamed)
        others += looks.scene + ' ' + key + ':' + names + " overlap " + std::to_string(d.outlines.overlap) +
                  " verdict " + std::to_string(int(d.verdict)) + '\n';
      const bool accuses =
          d.verdict == Marking::Mistake || d.verdict == Marking::OneOf || d.verdict == Marking::Numbers;
      EXPECT_TRUE(isNamed || !accuses) << looks.scene << ' ' << key << ':' << names;
    }
  }
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
        misnamed += looks.scene + ' ' + std::to_string(what) + ' ' + std::to_string(by) + namesOf(d) + '\n';
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
          << key << ' ' << shades << namesOf(d);
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
          EXPECT_TRUE(isRight(d)) << looks.scene << ' ' << variant << ' ' << int(d.verdict) << namesOf(d);
        }
    }
}

}  // namespace

}  // namespace xnewell::THIS_FILE
