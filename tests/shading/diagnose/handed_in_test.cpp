#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <set>
#include <string>

#include "depthsort/order.h"
#include "geometry/files/parse_error.h"
#include "shading/color/png.h"
#include "shading/diagnose/diagnose.h"
#include "shading/diagnose/handed_in.h"
#include "shading/diagnose/judge_order.h"
#include "shading/diagnose/other_program.h"
#include "shading/diagnose/scene_for.h"
#include "shading/laboratory/errors.h"
#include "shading/picture/picture_cache.h"
#include "shading/scene/scene_file.h"
#include "tests/support/full_color_picture.h"
#include "tests/support/reader_fixture.h"
#include "tests/support/seeds.h"
#include "tests/support/small_picture.h"

namespace xnewell::THIS_FILE {

namespace {

/// ---- Pictures that are handed in

class HandedInFile : public ::testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& bytes) { return folder_.write(name, bytes); }
  void refused(const std::string& bytes, const std::string& why) {
    const std::string file = write("bad", bytes);
    EXPECT_THAT(complaint([&] { return readHandedIn(file); }), ::testing::HasSubstr(why));
  }
  TemporaryFolder folder_;
};

/// Numbers of four bytes, the highest byte first.
std::string big(std::initializer_list<std::uint32_t> numbers) {
  std::string bytes;
  for (const std::uint32_t n : numbers)
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(n >> shift & 255);
  return bytes;
}

/// The head of a window dump of 2 x 1 pixels.
std::string xwdHead(std::uint32_t bits, std::uint32_t line, std::uint32_t visual, std::uint32_t colors,
                    std::uint32_t lowFirst) {
  return big({100,    7,      2,    bits, 2,      1,        0,        lowFirst ? 0u : 1u, 32,
              0,      32,     bits, line, visual, 0xFF0000, 0x00FF00, 0x0000FF,           8,
              colors, colors, 2,    1,    0,      0,        0});
}

std::string little(std::initializer_list<std::int64_t> numbers) {
  std::string bytes;
  for (const std::int64_t n : numbers)
    for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(n >> shift & 255);
  return bytes;
}

/// A BMP file: its head, what follows it, and its rows.
std::string bmp(int width, int height, int bits, int packing, const std::string& more = "",
                const std::string& rows = std::string(8, 'a')) {
  return "BM" +
         little({0, 0, 54 + int(more.size()), 40, width, height, bits << 16 | 1, packing, 0, 0, 0,
                 bits == 8 ? 2 : 0, 0}) +
         more + rows;
}

// One picture of two pixels, as each kind of file.
TEST_F(HandedInFile, IsReadByWhatIsInIt) {
  RgbImage image{2, 1};
  image.rgb = {200, 10, 0, 1, 2, 3};
  EXPECT_EQ(readHandedIn(write("a.txt", encodePng(image))).picture, image);
  const std::string samples{"\xC8\x0A\x00\x01\x02\x03", 6};
  EXPECT_EQ(readHandedIn(write("a.ppm", "P6 # a comment\n2 1\n255\n" + samples)).picture, image);
  const std::string wide{"\xC8\xC8\x0A\x0A\x00\x00\x01\x01\x02\x02\x03\x03", 12};
  EXPECT_EQ(readHandedIn(write("a.ppm", "P6 2 1 65535\n" + wide)).picture, image);
  EXPECT_EQ(readHandedIn(write("a.ppm", "P3\n2 1 255\r\n200 10 0\t1 # end\n2 3")).picture, image);
  const std::string low{"\x00\x0A\xC8\x00\x03\x02\x01\x00", 8}, high{"\x00\xC8\x0A\x00\x00\x01\x02\x03", 8};
  EXPECT_EQ(readHandedIn(write("a.xwd", xwdHead(32, 8, 4, 0, 1) + low)).picture, image);
  EXPECT_EQ(readHandedIn(write("a.xwd", xwdHead(32, 8, 4, 0, 0) + high)).picture, image);
}

// A picture of two rows as BMP files have it: rows from below or from above, with what fills them up.
TEST_F(HandedInFile, ReadsBmp) {
  RgbImage image{1, 2};
  image.rgb = {255, 0, 0, 0, 255, 255};
  const std::string red{"\0\0\xFF\0", 4}, cyan{"\xFF\xFF\0\0", 4};
  EXPECT_EQ(readHandedIn(write("a", bmp(1, 2, 24, 0, "", cyan + red))).picture, image);
  EXPECT_EQ(readHandedIn(write("a", bmp(1, -2, 32, 0, "", red + cyan))).picture, image);
  const std::string red555{"\0\x7C\0\0", 4}, cyan555{"\xFF\x03\0\0", 4};
  EXPECT_EQ(readHandedIn(write("a", bmp(1, 2, 16, 0, "", cyan555 + red555))).picture, image);
  const std::string masks = little({0xF, 0xF0, 0xF00}), red444{"\x0F\0\0\0", 4}, cyan444{"\xF0\x0F\0\0", 4};
  EXPECT_EQ(readHandedIn(write("a", bmp(1, 2, 16, 3, masks, cyan444 + red444))).picture, image);
  const HandedIn in =
      readHandedIn(write("a", bmp(1, 2, 8, 0, cyan + red, std::string{"\0\0\0\0\1\0\0\0", 8})));
  EXPECT_EQ(in.picture, image);
  ASSERT_TRUE(in.cells);
  EXPECT_EQ(in.cells->pixels, (std::vector<std::uint8_t>{1, 0}));
}

// A palette keeps its indices, also with few bits a pixel.
TEST_F(HandedInFile, KeepsCells) {
  IndexImage cells{2, 1, 0};
  cells.pixels = {11, 250};
  Palette palette = scattered(1);
  palette[11] = {0x1200, 0, 0}, palette[250] = {0xF000, 0x100, 0};
  const HandedIn in = readHandedIn(write("a.png", encodePng(cells, palette)));
  ASSERT_TRUE(in.cells);
  EXPECT_EQ(*in.cells, cells);
  EXPECT_EQ(in.held[250], (std::array<std::uint8_t, 3>{0xF0, 1, 0}));
  for (int c = 0; c < 256; ++c) EXPECT_EQ(in.held[c][0], palette[c].r >> 8) << "used or not";
  EXPECT_EQ(in.picture.pixel(0, 0)[0], 0x12);

  std::string dump = xwdHead(8, 4, 3, 2, 1);
  dump.replace(4 * 14, 12, big({0, 0, 0}));  // no masks
  dump += big({11, 0x12000000, 0, 250, 0xF0000100, 0});
  dump += std::string{"\x0B\xFA\x00\x00", 4};
  const HandedIn window = readHandedIn(write("a.xwd", dump));
  ASSERT_TRUE(window.cells);
  EXPECT_EQ(*window.cells, cells);
  EXPECT_EQ(window.picture.pixel(1, 0)[0], 0xF0);
}

// A file that is not whole, not what it says, or too large is refused in one line, before memory is taken
// for it.
TEST_F(HandedInFile, RefusesBrokenFiles) {
  refused("", "not a PNG, PPM, BMP or XWD picture");
  refused("hello", "not a PNG, PPM, BMP or XWD picture");
  refused("\x89PNG", "not a PNG file");
  refused("P6 2 1 255\nabc", "the file ends early");
  refused("P6 2", "the file ends early");
  refused("P6 99999 99999 255\nabc", "larger than 8192 pixels");
  refused("P6 2 1 70000\nabc", "65535");
  refused("P6 -2 1 255\nabc", "no whole number");
  refused("P3 2 1 255 1 2 3 4 5 x", "no whole number");
  refused("P3 8000 8000 255 1 2 3", "the file ends early");
  refused("\xFF\xD8\xFF\xE0", "a JPEG picture; its compression changes the colours");
  refused(bmp(2, 1, 24, 0).substr(0, 60), "the file ends early");
  refused(bmp(-2, 1, 24, 0), "larger than 8192");
  refused(bmp(2, 1, 4, 0), "no 8, 16, 24 or 32 bits");
  refused(bmp(2, 1, 8, 1), "compressed");
  refused(xwdHead(32, 8, 4, 0, 1) + "abc", "the file ends early");
  refused(xwdHead(32, 4, 4, 0, 1) + "abcdefgh", "the rows of the window dump do not fit");
  refused(xwdHead(1, 4, 4, 0, 1) + "abcdefgh", "no 8, 16, 24 or 32 bits");
  refused(xwdHead(32, 8, 4, 0xFFFFFFFF, 1), "too many colours");
  std::string huge = xwdHead(32, 0x7FFFFFF0, 4, 0, 1);
  huge.replace(4 * 4, 8, big({8192, 8192}));
  refused(huge, "do not fit");
  EXPECT_THROW((void)readHandedIn((folder_.path() / "none").string()), std::system_error);
  EXPECT_THROW((void)readHandedIn(folder_.path().string()), std::system_error);
  EXPECT_THROW((void)readHandedIn("/dev/zero"), ParseError);
}

// Files with changed bytes are read or refused; nothing else happens.
TEST_F(HandedInFile, SurvivesChangedBytes) {
  IndexImage cells{20, 10, 3};
  Palette palette{};
  const std::vector<std::string> whole{encodePng(cells, palette),
                                       "P3 2 1 255 1 2 3 4 5 6",
                                       bmp(1, 2, 8, 0, std::string(8, 'b')),
                                       bmp(2, 1, 24, 0),
                                       "P6 4 2 255\n" + std::string(24, 'a'),
                                       xwdHead(32, 8, 4, 0, 1) + "abcdefgh"};
  for (unsigned seed = 0; seed < 300; ++seed) {
    std::mt19937 rng{seed};
    std::string bytes = whole[seed % whole.size()];
    for (int k = 0; k < 3; ++k) bytes[rng() % bytes.size()] = static_cast<char>(rng());
    if (seed % 5 == 0) bytes.resize(rng() % bytes.size());
    const std::string file = write("changed", bytes);
    try {
      EXPECT_LE(readHandedIn(file).picture.width, 8192);
    } catch (const ParseError&) {
    }
  }
}

/// ---- Pictures by other programs

PictureSettings settingsFor(const Scene& scene, Shading method) {
  PictureSettings s = setUpOf(scene, 320, 240);
  s.shading = method;
  return s;
}

struct Compared {
  int samples = 0, different = 0, most = 0;
};

/// Compares the cells of a picture with those of a program that works in some way, at the samples.
Compared compared(const Scene& scene, const PictureSettings& settings, const Approach& way,
                  PictureSettings drawn) {
  Diagnoser diagnoser{scene, settings};
  drawn.order = Order::Oracle;
  const Picture picture = makePicture(scene, drawn, std::uint8_t{0});
  Compared all;
  const auto predicted = diagnoser.predicted(way);
  for (std::size_t k = 0; k < predicted.size(); ++k) {
    const DiagnosedSample& s = diagnoser.samples()[k];
    const int off = std::abs(picture.image().row(s.j)[s.i] - predicted[k].cell);
    ++all.samples, all.different += off > 0, all.most = std::max(all.most, off);
  }
  return all;
}

constexpr std::array kMethods{Shading::Flat, Shading::Gouraud, Shading::Phong};

// Without a mistake the other program has the cells of the picture. Both round an intensity once, so a tie
// may fall the other way: one cell in 500 may be off by one.
TEST(OtherProgram, HasThePicturesCells) {
  const std::vector<std::string> scenes{"bench", "teapot", "spotlight", "lamp", "highlight", "textured-cube"};
  for (const std::string& name : someOf(scenes, 2))
    for (const Shading method : kMethods)
      for (const TableKind table : {TableKind::Linear, TableKind::Corrected}) {
        SCOPED_TRACE(name + ' ' + std::string{rowOf(method).name});
        const Scene scene = readScene(name);
        PictureSettings s = settingsFor(scene, method);
        s.table.kind = table, s.colors = ColorPlan::OneHue;
        const Compared c = compared(scene, s, {}, s);
        EXPECT_GT(c.samples, 500);
        EXPECT_LE(c.most, 1);
        EXPECT_LE(c.different, c.samples / 500 + 1);
      }
}

// Each mistake of the editable equation is the same picture by both programs.
TEST(OtherProgram, HasTheMistakesOfTheEquation) {
  const Scene scene = readScene("bench-n3");
  std::set<std::string_view> seen;
  for (const Shading method : kMethods)
    for (const MistakeRow& row : kMistakes) {
      if (row.id == Mistake::None) continue;
      SCOPED_TRACE(std::string{row.name} + ' ' + std::string{rowOf(method).name});
      const Hypothesis* const h = hypothesisNamed(row.name);
      ASSERT_NE(h, nullptr);
      EXPECT_EQ(h->sentence, row.is);
      PictureSettings s = settingsFor(scene, method), drawn = s;
      s.normals = drawn.normals = NormalRule::Sum;
      drawn.light.mistake = row.id;
      const Compared c = compared(scene, s, h->way, drawn);
      // The sum of long normals is another direction than the sum of unit ones, which xnewell lengthens.
      if (row.id == Mistake::NotUnitN && method != Shading::Flat) continue;
      EXPECT_LE(c.most, 1);
      EXPECT_LE(c.different, c.samples / 500 + 1);
      seen.insert(row.name);
    }
  EXPECT_EQ(seen.size(), kMistakes.size() - 1);
}

// Pictures of several hues, of coloured lights and of textures are right, and a mistake in them has its name.
TEST(Diagnose, ReadsColours) {
  for (const std::string name : someOf({"hues", "colored-lights", "textured-cube"}, 1))
    for (const Mistake mistake : {Mistake::None, Mistake::ReversedL}) {
      SCOPED_TRACE(name + ' ' + std::string{rowOf(mistake).name});
      const Scene scene = readScene(name);
      PictureSettings s = settingsFor(scene, Shading::Flat), drawn = s;
      drawn.light.mistake = mistake;
      const Picture picture = makePicture(scene, drawn, std::uint8_t{1});
      const Palette palette = picture.palette(CellPlan{});
      const HandedIn handed{.picture = shown(picture.image(), palette, 0), .cells = {}, .held = {}};
      Diagnoser diagnoser{scene, s};
      const Diagnosis d = diagnoser(handed);
      EXPECT_FALSE(d.oneHue);
      if (mistake == Mistake::None) {
        EXPECT_EQ(d.verdict, Marking::Right);
      } else {
        EXPECT_TRUE(std::ranges::any_of(d.found, [](const Fit& f) { return f.first->key == "L-sign"; }));
      }
    }
}

// The keys are names: each stands for one sentence, and mistakes and what the course allows share none.
TEST(Hypotheses, HaveOneSentenceForEachKey) {
  for (const Hypothesis& a : hypotheses()) {
    EXPECT_FALSE(a.sentence.empty());
    EXPECT_TRUE(a.sentence.ends_with('.')) << a.key;
    EXPECT_EQ(a.term.empty(), a.meaning == Meaning::Right) << a.key;
    for (const Hypothesis& b : hypotheses())
      if (a.key == b.key) {
        EXPECT_EQ(a.sentence, b.sentence);
        EXPECT_EQ(a.meaning, b.meaning);
      }
  }
  EXPECT_EQ(mistakesKnown(), 112);
}

// A row that applies does something else than the settings say.
TEST(Hypotheses, ChangeTheWay) {
  for (const Hypothesis& h : hypotheses())
    for (const Shading method : kMethods) {
      PictureSettings s;
      s.shading = method;
      const bool changes = h.meaning != Meaning::Right && (!h.applies || h.applies(s));
      EXPECT_TRUE(!changes || h.way.with(s) != Approach{}.with(s)) << h.key;
    }
}

/// ---- Orders that are judged

Picture pictureOf(const Scene& scene) {
  PictureSettings s = setUpOf(scene, 160, 120);
  s.order = Order::Unsorted, s.shading = Shading::Full;
  return makePicture(scene, s, std::uint8_t{0}).withPlanes();
}

std::vector<PaintStep> stepsOf(const std::vector<int>& faces) {
  std::vector<PaintStep> steps;
  for (std::size_t k = 0; k < faces.size(); ++k) steps.push_back({faces[k], {}, static_cast<int>(k) + 1});
  return steps;
}

/// The distance from the eye to the plane of a polygon, along the ray of the sample of pixel (i, j). It
/// starts from the camera's numbers and shares nothing with the sort.
double depthAlongRay(const Picture& picture, const std::vector<glm::dvec3>& polygon, int i, int j) {
  const ViewSpec& view = picture.camera().view;
  const PictureSettings& s = picture.settings();
  const glm::dvec3 n = glm::normalize(view.vpn), u = glm::normalize(glm::cross(view.vup, n)),
                   v = glm::cross(n, u);
  const glm::dvec2 size = view.windowMax - view.windowMin;
  const double x = view.windowMin.x + size.x * (i + 0.5) / s.width,
               y = view.windowMax.y - size.y * (j + 0.5) / s.height;
  const glm::dvec3 eye = view.vrp + view.prp.x * u + view.prp.y * v + view.prp.z * n;
  const glm::dvec3 through = view.vrp + x * u + y * v;
  const double unit = std::ldexp(1.0, picture.scene().exponent);
  const glm::dvec3 a = polygon[0] / unit, N = glm::cross(polygon[1] - polygon[0], polygon[2] - polygon[0]);
  return glm::dot(a - eye, N) / glm::dot(through - eye, N);
}

// The faces in the order of an exact sort without cuts are right, and so is any order of faces that the
// picture shows right.
TEST(JudgeOrder, FindsRightOrdersRight) {
  for (const std::string name : someOf({"room", "three-cards", "shingles", "decals", "makie-4693"}, 2)) {
    const Scene scene = readScene(name);
    const Picture unsorted = pictureOf(scene);
    PictureSettings s = unsorted.settings();
    s.order = Order::Newell, s.shading = scene.settings.shading;
    const Picture sorted = makePicture(scene, s);
    std::vector<int> faces;
    for (const Fragment& f : sorted.sorted().fragments) {
      ASSERT_LT(f.piece, 0) << name;
      faces.push_back(sorted.snapped().faces[f.face].number);
    }
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    const OrderReport report = judgeOrder(unsorted, stepsOf(faces));
    EXPECT_TRUE(report.isRight()) << name;
  }
}

// Sixty wrong orders: the pair that is named is wrong by rays, what it says of a test or a cut is so, and the
// two polygons alone show it again at the same pixel.
TEST(JudgeOrder, ShowsTheFirstWrongPairAlone) {
  int wrong = 0, cuts = 0, told = 0;
  const std::array<std::string, 6> names{"room", "crossing-sheets", "cycle", "slivers", "tori", "penetrate"};
  for (unsigned seed = 0; seed < (kSanitized ? 6u : 60u); ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 rng{seed};
    const Scene scene = readScene(names[seed % names.size()]);
    const Picture picture = pictureOf(scene);
    std::vector<int> faces(static_cast<std::size_t>(scene.mesh.faceCount()));
    std::iota(faces.begin(), faces.end(), 0);
    std::shuffle(faces.begin(), faces.end(), rng);
    const std::vector<PaintStep> steps = stepsOf(faces);
    const OrderReport report = judgeOrder(picture, steps);
    if (report.wrongSamples == 0) continue;
    ++wrong;
    ASSERT_TRUE(report.first);
    const WrongPair& pair = *report.first;
    EXPECT_GT(pair.shown, pair.hidden);  // it is painted later
    const auto shown = stepInWorld(picture, steps[pair.shown]),
               hidden = stepInWorld(picture, steps[pair.hidden]);
    EXPECT_LT(depthAlongRay(picture, hidden, pair.i, pair.j), depthAlongRay(picture, shown, pair.i, pair.j));

    const Scene alone = parseSceneFile(pairAsScene(picture, pair, steps), "pair", ".");
    const Picture again = pictureOf(alone);
    const std::size_t at = static_cast<std::size_t>(pair.j) * 160 + pair.i;
    EXPECT_EQ(again.faceImage()[at], 2u);  // the second face, which should be hidden
    const std::vector<SampleCheck> checks = checkedSamples(again);
    EXPECT_TRUE(isWrong(checks[at]));
    cuts += pair.needsCut, told += pair.told.has_value() && !pair.needsCut;
    // Only a cut helps if the two cross: then the other order is wrong somewhere, too.
    if (pair.cycle.size() != 3) continue;
    const OrderReport other = judgeOrder(picture, stepsOf({steps[pair.shown].face, steps[pair.hidden].face}));
    EXPECT_GT(
        other.wrongSamples +
            judgeOrder(picture, stepsOf({steps[pair.hidden].face, steps[pair.shown].face})).wrongSamples,
        0);
  }
  if (kSanitized) return;
  EXPECT_EQ(wrong, 60);
  EXPECT_GT(cuts, 5);
  EXPECT_GT(told, 5);
}

// A face that shows and is not painted, one that is painted twice, and pieces that overlap or leave a gap.
TEST(JudgeOrder, CountsFacesAndPieces) {
  const Scene scene = readScene("three-cards");
  const Picture picture = pictureOf(scene);
  OrderReport report = judgeOrder(picture, stepsOf({0, 1}));
  EXPECT_EQ(report.missing, std::vector{2});
  report = judgeOrder(picture, stepsOf({0, 1, 2, 1}));
  EXPECT_EQ(report.repeated, std::vector{1});

  std::vector<PaintStep> steps = stepsOf({0, 1, 2});
  const OrderReport whole = judgeOrder(picture, steps);
  steps.push_back({2, {{0, 0}, {80, 0}, {80, 120}}, 4});
  EXPECT_EQ(judgeOrder(picture, steps).repeated, std::vector{2}) << "whole and in a piece";
  steps.pop_back();
  steps[0].piece = {{0, 0}, {80, 0}, {80, 120}, {0, 120}};
  steps.insert(steps.begin() + 1, PaintStep{0, {{80, 0}, {160, 0}, {160, 120}, {80, 120}}, 9});
  report = judgeOrder(picture, steps);
  EXPECT_TRUE(report.covers.empty());
  EXPECT_EQ(report.wrongSamples, whole.wrongSamples);
  ASSERT_EQ(report.outside.size(), 2u) << "halves of the screen are no pieces";
  EXPECT_EQ(report.outside[1].step, 1);
  EXPECT_FALSE(report.isRight());
  steps[1].piece[0].x = steps[1].piece[3].x = 70;
  report = judgeOrder(picture, steps);
  ASSERT_EQ(report.covers.size(), 1u);
  EXPECT_EQ(report.covers[0].times, 2);
  steps[1].piece[0].x = steps[1].piece[3].x = 90;
  report = judgeOrder(picture, steps);
  ASSERT_EQ(report.covers.size(), 1u);
  EXPECT_EQ(report.covers[0].times, 0);
}

// Three bars, each over the next: whatever the order, only a cut helps, and the cycle is named.
TEST(JudgeOrder, NamesACycle) {
  const Scene scene = readScene("cycle");
  const Picture picture = pictureOf(scene);
  std::vector<int> order{0, 1, 2};
  do {
    const OrderReport report = judgeOrder(picture, stepsOf(order));
    ASSERT_TRUE(report.first);
    EXPECT_TRUE(report.first->needsCut);
    ASSERT_EQ(report.first->cycle.size(), 4u);
    EXPECT_EQ(report.first->cycle.front(), report.first->cycle.back());
  } while (std::ranges::next_permutation(order).found);
}

// Lines that are no steps are refused with their number.
TEST(PaintSteps, AreReadOrRefused) {
  const TemporaryFolder folder;
  const auto [steps, size] = readPaintOrder(
      folder.write("a", "{\"face\": 2}\n\n{\"face\": 0, \"piece\": [[1, 2], [3.5, 4], [5, 6]]}\n"), 3);
  EXPECT_FALSE(size);
  ASSERT_EQ(steps.size(), 2u);
  EXPECT_EQ(steps[0].face, 2);
  EXPECT_EQ(steps[1].line, 3);
  EXPECT_EQ(steps[1].piece[1], (glm::dvec2{3.5, 4}));
  const auto refused = [&](const std::string& text, const std::string& why) {
    try {
      (void)readPaintOrder(folder.write("a", text), 3);
      ADD_FAILURE() << text;
    } catch (const ParseError& e) {
      EXPECT_THAT(e.what(), ::testing::HasSubstr(why));
    }
  };
  refused("", "no line paints a face");
  refused("{\"face\": 1}\n{\"face\": 3}", "a:2: the scene has no face 3: its faces are 0 to 2");
  refused("{\"face\": -1}", "no face -1");
  refused("{\"face\": 1e99}", "\"face\" is the number of a face");
  refused("[1]", "not a JSON object");
  refused("{\"face\": 1, \"pece\": 1}", "unknown key 'pece'");
  refused("{\"face\": 1, \"piece\": [[1, 2], [3, 4]]}", "3 to 1000 corners");
  refused("{\"face\": 1, \"piece\": [[1, 2], [3, 4], [5, 1e9]]}", "a million pixels");
  refused("{\"face\": 1, \"piece\": [[1, 2], [3, 4], [5]]}", "[x, y]");
  refused("{\"face\": 1, \"face\": 2}", "a:1: the key 'face' appears twice in an object");
  refused("{\"face\": 1}\n{\"face\": 0, \"face\": 2}", "a:2: the key 'face' appears twice in an object");

  // The size, and the same text again.
  const std::string sized =
      "{\"size\":[572,284]}\n{\"face\":2}\n{\"face\":0,\"piece\":[[1.0,2.0],[3.5,4.0],[5.0,6.0]]}\n";
  const PaintOrder order = readPaintOrder(folder.write("a", sized), 3);
  EXPECT_EQ(order.size, (glm::ivec2{572, 284}));
  EXPECT_EQ(order.steps.front().line, 2);
  EXPECT_EQ(paintOrderText(order.steps, order.size), sized);
  EXPECT_EQ(paintOrderText(order.steps, {}), sized.substr(sized.find('\n') + 1));
  const std::string bounds = "a:1: the size is {\"size\": [width, height]}, each from 64 to 4096 pixels";
  for (const char* const wrong : {"[572]", "[572, 284.0]", "[63, 284]", "[572, 4097]", "\"572x284\"",
                                  "[572, 284], \"face\": 1", "[18446744073709551615, 284]"})
    refused("{\"size\": " + std::string{wrong} + "}\n{\"face\": 1}", bounds);
  refused("{\"size\": [572, 284]}", "no line paints a face");
  refused("{\"size\": [572, 284]}\n{\"size\": [572, 284]}\n{\"face\": 1}",
          "a:2: the size stands once, before all faces");
  refused("{\"face\": 1}\n{\"size\": [572, 284]}", "a:2: the size stands once, before all faces");
}

}  // namespace

}  // namespace xnewell::THIS_FILE
