#include "shading/diagnose/other_program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "shading/diagnose/diagnose.h"
#include "shading/picture/picture_cache.h"
#include "tests/support/seeds.h"

namespace xnewell::THIS_FILE {

namespace {

PictureSettings settingsFor(const Scene& scene, Shading method) {
  PictureSettings s = scene.settings;
  s.camera = scene.camera, s.shading = method;
  s.width = 320, s.height = 240;
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

}  // namespace

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
      HandedIn handed{.picture = RgbImage{s.width, s.height}, .cells = {}, .held = {}};
      for (std::size_t k = 0; k < picture.image().pixels.size(); ++k) {
        const Rgb16 held = palette[picture.image().pixels[k]];
        handed.picture.rgb[3 * k] = static_cast<std::uint8_t>(held.r >> 8);
        handed.picture.rgb[3 * k + 1] = static_cast<std::uint8_t>(held.g >> 8);
        handed.picture.rgb[3 * k + 2] = static_cast<std::uint8_t>(held.b >> 8);
      }
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

}  // namespace xnewell::THIS_FILE
