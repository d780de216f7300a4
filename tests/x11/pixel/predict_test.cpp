#include "x11/pixel/predict.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "shading/picture/picture_cache.h"
#include "tests/x11/support/bench_stage.h"
#include "x11/drawing/wording.h"
#include "x11/kit/typed_line.h"
#include "x11/pixel/pixel_bench.h"

namespace xnewell::THIS_FILE {

namespace {

Picture made(Shading method, const char* scene = "teapot") {
  PictureCache pictures{readScene(scene, 4)};
  PictureSettings s = pictures.scene().settings;
  s.camera = pictures.scene().camera;
  s.width = 120, s.height = 90;
  s.shading = method;
  return pictures.make(s, 8);
}

std::vector<Prediction> predictionsAt(const PixelStory& story) {
  const Explanation& e = *story.shown();
  return predictionsOf(story, e, equationShown(e, 0), 0);
}

/// View 8 of a window, with the line that the student types on.
struct Asked : BenchStage {
  Asked() : BenchStage{"teapot", 4, 1024, 768} { draws(); }
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
    for (int k = 0; k < 8; ++k) line.press({NamedKey::Backspace});  // what was not accepted
    for (const char c : text) line.press({NamedKey::Letter, c});
    line.press({NamedKey::Return});
    draws();
  }
  void showsAll() {
    press(bench, NamedKey::Escape);
    draws();
  }
  void givesUp() {
    line.press({NamedKey::Escape});
    draws();
  }

  PixelBench bench{*this, [this] { return Subject{pictures.scene(), glm::dvec3{0.0}, 1.5}; }};
  TypedLine line;
};

}  // namespace

// A typed number is right within half of its last digit. One decimal is too few, and more than the page shows
// do not count. Terms may be typed as they are written, though they are rounded to add up.
TEST(Predict, RightIsWithinHalfOfTheLastDigit) {
  const Prediction cosine{Predicted::NdotL, "N.L", 0.89476, 0.89476};
  for (const char* const right : {"0.89", "0.895", "0.8948", "0.89481", ".89", " +0.895 "})
    EXPECT_TRUE(judged(cosine, right).isRight) << right;
  for (const char* const wrong : {"0.88", "0.90", "0.894", "0.8946", "-0.89"}) {
    EXPECT_FALSE(judged(cosine, wrong).isRight) << wrong;
    EXPECT_EQ(judged(cosine, wrong).complaint, "") << wrong;
  }
  for (const char* const few : {"0.9", "1", "1."})
    EXPECT_EQ(judged(cosine, few).complaint, "Type at least two decimals.") << few;
  for (const char* const none : {"", "x", "0.8x", "nan"})
    EXPECT_EQ(judged(cosine, none).complaint, "Type a number.") << none;
  const Prediction term{Predicted::Diffuse, "the diffuse term", 0.56374, 0.5638};
  EXPECT_TRUE(judged(term, "0.5638").isRight);
  EXPECT_TRUE(judged(term, "0.5637").isRight);
  EXPECT_FALSE(judged(term, "0.5636").isRight);
  const Prediction cell{Predicted::Cell, "the cell", 213, 213, 0};
  EXPECT_TRUE(judged(cell, "213").isRight);
  EXPECT_FALSE(judged(cell, "214").isRight);
}

// What the page writes is right for each value that it asks, in the order of the chain. Without an equation
// only the cell can be asked.
TEST(Predict, ValuesAreThoseOfTheChain) {
  const Picture phong = made(Shading::Phong);
  const PixelStory lit{phong, 45, 45};
  const std::vector<Prediction> all = predictionsAt(lit);
  ASSERT_EQ(all.size(), 6u);
  for (std::size_t k = 0; k < all.size(); ++k) {
    EXPECT_EQ(static_cast<std::size_t>(all[k].what), k);
    EXPECT_TRUE(judged(all[k], fixed(all[k].written, all[k].decimals)).isRight) << all[k].name;
  }
  EXPECT_EQ(all.back().value, lit.cell());
  EXPECT_NEAR(all[4].written, all[2].written + all[3].written + 0.18, 1e-9);
  const Picture depth = made(Shading::Depth);
  const PixelStory unlit{depth, 45, 45};
  ASSERT_EQ(predictionsAt(unlit).size(), 1u);
  EXPECT_EQ(predictionsAt(unlit).front().what, Predicted::Cell);
}

// y hides a number until it is typed: the words to copy and the mark in the strip are hidden too. The first
// try counts. Esc gives up, shows the number and does not count.
TEST(Predict, AsksAndScores) {
  Asked view;
  const IndexImage before = view.image;
  const std::size_t words = view.bench.inWords().size();
  ASSERT_TRUE(view.bench.inspected());
  view.predicts();
  EXPECT_EQ(view.line.typed()->asks, "predict N.L, to two decimals at least");
  EXPECT_NE(view.image, before);
  EXPECT_FALSE(view.bench.inspected());
  EXPECT_EQ(view.bench.inWords().size(), 1u) << "only the pixel";
  view.types("0.5");
  EXPECT_EQ(view.line.typed()->complaint, "Type at least two decimals.");
  view.types("7.77");
  ASSERT_TRUE(view.line.isOpen()) << "another try";
  view.givesUp();
  EXPECT_TRUE(view.notices.back().starts_with("N.L is ")) << view.notices.back();
  EXPECT_TRUE(view.notices.back().ends_with("0 of 1 right at the first try.")) << view.notices.back();
  EXPECT_NE(view.image, before) << "what follows can still be asked";
  EXPECT_EQ(view.bench.inWords().size(), 1u);
  view.showsAll();
  EXPECT_EQ(view.image, before) << "all is shown again";
  EXPECT_EQ(view.bench.inWords().size(), words);

  // The next value. To give up without a try is no answer.
  view.predicts();
  EXPECT_EQ(view.line.typed()->asks, "predict R.V, to two decimals at least");
  view.givesUp();
  EXPECT_TRUE(view.notices.back().ends_with("0 of 1 right at the first try.")) << view.notices.back();

  // The last value is the cell, which the strip had marked.
  for (int k = 0; k < 3; ++k) view.predicts(), view.givesUp();
  EXPECT_FALSE(view.bench.inspected());
  view.showsAll();
  const int cell = view.bench.inspected().value();
  view.predicts();
  EXPECT_EQ(view.line.typed()->asks, "predict the cell");
  view.types(std::to_string(cell));
  EXPECT_FALSE(view.line.isOpen());
  EXPECT_EQ(view.notices.back(),
            "Right: the cell is " + std::to_string(cell) + ". 1 of 2 right at the first try.");
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
TEST(Predict, TheWrittenSumHidesWhatIsAsked) {
  const Picture picture = made(Shading::Phong);
  const PixelStory story{picture, 45, 45};
  const ExplainedEquation& at = story.shown()->equations.front();
  const std::string full = sumOf(at, 0);
  const std::string put = numbersPutIn(*story.shown(), at, 0, Mistake::None).front(),
                    NL = fixed(at.lights.front().NdotL, 4), RV = fixed(at.lights.front().counted, 4);
  const auto blanked = [&](std::string text, const std::string& number) {
    const std::size_t where = text.find(number);
    return where == std::string::npos ? text + ": no " + number : text.replace(where, number.size(), "?");
  };
  EXPECT_EQ(numbersPutIn(*story.shown(), at, 0, Mistake::None, {.RV = true}).front(), blanked(put, RV));
  EXPECT_EQ(numbersPutIn(*story.shown(), at, 0, Mistake::None, {true, true}).front(),
            blanked(blanked(put, RV), NL));
  EXPECT_EQ(sumOf(at, 0, true, 1), full.substr(0, full.find(" + ")) + " + ? + ? = ?");
  EXPECT_EQ(sumOf(at, 0, true, 3), full.substr(0, full.rfind(" = ")) + " = ?");
}

}  // namespace xnewell::THIS_FILE
