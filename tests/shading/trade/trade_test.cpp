#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <malloc.h>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <set>
#include <stdexcept>

#include "shading/laboratory/errors.h"
#include "shading/picture/picture_cache.h"
#include "shading/scene/units.h"
#include "shading/trade/measure.h"
#include "shading/trade/timing.h"
#include "shading/trade/trade.h"
#include "tests/support/seeds.h"
#include "tests/support/small_picture.h"

namespace xnewell::THIS_FILE {

namespace {

using testing::Contains, testing::IsSupersetOf, testing::Not;

/// ---- Time against accuracy

Trade quickTrade(const std::string& scene, const PictureSettings& settings, TradeRequest request,
                 const TradeProgress& progress = {}) {
  request.seconds = 600;  // however slow the machine is, nothing is left out
  request.mostRounds = 7;
  return tradeOf(readScene(scene), settings, request, progress);
}

const TradeRow& rowOf(const Trade& trade, std::string_view axis, std::string_view value) {
  for (const TradeRow& row : trade.rows)
    if (trade.axes[row.axis].name() == axis && trade.axes[row.axis].text(row.value) == value) return row;
  throw std::runtime_error{"no such row"};
}

std::vector<std::string> namesOf(const std::vector<Axis>& axes) {
  std::vector<std::string> names;
  for (const Axis& axis : axes) names.emplace_back(axis.name());
  return names;
}

/// A measured configuration with these numbers: its time, its error elsewhere and here.
Measured with(double ratio, double elsewhere, double here = 0, double spread = 0) {
  Measured one;
  one.cost.time = {.ms = 10 * ratio, .ratio = ratio, .interval = {ratio - spread, ratio + spread}};
  one.elsewhere = elsewhere;
  one.here.afterTable.rootMeanSquare = here;
  return one;
}

// The short cuts that a picture has. Those without an effect are no axes.
TEST(Trade, AxesAreTheShortCutsWithAnEffect) {
  PictureSettings settings = small();
  const auto axes = [&](const std::string& scene) {
    return namesOf(axesOf(makePicture(readScene(scene), settings)));
  };
  const auto flat = axes("teapot");
  EXPECT_THAT(flat,
              IsSupersetOf({"divisions", "shade", "order", "cull", "table", "shades", "adapt", "bits"}));
  // fill needs a server; the others interpolate, need a lamp at a place, or are of the model.
  for (const char* name : {"fill", "normals", "polygons", "constant-l", "ka", "hue", "form"})
    EXPECT_THAT(flat, Not(Contains(name)));
  // The files of these scenes give the divisions, but colored-lights gives those of the floor alone.
  for (const char* name : {"cycle", "lamp", "coarse-teapot"})
    EXPECT_THAT(axes(name), Not(Contains("divisions")));
  EXPECT_THAT(axes("colored-lights"), Contains("divisions"));
  settings.shading = Shading::Gouraud;
  settings.light.lightPosition = glm::dvec3{1, 1, 1};
  EXPECT_THAT(axes("teapot"), IsSupersetOf({"normals", "polygons", "constant-l"}));
}

// Some have an effect only beside others. The program may choose all of them but the plan of the colours.
TEST(Trade, AxesInReachHaveAnEffectBesideOthers) {
  const Picture flat = makePicture(readScene("teapot"), small());
  const std::vector<Axis> axes = axesOf(flat, Reach::BesideOthers);
  const std::vector<std::string> near = namesOf(axesOf(flat)), reach = namesOf(axes),
                                 choosable = choosableAxes(flat);
  for (const char* name : {"normals", "crease", "polygons", "interpolate", "unnormalized", "environment",
                           "mapping", "i0", "pick"}) {
    EXPECT_THAT(reach, Contains(name));
    EXPECT_THAT(near, Not(Contains(name)));
  }
  EXPECT_EQ(choosable.size() + 1, reach.size());
  EXPECT_THAT(choosable, Not(Contains("colors")));
  EXPECT_EQ(std::ranges::find(axes, "divisions", &Axis::name)->others.back(), 64);
}

// Each row differs from the set-up in one short cut, and its errors are those of that picture. Errors in
// other views are equal to the bit in every run.
TEST(Trade, RowsAreThePicturesOfOneShortCut) {
  const PictureSettings settings = small();
  const Trade trade =
      quickTrade("nested-cycles", settings, {.axes = {"order", "shade"}, .without = {"shade=depth"}});
  EXPECT_FALSE(trade.stopped);
  EXPECT_EQ(trade.rows.size(), kOrders.size() - 1 + kShadings.size() - 2);
  EXPECT_THROW((void)rowOf(trade, "shade", "depth"), std::runtime_error);
  const Trade again = quickTrade("nested-cycles", settings, {.axes = {"order"}});
  const Scene scene = readScene("nested-cycles");
  for (const OrderRow& order : kOrders) {
    if (order.id == settings.order) continue;
    SCOPED_TRACE(order.name);
    const TradeRow& row = rowOf(trade, "order", order.name);
    PictureSettings other = settings;
    other.order = order.id;
    const Picture picture = makePicture(scene, other, CellPlan{}[Cell::Well]);
    EXPECT_EQ(row.measured.here.wrongFaces, exactnessOf(picture).wrong);
    const Errors errors = errorsOf(picture, picture.palette(CellPlan{}));
    EXPECT_EQ(row.measured.here.afterTable.rootMeanSquare, errors.afterTable.rootMeanSquare);
    EXPECT_EQ(row.measured.here.color.largest, errors.color.largest);
    EXPECT_EQ(row.measured.elsewhere, rowOf(again, "order", order.name).measured.elsewhere);
    EXPECT_GT(row.measured.cost.time.ms, 0);
    if (!kSanitized) {  // whose heap does not tell
      EXPECT_GT(row.measured.cost.bytes, std::int64_t{settings.width} * settings.height);
    }
  }
  EXPECT_GT(rowOf(trade, "order", "none").measured.here.wrongFaces, 0);
  EXPECT_NE(rowOf(trade, "order", "none").sentence.find("more samples show a wrong face"), std::string::npos);
  EXPECT_TRUE(rowOf(trade, "order", "oracle").measured.samePixels);
  EXPECT_NE(rowOf(trade, "order", "oracle").sentence.find("shows the same picture"), std::string::npos);
  EXPECT_FALSE(rowOf(trade, "shade", "phong").measured.samePixels);
}

// With more divisions a picture comes nearer to the patches. All are measured against one reference.
TEST(Trade, MoreDivisionsComeNearerToThePatches) {
  PictureSettings settings = small();
  settings.shading = Shading::Phong;
  const Trade trade =
      quickTrade(XNEWELL_DATA_DIR "/../tests/data/dome.bpt", settings, {.axes = {"divisions"}});
  EXPECT_EQ(trade.referenceDivisions, 64);
  ASSERT_TRUE(trade.referenceOff);
  EXPECT_LT(trade.referenceOff->largestPixels, 0.1);  // one patch fills the picture
  double last = 1;
  for (const char* n : {"1", "2", "4", "16"}) {
    const Errors& errors = rowOf(trade, "divisions", n).measured.here;
    EXPECT_LT(errors.afterTable.rootMeanSquare, 0.7 * last) << n;
    EXPECT_EQ(errors.wrongFaces, 0) << n;  // of its own polygons
    last = errors.afterTable.rootMeanSquare;
  }
}

TEST(Trade, RefusesWhatIsNotThere) {
  const auto refusal = [](TradeRequest request) -> std::string {
    try {
      static_cast<void>(quickTrade("cycle", small(), std::move(request)));
    } catch (const std::invalid_argument& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_EQ(refusal({.axes = {"divisions"}}).find("'divisions' is no short cut of this picture: these are "),
            0u);
  EXPECT_EQ(refusal({.without = {"order"}}), "--without order: AXIS=VALUE is needed, such as order=none");
  EXPECT_EQ(refusal({.without = {"cull=front"}}), "--without cull=front: the values to try are back");
}

// The caller may stop it at any time. Then what is known comes back.
TEST(Trade, StopsWhenItIsTold) {
  int most = 0;
  static_cast<void>(quickTrade("cycle", small(), {.axes = {"order"}},
                               [&](const std::string&, const Trade&) { return ++most > 0; }));
  for (const int calls : {0, 2, 5, most / 2}) {
    int left = calls;
    const Trade trade = quickTrade("cycle", small(), {.axes = {"order"}},
                                   [&](const std::string&, const Trade&) { return left-- > 0; });
    EXPECT_TRUE(trade.stopped) << calls;
    EXPECT_LE(trade.rows.size(), kOrders.size() - 1);
    EXPECT_LE(static_cast<int>(trade.rows.size()), calls);
  }
}

// One picture that takes long cannot take much more than the time that there is. So without time nothing is
// timed, and what was left out is told.
TEST(Trade, GivesUpWhatTakesTooLong) {
  const Trade trade = tradeOf(readScene("teapot"), small(), {.axes = {"order"}, .seconds = 1e-9});
  EXPECT_FALSE(trade.stopped);
  EXPECT_TRUE(trade.rows.empty());
  ASSERT_FALSE(trade.notes.empty());
  EXPECT_TRUE(trade.notes[0].starts_with("the time did not suffice (--budget) for --order none"));
  EXPECT_EQ(trade.ofRows.rounds, 0);
  EXPECT_EQ(trade.ofRows.ended, Ended::OutOfTime);
  EXPECT_GT(trade.asked.here.samples, 0);
  EXPECT_TRUE(trade.combinations.empty());
  EXPECT_EQ(chooseWithin(trade, {0.1}).combination, -1);
}

// The time that was given is kept within a tenth, and it is used: the combinations have their times. Without
// any time the references and the set-up are measured all the same, so the time that is given is some times
// as long.
TEST(Trade, KeepsItsTime) {
  const auto secondsFor = [](double seconds, Trade* made) {
    const double start = processorMs();
    Trade trade = tradeOf(readScene("teapot", 4), small(), {.seconds = seconds});
    if (made) *made = std::move(trade);
    return (processorMs() - start) / 1e3;
  };
  const double least = secondsFor(1e-9, nullptr);
  for (const double times : {12, 30}) {
    Trade trade;
    EXPECT_LT(secondsFor(times * least, &trade), 1.1 * times * least);
    EXPECT_GE(trade.combinations.size(), 8u);
    EXPECT_GT(trade.ofCombinations.rounds, 0);
  }
}

// No combination beats one on the front, unless their times or their errors are a tie.
TEST(Trade, NothingBeatsTheFront) {
  PictureSettings settings = small();
  const Trade trade = quickTrade("coarse-teapot", settings, {.axes = {"shade", "order"}});
  ASSERT_FALSE(trade.front.empty());
  EXPECT_LE(trade.combinations.size(), static_cast<std::size_t>(kMostCombinations));
  for (const int k : trade.front) {
    const Measured& one = trade.combinations[k];
    EXPECT_GT(one.here.color.count, 0);  // it was looked at closely
    for (const Measured& other : trade.combinations)
      EXPECT_FALSE(kErrorTie * other.elsewhere < one.elsewhere &&
                   other.cost.time.interval.high < one.cost.time.interval.low)
          << other.configuration.name() << " beats " << one.configuration.name();
  }
  std::set<std::string> names;
  for (const Measured& one : trade.combinations) names.insert(one.configuration.name());
  EXPECT_EQ(names.size(), trade.combinations.size());
}

TEST(Front, HasWhatIsCheaperOrMoreAccurate) {
  EXPECT_EQ(frontOf({}), (std::vector<int>{}));
  EXPECT_EQ(frontOf({with(1, 0.1)}), (std::vector{0}));
  EXPECT_EQ(frontOf({with(2, 0.1), with(1, 0.3), with(1.5, 0.2), with(1.7, 0.25), with(3, 0.1)}),
            (std::vector{1, 2, 0}));
  // The first two are equally fast as far as their times tell.
  EXPECT_EQ(frontOf({with(1, 0.3, 0, 0.1), with(1.05, 0.2, 0, 0.1), with(2, 0.1, 0, 0.1)}),
            (std::vector{1, 2}));
  // The last is six times slower for the same error.
  EXPECT_EQ(frontOf({with(1, 0.3), with(2, 0.00111), with(12, 0.00109)}), (std::vector{0, 1}));
}

TEST(Trade, SaysWhatIsSaved) {
  EXPECT_EQ(savingOf({.ms = 1, .ratio = 0.77}), "saves 23 % of the time");
  EXPECT_EQ(savingOf({.ms = 1, .ratio = 1.04}), "takes 4 % longer");
  EXPECT_EQ(savingOf({.ms = 1, .ratio = 1.44}), "takes 1.4 times as long");
  EXPECT_EQ(savingOf({.ms = 1, .ratio = 12.3}), "takes 12 times as long");
  EXPECT_EQ(savingOf({.ms = 1, .ratio = 0.98, .tie = true}), "takes as long");
}

// A held camera shows the same picture, sample by sample.
TEST(Trade, HoldsTheCamera) {
  for (const char* name : {"teapot", "room", "cycle"})
    for (const bool parallel : {false, true}) {
      PictureSettings settings = small();
      settings.camera.parallel = parallel;
      const Scene scene = readScene(name);
      const Picture picture = makePicture(scene, settings, 0);
      settings.camera = heldCamera(picture);
      const Picture held = makePicture(scene, settings, 0);
      EXPECT_EQ(held.image().pixels, picture.image().pixels) << name;
    }
}

// The same scene with other divisions has the same camera and light, in the same units.
TEST(Trade, DividesAnewInTheSameUnits) {
  const Scene eight = readScene("teapot", 8), one = dividedAnew(eight, 1);
  EXPECT_EQ(one.divisions, 1);
  EXPECT_EQ(one.exponent, eight.exponent);
  // Corners of the patches are corners with any divisions.
  for (const glm::dvec3& p : one.mesh.points)
    EXPECT_NE(std::ranges::find(eight.mesh.points, p), eight.mesh.points.end());
}

// A measure holds the faces of the scene once, however many views it has: its four references and the picture
// that was asked for keep what they show.
TEST(Measure, HoldsTheFacesOnce) {
#ifdef __GLIBC__
  if (kSanitized) GTEST_SKIP() << "the heap is not counted";
  const auto heap = [] {
    const struct mallinfo2 now = ::mallinfo2();
    return static_cast<std::int64_t>(now.uordblks + now.hblkhd);
  };
  const Shared<Scene> scene{readScene("teapot", 100)};
  const std::int64_t before = heap();
  Measure measure{scene, small()};
  EXPECT_EQ(measure.otherViews(), 3);
  const std::int64_t picture = measure.brief(measure.askedConfiguration()).cost.bytes;
  EXPECT_GT(picture, 50'000'000);
  EXPECT_LT(heap() - before, picture);
#else
  GTEST_SKIP() << "the heap is not counted";
#endif
}

/// ---- Choices

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

// The second limit counts samples of the user's view that show a wrong face. Without it they do not count,
// and that is said.
TEST(Choice, KeepsASecondLimit) {
  Measured cheap = with(1, 0.04, 0.04), dear = with(2, 0.02, 0.02);
  cheap.here.wrongFaces = 1'531;
  dear.here.wrongFaces = 3;
  const Trade trade = tradeWith({cheap, dear});
  EXPECT_EQ(chooseWithin(trade, {0.05}).combination, 0);
  EXPECT_EQ(chooseWithin(trade, {0.05}).why.back(),
            "1531 samples show a wrong face. The limit is for the intensity alone.");
  EXPECT_EQ(chooseWithin(trade, {0.05, 3}).combination, 1);
  EXPECT_EQ(chooseWithin(trade, {0.05, 3}).why.back(), "3 samples show a wrong face. 3 may.");
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
  ASSERT_GE(chosen.why.size(), 3u);
  EXPECT_EQ(chosen.why[0], "Of " + std::to_string(trade.combinations.size()) +
                               " combinations that were timed, it is the cheapest on the front within the "
                               "limit, with 3 % to spare.");
  EXPECT_TRUE(chosen.why[1].starts_with("Its RMS error is at most ")) << chosen.why[1];
  EXPECT_NE(chosen.why[1].find(" in this view and in 3 turned ones, and 0.1 is allowed. It takes "),
            std::string::npos)
      << chosen.why[1];
  EXPECT_EQ(chosen.why.back(), "No sample shows a wrong face. The limit is for the intensity alone.");
  EXPECT_TRUE(chooseWithin(trade, {1e-9}).why.front().ends_with(" it is the most accurate."));
}

// The point of the front that is next in cost, and too far off, is told.
TEST(Choice, SaysWhatIsCheaper) {
  Trade trade = tradeWith({with(1, 0.2, 0.2), with(2, 0.04, 0.04), with(1.5, 0.3, 0.3)});
  trade.front = frontOf(trade.combinations);
  EXPECT_EQ(chooseWithin(trade, {0.1}).why[2],
            "The next cheaper on the front, as it is, takes 10 ms and is off by 0.2.");
  EXPECT_EQ(chooseWithin(trade, {0.3}).why.size(), 3u);
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

/// ---- Times

/// A machine whose speed changes: each run takes the way's own time, times what the moment costs.
class Machine {
 public:
  explicit Machine(unsigned seed) : random_{seed} {}

  Timed way(double ms) {
    return [this, ms] {
      // It slows down and speeds up by a factor of 3 over forty runs, and some runs are interrupted.
      const double moment = std::exp(std::log(3.0) / 2 * std::sin(2 * M_PI * ++runs_ / 40.0));
      const double noise = 1 + 0.03 * std::uniform_real_distribution<>{-1, 1}(random_);
      const double interrupted = std::uniform_int_distribution<>{0, 19}(random_) == 0 ? 5 : 1;
      return ms * moment * noise * interrupted;
    };
  }
  [[nodiscard]] int runs() const { return runs_; }

 private:
  std::mt19937 random_;
  int runs_ = 0;
};

TEST(Timing, FindsRatiosOnAMachineWhoseSpeedChanges) {
  Machine machine{1};
  const std::vector<Timed> ways{machine.way(10), machine.way(5), machine.way(10), machine.way(12)};
  const Timings timings = timeAll(ways, {.seconds = 1000, .mostRounds = 150});
  EXPECT_NEAR(timings.of[1].ratio, 0.5, 0.02);
  EXPECT_NEAR(timings.of[3].ratio, 1.2, 0.05);
  EXPECT_EQ(timings.of[0].ratio, 1.0);
  EXPECT_TRUE(timings.of[0].tie);
  EXPECT_FALSE(timings.of[1].tie);
  EXPECT_TRUE(timings.of[2].tie);
  EXPECT_FALSE(timings.of[3].tie);
  EXPECT_EQ(machine.runs(), timings.rounds * 5);
}

// Ways that are equally fast are called a tie nearly always, on many such machines.
TEST(Timing, CallsEqualWaysATie) {
  int ties = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    Machine machine{seed};
    const std::vector<Timed> ways{machine.way(10), machine.way(10)};
    ties += timeAll(ways, {.seconds = 1000, .mostRounds = 21, .seed = seed}).of[1].tie;
  }
  EXPECT_GE(ties, 194);
}

// In each round every way runs once and the base twice, and the order changes.
TEST(Timing, RunsInTurn) {
  std::vector<int> ran;
  const auto way = [&](int k) { return Timed{[&ran, k] { return ran.push_back(k), 1.0 + k; }}; };
  const std::vector<Timed> ways{way(0), way(1), way(2)};
  const Timings timings = timeAll(ways, {.seconds = 1000, .leastRounds = 10, .mostRounds = 10});
  ASSERT_EQ(timings.rounds, 10);
  ASSERT_EQ(ran.size(), 40u);
  std::set<std::vector<int>> orders;
  for (std::size_t k = 0; k < ran.size(); k += 4) {
    std::vector<int> round{ran.begin() + static_cast<std::ptrdiff_t>(k),
                           ran.begin() + static_cast<std::ptrdiff_t>(k + 4)};
    orders.insert(round);
    std::ranges::sort(round);
    EXPECT_EQ(round, (std::vector{0, 0, 1, 2}));
  }
  EXPECT_GT(orders.size(), 3u);
}

TEST(Timing, EndsAsItSays) {
  const std::vector<Timed> constant{[] { return 2.0; }, [] { return 3.0; }};
  const Timings sure = timeAll(constant);
  EXPECT_EQ(sure.ended, Ended::Sure);
  EXPECT_EQ(sure.rounds, TimingLimits{}.leastRounds);
  EXPECT_EQ(sure.of[1].ms, 3.0);
  EXPECT_EQ(sure.of[1].interval.low, 1.5);
  EXPECT_EQ(sure.of[1].interval.high, 1.5);

  Machine machine{3};
  const std::vector<Timed> noisy{machine.way(10), machine.way(11)};
  EXPECT_EQ(timeAll(noisy, {.seconds = 0}).ended, Ended::OutOfTime);
  EXPECT_EQ(timeAll(noisy, {.seconds = 0}).rounds, TimingLimits{}.leastRounds);
  EXPECT_EQ(timeAll(noisy, {.seconds = 1000, .mostRounds = 8}).ended, Ended::OutOfTime);

  // A round that was not finished does not count.
  int calls = 0;
  const Timings stopped = timeAll(constant, {}, [&](int, const Timings&) { return ++calls <= 7; });
  EXPECT_EQ(stopped.ended, Ended::Stopped);
  EXPECT_EQ(stopped.rounds, 2);
  EXPECT_EQ(stopped.of[1].ms, 3.0);
  const Timings none = timeAll(constant, {}, [](int, const Timings&) { return false; });
  EXPECT_EQ(none.rounds, 0);
  EXPECT_EQ(none.of[1].ms, 0.0);
}

TEST(Timing, MediansAreThoseOfSortedValues) {
  EXPECT_EQ(medianOf({}), 0.0);
  EXPECT_EQ(medianOf({3}), 3.0);
  EXPECT_EQ(medianOf({9, 1, 5}), 5.0);
  EXPECT_EQ(medianOf({9, 1, 5, 2}), 3.5);
}

// Of many samples of a distribution whose median is 1, about 95 % have an interval that contains it.
TEST(Timing, IntervalsContainTheMedian) {
  std::mt19937 random{5};
  std::lognormal_distribution<double> skewed{0, 0.5};  // its median is 1
  int contain = 0;
  constexpr int kTrials = 400;
  for (int trial = 0; trial < kTrials; ++trial) {
    std::vector<double> values(25);
    for (double& v : values) v = skewed(random);
    const Interval interval = intervalOfMedian(values);
    contain += interval.low <= 1 && 1 <= interval.high;
  }
  EXPECT_GT(contain, 0.91 * kTrials);
  EXPECT_LT(contain, 0.99 * kTrials);
}

}  // namespace

}  // namespace xnewell::THIS_FILE
