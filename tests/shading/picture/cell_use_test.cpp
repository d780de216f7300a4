#include "shading/picture/cell_use.h"
#include "shading/picture/picture_cache.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

namespace xnewell::THIS_FILE {

namespace {

struct Made {
  Picture picture;
  IndexImage image;
};

Made made(const char* scene, ColorPlan plan = ColorPlan::Needed, Shading shading = Shading::Gouraud) {
  Scene read = readScene(scene, 4);
  PictureSettings s;
  s.width = 200, s.height = 150;
  s.shading = shading;
  s.colors = plan;
  s.camera = completed({}, read.camera);
  const Picture picture = makePicture(std::move(read), s, CellPlan{}[Cell::Well]);
  return {picture, picture.image()};
}

}  // namespace

// The counts of samples and polygons are those of a count over all pixels, cell by cell, and the samples add
// up to the picture. This holds also if the depth sort has split faces and if a plan has several hues or
// colours.
TEST(CellUse, EqualsBruteForce) {
  int cells = 0, shared = 0;
  for (const auto& [scene, plan] : {std::pair{"teapot", ColorPlan::Needed},
                                    {"tori", ColorPlan::Needed},
                                    {"hues", ColorPlan::Needed},
                                    {"hues", ColorPlan::Cube},
                                    {"hues", ColorPlan::Chosen}}) {
    SCOPED_TRACE(scene);
    const Made m = made(scene, plan);
    const std::vector<std::uint32_t> faces = m.picture.faceImage();
    const CellUse use = cellUse(m.image, faces);
    for (int cell = 0; cell < 256; ++cell) {
      int samples = 0;
      std::set<std::uint32_t> shown;
      for (std::size_t k = 0; k < faces.size(); ++k) {
        samples += m.image.pixels[k] == cell;
        if (m.image.pixels[k] == cell && faces[k] != 0) shown.insert(faces[k]);
      }
      ASSERT_EQ(use.samples[cell], samples) << cell;
      ASSERT_EQ(use.polygons[cell], static_cast<int>(shown.size())) << cell;
      cells += samples > 0;
      shared += shown.size() > 1;
    }
    EXPECT_EQ(std::accumulate(use.samples.begin(), use.samples.end(), 0), 200 * 150);
    EXPECT_EQ(cellUse(m.image).samples, use.samples);
  }
  EXPECT_GT(cells, 500);
  EXPECT_GT(shared, 200);
}

// Samples that show a face have the scene's cells, and the others have the ground. Ramps divide the scene's
// cells.
TEST(CellUse, SceneCellsAreThoseOfItsSurfaces) {
  for (const ColorPlan plan : {ColorPlan::OneHue, ColorPlan::Hues, ColorPlan::Cube, ColorPlan::Chosen}) {
    const Made m = made("hues", plan);
    const CellRange scene = sceneCells(m.picture);
    const std::vector<std::uint32_t> faces = m.picture.faceImage();
    for (std::size_t k = 0; k < faces.size(); ++k)
      ASSERT_EQ(scene.has(m.image.pixels[k]), faces[k] != 0) << k;
    const std::vector<CellRange> ramps = rampsOf(m.picture);
    const bool colors = plan == ColorPlan::Cube || plan == ColorPlan::Chosen;
    EXPECT_EQ(ramps.size(), colors ? 0u : plan == ColorPlan::Hues ? 7u : 1u);
    int next = scene.first;
    for (const CellRange& ramp : ramps) EXPECT_EQ(std::exchange(next, ramp.last() + 1), ramp.first);
    if (!colors) {
      EXPECT_EQ(next, scene.last() + 1);
    }
    EXPECT_GT(usedCells(cellUse(m.image), scene), 20);
  }
}

// At most half of the samples lie below the middle cell and at most half above it, and polygons show that
// cell.
TEST(CellUse, MedianHasHalfOnEitherSide) {
  std::mt19937 rng{4};
  for (int trial = 0; trial < 200; ++trial) {
    CellUse use;
    const CellRange cells{11, 1 + static_cast<int>(rng() % 240)};
    int all = 0;
    for (int cell = 0; cell < 256; ++cell) {
      use.polygons[cell] = rng() % 3 ? 0 : static_cast<int>(rng() % 100);
      if (cells.has(cell)) all += use.polygons[cell];
    }
    const int median = medianCell(use, cells);
    const auto from = use.polygons.begin() + cells.first, at = use.polygons.begin() + median;
    const int below = std::accumulate(from, at, 0);
    EXPECT_LE(2 * below, all);
    EXPECT_LE(2 * (all - below - *at), all);
    EXPECT_TRUE(all == 0 ? median == cells.first : *at > 0);
  }
}

}  // namespace xnewell::THIS_FILE
