#include "shading/trade/search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "shading/picture/picture_cache.h"
#include "tests/support/small_picture.h"

namespace xnewell::THIS_FILE {

// What was tried has no combination twice, and none with a change that has no effect.
TEST(Search, TriesEachCombinationOnce) {
  Measure measure{readScene("cubes"), small()};
  Search search{measure, axesInReach(measure.asked())};
  for (int k = 0; k < 40; ++k) (void)search.step();
  std::set<std::string> names;
  for (const Measured& one : search.tried()) {
    EXPECT_TRUE(names.insert(one.configuration.name()).second) << one.configuration.name();
    EXPECT_TRUE(allHaveEffect(one.configuration, measure.asked())) << one.configuration.name();
  }
  EXPECT_GT(names.size(), 10u);
}

// Cheap values come before dear ones: sorts and z-buffers before Phong's method and BSP trees.
TEST(Search, BeginsWithWhatIsCheap) {
  Measure measure{readScene("teapot"), small()};
  Search search{measure, axesInReach(measure.asked())};
  for (int k = 0; k < 6; ++k) ASSERT_TRUE(search.step());
  for (const Measured& one : search.tried()) {
    EXPECT_NE(one.configuration.settings.order, Order::Bsp) << one.configuration.name();
    EXPECT_NE(one.configuration.settings.shading, Shading::Phong) << one.configuration.name();
  }
}

// It says what no combination had.
TEST(Search, SaysWhatWasNeverTried) {
  Measure measure{readScene("teapot"), small()};
  std::vector<Axis> axes = axesOf(measure.asked());
  std::erase_if(axes, [](const Axis& axis) { return axis.name() != "order" && axis.name() != "cull"; });
  Search search{measure, axes};
  EXPECT_TRUE(search.step());
  EXPECT_EQ(search.neverTried(),
            "--order none, zmean, zsort, bsp, zbuffer16, zbuffer24, zbuffer32, oracle; --cull back");
  while (search.step()) {
  }
  EXPECT_EQ(search.neverTried(), "");
  EXPECT_GE(search.nearFront(100).size(), 2u);
}

}  // namespace xnewell::THIS_FILE
