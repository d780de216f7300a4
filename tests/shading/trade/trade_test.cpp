#include "shading/trade/trade.h"

#include <gtest/gtest.h>
#include <malloc.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "shading/laboratory/exactness.h"
#include "shading/picture/picture_cache.h"
#include "shading/trade/measure.h"
#include "tests/support/seeds.h"
#include "tests/support/small_picture.h"

namespace xnewell::THIS_FILE {

namespace {

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

/// A measured configuration with these numbers.
Measured with(double ratio, double error, double spread = 0) {
  Measured one;
  one.cost.time = {.ms = 10 * ratio, .ratio = ratio, .interval = {ratio - spread, ratio + spread}};
  one.elsewhere = error;
  return one;
}

}  // namespace

// The short cuts that a picture has. Those without an effect are no axes.
TEST(Trade, AxesAreTheShortCutsWithAnEffect) {
  PictureSettings settings = small();
  const auto axes = [&](const std::string& scene) {
    return namesOf(axesOf(makePicture(readScene(scene), settings)));
  };
  const auto has = [](const std::vector<std::string>& names, std::string_view name) {
    return std::ranges::find(names, name) != names.end();
  };
  const auto flat = axes("teapot");
  for (const std::string_view name :
       {"divisions", "shade", "order", "cull", "table", "shades", "adapt", "bits"})
    EXPECT_TRUE(has(flat, name)) << name;
  // fill needs a server; the others interpolate, need a lamp at a place, or are of the model.
  for (const std::string_view name : {"fill", "normals", "polygons", "constant-l", "ka", "hue", "form"})
    EXPECT_FALSE(has(flat, name)) << name;
  EXPECT_FALSE(has(axes("cycle"), "divisions"));
  EXPECT_FALSE(has(axes("lamp"), "divisions"));  // its file gives them
  EXPECT_FALSE(has(axes("coarse-teapot"), "divisions"));
  EXPECT_TRUE(has(axes("colored-lights"), "divisions"));  // its file gives those of the floor alone
  settings.shading = Shading::Gouraud;
  settings.light.lightPosition = glm::dvec3{1, 1, 1};
  const auto lamp = axes("teapot");
  for (const std::string_view name : {"normals", "polygons", "constant-l"})
    EXPECT_TRUE(has(lamp, name)) << name;
}

// Some have an effect only beside others. The program may choose all of them but the plan of the colours.
TEST(Trade, AxesInReachHaveAnEffectBesideOthers) {
  const Picture flat = makePicture(readScene("teapot"), small());
  const std::vector<std::string> near = namesOf(axesOf(flat)),
                                 reach = namesOf(axesOf(flat, Reach::BesideOthers)),
                                 choosable = choosableAxes(flat);
  std::vector<std::string> more;
  for (const std::string& name : reach)
    if (std::ranges::find(near, name) == near.end()) more.push_back(name);
  for (const char* name : {"normals", "crease", "polygons", "interpolate", "unnormalized", "environment",
                           "mapping", "i0", "pick"})
    EXPECT_NE(std::ranges::find(more, name), more.end()) << name;
  EXPECT_EQ(choosable.size() + 1, reach.size());
  EXPECT_EQ(std::ranges::find(choosable, "colors"), choosable.end());
  const std::vector<Axis> axes = axesOf(flat, Reach::BesideOthers);
  EXPECT_EQ(std::ranges::find(axes, "divisions", &Axis::name)->others.back(), 64);
}

// Each row differs from the set-up in one short cut, and its errors are those of that picture.
TEST(Trade, RowsAreThePicturesOfOneShortCut) {
  const PictureSettings settings = small();
  const Trade trade = quickTrade("nested-cycles", settings, {.axes = {"order", "shade"}});
  EXPECT_FALSE(trade.stopped);
  EXPECT_EQ(trade.rows.size(), kOrders.size() - 1 + kShadings.size() - 1);
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

// Errors are equal to the bit in every run. Only times differ.
TEST(Trade, ErrorsDoNotDependOnTheRun) {
  const TradeRequest request{.axes = {"order", "shades"}, .without = {"order=none"}};
  const Trade a = quickTrade("cycle", small(), request), b = quickTrade("cycle", small(), request);
  ASSERT_EQ(a.rows.size(), b.rows.size());
  for (std::size_t k = 0; k < a.rows.size(); ++k) {
    EXPECT_EQ(a.rows[k].measured.elsewhere, b.rows[k].measured.elsewhere);
    EXPECT_EQ(a.rows[k].measured.here.afterTable.rootMeanSquare,
              b.rows[k].measured.here.afterTable.rootMeanSquare);
  }
  for (const TradeRow& row : a.rows)
    EXPECT_FALSE(a.axes[row.axis].name() == "order" && a.axes[row.axis].text(row.value) == "none");
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
  EXPECT_EQ(frontOf({with(1, 0.3, 0.1), with(1.05, 0.2, 0.1), with(2, 0.1, 0.1)}), (std::vector{1, 2}));
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

}  // namespace xnewell::THIS_FILE
