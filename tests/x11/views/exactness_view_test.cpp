#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "depthsort/fragment_spans.h"
#include "depthsort/oracle.h"
#include "geometry/model/solids.h"
#include "shading/laboratory/ground_truth.h"
#include "shading/picture/picture_cache.h"
#include "tests/x11/support/ready_workbench.h"
#include "x11/views/difference.h"
#include "x11/views/exactness_view.h"
#include "x11/views/wireframe.h"

namespace xnewell::THIS_FILE {

namespace {

PictureSettings fromAbove(Order order) {
  PictureSettings s;
  s.width = s.height = 100;
  s.order = order;
  s.camera.eye = glm::dvec3{0, 0, 20};
  s.camera.lookAt = glm::dvec3{0, 0, 0};
  s.camera.parallel = true;
  s.camera.height = 10.0;
  return s;
}

/// A square of side 2 at z = 0, and one over it that rises from `left` to `right`, from a file whose
/// coordinates are rounded by 1e-5. Seen from above, 50 pixels to the unit.
Exactness ofSheets(double left, double right, Order order, IndexImage* map = nullptr) {
  Mesh mesh;
  mesh.groupNames = {""};
  mesh.rounding = {1e-5};
  mesh.points = {{-1, -1, 0},    {1, -1, 0},     {1, 1, 0},     {-1, 1, 0},
                 {-1, -1, left}, {1, -1, right}, {1, 1, right}, {-1, 1, left}};
  mesh.addFace(std::array{0, 1, 2, 3}, 0);
  mesh.addFace(std::array{4, 5, 6, 7}, 0);
  PictureCache pictures{makeScene("sheets", mesh, UpAxis::Y)};
  PictureSettings s = fromAbove(order);
  s.cull = Cull::Keep, s.camera.height = 2.0;
  const std::vector<SampleCheck> verdicts = checkedSamples(pictures.make(s));
  if (map) *map = verdictImage(verdicts, 100, CellPlan{});
  return exactnessOf(verdicts);
}

/// What a finding needs to know of a picture.
PictureSettings of(Order order, Cull cull = Cull::Keep) {
  PictureSettings s;
  s.order = order, s.cull = cull;
  s.width = 90, s.height = 50;
  return s;
}

/// Squares of side 2 in planes of constant z, seen along z, ten pixels to the unit.
Scene squares(const std::vector<glm::dvec3>& centres) {
  Mesh mesh;
  mesh.groupNames = {""};
  for (const glm::dvec3& c : centres) {
    std::vector<int> face;
    for (const glm::dvec2 d : {glm::dvec2{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
      face.push_back(static_cast<int>(mesh.points.size()));
      mesh.points.push_back(c + glm::dvec3{d, 0});
    }
    mesh.addFace(face, 0);
  }
  return makeScene("squares", mesh, UpAxis::Y);
}

PictureSettings small(Shading shading) {
  PictureSettings s;
  s.width = 200, s.height = 150;
  s.shading = shading;
  return s;
}

Compared compared(const Picture& picture) { return comparedWithReference(picture, GroundTruth{picture}); }

/// A ball of flat faces, which the scene knows to be a sphere.
Scene ball(int around, int down) {
  Scene scene = makeScene("ball", sphere(around, down), UpAxis::Z);
  scene.rounds.push_back({.faces = scene.mesh.faceCount(), .columns = around});
  return scene;
}

PictureSettings viewOf(const Scene& scene, Order order) {
  PictureSettings s;
  s.width = 300, s.height = 220;
  s.order = order;
  s.camera = completed({}, scene.camera);
  return s;
}

/// For each sample, the pieces of faces that cover it, as (face, piece).
std::vector<std::set<std::pair<int, int>>> piecesAt(const Picture& picture) {
  const PictureSettings& s = picture.settings();
  std::vector<std::set<std::pair<int, int>>> at(std::size_t(s.width) * s.height);
  for (const Fragment& fragment : picture.sorted().fragments) {
    if (fragment.piece < 0) continue;
    forEachSpan(picture.snapped(), picture.sorted(), fragment, s.width, s.height,
                [&](int row, int from, int to) {
                  for (int i = from; i < to; ++i)
                    at[std::size_t(row) * s.width + i].insert({fragment.face, fragment.piece});
                });
  }
  return at;
}

bool isDash(std::uint8_t cell) {
  const CellPlan plan;
  return cell == plan[Cell::White] || cell == plan[Cell::Soft];
}
Wireframe wiresOf(const Picture& picture) { return wireframeOf(picture, CellPlan{}); }
auto dashesIn(const Wireframe& wires) { return std::ranges::count_if(wires.image.pixels, isDash); }

}  // namespace

// A worked example. The upper sheet is 6e-5 behind the other at its left side and 1.9e-5 before it at its
// right side. Rounding explains 2e-5. So the order of the left side may be shown everywhere, and the right
// quarter, where the upper sheet is before the other, is doubtful. If it rises to 3e-5, rounding does not
// explain that: the depth sort cuts, and every sample is right. An order that cannot cut is wrong there.
TEST(ExactnessView, ThinLayersAreDoubtfulAndThickOnesWrong) {
  IndexImage map;
  const Exactness thin = ofSheets(-6e-5, 1.9e-5, Order::Newell, &map);
  EXPECT_EQ(thin.samples, 10'000);
  EXPECT_EQ(thin.wrong, 0);
  EXPECT_EQ(thin.doubtful, 2'400);  // x > 60 / 79 of the way: columns 76 to 99
  const CellPlan plan;
  for (int i = 0; i < 100; ++i) EXPECT_EQ(map.row(50)[i], plan[i < 76 ? Cell::WellLine : Cell::Q]) << i;

  const Exactness thick = ofSheets(-6e-5, 3e-5, Order::Newell);
  EXPECT_EQ(thick.samples, 10'000);
  EXPECT_EQ(thick.wrong + thick.doubtful, 0);

  const Exactness sorted = ofSheets(-6e-5, 3e-5, Order::Unsorted, &map);  // the upper one is painted last
  EXPECT_GT(sorted.wrong, 3'000);
  EXPECT_GT(sorted.doubtful, 1'500);
  EXPECT_EQ(sorted.wrong + sorted.doubtful, 6'700);  // x < 60 / 90 of the way: columns 0 to 66
  EXPECT_EQ(map.row(50)[0], plan[Cell::Alarm]);
  EXPECT_EQ(map.row(50)[66], plan[Cell::Q]);
  EXPECT_EQ(map.row(50)[67], plan[Cell::WellLine]);
}

// Two faces in one plane: the later one should show. An order that shows the earlier one is wrong, though
// none is nearer, and the finding says so.
TEST(ExactnessView, OfOnePlaneTheLaterShouldShow) {
  const Scene scene = readScene("decals");
  PictureSettings s = scene.settings;
  s.width = 768, s.height = 412;
  s.order = Order::ZBuffer32;
  const Exactness e = exactnessOf(makePicture(scene, s));
  EXPECT_GT(e.earlier, 100);
  EXPECT_LE(e.earlier, e.wrong);
  EXPECT_NE(findingOf(e, s).why.find("in the plane of the face that should show"), std::string::npos);
  s.order = Order::Newell;
  EXPECT_EQ(exactnessOf(makePicture(scene, s)).wrong, 0);
  const auto why = [](int wrong, int earlier) {
    return findingOf({.samples = 4000, .wrong = wrong, .earlier = earlier}, of(Order::ZSort)).why;
  };
  EXPECT_EQ(why(1200, 0), "The oracle, which compares all faces at each sample, sees a nearer one there.");
  EXPECT_EQ(
      why(1200, 1200),
      "There it lies in the plane of the face that should show: of faces in one plane, the later one wins.");
  EXPECT_EQ(
      why(1200, 200),
      "The oracle, which compares all faces at each sample, sees a nearer one at 1,000 of them. At 200 it "
      "lies in the plane of the face that should show: of faces in one plane, the later one wins.");
}

// Wrong samples in blocks that touch are one spot. Each small spot has a ring that keeps off it; doubtful
// samples have one only if none is wrong. A large spot needs none.
TEST(ExactnessView, RingsFindSingleSamples) {
  constexpr int kWidth = 400, kHeight = 300;
  const CellPlan plan;
  std::vector<SampleCheck> verdicts(std::size_t{kWidth} * kHeight, SampleCheck::Right);
  const auto at = [&](int i, int j) -> SampleCheck& { return verdicts[std::size_t(j) * kWidth + i]; };
  EXPECT_TRUE(spotsOf(verdicts, kWidth).empty());
  at(200, 100) = SampleCheck::Doubtful;
  EXPECT_EQ(spotsOf(verdicts, kWidth), (std::vector<Rect>{{200, 100, 1, 1}}));
  at(40, 50) = at(47, 52) = SampleCheck::Wrong;
  at(390, 290) = SampleCheck::Earlier;
  EXPECT_EQ(spotsOf(verdicts, kWidth), (std::vector<Rect>{{40, 50, 8, 3}, {390, 290, 1, 1}}));

  const auto ringed = [&] {
    IndexImage image = verdictImage(verdicts, kWidth, plan);
    ringSpots(Painter{image}, 0, 0, verdicts, kWidth, plan);
    return image;
  };
  IndexImage image = ringed();
  EXPECT_EQ(image.row(50)[40], plan[Cell::Alarm]);
  EXPECT_EQ(image.row(52)[47], plan[Cell::Alarm]);
  EXPECT_EQ(image.row(290)[390], plan[Cell::Alarm]);
  EXPECT_EQ(image.row(100)[200], plan[Cell::Q]);
  const auto whiteIn = [&](const Rect& r) {
    return std::ranges::count(partOf(image, r).pixels, plan[Cell::White]);
  };
  EXPECT_GT(whiteIn({25, 35, 40, 35}), 60);
  EXPECT_GT(whiteIn({370, 270, 30, 30}), 40);
  EXPECT_EQ(whiteIn({180, 80, 40, 40}), 0);

  for (int j = 100; j < 200; ++j)
    for (int i = 100; i < 200; ++i) at(i, j) = SampleCheck::Wrong;
  at(40, 50) = at(47, 52) = at(390, 290) = SampleCheck::Right;
  image = ringed();
  EXPECT_EQ(whiteIn({0, 0, kWidth, kHeight}), 0);
}

// The finding tells what was counted: wrong samples first, then doubtful ones.
TEST(ExactnessView, FindingIsOfTheNumbers) {
  EXPECT_EQ(findingOf({}, of(Order::Newell)).bold, "Nothing shows.");
  EXPECT_EQ(findingOf({.samples = 9}, of(Order::Newell)).bold, "Every sample shows the right face.");
  EXPECT_NE(findingOf({.samples = 9}, of(Order::Newell)).why,
            findingOf({.samples = 9}, of(Order::Oracle)).why);
  // With backs culled, a face that was culled may be nearer: --errors counts that.
  const Finding culled = findingOf({.samples = 9}, of(Order::Newell, Cull::Back));
  EXPECT_EQ(culled.bold, "Every sample shows the right one of the faces that culling left.");
  EXPECT_TRUE(culled.why.ends_with(" Only the faces that culling left are compared.")) << culled.why;
  const Finding doubtful = findingOf({.samples = 4000, .doubtful = 1}, of(Order::Newell));
  EXPECT_EQ(doubtful.bold, "No face is wrong, but 1 sample may be.");
  EXPECT_EQ(doubtful.why.substr(0, 27), "At 1 sample two faces lie s");
  const Finding wrong = findingOf({.samples = 4000, .wrong = 1200, .doubtful = 2}, of(Order::ZSort));
  EXPECT_EQ(wrong.bold, "A wrong face shows at 1,200 of 4,000 samples of 90 x 50.");
  EXPECT_NE(wrong.why.find("At 2 samples two faces"), std::string::npos);
}

// Each sample is painted as often as spans cover it, in every order, and the numbers are counted from that.
// The samples that show something are those of the oracle, which paints each sample once.
TEST(Overdraw, CountsTheSpans) {
  int cut = 0, more = 0;
  for (const char* const name : {"teapot", "penetrate", "cycle", "hues"}) {
    PictureCache pictures{readScene(name, 3)};
    PictureSettings s = viewOf(pictures.scene(), Order::Oracle);
    const Overdraw oracle = overdrawOf(pictures.make(s));
    EXPECT_EQ(oracle.most, 1);
    EXPECT_EQ(oracle.once, oracle.samples);
    EXPECT_EQ(oracle.painted, oracle.samples);
    for (const Order order : {Order::Unsorted, Order::ZMean, Order::ZSort, Order::Newell, Order::Bsp}) {
      s.order = order;
      const Overdraw o = overdrawOf(pictures.make(s));
      std::vector<int> times(std::size_t(s.width) * s.height, 0);
      for (const Fragment& fragment : pictures.last().sorted().fragments)
        forEachSpan(pictures.last().snapped(), pictures.last().sorted(), fragment, s.width, s.height,
                    [&](int row, int from, int to) {
                      for (int i = from; i < to; ++i) ++times[std::size_t(row) * s.width + i];
                    });
      EXPECT_TRUE(std::ranges::equal(o.times, times));
      EXPECT_EQ(o.painted, std::accumulate(times.begin(), times.end(), 0));
      EXPECT_EQ(o.samples, std::ranges::count_if(times, [](int n) { return n > 0; }));
      EXPECT_EQ(o.samples, oracle.samples);
      EXPECT_EQ(o.once, std::ranges::count(times, 1));
      EXPECT_EQ(o.most, std::ranges::max(times));
      EXPECT_EQ(o.times[o.mostAt], o.most);
      EXPECT_DOUBLE_EQ(o.mean() * static_cast<double>(o.samples), static_cast<double>(o.painted));
      cut += pictures.last().sorted().statistics.splits > 0;
      more += o.most > 2;
    }
  }
  EXPECT_GE(cut, 2);
  EXPECT_GE(more, 4);
}

// Each sample of the map has the cell of the step that its count falls in, or the ground if nothing was
// painted there.
TEST(Overdraw, MapStepsByTheCount) {
  Overdraw o{.width = 12, .times = {0, 1, 2, 3, 4, 5, 8, 9, 100, 0, 1, 7}};
  const CellPlan plan;
  const IndexImage map = overdrawImage(o, plan);
  ASSERT_EQ(map.height, 1);
  constexpr std::array kExpected{Cell::Well,     Cell::WellLine, Cell::Soft,     Cell::Faint,
                                 Cell::WellText, Cell::White,    Cell::White,    Cell::Q,
                                 Cell::Q,        Cell::Well,     Cell::WellLine, Cell::White};
  for (std::size_t k = 0; k < kExpected.size(); ++k) EXPECT_EQ(map.pixels[k], plan[kExpected[k]]) << k;
}

// The finding gives the counted numbers. If nothing was counted, it says that.
TEST(Overdraw, FindingIsOfTheNumbers) {
  PictureCache pictures{squares({{-1, -1, 0}, {0, 0, 1}, {1, 1, 2}})};
  const auto found = [&](const PictureSettings& settings) {
    pictures.make(settings);
    return findingOf(overdrawOf(pictures.last()), pictures.last());
  };
  const Finding sorted = found(fromAbove(Order::ZSort)), tested = found(fromAbove(Order::ZBuffer24));
  EXPECT_EQ(sorted.bold, "A sample is painted 1.20 times on average, 2 at most.");
  EXPECT_EQ(sorted.why.substr(0, 43), "16.7 % of all painted samples are painted o");
  EXPECT_EQ(found(fromAbove(Order::Oracle)).bold, "Every sample is painted once.");
  EXPECT_EQ(tested.bold, "Every sample is painted once.");
  EXPECT_EQ(
      tested.why,
      "The z-buffer found the face that each sample shows by 1,200 tests of a depth, one for each sample "
      "of each face.");
  PictureSettings away = fromAbove(Order::Newell);
  away.camera.eye = glm::dvec3{90, 0, 20}, away.camera.lookAt = glm::dvec3{90, 0, 0};
  EXPECT_EQ(found(away).bold, "Nothing shows.");
}

// On flat surfaces, Phong's method has the true normals. Its picture differs from the reference only by the
// rounding to shades: by half a shade, plus a hundredth of a shade from the single precision of its kernel.
TEST(Difference, OfPhongOnFlatSurfacesIsHalfAShade) {
  PictureCache squares{readScene("highlight", 4)};
  const CameraSettings camera = completed({}, squares.scene().camera);
  for (const TableRow& row : kTables)
    for (const int shades : {240, 60, 7}) {
      PictureSettings s = small(Shading::Phong);
      s.table.shades = shades;
      s.table.kind = row.id;
      s.camera = camera;
      const Difference d = compared(squares.make(s, 8)).difference;
      EXPECT_GT(d.errors.count, 5000);
      EXPECT_EQ(d.wrongFaces, 0);
      // Between the levels of the corrected table there are steps of ratio r.
      const double r = ratioOfShades(s.table.I0, shades - 1),
                   step = isEven(row.id) ? 1.0 / (shades - 1) : r - 1;
      EXPECT_LE(d.errors.largest, 0.51 * step);
      if (!isEven(row.id)) continue;
      EXPECT_GT(d.errors.largest, 0.4 * step);
      EXPECT_EQ(d.above == 0, shades == 240);
    }
}

// The numbers are computed from the samples. A sample's number is the distance of its shade from the
// reference.
TEST(Difference, IsThatOfEverySample) {
  PictureCache balls{ball(16, 8)};
  const PictureSettings s = small(Shading::Flat);
  const Compared result = compared(balls.make(s, 8));
  const Difference& d = result.difference;
  EXPECT_EQ(d.kind, Unlike::Intensity);
  const std::vector<double> flat = balls.last().intensities(balls.last().seen(0, s.height));
  const GroundTruth truth{balls.last()};
  const Reference& reference = truth.reference();
  double sum = 0, largest = 0;
  int samples = 0, above = 0, beyond = 0;
  for (std::size_t k = 0; k < flat.size(); ++k) {
    const bool isShown = !std::isnan(flat[k]), isDue = reference.faces()[k] != kNothing;
    ASSERT_EQ(std::isnan(d.at[k]), !isShown && !isDue);
    if (!isShown && !isDue) continue;
    ASSERT_NEAR(d.at[k], std::abs((isShown ? flat[k] : 0.0) - reference.I(k).r), 0.51 / 239);
    beyond += !isShown;
    ++samples, sum += d.at[k], above += d.at[k] > 1.0 / 240, largest = std::max<double>(largest, d.at[k]);
  }
  EXPECT_EQ(d.errors.count, samples);
  EXPECT_EQ(d.above, above);
  EXPECT_GT(above, samples / 2);
  EXPECT_GT(beyond, 20);  // the sphere is larger than its polygons
  EXPECT_NEAR(d.errors.mean, sum / samples, 1e-6);
  EXPECT_NEAR(d.errors.largest, largest, 1e-6);
  EXPECT_NEAR(d.at[d.largestAt], largest, 1e-6);
  EXPECT_GT(largest, 0.05);
}

// With several hues, each picture divides the cells in its own way. A picture's cells are read as that
// picture uses them.
TEST(Difference, OfHuesGoesByThePicturesOwnCells) {
  PictureCache hues{readScene("hues")};
  PictureSettings s = small(Shading::Gouraud);
  s.camera = completed({}, hues.scene().camera);
  s.colors = ColorPlan::Hues;
  const Compared result = compared(hues.make(s, 8));
  const IndexImage& image = hues.last().image();
  ASSERT_GT(hues.last().colors().tables().size(), 5u);
  int fewest = 240;
  for (const ColorTable& table : hues.last().colors().tables()) fewest = std::min(fewest, table.shades());
  const std::vector<double> gouraud = hues.last().intensities(hues.last().seen(0, s.height));
  int samples = 0;
  for (std::size_t k = 0; k < gouraud.size(); ++k) {
    if (std::isnan(gouraud[k])) continue;
    ++samples;
    ASSERT_NEAR(hues.last().colors().intensityOf(image.pixels[k]), gouraud[k], 1.0 / fewest);
    ASSERT_NEAR(hues.last().colors().intensityOf(result.reference.pixels[k]), gouraud[k],
                result.difference.at[k] + 1.0 / fewest);
  }
  EXPECT_GT(samples, 5000);
  EXPECT_LT(result.difference.errors.mean, 0.02);
}

// Colours are compared as they look. With more than enough cells for one gray ramp, the eye cannot see
// Phong's own difference, but can see that of flat shading.
TEST(Difference, OfColoursIsHowTheyLook) {
  PictureCache balls{ball(256, 128)};  // as fine as the reference, so the outline is no difference
  PictureSettings s = small(Shading::Phong);
  s.colors = ColorPlan::Chosen;
  Compared result = compared(balls.make(s, 8));
  EXPECT_EQ(result.difference.kind, Unlike::Color);
  EXPECT_GT(result.difference.errors.count, 5000);
  EXPECT_EQ(result.difference.above, 0);
  int differ = 0;  // a channel has 255 steps, so some samples are rounded to the next colour
  for (std::size_t k = 0; k < result.reference.pixels.size(); ++k)
    differ += std::abs(result.reference.pixels[k] - balls.last().image().pixels[k]);
  EXPECT_LT(differ, result.difference.errors.count / 4);
  s.colors = ColorPlan::Cube;
  EXPECT_GT(compared(balls.make(s, 8)).difference.errors.mean, 2.0);
  s.shading = Shading::Flat, s.colors = ColorPlan::Chosen;
  balls = PictureCache{ball(64, 32)};
  result = compared(balls.make(s, 8));
  EXPECT_GT(result.difference.above, result.difference.errors.count / 4);
  EXPECT_GT(result.difference.errors.largest, 3.0);
}

// A cube seen from a corner shows nine of its twelve edges, and three are hidden. Three of its six polygons
// are seen from behind.
TEST(Wireframe, OfACubeIsCounted) {
  PictureCache pictures{makeScene("cube", cube(), UpAxis::Z)};
  PictureSettings s = viewOf(pictures.scene(), Order::Newell);
  s.camera.eye = glm::dvec3{6, -5, 4};
  const Wireframe wires = wiresOf(pictures.make(s));
  EXPECT_EQ(wires.polygons, 6);
  EXPECT_EQ(wires.back, 3);
  EXPECT_EQ(wires.edges, 12);
  EXPECT_EQ(wires.cuts, 0);
  const auto hidden = std::ranges::count(wires.image.pixels, CellPlan{}[Cell::WellLine]),
             showing = std::ranges::count(wires.image.pixels, CellPlan{}[Cell::WellText]);
  EXPECT_GT(hidden, 60);
  EXPECT_GT(showing, 2 * hidden);
  EXPECT_EQ(hidden + showing + std::ranges::count(wires.image.pixels, CellPlan{}[Cell::Well]), 300 * 220);
}

// Edges are dashed only along cuts: next to each dashed pixel two pieces of one face meet. Where pieces meet
// there are dashes, except for the gaps.
TEST(Wireframe, DashesWhereACutRuns) {
  for (const char* const name : {"penetrate", "cycle"}) {
    SCOPED_TRACE(name);
    PictureCache pictures{readScene(name)};
    const Wireframe wires = wiresOf(pictures.make(viewOf(pictures.scene(), Order::Newell)));
    EXPECT_EQ(wires.cuts, pictures.last().sorted().statistics.splits);
    ASSERT_GT(wires.cuts, 0);
    const auto pieces = piecesAt(pictures.last());
    const int W = wires.image.width, H = wires.image.height;
    int dashes = 0, borders = 0, near = 0;
    const auto around = [&](int x, int y, int reach, auto&& use) {
      for (int j = std::max(0, y - reach); j <= std::min(H - 1, y + reach); ++j)
        for (int i = std::max(0, x - reach); i <= std::min(W - 1, x + reach); ++i) use(j * W + i);
    };
    for (int y = 0; y < H; ++y)
      for (int x = 0; x < W; ++x) {
        std::set<std::pair<int, int>> beside;
        around(x, y, 1, [&](int k) { beside.insert(pieces[k].begin(), pieces[k].end()); });
        bool meet = false;
        for (auto p = beside.begin(); p != beside.end() && std::next(p) != beside.end(); ++p)
          meet |= p->first == std::next(p)->first;
        if (isDash(wires.image.row(y)[x])) {
          ++dashes;
          ASSERT_TRUE(meet) << x << ", " << y;
        }
        if (!meet) continue;
        ++borders;
        bool dash = false;  // or an edge drawn over it
        around(x, y, kDashPeriod, [&](int k) { dash |= isDash(wires.image.pixels[k]); });
        near += dash;
      }
    EXPECT_GT(dashes, 8);
    EXPECT_GT(near, borders * 9 / 10);
  }
}

// An order that cuts nothing has the same edges and no dashes.
TEST(Wireframe, WithoutCutsNothingIsDashed) {
  PictureCache pictures{readScene("penetrate")};
  const Wireframe cut = wiresOf(pictures.make(viewOf(pictures.scene(), Order::Newell)));
  EXPECT_GT(dashesIn(cut), 20);
  for (const Order order : {Order::Unsorted, Order::ZMean, Order::ZSort, Order::ZBuffer16, Order::Oracle}) {
    const Wireframe wires = wiresOf(pictures.make(viewOf(pictures.scene(), order)));
    EXPECT_EQ(wires.cuts, 0);
    EXPECT_EQ(dashesIn(wires), 0);
    EXPECT_EQ(wires.edges, cut.edges);
    EXPECT_EQ(wires.polygons, cut.polygons);
    EXPECT_EQ(findingOf(wires, pictures.last()).bold, "Nothing is cut.");
  }
  // A BSP tree of two plates that pass through each other makes one cut, too.
  const Wireframe tree = wiresOf(pictures.make(viewOf(pictures.scene(), Order::Bsp)));
  EXPECT_EQ(tree.cuts, 1);
  EXPECT_GT(dashesIn(tree), 20);
  EXPECT_EQ(findingOf(tree, pictures.last()).bold, "The BSP tree cut once.");
}

// Visible lines lie next to samples of their polygons: a pixel with only another face around it is never
// bright.
TEST(Wireframe, BrightLinesLieOnWhatShows) {
  PictureCache pictures{readScene("teapot", 3)};
  const Wireframe wires = wiresOf(pictures.make(viewOf(pictures.scene(), Order::Newell)));
  const SeenRows seen = pictures.last().seen(0, wires.image.height);
  int bright = 0, inside = 0;
  for (int y = 1; y + 1 < wires.image.height; ++y)
    for (int x = 1; x + 1 < wires.image.width; ++x) {
      if (wires.image.row(y)[x] != CellPlan{}[Cell::WellText]) continue;
      ++bright;
      std::set<int> faces;
      for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i) faces.insert(seen.faces[std::size_t(y + j) * seen.width + x + i]);
      ASSERT_FALSE(faces.size() == 1 && faces.contains(kNothing)) << x << ", " << y;
      inside += faces.size() > 1;
    }
  EXPECT_GT(bright, 1000);
  EXPECT_GT(inside, bright * 9 / 10);  // an edge lies where the visible face changes
}

}  // namespace xnewell::THIS_FILE
