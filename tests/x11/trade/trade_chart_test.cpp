#include "x11/views/trade_chart.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace xnewell::THIS_FILE {

// The chart of a trade.

// What is beyond the marks is put at the edge of their area. The scale of one combination is the narrowest.
TEST(TradeScale, PutsWhatIsBeyondAtTheEdge) {
  Measured one;
  one.cost.time = {.ms = 2, .ratio = 1};
  one.here.afterTable.rootMeanSquare = 0.001;
  Trade trade;
  trade.combinations = {one};
  const Rect area{60, 40, 300, 200};
  const TradeScale scale{area, trade, {}};
  for (const double far : {0.1, 1e9}) {
    EXPECT_EQ(scale.y(far), area.y);
    EXPECT_EQ(limitHandle(scale, far).y, limitHandle(scale, scale.errorAt(area.y)).y);
    EXPECT_EQ(scale.x(1000 * far), area.x + area.width - 1);
  }
  EXPECT_EQ(scale.y(1e-9), area.y + area.height - 1);
  EXPECT_EQ(scale.x(1e-9), area.x);
}

// The words beside the line of the limit cover no mark, wherever the marks and the line are.
TEST(TradePlot, WordsOfTheLimitCoverNoMark) {
  const Rect area{60, 40, 420, 260};
  const CellPlan plan{TableKind::Linear};
  int said = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    std::minstd_rand rng{seed + 1};
    std::uniform_real_distribution<double> share{0, 1};
    Trade trade;
    for (unsigned k = 0; k < 10 + 2 * seed; ++k) {
      Measured one;
      one.cost.time = {.ms = std::pow(10.0, 3 * share(rng)), .ratio = 1};
      one.here.afterTable.rootMeanSquare = std::pow(10.0, -3 * share(rng));
      one.configuration.settings.shading = Shading::Flat;
      trade.combinations.push_back(one);
    }
    const TradeScale scale{area, trade, {}};
    const double limit = std::pow(10.0, -3 * share(rng));
    IndexImage image{520, 340, 0};
    drawTradePlot(Painter{image}, plan, scale, trade, -1, limit);
    const int line = scale.y(limit);
    const auto good = [&](int x, int y) { return image.row(y)[x] == plan[Cell::Good]; };
    for (const Measured& one : trade.combinations) {
      const int x = scale.x(one.cost.time.ms), y = scale.y(one.here.afterTable.rootMeanSquare);
      for (int j = y - 3; j <= y + 3; ++j)
        for (int i = x - 3; i <= std::min(x + 3, area.x + area.width - 6); ++i)
          ASSERT_FALSE(good(i, j) && std::abs(j - line) > 1) << "seed " << seed;
    }
    int words = 0;
    for (int j = area.y; j < area.y + area.height; ++j)
      for (int i = area.x; i < area.x + area.width - 6; ++i) words += good(i, j) && std::abs(j - line) > 1;
    said += words > 100;
  }
  EXPECT_GT(said, 30);
}

}  // namespace xnewell::THIS_FILE
