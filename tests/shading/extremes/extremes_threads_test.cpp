#include <gtest/gtest.h>

#include "shading/extremes/extremes.h"
#include "shading/scene/scene.h"

namespace xnewell::THIS_FILE {

// The number of threads changes nothing.
TEST(Extremes, AreTheSameOnAnyNumberOfThreads) {
  const Scene scene = readScene("cycle");
  PictureSettings settings = scene.settings;
  settings.width = 16, settings.height = 12;
  const Extremes one = extremesOf(scene, settings, {}, 1);
  for (const int threads : {2, 4, 7}) {
    SCOPED_TRACE(threads);
    const Extremes many = extremesOf(scene, settings, {}, threads);
    ASSERT_EQ(many.ways.size(), one.ways.size());
    for (std::size_t k = 0; k < one.ways.size(); ++k) {
      SCOPED_TRACE(one.ways[k].name);
      EXPECT_EQ(findingOf(many.ways[k], many.setUp), findingOf(one.ways[k], one.setUp));
      ASSERT_EQ(many.ways[k].steps.size(), one.ways[k].steps.size());
      for (std::size_t s = 0; s < one.ways[k].steps.size(); ++s) {
        EXPECT_EQ(many.ways[k].steps[s].value, one.ways[k].steps[s].value);
        EXPECT_EQ(many.ways[k].steps[s].seen.samples, one.ways[k].steps[s].seen.samples);
        EXPECT_EQ(many.ways[k].steps[s].changed, one.ways[k].steps[s].changed);
      }
    }
  }
}

}  // namespace xnewell::THIS_FILE
