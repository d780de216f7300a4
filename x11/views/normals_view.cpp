#include "x11/views/normals_view.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "depthsort/oracle.h"
#include "x11/drawing/sheet.h"
#include "x11/drawing/wording.h"
#include "x11/views/own_colors.h"

namespace xnewell {

namespace {

constexpr int kBall = 72;     // diameter of the ball
constexpr int kNeedles = 24;  // units from needle to needle
constexpr double kNeedle = 14.0;

/// To 8 bits, the nearest.
void setColor(std::uint8_t* rgb, const glm::dvec3& N) {
  for (int axis = 0; axis < 3; ++axis)
    rgb[axis] =
        static_cast<std::uint8_t>(std::floor(255.0 * std::clamp((N[axis] + 1.0) / 2.0, 0.0, 1.0) + 0.5));
}

/// Calls use(i, j, N) for the samples of the half of a ball that faces the viewer.
template <class Use>
void forEachOfBall(int diameter, Use&& use) {
  for (int j = 0; j < diameter; ++j)
    for (int i = 0; i < diameter; ++i) {
      const double x = (2.0 * i + 1.0) / diameter - 1.0, y = 1.0 - (2.0 * j + 1.0) / diameter;
      if (x * x + y * y < 1.0) use(i, j, glm::dvec3{x, y, std::sqrt(1.0 - x * x - y * y)});
    }
}

/// The normals of a picture in viewing coordinates.
struct SeenNormals {
  RgbImage colors;                  ///< black where no face shows
  std::vector<std::uint8_t> shows;  ///< of each sample: 1 where a face shows
  std::vector<glm::dvec3> needles;  ///< where needles stand, row by row; 0 where no face shows
};

/// The rows below the picture, `below` of them, stay black and show nothing. A large picture is worked on in
/// bands of rows, because a normal takes eight times as much memory as its colour.
SeenNormals seenNormals(const Picture& picture, int below = 0, int unit = 1) {
  constexpr int kMostSamples = 1 << 21;  // of a band
  const int width = picture.settings().width, height = picture.settings().height;
  const int rows = std::max(1, kMostSamples / width), pitch = kNeedles * unit;
  const glm::dmat3 rotation = vrcRotation(picture.camera().view);
  SeenNormals seen{.colors = {width, height + below},
                   .shows = std::vector<std::uint8_t>(std::size_t(width) * (height + below), 0),
                   .needles = {}};
  for (int row = 0; row < height; row += rows) {
    const std::vector<glm::dvec3> N = picture.normals(picture.seen(row, std::min(row + rows, height)));
    const std::size_t first = std::size_t(row) * width;
    for (std::size_t k = 0; k < N.size(); ++k) {
      const glm::dvec3 n = rotation * N[k];
      const bool shows = n != glm::dvec3{0.0};
      if (shows) seen.shows[first + k] = 1, setColor(&seen.colors.rgb[3 * (first + k)], n);
      const int i = static_cast<int>(k % width), j = row + static_cast<int>(k / width);
      if (i % pitch == pitch / 2 && j % pitch == pitch / 2) seen.needles.push_back(n);
    }
  }
  return seen;
}

/// Draws one needle for each cell of the coarse grid whose middle shows a face; a dot if it points at the
/// viewer.
void drawNeedles(Painter painter, const SeenNormals& seen, const Rect& at, std::uint8_t cell) {
  auto n = seen.needles.begin();
  const double length = kNeedle * painter.unit();
  const int pitch = kNeedles * painter.unit();
  painter = painter.pixels();
  for (int j = pitch / 2; j < at.height; j += pitch)
    for (int i = pitch / 2; i < at.width; i += pitch, ++n) {
      if (*n == glm::dvec3{0.0}) continue;
      const int x = at.x + i, y = at.y + j;
      painter.line(x, y, x + static_cast<int>(std::lround(length * n->x)),
                   y - static_cast<int>(std::lround(length * n->y)), cell);
      painter.disc(x, y, 1, cell);
    }
}

std::string wordsFor(const PictureSettings& settings) {
  const std::string which = rowOf(settings.shading).interpolates
                                ? "The normals are interpolated from the vertices over each face and made "
                                  "unit vectors at every pixel. At the vertices they follow the rule " +
                                      std::string{kNormalRules[static_cast<int>(settings.normals)].name} +
                                      ". "
                                : "Each face has one normal, that of its plane. ";
  return which +
         "Red, green and blue are (N + 1) / 2 of x to the right, y up and z towards the viewer. A needle is "
         "N "
         "from its dot, foreshortened as seen.";
}

struct NormalsPlaces {
  std::string words;
  int textLeft, textWidth;
  Rect picture;
};

NormalsPlaces placesOf(const ViewSettings& settings) {
  const int W = settings.picture.width, H = settings.picture.height;
  NormalsPlaces at{.words = wordsFor(settings.picture),
                   .textLeft = Sheet::kMargin + kBall + Sheet::kGutter,
                   .textWidth = 0,
                   .picture = {}};
  at.textWidth = W - at.textLeft - Sheet::kMargin;
  const int strip = std::max(kBall, Sheet::kRow + Sheet::paragraphHeight(at.textWidth, at.words));
  at.picture = {Sheet::kMargin, Sheet::kMargin, W - 2 * Sheet::kMargin,
                H - strip - 2 * Sheet::kMargin - Sheet::kGutter};
  return at;
}

}  // namespace

RgbImage normalColors(const Picture& picture) { return seenNormals(picture).colors; }

ColoredImage normalsImage(const Picture& picture, const CellPlan& plan, const Palette& palette, int unit) {
  const PictureSettings& settings = picture.settings();
  const SeenNormals seen = seenNormals(picture, 0, unit);
  ColoredImage normals = inOwnColors(seen.colors, seen.shows, true, settings, plan, palette);
  drawNeedles({normals.image, unit}, seen, {0, 0, settings.width, settings.height}, plan[Cell::Black]);
  return normals;
}

PictureSettings pictureForNormals(const ViewSettings& settings) {
  const Rect at = placesOf(settings).picture;
  PictureSettings smaller = settings.picture;
  smaller.width = at.width, smaller.height = at.height;
  return smaller;
}

ColoredImage drawNormals(const Picture& picture, const ViewSettings& settings) {
  const std::string heading = "Normals, " + std::string{rowOf(settings.picture.shading).label} + " shading";
  const NormalsPlaces places = placesOf(settings);
  const Rect& at = places.picture;
  const PictureSettings& smaller = picture.settings();

  // The ball's colours are chosen with the picture's: one image above the other.
  const int rows = at.height + kBall;
  SeenNormals seen = seenNormals(picture, kBall);
  forEachOfBall(kBall, [&](int i, int j, const glm::dvec3& n) {
    setColor(seen.colors.pixel(i, at.height + j), n);
    seen.shows[std::size_t(at.height + j) * at.width + i] = 1;
  });
  ColoredImage own = inOwnColors(seen.colors, seen.shows, true, smaller, settings.cells, settings.unneeded);
  IndexImage& cells = own.image;
  for (int j = at.height; j < rows; ++j)
    std::replace(cells.row(j), cells.row(j) + at.width, settings.cells[Cell::Well],
                 settings.cells[Cell::Paper]);

  Sheet sheet{settings.picture.width, settings.picture.height, settings.cells};
  sheet.painter().place(cells, {0, 0, at.width, at.height}, at.x, at.y);
  drawNeedles(sheet.painter().within(at), seen, at, sheet.cell(Cell::Black));
  sheet.painter().frame(at, sheet.cell(Cell::Ink));
  const int top = at.y + at.height + Sheet::kGutter;
  sheet.painter().place(cells, {0, at.height, kBall, kBall}, Sheet::kMargin, top);
  sheet.painter().text(places.textLeft, top + Sheet::kAscent, heading, sheet.cell(Cell::Ink), Voice::Bold);
  sheet.paragraph(places.textLeft, top + Sheet::kRow, places.textWidth, places.words, Cell::Soft);

  return {sheet.image(), withInterface(own.palette, settings.cells)};
}

}  // namespace xnewell
