#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "shading/picture/picture_cache.h"
#include "tests/x11/support/ready_workbench.h"
#include "tests/x11/support/staged_view.h"
#include "x11/drawing/wording.h"
#include "x11/kit/typed_line.h"
#include "x11/lessons/lesson.h"
#include "x11/pixel/pixel_page.h"
#include "x11/pixel/pixel_view.h"

namespace xnewell::THIS_FILE {

namespace {

/// A window at view 8.
struct PixelWindow : ReadyWorkbench {
  explicit PixelWindow(const char* scene = "teapot", int width = 1024, int height = 768)
      : ReadyWorkbench{{}, width, height, scene} {
    does('8');
  }
  [[nodiscard]] std::string status() const { return bench().status(); }
  /// The cell of the picture's pixel that the status line names.
  [[nodiscard]] int cellThere() const {
    int i = 0, j = 0;
    EXPECT_EQ(std::sscanf(status().c_str(), "pixel %d, %d", &i, &j), 2) << status();
    const Rect at = bench().frame(layout());
    PictureSettings settings = setup().picture;
    settings.width = at.width, settings.height = at.height;
    PictureCache pictures{readScene("teapot", 3)};
    return pictures.make(settings, ground()).image().row(j)[i];
  }
};

/// Small pictures of a scene by its own camera.
struct Pictures : PictureCache {
  Pictures(const char* name, int width, int height) : PictureCache{readScene(name, 4)} {
    settings.camera = scene().camera;
    settings.width = width, settings.height = height;
  }
  PictureSettings settings = scene().settings;
  Picture make(std::uint8_t ground = 0) { return PictureCache::make(settings, ground); }
};

std::shared_ptr<const PixelStory> storyAt(const Picture& picture, int i, int j) {
  return std::make_shared<const PixelStory>(picture, i, j);
}

Picture made(Shading method, const char* scene = "teapot") {
  Pictures pictures{scene, 120, 90};
  pictures.settings.shading = method;
  return pictures.make(8);
}

page::Page pageOf(const Picture& picture) {
  return page::ofPixel(storyAt(picture, 45, 45), {.vertex = 0, .channel = 0});
}

/// View 8 of a window, with the line that the student types on.
struct Asked : StagedView {
  Asked() : StagedView{"teapot", 4, 1024, 768} { draws(); }
  void draws() {
    std::ranges::fill(image.pixels, std::uint8_t{0});
    draw(bench);
  }
  void predicts() {
    press(bench, "y");
    line.ask(question.value());
    draws();
  }
  void types(const std::string& text) {
    for (int k = 0; k < 8; ++k) line.press(NamedKey::Backspace);  // what was not accepted
    for (const char c : text) line.press({NamedKey::Letter, c});
    line.press(NamedKey::Return);
    draws();
  }
  void showsAll() {
    press(bench, NamedKey::Escape);
    draws();
  }
  void givesUp() {
    line.press(NamedKey::Escape);
    draws();
  }

  PixelView bench{*this, [this] { return Subject{pictures.scene(), glm::dvec3{0.0}, 1.5}; }};
  TypedLine line;
};

}  // namespace

// The arrows move by one pixel, with Shift by ten, and stay within the picture; g goes to a pixel by its
// numbers, and a click in this view's picture chooses the pixel there. A changed setting keeps the pixel, and
// the arrows after its letter are its own. In any method the cell that is explained is the one that the
// window shows.
TEST(PixelView, KeysChooseThePixel) {
  PixelWindow b;
  const auto expectPixel = [&](int i, int j) {
    b.finish();
    EXPECT_TRUE(b.status().starts_with("pixel " + std::to_string(i) + ", " + std::to_string(j) + " of "))
        << b.status();
    EXPECT_EQ(b.bench().inspected(), b.cellThere()) << rowOf(b.setup().picture.shading).name;
  };
  b.type("g300,200");
  b.does(NamedKey::Return);
  for (const Shading method :
       {Shading::Gouraud, Shading::Phong, Shading::Environment, Shading::Full, Shading::Depth}) {
    b.change('S', [&](xnewell::Setup& s) { s.picture.shading = method; });
    expectPixel(300, 200);
  }
  b.type("s");
  b.does(NamedKey::Right);  // the arrows are those of ks now
  expectPixel(300, 200);
  b.does(NamedKey::Escape);
  b.does(NamedKey::Right);
  b.does({NamedKey::Down, 0, true});
  expectPixel(301, 210);
  for (int k = 0; k < 60; ++k) b.press({NamedKey::Up, 0, true});
  expectPixel(301, 0);
  const Rect at = b.bench().picture(b.layout()), all = b.bench().frame(b.layout());  // shown smaller
  ASSERT_TRUE(b.grab(at.x + 30, at.y + 40));
  b.settle();
  expectPixel(61 * all.width / (2 * at.width), 81 * all.height / (2 * at.height));
}

// A question for a number of the page ends when the page has another pixel, and when the pixel is moved. The
// pixel is one of the teapot at the first size and one of the background at the second.
TEST(PixelView, AQuestionEndsWithItsPage) {
  for (const bool drags : {false, true}) {
    PixelWindow b;
    b.type("g252,389");
    b.does(NamedKey::Return);
    b.does('y');
    ASSERT_TRUE(b.isAsking());
    EXPECT_FALSE(b.bench().inspected()) << "hidden";
    if (drags) {
      const Rect at = b.bench().picture(b.layout());
      ASSERT_TRUE(b.grab(at.x + 5, at.y + 5));
      b.press('y');
      b.dragTo(at.x + 6, at.y + 5);
      b.settle();
    } else {
      b.resize(800, 600);
    }
    b.finish();
    EXPECT_FALSE(b.isAsking());
    EXPECT_TRUE(drags || b.status().find(": ground") != std::string::npos) << b.status();
    if (!b.bench().inspected()) b.does(NamedKey::Escape);  // it shows what is hidden still
    EXPECT_TRUE(b.bench().inspected());
  }
}

// The pixel is that of the step that the keys go to, however quickly they are pressed.
TEST(PixelView, ExplainsAStepThatIsNotDrawnYet) {
  std::vector<std::string> said;
  for (const bool waits : {true, false}) {
    ReadyWorkbench b;
    b.teach(readLesson(XNEWELL_DATA_DIR "/lessons/cycles.json"));
    for (const Key& key : {Key{NamedKey::PageDown}, Key{NamedKey::PageDown}, Key{'8'}}) {
      if (waits) b.finish();
      b.press(key);
    }
    EXPECT_EQ(b.view(), View::Pixel);
    b.finish();
    said.push_back(b.bench().status());
  }
  EXPECT_EQ(said.front(), said.back());
}

// More decimals than the page shows do not count. Terms may be typed as they are written, though they are
// rounded to add up.
TEST(Predict, RightIsAsItIsWritten) {
  const page::Question cosine{1, "N.L", 0.89476, 0.89476}, term{3, "the diffuse term", 0.56374, 0.5638};
  EXPECT_TRUE(cosine.judged(" 0.89481 ").isRight);
  for (const char* const right : {"0.5638", "0.5637"}) EXPECT_TRUE(term.judged(right).isRight) << right;
  EXPECT_FALSE(term.judged("0.5636").isRight);
}

// What the page writes is right for each value that it asks, in the order of the chain. Without an equation
// only the cell can be asked.
TEST(Predict, ValuesAreThoseOfTheChain) {
  const Picture phong = made(Shading::Phong);
  const std::vector<page::Question> all = pageOf(phong).questions;
  ASSERT_EQ(all.size(), 6u);
  for (std::size_t k = 0; k < all.size(); ++k) {
    EXPECT_EQ(static_cast<std::size_t>(all[k].rank), k + 1);
    EXPECT_TRUE(all[k].judged(fixed(all[k].written, all[k].decimals)).isRight) << all[k].name;
  }
  EXPECT_EQ(all.back().value, phong.image().row(45)[45]);
  EXPECT_NEAR(all[4].written, all[2].written + all[3].written + 0.18, 1e-9);
  const std::vector<page::Question> unlit = pageOf(made(Shading::Depth)).questions;
  ASSERT_EQ(unlit.size(), 1u);
  EXPECT_EQ(unlit.front().name, "the cell");
}

// y hides a number until it is typed: the words to copy and the mark in the strip are hidden too. Esc gives
// up and shows the number, and once more all of them.
TEST(Predict, HidesWhatIsAsked) {
  Asked view;
  const IndexImage before = view.image;
  const std::size_t words = view.bench.report().size();
  const int cell = view.bench.inspected().value();
  const auto expectHidden = [&] {
    EXPECT_NE(view.image, before) << "what follows can still be asked";
    EXPECT_FALSE(view.bench.inspected());
    EXPECT_EQ(view.bench.report().size(), 1u) << "only the pixel";
  };
  for (int k = 0; k < 5; ++k) {
    view.predicts();
    expectHidden();
    view.givesUp();
    expectHidden();
  }
  view.showsAll();
  EXPECT_EQ(view.image, before) << "all is shown again";
  EXPECT_EQ(view.bench.report().size(), words);

  // The last value is the cell. The strip marks the cell of an answer that is wrong. A cosine has none.
  view.predicts();
  view.types(std::to_string(cell - 1));
  EXPECT_TRUE(view.line.isOpen()) << "another try";
  EXPECT_EQ(view.bench.inspected(), cell - 1);
  EXPECT_TRUE(view.line.pick(cell));
  EXPECT_FALSE(view.line.isOpen());
  view.draws();
  view.predicts();
  EXPECT_FALSE(view.line.pick(cell));
}

// What was kept is hidden while a number is asked: it may be that number.
TEST(Predict, HidesWhatWasKept) {
  Asked plain, kept;
  kept.press(kept.bench, "k");
  kept.draws();
  EXPECT_NE(kept.image, plain.image);
  plain.predicts(), kept.predicts();
  EXPECT_EQ(kept.image, plain.image);
  kept.showsAll();
  EXPECT_NE(kept.image, plain.image);

  plain.predicts();
  const int cell = kept.bench.inspected().value();
  plain.press(plain.bench, "k");
  EXPECT_EQ(plain.notices.back().find(std::to_string(cell)), std::string::npos) << plain.notices.back();
}

// While a number is asked no other line gives it away: each value of the chain hides what follows from it.
TEST(Predict, NoLineTellsWhatIsAsked) {
  for (const Shading method : {Shading::Flat, Shading::Gouraud, Shading::Phong})
    for (const char* scene : {"teapot", "spotlight"}) {
      const page::Page page = pageOf(made(method, scene));
      std::string all;
      for (const std::string& line : page::asLines(page)) all += line + '\n';
      for (const page::Question& asked : page.questions) {
        std::string hidden;
        for (const std::string& line : page::asLines(page, {asked.rank})) hidden += line + '\n';
        const std::string value = fixed(asked.written, asked.decimals);
        EXPECT_NE(all.find(value), std::string::npos) << asked.name;
        EXPECT_NE(hidden.find('?'), std::string::npos) << asked.name;
        // Vectors and weights may have the same digits, but no value beside a name or a sign.
        for (const char* before : {"= ", "+ ", "N.L ", "R.V ", "I ", "cell "})
          if (std::abs(asked.written) > 1e-3) {
            EXPECT_EQ(hidden.find(before + value + '\n'), std::string::npos) << asked.name << '\n' << hidden;
          }
      }
      EXPECT_EQ(all.find('?'), std::string::npos);
    }
}

// Where the cells hold colours, each chain ends in the cell that the picture has: the nearest colour, or with
// dithering the colour of this place among the two that share its block.
TEST(PixelPage, ChainsEndInTheCellsOfColors) {
  for (const char* name : {"colored-lights", "textured-cube"}) {
    Pictures pictures{name, 64, 48};
    for (const ColorPlan plan : {ColorPlan::Cube, ColorPlan::Chosen})
      for (const bool dither : {false, true}) {
        SCOPED_TRACE(std::string{name} + (plan == ColorPlan::Cube ? ", cube" : "") +
                     (dither ? ", dithered" : ""));
        pictures.settings.colors = plan, pictures.settings.dither = dither;
        const Picture picture = pictures.make();
        int shown = 0;
        for (int j = 0; j < 48; j += 5)
          for (int i = j % 3; i < 64; i += 3) {
            const PixelStory story{picture, i, j};
            shown += story.shown() != nullptr;
            EXPECT_TRUE(story.isExplained()) << i << ',' << j;
          }
        EXPECT_GT(shown, 30);
      }
  }
}

// The upper bits of a stored value are the value divided by a power of two, rounded down.
TEST(PixelPage, AScreenShowsTheHighBits) {
  const auto story = storyAt(Pictures{"two-cards", 64, 48}.make(), 32, 24);
  ASSERT_TRUE(story->shown());
  Palette palette{};
  const auto said = [&](Rgb16 stored, int bits) {
    palette.fill(stored);
    return page::asText(page::ofPixel(story, {.channel = 0, .palette = &palette, .shownBits = bits}));
  };
  EXPECT_NE(said({52685, 255, 256}, 8).find("this screen shows the upper 8 bits: 205, 0, 1\n"),
            std::string::npos);
  EXPECT_NE(said({65535, 2047, 2048}, 5).find("the upper 5 bits: 31, 0, 1\n"), std::string::npos);
  EXPECT_NE(said({52685, 255, 256}, 16).find("all 16 bits: 52685, 255, 256\n"), std::string::npos);
}

// The written intensity lies in the written interval, by the decimals that are written, and so does the
// JSON's. The interval's ends are where the neighbours among the stored levels are as near. For every table,
// with I0 from 1e-300 to 0.999, and every method: the loops round differently.
TEST(PixelPage, TheIntervalHasTheIntensity) {
  struct Way {
    Shading shading;
    Interpolated interpolated = Interpolated::Intensity;
  };
  Pictures pictures{"teapot", 40, 30};
  PictureSettings& settings = pictures.settings;
  int checked = 0;
  for (const TableRow& row : kTables)
    for (const double I0 : {1e-300, 1e-9, 1e-6, 1e-4, 0.02, 0.3, 0.999})
      for (const auto& [shades, pick] : {std::pair{240, Pick::Log}, std::pair{64, Pick::Search}})
        for (const Way& way :
             {Way{Shading::Flat}, Way{Shading::Gouraud}, Way{Shading::Gouraud, Interpolated::Cell},
              Way{Shading::Phong}, Way{Shading::Depth}, Way{Shading::Environment}})
          for (const double light : {0.7, 1e-5}) {
            if (isEven(row.id) && I0 != 0.02) continue;
            settings.table = {.kind = row.id, .shades = shades, .I0 = I0, .pick = pick};
            settings.shading = way.shading, settings.interpolated = way.interpolated;
            settings.light.Ia = light / 5, settings.light.Ip = light;
            const Picture picture = pictures.make();
            for (int j = 1; j < 30; j += 4)
              for (int i = 1; i < 40; i += 3) {
                const auto story = storyAt(picture, i, j);
                if (story->shown() == nullptr) continue;
                const std::string page = page::asText(page::ofPixel(story, {}));
                const std::size_t begin = page.rfind("I ", page.find(" picks shade "));
                ASSERT_NE(begin, std::string::npos);
                const std::string text = page.substr(begin);
                SCOPED_TRACE(text);
                double I = 0, from = 0, to = 0;
                int shade = 0;
                ASSERT_EQ(std::sscanf(text.c_str(), "I %lf picks shade %d", &I, &shade), 2);
                // The first shade has no end below, the last none above.
                const char* const is = text.c_str() + text.find("that shade is for") + 18;
                const bool first = *is == 'I';
                const int read =
                    first ? std::sscanf(is, "I < %lf", &to) : std::sscanf(is, "%lf <= I < %lf", &from, &to);
                ASSERT_EQ(read, first || shade == shades - 1 ? 1 : 2);
                EXPECT_TRUE(from <= I && (I < to || shade == shades - 1));
                const ColorTable& table = picture.table();
                const auto between = [&](int k) -> long double {
                  const long double a = table.intensity(k), b = table.intensity(k + 1);
                  return row.id == TableKind::Corrected && pick == Pick::Log ? std::sqrt(a * b) : (a + b) / 2;
                };
                const long double least = shade > 0 ? between(shade - 1) : 0,
                                  most = shade + 1 < shades ? between(shade) : 1;
                const double inLoop = story->shown()->inLoop;
                EXPECT_TRUE(least * (1 - 0x1p-42L) <= inLoop && inLoop <= most * (1 + 0x1p-42L)) << inLoop;
                ++checked;
              }
          }
  EXPECT_GT(checked, 5'000);
}

// With a constant L, the share of a spot can be computed from the L that is said for the cone alone.
TEST(PixelPage, SaysWhichLTheConeHas) {
  Pictures pictures{"spotlight", 80, 60};
  pictures.settings.shading = Shading::Phong, pictures.settings.light.constantL = true;
  const Picture picture = pictures.make();
  const Light& spot = pictures.scene().light.lights.front();
  const auto cosineOf = [](double degrees) { return std::cos(degrees * std::acos(-1.0) / 180); };
  int edge = 0;
  for (int j = 0; j < 60; ++j)
    for (int i = 0; i < 80; ++i) {
      const auto story = storyAt(picture, i, j);
      if (!story->shown()) continue;
      const auto json = nlohmann::json::parse(page::asJson(page::ofPixel(story, {})));
      const auto light = json["equations"][0]["lights"][0];
      double dot = 0, length = 0;
      for (int c = 0; c < 3; ++c)
        dot -= light["L_for_cone"][c].get<double>() * spot.direction[c],
            length += spot.direction[c] * spot.direction[c];
      const double a = dot / std::sqrt(length), inner = cosineOf(spot.inner), outer = cosineOf(spot.outer);
      const double share = a >= inner   ? 1
                           : a <= outer ? 0
                                        : std::pow((a - outer) / (inner - outer), spot.falloff);
      ASSERT_NEAR(light["spot"].get<double>(), share, 1e-9) << i << ',' << j;
      edge += share > 0 && share < 1;
    }
  EXPECT_GT(edge, 20);
}

// What must be there in each window has room, for all methods, textures, colours and lights: the history,
// the formula with its numbers and its sum, and the chain's end. A larger window leaves nothing out that a
// smaller one has.
TEST(PixelPage, SaysWhatMattersInEverySize) {
  for (const char* scene : {"teapot", "colored-lights", "textured-cube", "spotlight", "shingles"})
    for (const Shading method : {Shading::Full, Shading::Depth, Shading::Flat, Shading::Gouraud,
                                 Shading::Phong, Shading::Environment}) {
      Pictures pictures{scene, 80, 60};
      pictures.settings.camera = {}, pictures.settings.shading = method;
      if (scene == std::string{"shingles"}) pictures.settings.order = Order::ZMean;
      const auto story = storyAt(pictures.make(8), 40, 34);
      if (!story->shown()) continue;
      std::size_t last = 99;
      for (const auto& [width, height, unit] :
           {std::tuple{800, 540, 1}, {1600, 1080, 2}, {1024, 768, 1}, {1920, 1080, 1}}) {
        SCOPED_TRACE(std::string{scene} + ' ' + std::string{rowOf(method).name} + ' ' +
                     std::to_string(width) + " / " + std::to_string(unit));
        const Layout at = layoutOf(width, height, unit);
        IndexImage image{width, height, 0};
        const CellPlan plan{TableKind::Linear};
        Pen pen{Painter{image, unit}, plan};
        std::vector<std::string> leftOut;
        const auto pressed =
            page::draw(pen, page::ofPixel(story, {.chosen = story->history.shown, .vertex = 0, .channel = 0}),
                       frameOf(at).column, page::pitchOf(at.body), {}, &leftOut);
        EXPECT_TRUE(
            std::ranges::any_of(pressed, [](const page::Pressed& p) { return p.id == kPressHistory; }));
        for (const std::string& words : leftOut)
          for (const char* must :
               {"I = ", "= 0.", "picks shade", "the chain", "hidden everywhere", "each channel is",
                "interpolated to", "The map holds", "No light is computed"})
            EXPECT_FALSE(words.starts_with(must) || words.find(": I = ") != std::string::npos ||
                         words.find("the chain") != std::string::npos)
                << words;
        EXPECT_LE(leftOut.size(), last);
        last = leftOut.size();
        if (height == 1080 && unit == 1) {
          EXPECT_TRUE(std::ranges::none_of(
              leftOut, [](const std::string& w) { return w == "a sketch" || w == "a table"; }));
        }
      }
    }
}

}  // namespace xnewell::THIS_FILE
