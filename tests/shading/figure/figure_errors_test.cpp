#include "shading/figure/figure_errors.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "shading/figure/make_figure.h"
#include "shading/picture/picture_cache.h"
#include "shading/scene/scene.h"

namespace xnewell::THIS_FILE {

/// The colour of the last path that winds around a sample: each path is asked anew at each sample.
FigureColor lastAround(const VectorFigure& figure, int i, int j, FigureColor ground) {
  const std::int64_t x = std::int64_t{i} * kFigureSteps + kFigureSteps / 2,
                     y = std::int64_t{j} * kFigureSteps + kFigureSteps / 2;
  FigureColor shown = ground;
  for (const FigurePath& path : figure.paths) {
    int turns = 0;
    for (const FigureLoop& loop : path.loops)
      for (std::size_t k = 0; k < loop.size(); ++k) {
        const glm::i64vec2 a = loop[k], b = loop[(k + 1) % loop.size()];
        if ((a.y <= y) == (b.y <= y)) continue;
        // The ray to the left meets the side where this is not negative.
        const std::int64_t left = ((x - a.x) * (b.y - a.y) - (y - a.y) * (b.x - a.x)) * (b.y > a.y ? 1 : -1);
        if (left >= 0) turns += b.y > a.y ? 1 : -1;
      }
    if (turns != 0) shown = path.color;
  }
  return shown;
}

// Random paths, some of whose corners lie at samples and outside of the page, against a test of each sample.
TEST(FigureErrors, ColorsAtSamplesAreThoseOfTheLastPathAroundThem) {
  std::mt19937 dice{43};
  const auto number = [&](int from, int to) { return std::uniform_int_distribution{from, to}(dice); };
  int shown = 0;
  for (int round = 0; round < 300; ++round) {
    VectorFigure figure;
    figure.width = 12, figure.height = 9;
    for (int p = number(1, 4); p > 0; --p) {
      FigurePath path{{static_cast<std::uint8_t>(p), 0, 0}, {}};
      for (int l = number(1, 3); l > 0; --l) {
        FigureLoop& loop = path.loops.emplace_back();
        const bool atSamples = number(0, 2) == 0;
        for (int k = number(3, 6); k > 0; --k)
          loop.push_back(atSamples ? glm::ivec2{256 * number(-3, 14) + 128, 256 * number(-3, 11) + 128}
                                   : glm::ivec2{number(-900, 3900), number(-900, 3200)});
      }
      figure.paths.push_back(std::move(path));
    }
    const FigureColor ground{9, 9, 9};
    const std::vector<FigureColor> colors = colorsAtSamples(figure, ground);
    ASSERT_EQ(colors.size(), 12u * 9u);
    for (int j = 0; j < 9; ++j)
      for (int i = 0; i < 12; ++i) {
        const FigureColor due = lastAround(figure, i, j, ground);
        ASSERT_EQ(colors[j * 12 + i], due) << round << ": " << i << "," << j;
        shown += due != ground;
      }
  }
  EXPECT_GT(shown, 5'000);
}

// A figure of flat cubes has the picture's colours. If we change the colour of one path, exactly its samples
// differ, and by as much.
TEST(FigureErrors, CountsWhatDiffers) {
  Scene scene = readScene("cubes");
  PictureSettings settings = scene.settings;
  settings.width = 160, settings.height = 120;
  settings.shading = Shading::Flat, settings.order = Order::Newell, settings.colors = ColorPlan::OneHue;
  const Picture picture = makePicture(std::move(scene), settings, std::uint8_t{0}).withPlanes();
  const Palette palette = picture.palette(CellPlan{settings.table.kind});
  VectorFigure figure = makeFigure(picture, figureOrder(picture, Order::Newell), palette);
  const GroundTruth truth{picture};
  const Comparison comparison{picture, truth, palette};
  const FigureErrors right = errorsOf(figure, comparison, palette);
  EXPECT_GT(right.samples, 4'000);
  EXPECT_LE(right.differ, 12) << "beside borders";
  EXPECT_NEAR(right.figure.mean, right.picture.mean, 0.05);

  FigureColor& color = figure.paths.back().color;
  const std::vector<FigureColor> before = colorsAtSamples(figure, {});
  const auto painted = std::ranges::count(before, color);
  ASSERT_GT(painted, 500);
  color[2] ^= 64;
  const FigureErrors wrong = errorsOf(figure, comparison, palette);
  EXPECT_NEAR(static_cast<double>(wrong.differ), static_cast<double>(painted + right.differ), 12.0);
  EXPECT_GE(wrong.largest, 64);
  EXPECT_GT(wrong.figure.mean, right.figure.mean + 1);
  EXPECT_EQ(wrong.picture.mean, right.picture.mean);
}

}  // namespace xnewell::THIS_FILE
