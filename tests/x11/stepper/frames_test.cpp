#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "shading/picture/picture_cache.h"
#include "x11/stepper/frames.h"
#include "x11/stepper/sort_picture.h"
#include "x11/stepper/sort_run.h"
#include "x11/stepper/sort_state.h"

namespace xnewell::THIS_FILE {

namespace {

constexpr int kSize = 32;

int count(const IndexImage& image, std::uint8_t cell) {
  return static_cast<int>(std::ranges::count(image.pixels, cell));
}

}  // namespace

// No word reaches into the margin of the strip, for any names and for narrow frames, so no word is cut off.
// Outlines stay in the picture. Each step looks otherwise than the one before, and the finished picture is
// the same after an earlier step.
TEST(Frames, NothingIsCutOff) {
  Scene scene = readScene("cycle");
  scene.mesh.groupNames = {std::string(100, 'W'), "a name of many words that goes on and on",
                           "\xC3\xA4\xC3\xB6\xC3\xBC"};
  for (const int width : {1, 64, 320, 1600, 1700}) {
    PictureSettings settings;
    settings.width = width, settings.height = 64;
    settings.camera = completed({}, scene.camera);
    const Picture picture = makePicture(scene, settings).withPlanes();
    SortSettings sort{width, 64, true};
    sort.record = true;
    const SortedScene sorted = depthSort(picture.snapped(), sort);
    const std::vector<int> steps = stepsOf(sorted, Every::Step);
    Frames frames{picture, sorted, true, steps};
    const CellPlan plan;
    std::int64_t ink = 0;
    const IndexImage finished = frames.finished();
    IndexImage last{1, 1, 0};
    for (const int step : steps) {
      const IndexImage& frame = frames.at(step);
      EXPECT_NE(frame, last) << step;
      last = frame;
      for (int j = 64; j < frame.height; ++j)
        for (int i = 0; i < frame.width; ++i) {
          ink += frame.row(j)[i] == plan[Cell::Ink];
          if (j == 64 || (i >= 4 && i < frame.width - 4 && j < frame.height - 4)) continue;
          ASSERT_EQ(frame.row(j)[i], plan[Cell::Paper]) << width << ' ' << step << ": " << i << ", " << j;
        }
      for (int j = 0; j < 64; ++j)
        for (int i = width; i < frame.width; ++i) ASSERT_EQ(frame.row(j)[i], plan[Cell::Panel]);
    }
    EXPECT_GT(ink, 1000);
    (void)frames.at(2);
    EXPECT_EQ(frames.finished(), finished);
  }
}

// The picture so far is the one that painting from the start makes, in whatever order steps are visited and
// however many copies are kept. The last one is the finished picture.
TEST(SoFar, DoesNotDependOnTheWayThere) {
  PictureSettings settings;
  settings.width = 120, settings.height = 90;
  const Picture picture = makePicture(readScene("teapot", 3), settings);
  const SortedScene& sorted = picture.sorted();
  const int all = static_cast<int>(sorted.fragments.size());
  ASSERT_GT(all, 300);
  std::vector<IndexImage> expected{{120, 90, 8}};
  SurfacePainter painter = picture.painter();
  for (const Fragment& fragment : sorted.fragments) {
    expected.push_back(expected.back());
    painter.paint(expected.back(), sorted, fragment);
  }
  ASSERT_EQ(expected.back(), picture.paint(8).image);

  constexpr std::size_t kOne = 120 * 90;
  for (const std::size_t bytes : {std::size_t{0}, kOne - 1, kOne, 7 * kOne, 1000 * kOne}) {
    SoFar soFar{picture, sorted, 8, bytes};
    std::mt19937 rng{1972};
    for (int k = 0; k < 300; ++k) {
      const int painted = k == 100 ? all : static_cast<int>(rng() % (all + 1));
      ASSERT_EQ(soFar.at(painted), expected[painted]) << bytes << ' ' << painted;
    }
  }
}

// The run of a part of a picture ends with what the whole picture shows in that part, for flat and
// interpolated shading. It has no more polygons than the picture.
TEST(SoFar, APartEndsAsTheWhole) {
  std::mt19937 rng{1969};
  for (const char* const scene : {"teapot", "room", "crossing-sheets", "penetrate"})
    for (const Shading shading : {Shading::Flat, Shading::Gouraud}) {
      SCOPED_TRACE(scene);
      PictureSettings settings;
      settings.width = 120, settings.height = 90, settings.shading = shading;
      Scene read = readScene(scene, 4);
      settings.camera = completed({}, read.camera);
      const Picture picture = makePicture(std::move(read), settings, 8);
      for (int k = 0; k < 20; ++k) {
        const glm::ivec2 low{rng() % 110, rng() % 80};
        const glm::ivec2 high = glm::min(low + glm::ivec2{1 + rng() % 40, 1 + rng() % 40}, {120, 90});
        const Picture part = picture.onlyWithin(low, high);
        ASSERT_EQ(part.snapped().faces.size(), picture.facesWithin(low, high));
        ASSERT_LE(part.snapped().faces.size(), picture.snapped().faces.size());
        SortRun run{part, 8};
        run.goTo(run.steps());
        for (int y = low.y; y < high.y; ++y)
          for (int x = low.x; x < high.x; ++x)
            ASSERT_EQ(run.soFar().row(y)[x], picture.image().row(y)[x]) << x << ", " << y;
      }
    }
}

// A segment looks like its part near the image, however far away its ends are.
TEST(Outline, FarEndsDoNotMatter) {
  for (const double far : {1e2, 1e6, 1e9, 1e12}) {
    IndexImage near{kSize, kSize, 0}, image{kSize, kSize, 0};
    Painter a{near}, b{image};
    segment(a, {-40.0, 16.5}, {80.0, 16.5}, 1);
    segment(a, {7.5, -40.0}, {7.5, 80.0}, 1);
    segment(b, {-far, 16.5}, {far, 16.5}, 1);
    segment(b, {7.5, far}, {7.5, -far}, 1);
    EXPECT_EQ(near, image) << far;
    EXPECT_EQ(count(image, 1), 2 * kSize - 1);
    segment(b, {-far, far + 100}, {far, far + 90}, 2);
    EXPECT_EQ(count(image, 2), 0);
  }
}

// Only pixels within the figure are tinted. Two halves of a square share no pixel, and together they are the
// square.
TEST(Outline, HalvesShareNoTint) {
  const Outline lower{{3, 4}, {3, 27}, {29, 27}}, upper{{3, 4}, {29, 27}, {29, 4}};
  IndexImage a{kSize, kSize, 0}, b{kSize, kSize, 0};
  Painter pa{a}, pb{b};
  const Rect area{0, 0, kSize, kSize};
  tint(pa, area, lower, Stipple::Quarter, 1);
  tint(pb, area, upper, Stipple::Quarter, 1);
  int both = 0;
  for (int j = 0; j < kSize; ++j)
    for (int i = 0; i < kSize; ++i) {
      const bool in = i >= 3 && i < 29 && j >= 4 && j < 27 && stippled(Stipple::Quarter, i, j);
      ASSERT_EQ(a.row(j)[i] + b.row(j)[i], in) << i << ' ' << j;
      both += in;
    }
  EXPECT_GT(both, 100);
}

// If the values at the corners are those of a plane, the zero line lies where the plane is zero. If all
// values have one sign, there is no line.
TEST(Outline, TheZeroLineIsWhereThePlaneIsZero) {
  const Outline square{{0, 0}, {0, 10}, {10, 10}, {10, 0}};
  int lines = 0;
  for (int a = -5; a <= 5; ++a)
    for (int c = -60; c <= 60; c += 7) {
      const auto value = [&](Place p) { return a * p.x + 3 * p.y + c; };
      std::vector<double> values;
      for (const Place& p : square) values.push_back(value(p));
      const bool both = std::ranges::min(values) < 0 && std::ranges::max(values) >= 0;
      const std::optional<Chord> line = zeroLine(square, values);
      ASSERT_EQ(line.has_value(), both);
      if (!line) continue;
      ++lines;
      EXPECT_NEAR(value(line->from), 0, 1e-9);
      EXPECT_NEAR(value(line->to), 0, 1e-9);
    }
  EXPECT_GT(lines, 50);
}

}  // namespace xnewell::THIS_FILE
