#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "shading/figure/figure_errors.h"
#include "shading/figure/make_figure.h"
#include "shading/figure/write_figure.h"
#include "shading/picture/picture_cache.h"
#include "shading/scene/scene.h"

namespace xnewell::THIS_FILE {

constexpr int kWidth = 160, kHeight = 120;

Picture gouraudPicture(const std::string& name) {
  Scene scene = readScene(name);
  PictureSettings settings = scene.settings;
  settings.width = kWidth, settings.height = kHeight, settings.order = Order::Newell;
  settings.shading = Shading::Gouraud, settings.colors = ColorPlan::OneHue;
  return makePicture(std::move(scene), settings, std::uint8_t{0}).withPlanes();
}

VectorFigure smoothFigure(const Picture& picture, const Palette& palette) {
  return makeFigure(picture, figureOrder(picture, Order::Newell), palette, FigureColors::Shades,
                    {.tolerance = 0, .samples = {}, .smooth = true});
}

std::int64_t doubleAreaOf(glm::i64vec2 a, glm::i64vec2 b, glm::i64vec2 c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The colour of a triangle at a place, by the areas of the three triangles that the place makes with its
/// sides; nothing outside.
std::optional<std::array<double, 3>> colorOf(const FigureTriangle& t, std::int64_t x, std::int64_t y) {
  const glm::i64vec2 at{x, y}, a = t.corners[0], b = t.corners[1], c = t.corners[2];
  const std::int64_t whole = doubleAreaOf(a, b, c),
                     of[] = {doubleAreaOf(at, b, c), doubleAreaOf(a, at, c), doubleAreaOf(a, b, at)};
  std::array<double, 3> color{};
  for (int k = 0; k < 3; ++k) {
    if ((of[k] < 0) != (whole < 0) && of[k] != 0) return {};
    for (int channel = 0; channel < 3; ++channel)
      color[channel] += static_cast<double>(of[k]) / static_cast<double>(whole) * t.colors[k][channel];
  }
  return color;
}

// At samples away from other faces, the last triangle has the picture's colour within what the figure says,
// and colorsAtSamples() finds the same.
TEST(SmoothFigure, HasTheShadeOfEachSample) {
  for (const char* name : {"tori", "coarse-teapot"}) {
    SCOPED_TRACE(name);
    const Picture picture = gouraudPicture(name);
    const Palette palette = picture.palette(CellPlan{picture.settings().table.kind});
    const ShownSamples samples = shownSamples(picture, palette);
    const VectorFigure figure = smoothFigure(picture, palette);
    const std::vector<FigureColor> sampled = colorsAtSamples(figure, {});
    EXPECT_LE(figure.statistics.off, 2);
    for (const FigurePath& path : figure.paths)
      for (const FigureTriangle& t : path.triangles)
        ASSERT_NE(doubleAreaOf(t.corners[0], t.corners[1], t.corners[2]), 0);
    int compared = 0;
    for (int j = 1; j + 1 < kHeight; ++j)
      for (int i = 1; i + 1 < kWidth; ++i) {
        const auto faceAt = [&](int x, int y) { return samples.faces[std::size_t(y) * kWidth + x]; };
        bool inside = faceAt(i, j) >= 0;
        for (int n = 0; n < 9; ++n) inside = inside && faceAt(i + n % 3 - 1, j + n / 3 - 1) == faceAt(i, j);
        if (!inside) continue;
        std::optional<std::array<double, 3>> last;
        for (const FigurePath& path : figure.paths)
          for (const FigureTriangle& triangle : path.triangles)
            if (const auto color = colorOf(triangle, i * kFigureSteps + 128, j * kFigureSteps + 128))
              last = color;
        ASSERT_TRUE(last) << i << ' ' << j;
        ++compared;
        const std::size_t at = std::size_t(j) * kWidth + i;
        for (int c = 0; c < 3; ++c) {
          EXPECT_NEAR((*last)[c], samples.colors[at][c], figure.statistics.off) << i << ' ' << j;
          EXPECT_NEAR((*last)[c], sampled[at][c], 0.5 + 1e-6) << i << ' ' << j;
        }
      }
    EXPECT_GT(compared, 500);
  }
}

// With eight shades, the borders between them go, and the figure says how far its colours are off.
TEST(SmoothFigure, SaysThatBandsAreLost) {
  Scene scene = readScene("tori");
  scene.settings.shading = Shading::Gouraud, scene.settings.table.shades = 8;
  const FigureStages stages{scene, scene.settings, 0, true};
  const int off = stages.figure().statistics.off;
  EXPECT_GE(off, 10);
  EXPECT_LE(off, 255 / 7 + 1);
}

// The PDF file holds each list of triangles in 30 bytes a triangle: per corner a flag, two coordinates of
// three bytes with 2^23 added, and three bytes of colour.
TEST(SmoothFigure, WritesTriangles) {
  VectorFigure figure;
  figure.width = 4, figure.height = 3;
  const FigureTriangle one{{{{0, 0}, {-256, 700}, {1024, 5}}}, {{{0, 1, 2}, {255, 254, 0}, {7, 8, 128}}}};
  const FigureTriangle two{{{{1, 1}, {2, 9}, {9, 2}}}, {}};
  figure.paths = {{{1, 2, 3}, {{{0, 0}, {0, 256}, {256, 256}}}}, {{}, {}, 0, {one, two}}, {{}, {}, 1, {two}}};
  const std::string pdf = pdfOf(figure);
  EXPECT_NE(pdf.find("h\nf\n/S0 sh\n/S1 sh\n"), pdf.npos);
  EXPECT_NE(pdf.find("/Shading<</S0 5 0 R/S1 6 0 R>>"), pdf.npos);
  const std::size_t object = pdf.find("\n5 0 obj\n"), begin = pdf.find("stream\n", object) + 7;
  ASSERT_NE(object, pdf.npos);
  EXPECT_NE(pdf.find("/Decode[-8388608 8388607 -8388608 8388607 0 1 0 1 0 1]/Length 60>>"), pdf.npos);
  std::size_t at = begin;
  const auto number = [&](int bytes) {
    int n = 0;
    for (; bytes > 0; --bytes) n = n << 8 | static_cast<unsigned char>(pdf[at++]);
    return n;
  };
  for (const FigureTriangle& t : {one, two})
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(number(1), 0);
      EXPECT_EQ(number(3) - (1 << 23), t.corners[k].x);
      EXPECT_EQ(number(3) - (1 << 23), t.corners[k].y);
      for (const int level : t.colors[k]) EXPECT_EQ(number(1), level);
    }
  EXPECT_EQ(pdf.substr(at, 11), "\nendstream\n");
  const std::size_t table = std::stoul(pdf.substr(pdf.find("startxref\n") + 10));
  for (int n = 1; n <= 6; ++n)
    EXPECT_TRUE(pdf.substr(std::stoul(pdf.substr(table + 9 + 20 * std::size_t(n), 10)))
                    .starts_with(std::to_string(n) + " 0 obj\n"));
}

}  // namespace xnewell::THIS_FILE
