#include <gtest/gtest.h>

#include "shading/picture/picture_cache.h"
#include "tests/support/doubt.h"
#include "tests/support/model_view.h"
#include "tests/support/painted.h"
#include "tests/support/seeds.h"

namespace xnewell::THIS_FILE {

namespace {

constexpr int kWidth = 96, kHeight = 72;

/// What one kind of view showed.
struct Tally {
  long certain = 0, doubtful = 0, culled = 0, clipped = 0, splits = 0, contacts = 0;
};

}  // namespace

// The picture of every scene in data/ is the oracle's at every sample that is not doubtful. At doubtful
// samples the painted face may touch the one on top. This holds from any side and from within, in every
// projection, with and without back faces, for the program's sort and for the textbook's.
TEST(Model, PaintsWhatTheOracleSees) {
  const Seeds seeds{96};
  std::array<Tally, kSeen.size()> tallies;
  for (const BuiltInScene& scene : builtInScenes()) {
    SCOPED_TRACE(scene.name);
    PictureCache pictures{readScene(scene.name, 6)};
    for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
      SCOPED_TRACE(seed);
      Tally& tally = tallies[seed % kSeen.size()];
      pictures.make(randomView(pictures.scene(), seed, kWidth, kHeight));
      const Picture complete = pictures.last().withPlanes();
      const SnappedScene& snapped = complete.snapped();
      tally.culled += snapped.culled;
      tally.clipped += snapped.outside;
      const std::vector<int> seen = visibleFaces(snapped, kWidth, kHeight);
      const std::vector<char> doubt = doubtful(snapped, seen, kWidth, kHeight);
      for (const bool textbook : {false, true}) {
        SCOPED_TRACE(textbook ? "textbook" : "quick");
        const SortedScene sorted =
            textbook ? depthSort(snapped, {kWidth, kHeight, true}) : pictures.last().sorted();
        const std::vector<int> shown = painted(snapped, sorted, kWidth, kHeight);
        for (int k = 0; k < kWidth * kHeight; ++k) {
          if (shown[k] != seen[k]) {
            ASSERT_TRUE(doubt[k]) << "sample " << k % kWidth << ", " << k / kWidth;
            ASSERT_NE(shown[k], kNothing);
            ASSERT_TRUE(mayTouch(snapped, shown[k], seen[k], k, kWidth));
          }
          tally.certain += seen[k] != kNothing && !doubt[k];
          tally.doubtful += doubt[k];
        }
        tally.splits += sorted.statistics.splits;
        tally.contacts += sorted.statistics.contacts;
      }
    }
  }
  if (!seeds.all()) return;
  for (const SeenRow& row : kSeen) {
    SCOPED_TRACE(row.name);
    const Tally& tally = tallies[static_cast<int>(row.id)];
    EXPECT_GT(tally.certain, 500'000);
    EXPECT_GT(tally.doubtful, 100);
    EXPECT_GT(tally.culled, 1'000);
    EXPECT_GT(tally.splits, 5'000);
    EXPECT_GT(tally.contacts, 10);
  }
  EXPECT_GT(tallies[static_cast<int>(Seen::Inside)].clipped, 3'000);
}

// Rounding near the eye does not change what is seen far away. The plates pass through each other and the
// eye's surroundings, where rounding matters most: near the eye it moves a plate by whole pixels.
TEST(Model, WhatIsNearTheEyeLeavesNoDoubtAboutTheRest) {
  long samples = 0, near = 0, splits = 0;
  for (const char* name : {"penetrate", "crossing-sheets"}) {
    SCOPED_TRACE(name);
    PictureCache pictures{readScene(name)};
    for (unsigned seed = static_cast<unsigned>(Seen::Inside); seed < 400; seed += kSeen.size()) {
      SCOPED_TRACE(seed);
      PictureSettings s = randomView(pictures.scene(), seed, kWidth, kHeight);
      s.cull = Cull::Keep;
      pictures.make(s);
      const Picture complete = pictures.last().withPlanes();
      const SnappedScene& snapped = complete.snapped();
      const std::vector<int> seen = visibleFaces(snapped, kWidth, kHeight);
      EXPECT_EQ(painted(snapped, pictures.last().sorted(), kWidth, kHeight), seen);
      samples += std::ranges::count_if(seen, [](int face) { return face != kNothing; });
      splits += pictures.last().sorted().statistics.splits;
      near += std::ranges::count_if(snapped.faces, [&](const SnappedFace& face) {
        const auto first = snapped.vertices.begin() + face.first;
        return std::any_of(first, first + face.count, [&](const glm::ivec3& v) {
          return snapped.doubtOf(face).at(v.z) > kGrid >> snapped.zShift;
        });
      });
    }
  }
  EXPECT_GT(samples, 500'000);
  EXPECT_GT(near, 100);
  EXPECT_GT(splits, 400);
}

// A split changes no shading. In every method each pixel has the colour of its face, in the painter's picture
// and in the oracle's, whatever piece shows it: the cell of the face's stored intensity.
TEST(Model, PiecesHaveTheColorOfTheirFace) {
  const Seeds seeds{24};
  long ofPieces = 0, same = 0;
  std::vector<int> colors(256, 0);
  for (const char* name : {"teapot", "tori", "cycle", "pinwheels", "slivers"}) {
    SCOPED_TRACE(name);
    PictureCache newell{readScene(name, 6)}, oracle{newell.scene()};
    for (const ShadingRow& shading : kShadings)
      for (unsigned seed = seeds.from; seed < seeds.end; ++seed) {
        SCOPED_TRACE(seed);
        PictureSettings s = randomView(newell.scene(), seed, kWidth, kHeight);
        s.shading = shading.id;
        const IndexImage image = newell.make(s, 0).image();
        s.order = Order::Oracle;
        const IndexImage exact = oracle.make(s, 0).image();
        const Picture complete = newell.last().withPlanes();
        const SnappedScene& snapped = complete.snapped();
        const ColorTable table{s.table};
        const std::vector<std::uint32_t> shown = newell.last().faceImage(), seen = oracle.last().faceImage();
        std::vector<int> face = painted(snapped, newell.last().sorted(), kWidth, kHeight);
        for (int k = 0; k < kWidth * kHeight; ++k) {
          if (face[k] == kNothing) continue;
          const SnappedFace& f = snapped.faces[face[k]];
          if (shading.id == Shading::Full) {
            ASSERT_EQ(image.pixels[k], table.cell(1.0));
          } else if (shading.id == Shading::Flat) {
            const FrontBack<double>& I = oracle.last().shading().intensities(0).I[f.number];
            ASSERT_EQ(image.pixels[k], table.cell(I.seen(f.back)));
          }
          ASSERT_EQ(shown[k], f.number + 1u);
          if (shown[k] != seen[k]) continue;
          ASSERT_EQ(image.pixels[k], exact.pixels[k]);
          ++same;
          ++colors[image.pixels[k]];
        }
        for (const Fragment& fragment : newell.last().sorted().fragments)
          if (fragment.piece >= 0)
            forEachSpan(snapped, newell.last().sorted(), fragment, kWidth, kHeight,
                        [&](int row, int from, int to) {
                          for (int i = from; i < to; ++i) ofPieces += face[row * kWidth + i] == fragment.face;
                        });
      }
  }
  if (!seeds.all()) return;
  EXPECT_GT(ofPieces, 5'000);
  EXPECT_GT(same, 100'000);
  EXPECT_GT(std::ranges::count_if(colors, [](int n) { return n > 0; }), 100);
}

}  // namespace xnewell::THIS_FILE
