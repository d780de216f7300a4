#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <iterator>
#include <optional>
#include <random>
#include <thread>

#include "geometry/files/text_file.h"
#include "shading/trade/trade.h"
#include "tests/support/seeds.h"
#include "tests/support/temporary_folder.h"
#include "tests/x11/support/staged_view.h"
#include "x11/trade/trade_view.h"
#include "x11/views/trade_chart.h"

namespace xnewell::THIS_FILE {

namespace {

/// Few rounds, and a scene of few polygons: the measuring takes a second or two.
const TradeRequest kQuick{.brief = true, .seconds = 100, .mostRounds = 7};

/// A bench on a stage that has measured as `kQuick` asks.
struct Measured6 {
  StagedView stage;
  TradeView bench{stage, kQuick};
  explicit Measured6(const char* scene = "cubes", bool wholly = true) : stage{scene, 3, 800, 540} {
    stage.draw(bench);
    if (wholly) finish();
  }
  void wait() {
    std::this_thread::sleep_for(std::chrono::milliseconds{5});
    bench.tick();
  }
  void finish() {
    while (bench.moving()) wait();
    stage.draw(bench);
  }
  void press(std::string_view letters) { stage.press(bench, letters), stage.draw(bench); }
  void press(NamedKey key) { stage.press(bench, key), stage.draw(bench); }
  [[nodiscard]] TradeLayout at() const { return layoutOfTrade(stage.layout.body); }
  [[nodiscard]] const Measured& chosen() const { return bench.trade().combinations[bench.chosen()]; }
  [[nodiscard]] int count(const Rect& r, Cell cell) const {
    return static_cast<int>(std::ranges::count(stage.part(r).pixels, stage.plan[cell]));
  }
};

}  // namespace

// The view of the trade, without a server.

// What is chosen at first is the fastest that stays within the limit, but for ties.
TEST(TradeView, ChoosesWithinTheLimit) {
  constexpr double kTimeTie = 1.5;
  Measured6 m;
  ASSERT_GE(m.bench.chosen(), 0);
  m.press("=");
  ASSERT_TRUE(m.stage.question);
  EXPECT_NE(m.stage.question->take("0"), "");
  EXPECT_NE(m.stage.question->take("1"), "");
  EXPECT_NE(m.stage.question->take("small"), "");
  EXPECT_EQ(m.stage.question->take("0.1"), "");
  EXPECT_EQ(m.bench.limit(), 0.1);
  EXPECT_LE(errorOnAllViews(m.chosen()), m.bench.limit());
  for (const Measured& one : m.bench.trade().combinations)
    if (errorOnAllViews(one) <= 0.9 * m.bench.limit()) {
      EXPECT_GE(kTimeTie * one.cost.time.ratio, m.chosen().cost.time.ratio);
    }
  const double before = m.bench.limit(), ratio = m.chosen().cost.time.ratio;
  for (int k = 0; k < 20; ++k) m.press(NamedKey::Up);
  EXPECT_GT(m.bench.limit(), before);
  EXPECT_LE(m.chosen().cost.time.ratio, kTimeTie * ratio);  // a wider limit allows what the other one did
  for (int k = 0; k < 100; ++k) m.press(NamedKey::Down);
  EXPECT_DOUBLE_EQ(m.bench.limit(), 0.001);
  const double least =
      errorOnAllViews(*std::ranges::min_element(m.bench.trade().combinations, {}, errorOnAllViews));
  EXPECT_LE(errorOnAllViews(m.chosen()), kErrorTie * std::max(least, 0.001));
}

// The arrows go along the front, from the fastest to the slowest.
TEST(TradeView, WalksAlongTheFront) {
  if (kSanitized) GTEST_SKIP() << "the front is of times, and sanitizers change them";
  // On a busy machine the most accurate may seem the fastest. Then the front has one place only.
  std::optional<Measured6> measured;
  for (int tries = 0; tries < 10 && (!measured || measured->bench.trade().front.size() < 2); ++tries)
    measured.emplace("coarse-teapot");
  Measured6& m = *measured;
  const std::vector<int> front = m.bench.trade().front;
  ASSERT_GE(front.size(), 2u);
  for (std::size_t k = 0; k < front.size(); ++k) m.press(NamedKey::Left);
  EXPECT_EQ(m.bench.chosen(), front.front());
  for (const int at : front) {
    EXPECT_EQ(m.bench.chosen(), at);
    m.press(NamedKey::Right);
  }
  EXPECT_EQ(m.bench.chosen(), front.back());
}

// What the user picks stays chosen while the measuring goes on. Another limit chooses again.
TEST(TradeView, KeepsWhatIsPicked) {
  if (kSanitized) GTEST_SKIP() << "the front is of times, and sanitizers change them";
  Measured6 m{"coarse-teapot", false};
  StagedView& stage = m.stage;
  TradeView& bench = m.bench;
  while (bench.moving() && bench.trade().front.size() < 2) m.wait();
  ASSERT_TRUE(bench.moving());
  const auto changes = [&] { return m.chosen().configuration.changes; };
  const auto chosenByLimit = changes();
  const std::size_t known = bench.trade().combinations.size();
  for (int k = 0; k < 100; ++k) stage.press(bench, NamedKey::Right);
  if (changes() == chosenByLimit)
    for (int k = 0; k < 100; ++k) stage.press(bench, NamedKey::Left);
  const auto picked = changes();
  ASSERT_NE(picked, chosenByLimit);
  m.finish();
  EXPECT_GT(bench.trade().combinations.size(), known);
  EXPECT_EQ(changes(), picked);
  for (int k = 0; k < 100; ++k) stage.press(bench, NamedKey::Down);
  const auto least = std::ranges::min_element(bench.trade().combinations, {}, errorOnAllViews);
  // Of equally accurate ones, the fastest is taken.
  EXPECT_LE(errorOnAllViews(m.chosen()), kErrorTie * errorOnAllViews(*least));
}

// A click on a mark chooses it.
TEST(TradeView, AMarkCanBeClicked) {
  Measured6 m;
  const TradeScale scale{m.at().chart, m.bench.trade(), {}};
  for (const int at : m.bench.trade().front) {
    const Measured& one = m.bench.trade().combinations[at];
    const int x = scale.x(TradeAxes{}.costOf(one)), y = scale.y(TradeAxes{}.errorOf(one));
    EXPECT_FALSE(m.bench.grab(x, y));
    m.stage.draw(m.bench);
    EXPECT_EQ(scale.x(TradeAxes{}.costOf(m.chosen())), x);
    EXPECT_EQ(scale.y(TradeAxes{}.errorOf(m.chosen())), y);
  }
}

// The slider, the line of the limit and its handle, on both sides of the chart's edge, can be dragged; they
// move together.
TEST(TradeView, TheLimitCanBeDragged) {
  Measured6 m;
  const Rect track = m.bench.list().find({'E'})->track, chart = m.at().chart;
  ASSERT_TRUE(m.bench.grab(track.x + track.width / 2, track.y));
  m.bench.drop();
  EXPECT_NEAR(m.bench.limit(), valueAt(kLimits, 0.5), 1e-4);
  m.stage.draw(m.bench);
  const TradeScale scale{chart, m.bench.trade(), {}};
  // Far from all marks there is only the line.
  ASSERT_TRUE(m.bench.grab(chart.x + chart.width - 2, scale.y(m.bench.limit())));
  m.bench.dragTo(chart.x + chart.width - 2, chart.y + chart.height / 3);
  m.bench.drop();
  EXPECT_NEAR(m.bench.limit(), scale.errorAt(chart.y + chart.height / 3), 1e-12);
  m.press("=");
  ASSERT_EQ(m.stage.question->take("0.1"), "");
  m.stage.draw(m.bench);
  const Rect handle = limitHandle(TradeScale{chart, m.bench.trade(), {}}, m.bench.limit());
  EXPECT_EQ(m.count(handle, Cell::Good), handle.width * handle.height);
  for (int x = handle.x; x < handle.x + handle.width; ++x) {
    EXPECT_TRUE(m.bench.grab(x, handle.y + 1)) << x;
    m.bench.drop();
  }
  EXPECT_FALSE(m.bench.grab(handle.x + handle.width, handle.y + 1));
}

// Return uses the chosen combination in all views; 5 also puts it beside the set-up without short cuts.
TEST(TradeView, UsesAndComparesWhatIsChosen) {
  Measured6 m{"coarse-teapot"};
  for (int k = 0; k < 100; ++k) m.stage.press(m.bench, NamedKey::Right);
  m.stage.draw(m.bench);
  for (const Change& change : m.chosen().configuration.changes)
    if (change.setting) {
      EXPECT_NE(change.setting->field.get(m.stage.now.picture),
                change.setting->field.get(m.chosen().configuration.settings));
    }
  const Configuration used = m.chosen().configuration;
  m.press(NamedKey::Return);
  EXPECT_EQ(m.stage.undone.size(), 1u);
  for (const Change& change : used.changes)
    if (change.setting)
      EXPECT_EQ(change.setting->field.get(m.stage.now.picture), change.setting->field.get(used.settings));
    else
      EXPECT_EQ(m.stage.now.divisions, change.value);
  EXPECT_NE(m.bench.trade().combinations.size(), 0u);  // it is still there, and told to be of before
  m.press("5");
  ASSERT_TRUE(m.stage.compared);
  EXPECT_EQ(m.stage.compared->picture, withoutShortCuts(m.stage.now.picture));
  EXPECT_EQ(m.stage.compared->divisions, m.stage.now.divisions);
  EXPECT_TRUE(m.stage.notices.back().ends_with(", and B has no short cuts, but the same divisions."))
      << m.stage.notices.back();
}

// The worst places lie within the picture. n goes from one to the next.
TEST(TradeView, ShowsTheWorstPlaces) {
  Measured6 m;
  const Rect well = m.bench.well();
  const std::vector<Rect> frames = m.bench.places();
  ASSERT_GE(frames.size(), 2u);
  for (const Rect& frame : frames) EXPECT_FALSE(intersection(frame, well).empty());
  EXPECT_EQ(std::ranges::max(m.chosen().here.worst, {}, &WorstPlace::error).error,
            m.chosen().here.worst.front().error);
  const IndexImage first = m.stage.part(well);
  EXPECT_GT(m.count(frames[0], Cell::White), 0);
  m.press("n");
  EXPECT_NE(m.stage.part(well).pixels, first.pixels);
  for (std::size_t k = 1; k < frames.size(); ++k) m.press("n");
  EXPECT_EQ(m.stage.part(well).pixels, first.pixels);
}

// X and Y change what the axes show, and the front is one of these axes.
TEST(TradeView, HasOtherAxes) {
  Measured6 m;
  const IndexImage first = m.stage.part(m.at().chart);
  for (const auto& [key, same] : {std::pair{"X", false}, {"X", true}, {"Y", false}}) {
    m.press(key);
    EXPECT_EQ(m.stage.part(m.at().chart) == first, same);
  }
  for (const TradeCostRow& cost : kTradeCosts)
    for (const TradeErrorRow& error : kTradeErrors) {
      const TradeAxes axes{cost.id, error.id};
      const std::vector<int> front = frontBy(axes, m.bench.trade());
      if (axes == TradeAxes{}) continue;  // that one is chosen by other views
      for (const Measured& one : m.bench.trade().combinations)
        EXPECT_FALSE(std::ranges::all_of(front,
                                         [&](int k) {
                                           const Measured& best = m.bench.trade().combinations[k];
                                           return axes.costOf(one) < axes.costOf(best) ||
                                                  axes.errorOf(one) < axes.errorOf(best);
                                         }) &&
                     axes.errorOf(one) < axes.errorOf(m.bench.trade().combinations[front.back()]));
    }
}

// w saves the chart or the table, and asks before it replaces a file.
TEST(TradeView, SavesChartAndTable) {
  Measured6 m{"room"};
  const TemporaryFolder folder;
  m.press("w");
  ASSERT_TRUE(m.stage.question);
  EXPECT_EQ(m.stage.question->text, "room-trade.png");
  const auto take = m.stage.question->take;
  EXPECT_NE(take(folder.file("trade.json")), "");
  EXPECT_NE(take(folder.file("none/trade.txt")), "");
  const std::string file = folder.file("trade.txt");
  EXPECT_EQ(take(file), "");
  std::ifstream saved{file};
  const std::string table{std::istreambuf_iterator<char>{saved}, {}};
  for (const int k : m.bench.trade().front)
    EXPECT_NE(table.find("* " + m.bench.trade().combinations[k].configuration.name()), std::string::npos);
  EXPECT_NE(take(file), "");
  EXPECT_EQ(take(file), "");
  EXPECT_EQ(take(folder.file("trade.png")), "");
  EXPECT_TRUE(readTextFile(folder.file("trade.png")).starts_with("\x89PNG"));
}

// Another set-up makes the numbers old; m measures again. Another view ends the measuring.
TEST(TradeView, MeasuresAgainWhenAsked) {
  Measured6 m;
  const IndexImage before = m.stage.part(m.stage.layout.body);
  m.stage.now.picture.light.kd = 0.3;
  m.stage.draw(m.bench);
  EXPECT_NE(m.stage.part(m.stage.layout.body).pixels, before.pixels);
  EXPECT_FALSE(m.bench.moving());
  m.press("m");
  EXPECT_TRUE(m.bench.moving());
  m.finish();
  EXPECT_EQ(m.bench.trade().asked.configuration.settings.light.kd, 0.3);
  m.press("m");
  m.bench.leave();
  EXPECT_FALSE(m.bench.moving());
  m.stage.draw(m.bench);  // it is here again
  EXPECT_TRUE(m.bench.moving());
}

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
