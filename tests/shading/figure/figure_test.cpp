#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <optional>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "shading/color/font.h"
#include "shading/figure/figure_errors.h"
#include "shading/figure/make_figure.h"
#include "shading/figure/write_figure.h"
#include "shading/picture/picture_cache.h"
#include "shading/scene/scene.h"
#include "tests/support/temporary_folder.h"

namespace xnewell::THIS_FILE {

namespace {

/// ---- Figures

constexpr int kWidth = 160, kHeight = 120;

Picture pictureOf(const std::string& name, Shading shading = Shading::Flat) {
  Scene scene = readScene(name);
  PictureSettings settings = scene.settings;
  settings.width = kWidth, settings.height = kHeight;
  settings.shading = shading, settings.order = Order::Newell, settings.colors = ColorPlan::OneHue;
  return makePicture(std::move(scene), settings, std::uint8_t{0}).withPlanes();
}

VectorFigure figureOf(const Picture& picture, FigureColors colors, int strip = kStrip) {
  return makeFigure(picture, figureOrder(picture, Order::Newell),
                    picture.palette(CellPlan{picture.settings().table.kind}), colors, {}, strip);
}

/// How often the loops of a path wind around a point, by a ray to its left.
template <class T>
int winding(const FigurePath& path, T x, T y) {
  int turns = 0;
  for (const FigureLoop& loop : path.loops)
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const glm::vec<2, T> a{loop[k]}, b{loop[(k + 1) % loop.size()]};
      if ((a.y <= y) == (b.y <= y)) continue;
      // The ray meets the side where this is not negative.
      const T left = ((x - a.x) * (b.y - a.y) - (y - a.y) * (b.x - a.x)) * (b.y > a.y ? 1 : -1);
      if (left >= 0) turns += b.y > a.y ? 1 : -1;
    }
  return turns;
}

/// What paths show at a point: none where none lies. Each path is asked.
template <class T>
const FigureColor* colorAt(const VectorFigure& figure, T x, T y) {
  for (auto path = figure.paths.rbegin(); path != figure.paths.rend(); ++path)
    if (winding(*path, x, y) != 0) return &path->color;
  return nullptr;
}

/// What a figure in the colours of the ids shows at a point: 0 where no path lies.
std::uint32_t idAt(const VectorFigure& figure, double x, double y) {
  const FigureColor* const c = colorAt(figure, x, y);
  return c ? std::uint32_t{(*c)[0]} << 16 | std::uint32_t{(*c)[1]} << 8 | (*c)[2] : 0;
}

// The figure shows the picture's face at each sample. Only at the border of a face, where the steps of a
// figure are too coarse, it may show the one beside it.
TEST(VectorFigure, ShowsTheFaceOfEachSample) {
  for (const char* name : {"cubes", "cycle", "pinwheels", "crossing-sheets", "penetrate", "tori"})
    for (const int strip : {0, kStrip}) {
      SCOPED_TRACE(std::string{name} + " " + std::to_string(strip));
      const Picture picture = pictureOf(name);
      const VectorFigure figure = figureOf(picture, FigureColors::Ids, strip);
      const std::vector<std::uint32_t> ids = picture.faceImage();
      int atBorders = 0;
      for (int j = 0; j < kHeight; ++j)
        for (int i = 0; i < kWidth; ++i) {
          const std::uint32_t id = ids[std::size_t(j) * kWidth + i];
          const double x = i * kFigureSteps + 128.25, y = j * kFigureSteps + 128.25;
          if (idAt(figure, x, y) == id) continue;
          ++atBorders;
          bool near = false;
          for (const double dx : {-4.0, 0.0, 4.0})
            for (const double dy : {-4.0, 0.0, 4.0}) near |= idAt(figure, x + dx, y + dy) == id;
          EXPECT_TRUE(near) << i << ' ' << j;
        }
      EXPECT_LT(atBorders, kWidth * kHeight / 500);
    }
}

/// Visits each sample that is a pixel away from other faces. Returns how many there are.
template <class Visit>
int forEachInnerSample(const ShownSamples& samples, const Visit& visit) {
  const auto faceAt = [&](int i, int j) { return samples.faces[std::size_t(j) * kWidth + i]; };
  int visited = 0;
  for (int j = 1; j + 1 < kHeight; ++j)
    for (int i = 1; i + 1 < kWidth; ++i) {
      bool inside = faceAt(i, j) >= 0;
      for (int n = 0; n < 9; ++n) inside = inside && faceAt(i + n % 3 - 1, j + n / 3 - 1) == faceAt(i, j);
      if (inside) visit(i, j), ++visited;
    }
  return visited;
}

// Without tolerance a figure has the colour of each sample that is a pixel away from other faces: between the
// lines of the cells in Gouraud shading, and from the samples themselves in Phong shading.
TEST(VectorFigure, ShowsTheShadeOfEachSample) {
  for (const Shading shading : {Shading::Gouraud, Shading::Phong})
    for (const char* name : {"tori", "coarse-teapot"}) {
      SCOPED_TRACE(std::string{name} + (shading == Shading::Phong ? " Phong" : " Gouraud"));
      const Picture picture = pictureOf(name, shading);
      const Palette palette = picture.palette(CellPlan{picture.settings().table.kind});
      const ShownSamples samples = shownSamples(picture, palette);
      const VectorFigure figure = makeFigure(picture, figureOrder(picture, Order::Newell), palette,
                                             FigureColors::Shades, {0, samples});
      int most = 0;
      const int compared = forEachInnerSample(samples, [&](int i, int j) {
        const FigureColor* shown = colorAt(figure, i * kFigureSteps + 128.25, j * kFigureSteps + 128.25);
        ASSERT_NE(shown, nullptr);
        const FigureColor& sample = samples.colors[std::size_t(j) * kWidth + i];
        for (int c = 0; c < 3; ++c) most = std::max(most, std::abs((*shown)[c] - sample[c]));
      });
      EXPECT_GT(compared, 500);
      // The lines have corners in steps, so a sample right beside one may have the next cell.
      EXPECT_LE(most, shading == Shading::Gouraud ? 8 : 0);
    }
}

// Of eighteen faces of cubes, those stay that show at a sample. They have three colours: three paths.
TEST(VectorFigure, LeavesOutHiddenFacesAndJoinsColors) {
  const Picture picture = pictureOf("cubes");
  const VectorFigure figure = figureOf(picture, FigureColors::Shades);
  std::vector<std::uint32_t> ids = picture.faceImage();
  std::ranges::sort(ids);
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  EXPECT_EQ(figure.statistics.fragments, 18);
  EXPECT_EQ(figure.statistics.hidden, 18 - (std::ssize(ids) - 1)) << "one of the ids is the background";
  EXPECT_EQ(figure.paths.size(), 3u);
}

FigurePolygon triangle(glm::ivec2 a, glm::ivec2 b, glm::ivec2 c, std::uint8_t red) {
  FigurePolygon p;
  p.corners = {a, b, c};
  p.lines.resize(3);
  p.color = {red, 0, 0};
  return p;
}

// Four triangles around a point. The first covers a disk around it and strips of its two neighbours; the last
// one covers nothing but itself.
TEST(VectorFigure, CoversBordersUnderWhatIsPaintedLater) {
  const glm::ivec2 o{4000, 4000}, e{8000, 4000}, n{4000, 0}, w{0, 4000}, s{4000, 8000};
  const std::vector<FigurePolygon> around{triangle(o, e, n, 1), triangle(o, n, w, 2), triangle(o, w, s, 3),
                                          triangle(o, s, e, 4)};
  const auto paths = joinedPaths(around, {0, 1, 2, 3}, 100, 32, 32);
  ASSERT_EQ(paths.size(), 4u);
  EXPECT_NE(winding(paths[0], 3990.5, 3990.5), 0) << "the strip beside it";
  EXPECT_NE(winding(paths[0], 3980.5, 4020.5), 0) << "the disk, in the triangle across the point";
  EXPECT_EQ(winding(paths[0], 3800.5, 3900.5), 0) << "beyond the strip";
  EXPECT_EQ(paths[3].loops, (std::vector<FigureLoop>{{s, e, o}}));
  const auto bare = joinedPaths(around, {0, 1, 2, 3}, 0, 32, 32);
  EXPECT_EQ(bare[0].loops, (std::vector<FigureLoop>{{e, n, o}}));
}

// A polygon that ends under others, which have no side in common with it, goes on beneath them for a strip,
// and nowhere else.
TEST(VectorFigure, CoversWhatCrossesItsBorder) {
  const glm::ivec2 a{2000, 2000}, b{2000, 6000}, c{6000, 4000};
  const std::vector<FigurePolygon> crossing{triangle(a, b, c, 1),
                                            triangle({3000, 1000}, {3000, 3500}, {9000, 1000}, 2)};
  std::vector<FigurePolygon> polygons = crossing;
  std::uint64_t planes = 0;  // each side lies on a line of its own
  for (FigurePolygon& p : polygons)
    for (SideLine& line : p.lines) line = {SideLine::Kind::Cut, planes, planes + 1}, ++planes;
  const auto paths = joinedPaths(polygons, {0, 1}, 100, 40, 40);
  ASSERT_EQ(paths.size(), 2u);
  EXPECT_NE(winding(paths[0], 4000.5, 2950.5), 0) << "beyond the side, under the later polygon";
  EXPECT_EQ(winding(paths[0], 2500.5, 2200.5), 0) << "beyond the side, where no later one lies";
  EXPECT_EQ(paths[1].loops.size(), 1u);
}

VectorFigure smallFigure() {
  VectorFigure figure;
  figure.width = 4, figure.height = 3;
  figure.paths = {{{255, 136, 1}, {{{0, 0}, {0, 256}, {256, 256}}}}};
  figure.note = "xnewell draw a<b&c";
  return figure;
}

TEST(VectorFigure, WritesSvg) {
  EXPECT_EQ(svgOf(smallFigure()),
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"4\" height=\"3\" viewBox=\"0 0 4 3\">\n"
            "<desc>xnewell draw a&lt;b&amp;c</desc>\n"
            "<g transform=\"scale(.00390625)\">\n"
            "<path fill=\"#ff8801\" d=\"M0 0l0 256 256 0z\"/>\n"
            "</g>\n</svg>\n");
}

/// The table of a PDF file tells at which byte each of its objects begins.
void expectObjects(const std::string& pdf, int count) {
  const std::size_t start = pdf.find("startxref\n") + 10, table = std::stoul(pdf.substr(start));
  ASSERT_TRUE(pdf.substr(table).starts_with("xref\n0 " + std::to_string(count + 1) + '\n'));
  for (int n = 1; n <= count; ++n) {
    const std::size_t place = std::stoul(pdf.substr(table + 9 + 20 * std::size_t(n), 10));
    EXPECT_TRUE(pdf.substr(place).starts_with(std::to_string(n) + " 0 obj\n")) << n;
  }
}

// The table of a PDF file tells at which byte each object begins, and the stream has the length that it says.
TEST(VectorFigure, WritesPdf) {
  const std::string pdf = pdfOf(smallFigure());
  EXPECT_NE(pdf.find("1 .533 .004 rg\n0 0 m\n0 256 l\n256 256 l\nh\nf\n"), pdf.npos);
  EXPECT_NE(pdf.find("\n%xnewell: xnewell draw a<b&c\n"), pdf.npos);
  expectObjects(pdf, 4);
  const std::size_t begin = pdf.find("stream\n") + 7, end = pdf.find("endstream");
  EXPECT_NE(pdf.find("<</Length " + std::to_string(end - begin) + ">>"), pdf.npos);
}

TEST(VectorFigure, WritesEps) {
  const std::string eps = epsOf(smallFigure());
  EXPECT_TRUE(eps.starts_with("%!PS-Adobe-3.0 EPSF-3.0\n%%BoundingBox: 0 0 4 3\n"));
  EXPECT_NE(eps.find("1 .533 .004 c\n0 0 m\n0 256 l\n256 0 l\nh\nf\n"), eps.npos);
}

// Each format gives back the note that was put into it, and a file without one has none.
TEST(VectorFigure, GivesBackItsNote) {
  const TemporaryFolder folder;
  for (const FigureFormat& format : kFigureFormats)
    for (const std::string note : {"xnewell draw a<b&c>.json -o picture.png", "&lt;", ""}) {
      VectorFigure figure = smallFigure();
      figure.note = note;
      const auto found = noteInFigure(folder.write("f" + std::string{format.ending}, format.write(figure)));
      EXPECT_EQ(found.value_or(""), note) << format.name;
      EXPECT_EQ(found.has_value(), !note.empty()) << format.name;
    }
}

// Lines stand behind all paths, open, with dashes if they are dashed.
TEST(VectorFigure, WritesStrokes) {
  VectorFigure figure = smallFigure();
  figure.strokes = {{{0, 0, 0}, 128, true, {{{0, 0}, {256, 512}}}}};
  EXPECT_NE(
      svgOf(figure).find("<path fill=\"none\" stroke=\"#000\" stroke-width=\"128\" stroke-linecap=\"butt\" "
                         "stroke-dasharray=\"768\" d=\"M0 0L256 512\"/>\n</g>"),
      std::string::npos);
  EXPECT_NE(pdfOf(figure).find("f\n0 0 0 RG\n128 w 0 J [768] 0 d\n0 0 m\n256 512 l\nS\n"), std::string::npos);
  EXPECT_NE(epsOf(figure).find("128 w 0 J [768] 0 d\n0 0 m\n256 512 L\nS\n"), std::string::npos);
}

// In SVG a text is a text. PDF and EPS show the pixels of the program's font and need no other: the
// rectangles of both cover the glyph's doubled pixels, each once.
TEST(VectorFigure, WritesTexts) {
  VectorFigure figure = smallFigure();
  constexpr int kPixel = 256;  // half a pixel of the font, in steps
  figure.texts = {{{512, 25600}, {255, 0, 0}, 2 * kGlyphHeight * kPixel, "\u03B8<"}};
  EXPECT_NE(svgOf(figure).find(
                "<text x=\"512\" y=\"25600\" fill=\"#f00\" font-family=\"Helvetica, Arial, sans-serif\" "
                "font-size=\"6656\">\u03B8&lt;</text>\n</g>"),
            std::string::npos);
  for (const auto& [name, file] : {std::pair{"PDF", pdfOf(figure)}, {"EPS", epsOf(figure)}}) {
    SCOPED_TRACE(name);
    for (const char* const word : {"Font", "font"}) EXPECT_EQ(file.find(word), std::string::npos);
    std::istringstream lines{file.substr(file.find("\n1 0 0 ") + 1)};
    std::map<std::array<int, 2>, int> inked;
    std::vector<glm::ivec2> at;
    const bool pdf = std::string_view{name} == "PDF";
    for (std::string line; std::getline(lines, line);) {
      int x = 0, y = 0;
      char what = 0;
      if (line == "h") {
        ASSERT_EQ(at.size(), 4u);
        for (int i = at[0].x; i < at[2].x; i += kPixel)
          for (int j = at[0].y; j < at[2].y; j += kPixel) ++inked[{(i - 512) / kPixel, (j - 25600) / kPixel}];
        at.clear();
      } else if (std::sscanf(line.c_str(), "%d %d %c", &x, &y, &what) == 3 && (what == 'm' || what == 'l')) {
        at.push_back(pdf || what == 'm' ? glm::ivec2{x, y} : at.back() + glm::ivec2{x, y});
      }
    }
    int all = 0;
    for (int letter = 0; letter < 2; ++letter) {
      const DoubledGlyph glyph = scale2x(*glyphOf(letter == 0 ? U'\u03B8' : U'<'));
      for (int j = 0; j < 2 * kGlyphHeight; ++j)
        for (int i = 0; i < 2 * kGlyphWidth; ++i) {
          const bool on = glyph[j] >> (2 * kGlyphWidth - 1 - i) & 1;
          all += on;
          EXPECT_EQ((inked[{2 * kGlyphWidth * letter + i, j - 2 * kGlyphAscent}]), on) << i << ", " << j;
        }
    }
    EXPECT_EQ(std::ranges::count_if(inked, [](const auto& p) { return p.second > 0; }), all);
  }
}

/// ---- Figures that cannot be made

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
        const FigureColor* const last =
            colorAt(figure, std::int64_t{256 * i + 128}, std::int64_t{256 * j + 128});
        const FigureColor due = last ? *last : ground;
        ASSERT_EQ(colors[j * 12 + i], due) << round << ": " << i << "," << j;
        shown += due != ground;
      }
  }
  EXPECT_GT(shown, 5'000);
}

// A figure of flat cubes has the picture's colours. If we change the colour of one path, exactly its samples
// differ, and by as much.
TEST(FigureErrors, CountsWhatDiffers) {
  const Picture picture = pictureOf("cubes");
  const Palette palette = picture.palette(CellPlan{picture.settings().table.kind});
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

/// ---- Smooth shading

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
    const Picture picture = pictureOf(name, Shading::Gouraud);
    const Palette palette = picture.palette(CellPlan{picture.settings().table.kind});
    const ShownSamples samples = shownSamples(picture, palette);
    const VectorFigure figure = smoothFigure(picture, palette);
    const std::vector<FigureColor> sampled = colorsAtSamples(figure, {});
    EXPECT_LE(figure.statistics.off, 2);
    for (const FigurePath& path : figure.paths)
      for (const FigureTriangle& t : path.triangles)
        ASSERT_NE(doubleAreaOf(t.corners[0], t.corners[1], t.corners[2]), 0);
    const int compared = forEachInnerSample(samples, [&](int i, int j) {
      std::optional<std::array<double, 3>> last;
      for (const FigurePath& path : figure.paths)
        for (const FigureTriangle& triangle : path.triangles)
          if (const auto color = colorOf(triangle, i * kFigureSteps + 128, j * kFigureSteps + 128))
            last = color;
      ASSERT_TRUE(last) << i << ' ' << j;
      const std::size_t at = std::size_t(j) * kWidth + i;
      for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR((*last)[c], samples.colors[at][c], figure.statistics.off) << i << ' ' << j;
        EXPECT_NEAR((*last)[c], sampled[at][c], 0.5 + 1e-6) << i << ' ' << j;
      }
    });
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
  expectObjects(pdf, 6);
}

}  // namespace

}  // namespace xnewell::THIS_FILE
