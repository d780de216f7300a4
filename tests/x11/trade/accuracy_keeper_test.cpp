#include "x11/trade/accuracy_keeper.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "shading/picture/picture_cache.h"
#include "shading/scene/units.h"
#include "shading/trade/measure.h"
#include "tests/support/small_picture.h"
#include "tests/x11/support/ready_workbench.h"

namespace xnewell::THIS_FILE {

namespace {

constexpr int kWidth = 160, kHeight = 120;
const TradeRequest kQuick{.brief = true, .seconds = 600, .mostRounds = 7};

/// Waits until the keeper has something to say.
AccuracyKeeper::News waited(AccuracyKeeper& keeper, const AccuracyKeeper::Seen& now) {
  for (;;) {
    if (std::optional<AccuracyKeeper::News> news = keeper.tick(now)) return *news;
    std::this_thread::sleep_for(std::chrono::milliseconds{5});
  }
}

/// The RMS error of the picture of a setup.
double errorOf(const Scene& scene, const Setup& setup) {
  PictureSettings settings = setup.picture;
  settings.width = kWidth, settings.height = kHeight;
  const CellPlan plan{settings.table.kind};
  const Picture picture = makePicture(setup.divisions > 0 ? dividedAnew(scene, setup.divisions) : scene,
                                      settings, plan[Cell::Well]);
  return errorsOf(picture, picture.palette(plan)).afterTable.rootMeanSquare;
}

}  // namespace

// What it chooses stays within the limit. It rests until the view changes, and then chooses again.
TEST(AccuracyKeeper, KeepsTheLimit) {
  const Scene scene = readScene("teapot", 3);
  AccuracyKeeper keeper{{0.12}, {}, kQuick};
  AccuracyKeeper::Seen now{scene, {}, 3, kWidth, kHeight};
  EXPECT_FALSE(keeper.rests(now));
  for (const double azimuth : {0.0, 100.0}) {
    SCOPED_TRACE(azimuth);
    if (azimuth != 0)
      now.setup.picture.camera =
          moved(now.setup.picture.camera, makePicture(scene, small()).camera(), scene, azimuth, 0, 1);
    EXPECT_FALSE(keeper.rests(now));
    const AccuracyKeeper::News news = waited(keeper, now);
    EXPECT_LE(errorOf(scene, news.setup), 0.12);
    EXPECT_TRUE(news.says.starts_with("Within 0.12 with ")) << news.says;
    now.setup = news.setup;
    EXPECT_TRUE(keeper.rests(now));
    EXPECT_FALSE(keeper.tick(now));
  }
  now.setup.picture.table.hue = {1, 1, 0};  // only a colour
  EXPECT_TRUE(keeper.rests(now));
}

// A short cut that the user chooses stays as it is; what was chosen here may change again.
TEST(AccuracyKeeper, LeavesTheUsersChoicesAlone) {
  const Scene scene = readScene("nested-cycles");
  AccuracyKeeper keeper{{0.4}, {}, kQuick};
  AccuracyKeeper::Seen now{scene, {}, 0, kWidth, kHeight};
  now.setup = waited(keeper, now).setup;
  EXPECT_NE(now.setup.picture.order, Order::Newell);  // so large an error allows every order
  now.setup.picture.order = Order::Newell;
  now.setup = waited(keeper, now).setup;
  EXPECT_EQ(now.setup.picture.order, Order::Newell);
  now.setup.picture.light.kd = 0.5;
  now.setup = waited(keeper, now).setup;
  EXPECT_EQ(now.setup.picture.order, Order::Newell);

  AccuracyKeeper told{{0.4}, {"order"}, kQuick};
  EXPECT_EQ(waited(told, {scene, {}, 0, kWidth, kHeight}).setup.picture.order, Order::Newell);
}

// Where nothing is left to choose, it says so and leaves the setup as it is.
TEST(AccuracyKeeper, SaysThatNothingIsLeft) {
  const Scene scene = readScene("nested-cycles");
  AccuracyKeeper keeper{{0.4}, choosableAxes(makePicture(scene, small())), kQuick};
  const AccuracyKeeper::News news = waited(keeper, {scene, {}, 0, kWidth, kHeight});
  EXPECT_EQ(news.setup, xnewell::Setup{});
  EXPECT_EQ(news.says, "--accuracy: every short cut is chosen already");
}

// In the window it works while the user looks at another view than 6, and tells what it chose.
TEST(AccuracyKeeper, WorksInTheWindow) {
  ReadyWorkbench bench{{}, 800, 600, "nested-cycles"};
  EXPECT_FALSE(bench.moving());
  bench.keepWithin(AccuracyLimit{0.4});
  EXPECT_EQ(bench.keptWithin(), AccuracyLimit{0.4});
  for (; bench.moving(); bench.tick()) std::this_thread::sleep_for(std::chrono::milliseconds{5});
  EXPECT_NE(bench.setup().picture.order, Order::Newell);
  bench.finish();
  bench.type("O");
  EXPECT_TRUE(bench.moving());
  bench.keepWithin(std::nullopt);
  EXPECT_FALSE(bench.moving());
}

}  // namespace xnewell::THIS_FILE
