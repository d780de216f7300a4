#include "x11/trade/trade_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "x11/drawing/pen.h"
#include "x11/window/layout.h"

namespace xnewell::THIS_FILE {

// The page of the trade and its chart.

namespace {

std::vector<std::uint8_t> partOf(const IndexImage& image, const Rect& r) {
  std::vector<std::uint8_t> part;
  for (int j = r.y; j < r.y + r.height; ++j)
    part.insert(part.end(), image.row(j) + r.x, image.row(j) + r.x + r.width);
  return part;
}

}  // namespace

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

// A combination off the front is not said to be on it.
TEST(TradePage, SaysWhetherAMarkIsOnTheFront) {
  const auto with = [](double ms, double error) {
    Measured one;
    one.cost.time = {.ms = ms, .ratio = ms};
    one.elsewhere = one.here.afterTable.rootMeanSquare = error;
    return one;
  };
  Trade trade;
  trade.combinations = {with(1, 0.2), with(2, 0.1), with(3, 0.15)};
  trade.front = {0, 1};
  const Layout layout = layoutOf(800, 600);
  const TradeLayout at = layoutOfTrade(layout.body, layout.picture);
  const Rect words{at.column.x + at.column.width - 130, at.column.y, 130, 14};
  // The words alone, in the same place.
  const auto said = [&](const std::string& text) {
    IndexImage image{800, 600, 0};
    const CellPlan plan{TableKind::Linear};
    Pen{Painter{image}, plan}.softRight(at.column.x + at.column.width, at.column.y + 11, text);
    return partOf(image, words);
  };
  const auto shown = [&](int chosen) {
    IndexImage image{800, 600, 0};
    drawTradePage(image, at,
                  {.trade = trade, .doing = {}, .failure = {}, .axes = {}, .chosen = chosen, .within = {}},
                  CellPlan{TableKind::Linear});
    return partOf(image, words);
  };
  EXPECT_EQ(shown(0), said("on the front"));
  EXPECT_EQ(shown(1), said("on the front"));
  EXPECT_EQ(shown(2), said("not on the front"));
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

// Only whole sentences are shown.
TEST(TradePage, EndsAtAWholeSentence) {
  const std::vector<std::string> why{"One short.", "Two words and some more words.", "Three."};
  EXPECT_EQ(wholeSentences(why, 12, 9),
            (std::vector<std::string>{"One short.", "Two words", "and some", "more words.", "Three."}));
  EXPECT_EQ(wholeSentences(why, 12, 4),
            (std::vector<std::string>{"One short.", "Two words", "and some", "more words."}));
  EXPECT_EQ(wholeSentences(why, 12, 3), (std::vector<std::string>{"One short.", "Three."}));
  EXPECT_TRUE(wholeSentences(why, 12, 0).empty());
  EXPECT_TRUE(wholeSentences(why, 12, -3).empty());
}

// The parts of the page stay apart at every size.
TEST(TradePage, PartsStayApart) {
  for (const auto& [width, height] : {std::pair{800, 540}, {800, 600}, {1024, 768}, {1400, 1000}}) {
    SCOPED_TRACE(width);
    const Layout layout = layoutOf(width, height);
    const TradeLayout at = layoutOfTrade(layout.body, layout.picture);
    const std::vector<Rect> parts{at.chart, at.well, at.controls};
    for (std::size_t a = 0; a < parts.size(); ++a)
      for (std::size_t b = a + 1; b < parts.size(); ++b)
        EXPECT_TRUE(intersection(parts[a], parts[b]).empty()) << a << b;
    EXPECT_LE(at.controls.y + at.controls.height + 20, layout.body.y + layout.body.height);
    EXPECT_TRUE(at.well.has(at.picture.x, at.picture.y));
    EXPECT_NEAR(double(at.picture.width) / at.picture.height,
                double(layout.picture.width) / layout.picture.height, 0.02);
  }
}

}  // namespace xnewell::THIS_FILE
