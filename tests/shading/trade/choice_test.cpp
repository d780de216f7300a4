#include "shading/trade/choice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "shading/picture/picture_cache.h"
#include "shading/scene/units.h"
#include "shading/trade/combine.h"
#include "shading/trade/measure.h"
#include "tests/support/seeds.h"
#include "tests/support/small_picture.h"

namespace xnewell::THIS_FILE {

namespace {

/// A measured combination: its time, its error elsewhere and here.
Measured with(double ratio, double elsewhere, double here, double spread = 0) {
  Measured one;
  one.cost.time = {.ms = 10 * ratio, .ratio = ratio, .interval = {ratio - spread, ratio + spread}};
  one.elsewhere = elsewhere;
  one.here.afterTable.rootMeanSquare = here;
  return one;
}

Trade tradeWith(std::vector<Measured> combinations) {
  Trade trade;
  trade.combinations = std::move(combinations);
  return trade;
}

/// The RMS error of a configuration on samples that had no part in the choice.
double freshError(const Scene& scene, const Configuration& chosen, double azimuth, double elevation) {
  PictureSettings settings = chosen.settings;
  const Picture asked = makePicture(scene, settings);
  settings.camera = moved(settings.camera, asked.camera(), asked.scene(), azimuth, elevation, 1.0);
  const Picture picture =
      makePicture(dividedAnew(scene, chosen.divisions), settings, CellPlan{settings.table.kind}[Cell::Well]);
  return errorsOf(picture, picture.palette(CellPlan{settings.table.kind})).afterTable.rootMeanSquare;
}

}  // namespace

TEST(Choice, IsTheCheapestWithinTheLimit) {
  const Trade trade =
      tradeWith({with(3, 0.01, 0.01), with(1, 0.2, 0.2), with(2, 0.04, 0.03), with(1.5, 0.03, 0.06)});
  EXPECT_EQ(chooseWithin(trade, {0.3}).combination, 1);
  EXPECT_EQ(chooseWithin(trade, {0.05}).combination, 2);  // 3 is off by more here
  EXPECT_EQ(chooseWithin(trade, {0.02}).combination, 0);
  EXPECT_TRUE(chooseWithin(trade, {0.02}).accurate);
  EXPECT_EQ(chooseWithin(trade, {0.01}).combination, 0);  // nothing to spare
  EXPECT_FALSE(chooseWithin(trade, {0.01}).accurate);
  EXPECT_EQ(chooseWithin(trade, {0.005}).combination, 0);
  EXPECT_FALSE(chooseWithin(trade, {0.005}).accurate);
  EXPECT_EQ(chooseWithin({}, {0.1}).combination, -1);
}

// Without time for a single combination it ends, and nothing is chosen.
TEST(Choice, MayHaveNoTime) {
  PictureSettings settings;
  settings.width = 40, settings.height = 30;
  TradeRequest request;
  request.seconds = 1e-9;
  request.brief = true;
  request.within = AccuracyLimit{0.1};
  const Trade trade = tradeOf(readScene("cycle"), settings, request);
  EXPECT_TRUE(trade.combinations.empty());
  EXPECT_EQ(chooseWithin(trade, {0.1}).combination, -1);
}

// Times within 15 % may be equal, and errors within 5 %. Of equals a fixed rule decides, not chance: the
// fewest changes, then the more accurate, then the order of the axes.
TEST(Choice, BreaksTiesByAFixedRule) {
  const auto chosenOf = [](const std::vector<Measured>& some) {
    return chooseWithin(tradeWith(some), {0.3}).combination;
  };
  EXPECT_EQ(chosenOf({with(1, 0.2, 0.2), with(1.05, 0.1, 0.1), with(2, 0.01, 0.01)}), 1);
  // However wide the intervals are, it must not be much slower.
  EXPECT_EQ(chosenOf({with(1, 0.2, 0.2, 0.5), with(1.3, 0.1, 0.1, 0.5)}), 0);
  // Equals end at the widest gap, so it does not matter on which side of a fixed bound a time falls.
  for (const double off : {-0.02, 0.0, 0.02}) {
    EXPECT_EQ(chosenOf({with(1, 0.2, 0.2), with(1.1 + off, 0.1, 0.1), with(1.12 + off, 0.1, 0.1)}), 1);
    EXPECT_EQ(chosenOf({with(1, 0.2, 0.2), with(1.16 + off, 0.1, 0.1), with(1.18 + off, 0.1, 0.1)}), 0);
  }
  const Axis order{settingOf(std::string_view{"--order"}), 0, {1, 2, 3}};
  const auto orderedBy = [&](Measured one, double value) {
    one.configuration = changed(one.configuration, order, value);
    return one;
  };
  Measured plain = with(1.08, 0.104, 0.104);
  Trade trade = tradeWith({orderedBy(with(1, 0.1, 0.1), 2), orderedBy(with(1.09, 0.1, 0.1), 1), plain});
  trade.axes = {order};
  EXPECT_EQ(chooseWithin(trade, {0.3}).combination, 2);  // the one without changes
  trade.combinations[2] = with(1.08, 0.2, 0.2);
  EXPECT_EQ(chooseWithin(trade, {0.3}).combination, 2);  // though it is less accurate
  trade.combinations.pop_back();
  EXPECT_EQ(chooseWithin(trade, {0.3}).combination, 1);  // the first value
  std::ranges::reverse(trade.combinations);
  EXPECT_EQ(chooseWithin(trade, {0.3}).combination, 0);
}

// A time of one run does not count.
TEST(Choice, TakesNoRoughTime) {
  Measured rough = with(0.5, 0.1, 0.1);
  rough.cost.rough = true;
  EXPECT_EQ(chooseWithin(tradeWith({rough, with(1, 0.1, 0.1)}), {0.3}).combination, 1);
  EXPECT_EQ(chooseWithin(tradeWith({rough}), {0.3}).combination, -1);
}

// The second limit counts samples that show a wrong face, here and elsewhere. Without it they do not count,
// and that is said.
TEST(Choice, KeepsASecondLimit) {
  Measured cheap = with(1, 0.04, 0.04), dear = with(2, 0.04, 0.04);
  cheap.here.wrongFaces = 1'531;
  dear.wrongElsewhere = 3;
  const Trade trade = tradeWith({cheap, dear});
  EXPECT_EQ(chooseWithin(trade, {0.05}).combination, 0);
  EXPECT_EQ(chooseWithin(trade, {0.05}).why.back(),
            "1531 samples show a wrong face. The limit is for the intensity alone.");
  EXPECT_EQ(chooseWithin(trade, {0.05, 3}).combination, 1);
  EXPECT_EQ(chooseWithin(trade, {0.05, 3}).why[2],
            "At most 3 samples of a view may show a wrong face: 3 are allowed.");
  EXPECT_FALSE(chooseWithin(trade, {0.05, 2}).accurate);
}

TEST(Choice, TellsNumbersApart) {
  using Pair = std::pair<std::string, std::string>;
  EXPECT_EQ(toldApart(0.012, 0.01), (Pair{"0.012", "0.01"}));
  EXPECT_EQ(toldApart(0.01004, 0.01), (Pair{"0.01004", "0.01"}));
  EXPECT_EQ(toldApart(0.01, 0.01), (Pair{"0.01", "0.01"}));
}

// The sentences have the numbers of the trade.
TEST(Choice, SaysWhy) {
  const Scene scene = readScene(XNEWELL_DATA_DIR "/../tests/data/dome.bpt", 4);
  const Trade trade =
      tradeOf(scene, small(), {.axes = {"shade", "divisions"}, .seconds = 600, .mostRounds = 7});
  const Chosen chosen = chooseWithin(trade, {0.1});
  ASSERT_TRUE(chosen.accurate);
  ASSERT_GE(chosen.why.size(), 4u);
  EXPECT_EQ(chosen.why[0],
            "Of " + std::to_string(trade.combinations.size()) +
                " combinations that were tried, it is the fastest within the limit, with 3 % to spare.");
  EXPECT_TRUE(chosen.why[1].starts_with("Its RMS error is at most ")) << chosen.why[1];
  EXPECT_NE(chosen.why[1].find(" in this view and in 3 turned ones, and 0.1 is allowed. It takes "),
            std::string::npos)
      << chosen.why[1];
  for (std::size_t k = 2; k + 1 < chosen.why.size(); ++k)
    EXPECT_TRUE((chosen.why[k].starts_with("Of the other values of ") &&
                 chosen.why[k].find(" that were tried, the fastest within the limit is ") < 100) ||
                (chosen.why[k].starts_with("No other value of ") &&
                 chosen.why[k].find(" that was tried suffices; ") < 100))
        << chosen.why[k];
  EXPECT_EQ(chosen.why.back(), "No sample shows a wrong face. The limit is for the intensity alone.");
  EXPECT_TRUE(chooseWithin(trade, {1e-9}).why.front().ends_with(" it is the most accurate."));
}

// Of two values that an axis has, and of more, only what was tried is told.
TEST(Choice, SaysNothingOfValuesThatWereNotTried) {
  const Axis order{settingOf(std::string_view{"--order"}), 0, {1, 2, 3}};
  Measured chosen = with(1, 0.01, 0.01), other = with(2, 0.02, 0.02);
  other.configuration = changed(other.configuration, order, 1);
  Trade trade = tradeWith({chosen});
  trade.axes = {order};
  EXPECT_EQ(chooseWithin(trade, {0.1}).why.size(), 3u);  // the order is told by its samples alone
  trade.combinations.push_back(other);
  std::vector<std::string> why = chooseWithin(trade, {0.1}).why;
  ASSERT_EQ(why.size(), 4u);
  EXPECT_TRUE(why[2].starts_with("Of the other values of order that were tried, ")) << why[2];
  trade.axes[0].others = {1};
  why = chooseWithin(trade, {0.1}).why;
  EXPECT_TRUE(why[2].ends_with(", the fastest within the limit that was tried takes 20 ms.")) << why[2];
  trade.combinations[1].elsewhere = 0.5;
  why = chooseWithin(trade, {0.1}).why;
  EXPECT_TRUE(why[2].ends_with(", the best that was tried is off by 0.5.")) << why[2];
}

// An order that is not exact may be proved right for a view: then that is said instead.
TEST(Choice, SaysThatAnOrderIsProved) {
  PictureSettings settings = small();
  const Scene scene = readScene("three-cards");
  const Trade trade =
      withSingles(tradeOf(scene, settings, {.axes = {"order"}, .seconds = 600, .mostRounds = 7}));
  int proved = 0;
  for (const Measured& one : trade.combinations) {
    const OrderRow& order = rowOf(one.configuration.settings.order);
    EXPECT_EQ(one.pairs.has_value(), !order.exact && !order.bySample && one.here.wrongFaces == 0);
    if (!one.pairs || !one.pairs->proves()) continue;
    ++proved;
    Trade alone = trade;
    alone.combinations = {one};
    const std::string why = chooseWithin(alone, {0.5}).why.back();
    EXPECT_TRUE(why.starts_with("The order is exact here: all ")) << why;
  }
  EXPECT_GT(proved, 0);
}

// What is chosen keeps its promise on other samples of the view: the camera is turned by less than a degree,
// so that every sample falls on another place. XNEWELL_ACCURACY_VIEWS sets how often.
TEST(Choice, IsHonouredOnFreshSamples) {
  const char* const asked = std::getenv("XNEWELL_ACCURACY_VIEWS");
  const int views = asked ? std::atoi(asked) : 6;
  double worst = 0;
  for (const char* name : someOf({"room", "highlight", "lamp", "teapot"}, 1)) {
    const Scene scene = readScene(name);
    const Trade trade =
        tradeOf(scene, small(), {.axes = {"shade", "order"}, .seconds = 600, .mostRounds = 7});
    for (const double limit : {0.2, 0.05}) {
      const Chosen chosen = chooseWithin(trade, {limit});
      if (!chosen.accurate) continue;
      for (int k = 0; k < views; ++k) {
        const double error = freshError(scene, trade.combinations[chosen.combination].configuration,
                                        -0.5 + 1.0 * k / views, 0.7 - 1.1 * k / views);
        worst = std::max(worst, error / limit);
      }
    }
  }
  RecordProperty("largest error, in limits", std::to_string(worst));
  EXPECT_LE(worst, 1.0);
}

}  // namespace xnewell::THIS_FILE
