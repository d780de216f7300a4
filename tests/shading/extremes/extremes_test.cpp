#include "shading/extremes/extremes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iterator>

#include "depthsort/oracle.h"
#include "geometry/exact/box.h"
#include "geometry/model/bezier.h"
#include "shading/extremes/extreme_ways.h"
#include "shading/picture/picture_cache.h"
#include "tests/support/small_picture.h"

namespace xnewell::THIS_FILE {

namespace {

/// A square of side 2 that faces the viewer at height z.
void addCard(Mesh& mesh, double z) {
  const int first = static_cast<int>(mesh.points.size());
  for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) mesh.points.emplace_back(x, y, z);
  const int corners[]{first, first + 1, first + 2, first + 3};
  mesh.addFace(corners, 0);
}

/// Cards at these heights, in this order; the camera is 5 above the origin.
Scene cards(const std::vector<double>& heights) {
  Mesh mesh;
  mesh.groupNames = {"cards"};
  for (const double z : heights) addCard(mesh, z);
  return makeScene("cards", std::move(mesh), UpAxis::Y);
}

PictureSettings fromAbove() {
  PictureSettings settings;
  settings.width = 40, settings.height = 30;
  CameraSettings& camera = settings.camera;
  camera.eye = {0, 0, 5}, camera.lookAt = {0, 0, 0}, camera.up = {0, 1, 0};
  return settings;
}

/// Where the ways begin, facing the camera's look-at point from above.
Start startOf(const Scene& scene, const PictureSettings& settings, const Camera& camera, double size = 1) {
  return {.scene = scene,
          .settings = settings,
          .camera = camera,
          .size = size,
          .pixel = 0.01,
          .target = camera.lookAt,
          .facing = {0, 0, 1}};
}

/// Calls use(case) for all values of all ways. Where there is no view, there is no case.
template <class Use>
void forEachDrive(const Start& start, const Use& use) {
  for (const Way& way : extremeWays())
    for (const double value : way.values) {
      SCOPED_TRACE(testing::Message() << way.name << ' ' << value);
      try {
        use(way.at(start, value));
      } catch (const ViewError&) {
      }
    }
}

const Extreme& named(const Extremes& extremes, std::string_view name) {
  return *std::ranges::find(extremes.ways, name, &Extreme::name);
}

/// Steps with the values 1, 10, 100 ..., one for each letter: r right, w 7 wrong faces, W 9 wrong faces, m 7
/// missing faces, d 5 doubtful faces, e no face at all, c 3 samples changed, x no picture.
Extreme wayOf(std::string_view letters, std::string_view unit = "degrees") {
  Extreme way{.name = "turned by", .unit = unit, .drives = "The scene is turned."};
  for (std::size_t k = 0; k < letters.size(); ++k) {
    ExtremeStep& step =
        way.steps.emplace_back(ExtremeStep{.value = std::pow(10, k), .seen = {.samples = 99}});
    if (letters[k] == 'w') step.seen.wrong = 7;
    if (letters[k] == 'W') step.seen.wrong = 9;
    if (letters[k] == 'm') step.seen.wrong = step.seen.missing = 7;
    if (letters[k] == 'd') step.seen.doubtful = 5;
    if (letters[k] == 'e') step.seen.samples = 0;
    if (letters[k] == 'c') step.changed = 3;
    if (letters[k] == 'x') step.refused = "too far";
    step.why = "at " + std::to_string(k);
  }
  return way;
}

const std::string kWrong = "a face that is not the nearest at 7 of 99 samples";
const std::string kMissing = "no face at 7 of 99 samples that should show one";
const std::string kDoubt = "a face as near as the nearest, to a step of the grid, at 5 of 99 samples";
const std::string kChanged = "another face or shade than at first at 3 samples";

std::string found(std::string_view letters, std::string_view setUp = "r") {
  return findingOf(wayOf(letters), wayOf(setUp).steps.front());
}

}  // namespace

// A ray through the middle of the picture meets the nearest card at the distance that one reckons by hand.
TEST(Rays, MeetTheNearestCard) {
  const Scene scene = cards({0.5, -1, 0.25});
  const PictureSettings settings = fromAbove();
  const Rays rays{scene, makePicture(scene, settings).camera(), settings};
  const double unit = std::ldexp(1.0, -scene.exponent);
  const auto nearest = rays.nearest(20, 15);
  ASSERT_TRUE(nearest);
  EXPECT_EQ(nearest->face, 0);
  EXPECT_DOUBLE_EQ(static_cast<double>(nearest->t), 4.5 * unit);
  const auto last = rays.hit(1, 20, 15);
  ASSERT_TRUE(last);
  EXPECT_DOUBLE_EQ(static_cast<double>(last->t), 6 * unit);
  EXPECT_FALSE(rays.nearest(0, 0));
  EXPECT_FALSE(rays.hit(0, 0, 0));
}

// The depth sort is right. Painting the cards as they come is wrong wherever they overlap, by the share of
// the distance that one reckons by hand.
TEST(Rays, JudgeTheOrder) {
  const Scene scene = cards({1, 0});
  PictureSettings settings = fromAbove();
  const ByGroundTruth sorted = byGroundTruth(makePicture(scene, settings));
  EXPECT_GT(sorted.samples, 100);
  EXPECT_EQ(sorted.wrong, 0);
  settings.order = Order::Unsorted;
  const ByGroundTruth unsorted = byGroundTruth(makePicture(scene, settings));
  EXPECT_GT(unsorted.wrong, 100);
  EXPECT_LT(unsorted.wrong, unsorted.samples + 1);
  EXPECT_NEAR(unsorted.behind, 1.0 / 4.0, 1e-12);  // 5 - 4 of 4
}

// A card that hides another is doubtful, not wrong, if it lies behind by no more than a step of z. The step
// at a distance is reckoned by hand: 1 / depth has steps of one size.
TEST(Rays, CallDoubtfulWhatTheGridCannotTell) {
  for (const bool parallel : {false, true}) {
    SCOPED_TRACE(parallel);
    const auto judged = [&](double gap) {
      const Scene scene = cards({gap, 0});  // the lower one is painted last
      PictureSettings settings = fromAbove();
      settings.order = Order::Unsorted;
      settings.camera.parallel = parallel;
      const Picture picture = makePicture(scene, settings);
      const ViewSpec& view = picture.camera().view;
      const double pixel = (view.windowMax.x - view.windowMin.x) / settings.width;
      const double step = std::ldexp(pixel / kGrid, picture.snapped().zShift + scene.exponent);
      const double away = 5 / std::ldexp(view.prp.z, scene.exponent);
      return std::pair{byGroundTruth(picture), parallel ? step : step * away * away};
    };
    const double step = judged(0.125).second;
    ASSERT_GT(step, 0x1p-40);
    for (const double steps : {0.25, 0.75, 0.99}) {
      const ByGroundTruth seen = judged(steps * step).first;
      EXPECT_EQ(seen.wrong, 0) << steps;
      EXPECT_GT(seen.doubtful, 100) << steps;
    }
    for (const double steps : {1.01, 1.5, 100.0}) {
      const ByGroundTruth seen = judged(steps * step).first;
      EXPECT_GT(seen.wrong, 100) << steps;
      EXPECT_EQ(seen.doubtful, 0) << steps;
    }
  }
}

// Four digits, and powers of two as such where four digits do not say them.
TEST(Extremes, NumbersAreShort) {
  EXPECT_EQ(shortly(std::ldexp(1.0, 900)), "2^900");
  EXPECT_EQ(shortly(std::ldexp(1.0, -900)), "2^-900");
  EXPECT_EQ(shortly(1.0), "1");
  EXPECT_EQ(shortly(0.25), "0.25");
  EXPECT_EQ(shortly(1024), "1024");
  EXPECT_EQ(shortly(1e270), "1e+270");
  EXPECT_EQ(shortly(0), "0");
  EXPECT_EQ(shortly(1.0 / 3), "0.3333");
}

// What is cut away by a plane of the user's is not missing. What is cut away by a plane that the program
// chose would be.
TEST(Rays, EndAtTheUsersPlanes) {
  const Scene scene = cards({1, 0});
  PictureSettings settings = fromAbove();
  settings.camera.front = 0.5;
  const Camera camera = makePicture(scene, settings).camera();
  EXPECT_EQ((Rays{scene, camera, settings}.nearest(20, 15)->face), 1);
  settings.camera.front.reset();
  EXPECT_EQ((Rays{scene, camera, settings}.nearest(20, 15)->face), 0);
}

// The pictures of built-in scenes are right by the rays, in parallel and in perspective.
TEST(Rays, AgreeWithTheDepthSort) {
  for (const char* name : {"room", "cycle", "penetrate", "decals", "sheets", "coarse-teapot"})
    for (const bool parallel : {false, true}) {
      SCOPED_TRACE(name);
      const Scene scene = readScene(name);
      PictureSettings settings = scene.settings;
      settings.width = 120, settings.height = 90;
      settings.camera.parallel = parallel;
      const ByGroundTruth judged = byGroundTruth(makePicture(scene, settings));
      EXPECT_GT(judged.samples, 1'000);
      EXPECT_EQ(judged.wrong, 0) << judged.behind;
    }
}

// Powers of two change nothing. A move so far that doubles are as coarse as the scene changes everything.
// Fewer than 16 bits cannot hold a table that begins at 1e-6.
TEST(Extremes, FindWhatBecomesWrong) {
  const Scene scene = readScene("cycle");
  PictureSettings settings = scene.settings;
  settings.width = 60, settings.height = 45;
  std::vector<std::string> announced;
  const Extremes extremes = extremesOf(scene, settings, [&](const std::string& doing) {
    announced.push_back(doing);
    return true;
  });
  EXPECT_FALSE(extremes.isStopped());
  EXPECT_EQ(findingOf(extremes.setUp), "");
  EXPECT_GT(extremes.setUp.seen.samples, 100);
  std::size_t pictures = 0;
  for (const Extreme& extreme : extremes.ways) {
    SCOPED_TRACE(extreme.name);
    ASSERT_GE(extreme.steps.size(), 6u);
    EXPECT_FALSE(extreme.steps.front().isWrong()) << findingOf(extreme, extremes.setUp);
    for (const ExtremeStep& step : extreme.steps) EXPECT_FALSE(step.why.empty());
    pictures += extreme.steps.size();
  }
  EXPECT_EQ(announced.size(), pictures);
  const Extreme& powers = extremes.ways[0];
  EXPECT_EQ(powers.unit, "(powers of two)");
  EXPECT_TRUE(std::ranges::none_of(powers.steps, &ExtremeStep::isWrong)) << findingOf(powers, extremes.setUp);
  EXPECT_TRUE(findingOf(powers, extremes.setUp).starts_with("right up to "));

  const Extreme& moved = named(extremes, "moved by");
  for (const ExtremeStep& step : moved.steps) EXPECT_FALSE(step.value <= 1e6 && step.isWrong()) << step.value;
  EXPECT_TRUE(moved.steps.back().isWrong());
  EXPECT_GT(moved.steps.back().changed, 0);
  EXPECT_TRUE(findingOf(moved, extremes.setUp).starts_with("wrong from 1e+1"))
      << findingOf(moved, extremes.setUp);

  const Extreme& falling = named(extremes, "eye falls to");
  EXPECT_EQ(falling.steps.back().value, 1e-12);
  EXPECT_EQ(findingOf(falling, extremes.setUp), "right up to 1e-12 of its distance");

  const ExtremeStep& darkest = named(extremes, "I0 down to").steps.back();
  EXPECT_EQ(darkest.value, 1e-6);
  EXPECT_GT(darkest.merged, 10);
}

// However far a scene is moved, however small or flat it becomes: its patches make the corners of its mesh,
// or it has none. Rounding may let the corners of a patch coincide.
TEST(Extremes, PatchesGoWithTheirMesh) {
  const Scene scene = readScene("colored-lights");
  ASSERT_GE(scene.patches.size(), 2u);
  const Camera camera = makePicture(scene, scene.settings).camera();
  const Start start = startOf(scene, scene.settings, camera);
  int with = 0, without = 0;
  forEachDrive(start, [&](const Case& drive) {
    for (std::size_t k = 0; k < drive.scene.patches.size(); ++k) {
      const PatchRun &run = drive.scene.patches[k], &before = scene.patches[k];
      EXPECT_EQ(cornerNormals(run.patches, run.divisions).size(),
                cornerNormals(before.patches, before.divisions).size());
    }
    (drive.scene.patches.empty() ? without : with) += 1;
  });
  EXPECT_GT(with, 50);
  EXPECT_GT(without, 12);  // a copy in front has none, at twelve values
}

// Every sample that shows a face has an intensity, also where the eye is nearer to the face than numbers are
// exact. There is a pillar as long as a thousand million million of the others.
TEST(Extremes, IntensitiesAreNumbers) {
  const Scene scene = readScene(XNEWELL_DATA_DIR "/../tests/data/long-pillar.json");
  const PictureSettings settings = setUpOf(scene, 16, 12);
  const Camera camera = makePicture(scene, settings).camera();
  const Rays rays{scene, camera, settings};
  const auto hit = rays.nearest(7.5, 5.5);
  ASSERT_TRUE(hit);
  Start start = startOf(scene, settings, camera);
  start.target = rays.point(7.5, 5.5, hit->t);
  int pictures = 0;
  forEachDrive(start, [&](Case drive) {
    const Picture picture = makePicture(std::move(drive.scene), drive.settings);
    const SeenRows seen = picture.seen(0, picture.settings().height);
    const std::vector<double> I = picture.intensities(seen);
    for (std::size_t k = 0; k < I.size(); ++k) ASSERT_EQ(std::isnan(I[k]), seen.faces[k] == kNothing) << k;
    ++pictures;
  });
  EXPECT_GT(pictures, 60);
}

// A sentence has the numbers of its scene. Here it is two cards of side 2, one above the other by 1 and seen
// from 5 above, or above by 3, seen from 10 above, and far from the origin.
TEST(Extremes, SentencesHaveTheScenesNumbers) {
  const auto expectWhy = [](bool far, std::string_view name, double value, const std::string& why) {
    const Scene scene = far ? cards({1'000'003, 1'000'000}) : cards({1, 0});
    PictureSettings settings = fromAbove();
    if (far) {
      settings.camera.eye = {0, 0, 1'000'010}, settings.camera.lookAt = {0, 0, 1'000'000};
      settings.table.bits = 8;
    }
    const Camera camera = makePicture(scene, settings).camera();
    Start start = startOf(scene, settings, camera, boxOf(scene.mesh.points).side());
    start.pixel = std::ldexp(0.1, -scene.exponent);
    EXPECT_EQ(std::ranges::find(extremeWays(), name, &Way::name)->why(start, value), why);
  };
  const auto apart = [](double pixels) {
    return "Doubles this far from the origin are " + shortly(pixels) + " pixels apart.";
  };
  expectWhy(false, "moved by", 1e6, apart(0x1p-32 / 0.1));  // at 2,000,001
  expectWhy(true, "moved by", 0, apart(0x1p-33 / 0.1));     // at 1,000,003
  expectWhy(true, "moved by", 1e6, apart(0x1p-31 / 0.1));   // at 4,000,003
  // Seen from (0.22, 0.52, 1), over 0.94 of 30 rows: the lower edge of the near card is at the bottom, the
  // upper edge of the far one at the top.
  const auto depth = [](double z) {
    const double length = std::sqrt(0.22 * 0.22 + 0.52 * 0.52 + 1), flat = std::hypot(0.22, 1);
    const double high = (2 * flat * flat + 0.52 * (2 * 0.22 + z)) / (length * flat);
    const double wide = (2 + 0.22 * z) / flat;
    const double distance = std::max(high, wide * 3 / 4) / 2 / (0.94 * std::tan(0.005 * M_PI / 180));
    return "The scene's depth is only " + shortly((2 * 0.22 + 2 * 0.52 + z) / length / distance) +
           " of its distance; the depth of a sample keeps 30 bits.";
  };
  expectWhy(false, "field of view down to", 0.01, depth(1));
  expectWhy(true, "field of view down to", 0.01, depth(3));
  const auto side = [](double pixels) {
    return "The longest side of the scene is only " + shortly(pixels) + " pixels.";
  };
  expectWhy(false, "field of view up to", 90, side(2 * 30 / 10.0));
  expectWhy(true, "field of view up to", 90, side(3 * 30 / 20.0));
  expectWhy(false, "exponent n up to", 1000,
            "The n-th power multiplies an error of the cosine by n: 5.96e-05 in single precision.");
  expectWhy(false, "exponent n up to", 10'000,
            "The n-th power multiplies an error of the cosine by n: 1.11e-12 in double precision.");
  expectWhy(false, "I0 down to", 0.1,
            "A cell has 16 bits a channel: its darkest value above 0 is 1.526e-05, and I0 is 0.1.");
  expectWhy(true, "I0 down to", 0.1,
            "A cell has 8 bits a channel: its darkest value above 0 is 0.003922, and I0 is 0.1.");
}

// A finding says which values have a fault, and no others: "on" only where it stays. Where it is largest is
// told if it grows.
TEST(Extremes, AFindingHoldsWhatItSays) {
  EXPECT_EQ(found("rrr"), "right up to 100 degrees");
  EXPECT_EQ(found("rww"), "wrong from 10 degrees on: " + kWrong);
  EXPECT_EQ(found("rwr"), "wrong at 10 degrees: " + kWrong);
  EXPECT_EQ(found("rwWr"), "wrong from 10 to 100 degrees: " + kWrong + " (9 at 100)");
  EXPECT_EQ(found("rmrc"), "wrong at 10 degrees: " + kMissing + "; at 1000 degrees: " + kChanged);
  EXPECT_EQ(found("rxx"), "wrong from 10 degrees on: too far");
  EXPECT_EQ(findingOf(wayOf("rw", "(powers of ten)"), {}), "wrong at 10: " + kWrong);
}

// What the grid cannot tell is called doubtful. It is explained if nothing is wrong.
TEST(Extremes, AFindingKeepsDoubtApart) {
  EXPECT_EQ(found("rdd"), "doubtful from 10 degrees on: " + kDoubt);
  EXPECT_EQ(found("rdwr"), "doubtful at 10 degrees: " + kDoubt + "; wrong at 100 degrees: " + kWrong);
  EXPECT_EQ(found("ddd", "d"), "doubtful as the set-up itself, at all values");
  const ExtremeStep right = wayOf("r").steps.front(), doubtful = wayOf("d").steps.front();
  EXPECT_TRUE(doubtful.isDoubtful());
  EXPECT_FALSE(doubtful.isWrong());
  EXPECT_EQ(findingOf(doubtful), "The set-up itself is doubtful: " + kDoubt + '.');
  const Extreme way = wayOf("rdw"), only = wayOf("rdd"), empty = wayOf("rre");
  EXPECT_EQ(firstWrong(only, right), nullptr);
  EXPECT_EQ(firstToExplain(way, right)->why, "at 2");
  EXPECT_EQ(firstToExplain(only, right)->why, "at 1");
  EXPECT_EQ(firstToExplain(only, doubtful)->why, "at 1");
  EXPECT_EQ(firstToExplain(empty, right)->why, "at 2");
  EXPECT_EQ(firstToExplain(wayOf("rrr"), right), nullptr);
}

// A picture without a face is not right or wrong.
TEST(Extremes, AFindingTellsThatNoFaceShows) {
  EXPECT_EQ(found("eee"), "shows no face from 1 degrees on");
  EXPECT_EQ(found("ree"), "right up to 1 degrees; shows no face from 10 degrees on");
  EXPECT_EQ(found("rrer"), "right up to 10 degrees; shows no face at 100 degrees; elsewhere right");
  EXPECT_EQ(found("rwe"), "wrong at 10 degrees: " + kWrong + "; no face shows at 100 degrees");
  EXPECT_EQ(findingOf(wayOf("e").steps.front()), "The set-up itself shows no face.");
}

// What is wrong in the set-up is told once. A way tells how long it stays and what else becomes wrong, and
// only that is explained.
TEST(Extremes, AFindingLeavesOutTheSetUpsFaults) {
  const ExtremeStep right = wayOf("r").steps.front(), wrong = wayOf("w").steps.front();
  EXPECT_EQ(findingOf(right), "");
  EXPECT_EQ(findingOf(wrong), "The set-up itself is wrong: " + kWrong + '.');
  EXPECT_EQ(found("wWw", "w"), "wrong as the set-up itself, at all values");
  EXPECT_EQ(found("wwr", "w"), "wrong as the set-up itself, up to 10 degrees");
  EXPECT_EQ(found("wrc", "w"), "wrong as the set-up itself, up to 1 degrees; at 100 degrees: " + kChanged);
  // Another fault at the start of the way than that of the set-up is the way's own.
  EXPECT_EQ(found("mm", "w"), "wrong from 1 degrees on: " + kMissing);
  EXPECT_EQ(firstWrong(wayOf("www"), wrong), nullptr);
  EXPECT_EQ(firstWrong(wayOf("rrr"), right), nullptr);
  const Extreme later = wayOf("wwc"), own = wayOf("www");
  EXPECT_EQ(firstWrong(later, wrong)->why, "at 2");
  EXPECT_EQ(firstWrong(own, right)->why, "at 0");
}

// Stopped at any picture, the ways that were finished are as they would have been.
TEST(Extremes, AStopKeepsTheFinishedWays) {
  const Scene scene = cards({1, 0});
  PictureSettings settings = fromAbove();
  settings.width = 16, settings.height = 12;
  const Extremes whole = extremesOf(scene, settings);
  ASSERT_FALSE(whole.isStopped());
  EXPECT_EQ(stoppedText(whole), "");
  std::size_t pictures = 0;
  for (std::size_t finished = 0; finished < whole.ways.size(); ++finished) {
    const std::size_t steps = whole.ways[finished].steps.size();
    for (const std::size_t inWay : {std::size_t{0}, steps - 1}) {
      std::size_t left = pictures + inWay;
      const Extremes stopped = extremesOf(
          scene, settings, [&](const std::string&) { return left-- > 0; }, 1);
      ASSERT_TRUE(stopped.isStopped());
      ASSERT_EQ(stopped.ways.size(), finished);
      for (std::size_t k = 0; k < finished; ++k)
        EXPECT_EQ(findingOf(stopped.ways[k], stopped.setUp), findingOf(whole.ways[k], whole.setUp));
      EXPECT_EQ(stoppedText(stopped), "Stopped: " + std::to_string(finished) + " of 13 ways were finished.");
    }
    pictures += steps;
  }
}

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

// The eye may be nearer to the scene than the root of the smallest double. A copy in front still has numbers
// for coordinates, and lies nearer by what the way says.
TEST(Extremes, ACopyInFrontHasNumbers) {
  const Scene scene = cards({0});
  const PictureSettings settings = fromAbove();
  for (const double away : {1.0, 1e-100, 1e-170, 1e-300}) {
    SCOPED_TRACE(away);
    Camera camera;
    camera.eye = {0, 0, away}, camera.lookAt = {0, 0, 0}, camera.up = {0, 1, 0};
    const Start start = startOf(scene, settings, camera, 2);
    const Way& way = *std::ranges::find(extremeWays(), "a copy in front at", &Way::name);
    const Case copied = way.at(start, 0.25);
    ASSERT_EQ(copied.scene.mesh.points.size(), 8u);
    for (int k = 0; k < 4; ++k) {
      const glm::dvec3 apart = copied.scene.mesh.points[k + 4] - copied.scene.mesh.points[k];
      EXPECT_EQ(apart, (glm::dvec3{0, 0, 0.5}));
    }
  }
}

}  // namespace xnewell::THIS_FILE
