#include "x11/stepper/frames.h"
#include "shading/picture/picture_cache.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace xnewell::THIS_FILE {

namespace {

PictureSettings viewOf(const Scene& scene, int width, int height) {
  PictureSettings settings;
  settings.width = width;
  settings.height = height;
  settings.camera = completed({}, scene.camera);
  return settings;
}

/// A scene at its own camera, and its recorded run.
struct Recorded {
  Picture picture;
  SortedScene sorted;

  Recorded(const Scene& scene, int width, int height, bool textbook = true)
      : picture{makePicture(scene, viewOf(scene, width, height)).withPlanes()} {
    SortSettings sort{width, height, textbook};
    sort.record = true;
    sorted = depthSort(picture.snapped(), sort);
  }
};

}  // namespace

// A frame looks the same whether its step is reached forward, backward or directly.
TEST(Frames, DoNotDependOnTheWayThere) {
  const Recorded run{readScene("nested-cycles"), 200, 150};
  const std::vector<int> steps = stepsOf(run.sorted, Every::Step);
  ASSERT_EQ(steps.size(), run.sorted.events.size());
  Frames frames{run.picture, run.sorted, true, steps};
  std::vector<IndexImage> forward;
  for (const int step : steps) forward.push_back(frames.at(step));
  const IndexImage finished = frames.finished();
  for (const int step : {138, 100, 99, 60, 3, 77, 1}) EXPECT_EQ(frames.at(step), forward[step - 1]) << step;
  EXPECT_EQ(frames.finished(), finished);
  const auto differs = [&](int step) { return forward[step] != forward[step - 1]; };
  for (int step = 1; step < std::ssize(forward); ++step) EXPECT_TRUE(differs(step)) << step;
}

// The last frame shows the picture in the same order, with nothing over it.
TEST(Frames, TheLastOneIsThePicture) {
  for (const char* scene : {"cycle", "penetrate", "room", "decals"})
    for (const bool textbook : {true, false}) {
      Recorded run{readScene(scene), 120, 90, textbook};
      Frames frames{run.picture, run.sorted, textbook, {}};
      const IndexImage finished = frames.finished();
      const IndexImage image = run.picture.paint(CellPlan{}[Cell::Well]).image;
      ASSERT_GE(finished.width, 320);
      ASSERT_GT(finished.height, 90);
      for (int j = 0; j < 90; ++j)
        ASSERT_TRUE(std::equal(image.row(j), image.row(j) + 120, finished.row(j))) << scene << ' ' << j;
    }
}

// No word reaches into the margin of the strip, for any names and for narrow frames, so no word is cut off.
// Outlines stay in the picture.
TEST(Frames, NothingIsCutOff) {
  Scene scene = readScene("cycle");
  scene.mesh.groupNames = {std::string(100, 'W'), "a name of many words that goes on and on",
                           "\xC3\xA4\xC3\xB6\xC3\xBC"};
  for (const int width : {1, 64, 320, 1600, 1700}) {
    const Recorded run{scene, width, 64};
    const std::vector<int> steps = stepsOf(run.sorted, Every::Step);
    Frames frames{run.picture, run.sorted, true, steps};
    const CellPlan plan;
    std::int64_t ink = 0;
    for (const int step : steps) {
      const IndexImage& frame = frames.at(step);
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
  }
}

}  // namespace xnewell::THIS_FILE
