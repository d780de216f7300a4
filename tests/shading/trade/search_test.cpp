#include "shading/trade/search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "shading/picture/picture_cache.h"
#include "shading/trade/choice.h"
#include "tests/support/seeds.h"
#include "tests/support/small_picture.h"

namespace xnewell::THIS_FILE {

namespace {

/// The choice within a limit, on all axes on which the program may choose.
struct Choosing {
  Trade trade;
  Chosen chosen;
  [[nodiscard]] const Measured& measured() const { return trade.combinations[chosen.combination]; }
};
Choosing choiceOf(const Scene& scene, const PictureSettings& settings, const AccuracyLimit& limit,
                  unsigned seed = 1) {
  TradeRequest request{.brief = true, .within = limit, .seconds = 600, .mostRounds = 21, .seed = seed};
  request.axes = choosableAxes(makePicture(scene, settings));
  Choosing choice{tradeOf(scene, settings, request), {}};
  choice.chosen = chooseWithin(choice.trade, limit);
  return choice;
}

}  // namespace

// It finds combinations that keep a limit which no single short cut keeps.
TEST(Search, KeepsLimitsThatCanBeKept) {
  struct Case {
    const char* scene;
    double limit;
  };
  PictureSettings settings = small();
  for (const Case& c : someOf({Case{"cubes", 0.01}, {"room", 0.003}, {"teapot", 0.02}}, 1)) {
    SCOPED_TRACE(c.scene);
    const Choosing choice = choiceOf(readScene(c.scene), settings, {c.limit});
    ASSERT_TRUE(choice.chosen.accurate) << choice.chosen.why.back();
    EXPECT_LE(errorOnAllViews(choice.measured()), c.limit);
    EXPECT_FALSE(choice.measured().cost.rough);
  }
}

// What was tried has no combination twice, and none with a change that has no effect.
TEST(Search, TriesEachCombinationOnce) {
  PictureSettings settings = small();
  const Choosing choice = choiceOf(readScene("cubes"), settings, {0.05});
  const Picture asked = makePicture(readScene("cubes"), settings);
  std::set<std::string> names;
  for (const Measured& one : choice.trade.combinations) {
    EXPECT_TRUE(names.insert(one.configuration.name()).second) << one.configuration.name();
    EXPECT_TRUE(allHaveEffect(one.configuration, asked)) << one.configuration.name();
  }
  EXPECT_GT(names.size(), 10u);
}

// Cheap values come before dear ones: sorts and z-buffers before Phong's method and BSP trees.
TEST(Search, BeginsWithWhatIsCheap) {
  Measure measure{readScene("teapot"), small()};
  Search search{measure, axesInReach(measure.asked()), AccuracyLimit{0.1}};
  for (int k = 0; k < 6; ++k) ASSERT_TRUE(search.step());
  for (const Measured& one : search.tried()) {
    EXPECT_NE(one.configuration.settings.order, Order::Bsp) << one.configuration.name();
    EXPECT_NE(one.configuration.settings.shading, Shading::Phong) << one.configuration.name();
  }
}

// If the time did not suffice to try anything, nothing is near the limit.
TEST(Search, MayHaveTriedNothing) {
  Measure measure{readScene("cycle"), small()};
  const Search search{measure, axesInReach(measure.asked()), AccuracyLimit{0.1}};
  EXPECT_TRUE(search.within(1, 1).empty());
}

// If nothing keeps the limit, it says what no combination had.
TEST(Search, SaysWhatWasNeverTried) {
  Measure measure{readScene("teapot"), small()};
  std::vector<Axis> axes = axesOf(measure.asked());
  std::erase_if(axes, [](const Axis& axis) { return axis.name() != "order" && axis.name() != "cull"; });
  Search search{measure, axes, AccuracyLimit{1e-6}};
  EXPECT_TRUE(search.step());
  EXPECT_EQ(search.neverTried(),
            "--order none, zmean, zsort, bsp, zbuffer16, zbuffer24, zbuffer32, oracle; --cull back");
  while (search.step()) {
  }
  EXPECT_EQ(search.neverTried(), "");
  EXPECT_TRUE(search.within(1, 1).empty());
  EXPECT_EQ(search.byError().size(), search.tried().size());
}

// If nothing keeps the limit, what is said is true: no other combination that was tried has a smaller error
// on the views that were looked at, and so the set-up itself has not. The errors are measured anew.
TEST(Search, IsTheMostAccurateIfItSaysSo) {
  const Scene scene = readScene("hues", 3);
  const AccuracyLimit limit{1e-4};
  const Choosing choice = choiceOf(scene, small(), limit);
  ASSERT_FALSE(choice.chosen.accurate);
  EXPECT_TRUE(choice.chosen.why.front().ends_with(" combinations that were tried, it is the most accurate."))
      << choice.chosen.why.front();
  Measure measure{scene, small()};
  const double least = errorOnAllViews(measure.brief(choice.measured().configuration));
  EXPECT_EQ(errorOnAllViews(choice.measured()), least);
  EXPECT_LE(least, errorOnAllViews(measure.brief(measure.askedConfiguration())));
  int others = 0;
  for (const Measured& one : choice.trade.combinations)
    if (++others % 20 == 0) {
      EXPECT_LE(least, errorOnAllViews(measure.brief(one.configuration)));
    }
  EXPECT_GT(others, 20);
}

// Samples that show a wrong face are counted on all views.
TEST(Search, KeepsASecondLimit) {
  const Scene scene = readScene("nested-cycles");
  PictureSettings settings = small();
  const Choosing one = choiceOf(scene, settings, {0.2}), both = choiceOf(scene, settings, {0.2, 5});
  ASSERT_TRUE(one.chosen.accurate && both.chosen.accurate);
  EXPECT_GT(one.measured().here.wrongFaces, 5);
  EXPECT_LE(both.measured().here.wrongFaces, 5);
  EXPECT_LE(both.measured().wrongElsewhere, 5);
}

}  // namespace xnewell::THIS_FILE
