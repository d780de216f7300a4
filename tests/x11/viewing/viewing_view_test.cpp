#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <utility>

#include "shading/scene/units.h"
#include "tests/support/model_view.h"
#include "tests/support/seeds.h"
#include "tests/x11/support/ready_workbench.h"
#include "x11/drawing/wording.h"
#include "x11/viewing/outside_view.h"
#include "x11/viewing/view_controls.h"
#include "x11/viewing/viewing_page.h"
#include "x11/viewing/viewing_view.h"

namespace xnewell::THIS_FILE {

namespace {

/// A window at view 9.
struct ViewingWindow : ReadyWorkbench {
  explicit ViewingWindow(const char* scene = "teapot", int width = 1024, int height = 768)
      : ReadyWorkbench{{}, width, height, scene} {
    does('9');
  }
  [[nodiscard]] ViewingView& viewing() { return dynamic_cast<ViewingView&>(bench()); }
  [[nodiscard]] ViewingLayout places() const { return layoutOfViewing(layout()); }
  [[nodiscard]] Camera camera() const {
    const Rect at = bench().frame(layout());
    return placeCamera(scene(), setup().picture.camera, static_cast<double>(at.width) / at.height);
  }
  /// The large drawing.
  [[nodiscard]] StageImage drawn(const OutsideTurn& turn = {}) {
    const LitParts lit{picture(), palette()};
    const ViewingStory story{picture(), *cornerOf(scene().mesh, viewing().vertex())};
    const glm::ivec2 size{places().outside.width, places().outside.height};
    return {picture(),
            lit,
            story,
            StagePoints{scene().mesh, story.stages},
            static_cast<ViewStage>(viewing().stage() - 1),
            turn,
            size,
            ground(),
            kWordBand};
  }
  /// Has the set-up and the vertex of another, at the first stage.
  void becomes(ViewingWindow& other) {
    change('x', [&](xnewell::Setup& s) { s = other.setup(); });
    viewing().begin(1, other.viewing().vertex());
    finish();
  }
  /// Types the value of the control that is selected.
  void typeValue(const std::string& text) {
    press('=');
    for (const char c : text) press(c);
    does(NamedKey::Return);
  }
};

/// The numbers of a view, in one list.
std::array<double*, 18> numbersIn(ViewSpec& v) {
  return {&v.vrp.x,       &v.vrp.y,       &v.vrp.z,       &v.vpn.x,       &v.vpn.y, &v.vpn.z,
          &v.vup.x,       &v.vup.y,       &v.vup.z,       &v.prp.x,       &v.prp.y, &v.prp.z,
          &v.windowMin.x, &v.windowMax.x, &v.windowMin.y, &v.windowMax.y, &v.front, &v.back};
}
std::vector<double> numbersOf(ViewSpec v) {
  std::vector<double> all;
  for (const double* const number : numbersIn(v)) all.push_back(*number);
  return all;
}

/// The place of a handle of the view at a stage, by hand: in the textbook's own terms, not by the program's
/// matrices.
glm::dvec3 placeByHand(const ViewSpec& v, const ViewSpec& space, ViewHandle handle, ViewStage stage) {
  const glm::dvec3 n = glm::normalize(space.vpn), u = glm::normalize(glm::cross(space.vup, n));
  const glm::dvec2 low = v.windowMin, high = v.windowMax, middle = (low + high) / 2.0;
  const glm::dvec2 corner{low.x, high.y};
  const bool parallel = v.projection == Projection::Parallel;
  const auto along = [&](double depth) {  // the projector through the window's upper left corner
    const glm::dvec2 uv =
        parallel ? corner + (glm::dvec2{v.prp} - middle) * depth / v.prp.z
                 : glm::dvec2{v.prp} + (corner - glm::dvec2{v.prp}) * ((v.prp.z - depth) / v.prp.z);
    return glm::dvec3{uv, depth};
  };
  glm::dvec3 p{0.0};
  if (handle == ViewHandle::PrpU || handle == ViewHandle::PrpV || handle == ViewHandle::PrpN) p = v.prp;
  if (handle == ViewHandle::Front) p = along(v.front);
  if (handle == ViewHandle::Back) p = along(v.back);
  if (handle == ViewHandle::Umin) p = {low.x, middle.y, 0};
  if (handle == ViewHandle::Umax) p = {high.x, middle.y, 0};
  if (handle == ViewHandle::Vmin) p = {middle.x, low.y, 0};
  if (handle == ViewHandle::Vmax) p = {middle.x, high.y, 0};
  if (stage == ViewStage::World)
    return (handle == ViewHandle::Vrp ? v.vrp : space.vrp) + u * p.x + glm::cross(n, u) * p.y + n * p.z;
  if (stage == ViewStage::Sheared) {
    const glm::dvec2 centre = (space.windowMin + space.windowMax) / 2.0;
    const glm::dvec2 towardsEye = (glm::dvec2{space.prp} - centre) / space.prp.z;
    const double depth = p.z;
    if (!parallel) p -= space.prp;
    p -= glm::dvec3{towardsEye * (parallel ? depth : p.z), 0.0};
  }
  return p;
}

/// Which numbers of numbersOf() a handle changes: the first, and how many.
std::pair<int, int> numbersBy(ViewHandle handle) {
  constexpr std::array kFirst{0, 11, 16, 17, 12, 13, 14, 15, 9, 10};
  return {kFirst[static_cast<std::size_t>(handle)], handle == ViewHandle::Vrp ? 3 : 1};
}

/// The view whose number of a handle, which has one, has grown.
ViewSpec grownByHand(ViewSpec v, ViewHandle handle, double by) {
  *numbersIn(v)[numbersBy(handle).first] += by;
  return v;
}

/// The longest of 1, 2, 5, 10, ... and their parts that fits, in hundredths or more.
double stepBelow(double most) {
  double step = 0.01;
  for (double ten = 0.01; ten < 1e6; ten *= 10)
    for (const double times : {1.0, 2.0, 5.0})
      if (times * ten <= most) step = times * ten;
  return step;
}

/// The same at a stage.
struct HandleWindow : ViewingWindow {
  explicit HandleWindow(ViewStage stage, bool parallel = false, const char* scene = "teapot",
                        int width = 1024, int height = 768)
      : ViewingWindow{scene, width, height} {
    if (parallel) does('P');
    while (viewing().stage() <= static_cast<int>(stage)) does(NamedKey::Right);
  }
  /// The middle of a handle in the window; nothing if it is not there.
  [[nodiscard]] std::optional<glm::ivec2> find(ViewHandle handle) {
    for (const Control& control : viewing().controls())
      if (control.is == rowOf(handle).is)
        if (const ControlPlace* const place = viewing().list().find(control.id()))
          return glm::ivec2{place->area.x + place->area.width / 2, place->area.y + place->area.height / 2};
    return std::nullopt;
  }
  void dragBy(glm::ivec2 from, glm::ivec2 by) {
    ASSERT_TRUE(grab(from.x, from.y));
    for (const int share : {1, 2, 3, 4}) {
      dragTo(from.x + by.x * share / 4, from.y + by.y * share / 4);
      update(true);
    }
  }
  void letGo() {
    settle();
    finish();
  }
  /// The camera of the large drawing.
  [[nodiscard]] OutsideCamera outside() { return drawn().camera(); }
  /// The way of a handle in the drawing of the world, from one view to another.
  [[nodiscard]] glm::dvec2 wayOf(ViewHandle handle, const ViewSpec& to, const ViewSpec& from) {
    const OutsideCamera camera = outside();
    return glm::dvec2{camera(placeByHand(to, from, handle, ViewStage::World)) -
                      camera(placeByHand(from, from, handle, ViewStage::World))};
  }
  [[nodiscard]] double shownUnit() const { return lengthUnit(scene()); }
};

}  // namespace

// A number that is typed becomes that number of the view, and all the others stay, to the last bit after the
// first change. Undo brings back the view that was.
TEST(ViewingView, ANumberChangesTheViewAlone) {
  ViewingWindow b;
  const xnewell::Setup before = b.setup();
  const double file = std::ldexp(1.0, b.scene().exponent);
  int which = 0;
  for (const auto& [letter, numbers] :
       {std::pair{'v', 3}, {'n', 3}, {'y', 3}, {'p', 3}, {'o', 4}, {'f', 1}, {'b', 1}})
    for (int times = 1; times <= numbers; ++times, ++which) {
      SCOPED_TRACE(which);
      b.bench().enter();  // nothing is selected
      std::vector<double> expected = numbersOf(b.camera().view);
      for (int k = 0; k < times; ++k) b.press(letter);
      const double unit = letter == 'n' || letter == 'y' ? 1.0 : file;
      const double next = std::round((expected[which] * unit + 0.25) * 100) / 100;
      b.typeValue(std::to_string(next));
      EXPECT_FALSE(b.complains());
      const std::vector<double> now = numbersOf(b.camera().view);
      EXPECT_NEAR(now[which] * unit, next, 1e-12);
      expected[which] = now[which];
      EXPECT_EQ(now, expected);
    }
  for (int k = 0; k < which; ++k) b.press('u');
  EXPECT_EQ(b.setup(), before);
}

// A click outside chooses the nearest corner of the face under the pointer, at every stage with a scene; a
// drag turns the outside view and leaves the scene's camera and the vertex as they are.
TEST(ViewingView, AClickChoosesAVertexAndADragTurns) {
  ViewingWindow b;
  const Rect at = b.places().outside;
  for (int stage = 1; stage <= 6; ++stage, b.does(NamedKey::Right)) {
    ASSERT_EQ(b.viewing().stage(), stage);
    const StageImage drawn = b.drawn(turnAt(static_cast<ViewStage>(stage - 1), {}));
    int clicks = 0;
    for (int y = 5; y < at.height; y += 23)
      for (int x = 5; x < at.width; x += 31) {
        const int face = drawn.faceAt(x, y);
        if (face < 0) continue;
        ASSERT_TRUE(b.grab(at.x + x, at.y + y));
        b.settle();
        const std::optional<FaceCorner> vertex = cornerOf(b.scene().mesh, b.viewing().vertex());
        ASSERT_TRUE(vertex);
        EXPECT_EQ(vertex->face, face) << stage;
        ++clicks;
        b.finish();
        if (clicks == 6) y = at.height, x = at.width;
      }
    EXPECT_EQ(clicks, 6) << stage;
  }
  b.does(NamedKey::Left);  // the grid of stage 7 is not turned
  const std::string vertex = b.viewing().vertex();
  const IndexImage before = b.part(at);
  ASSERT_TRUE(b.grab(at.x + 50, at.y + 50));
  b.dragTo(at.x + 120, at.y + 60);
  b.settle();
  b.finish();
  EXPECT_EQ(b.setup(), b.defaults());
  EXPECT_EQ(b.viewing().vertex(), vertex);
  EXPECT_NE(b.part(at), before);
  // So do t and z with the arrows, and the wheel.
  for (const char key : {'t', 'z', 'w'}) {
    const IndexImage last = b.part(at);
    if (key == 'w')
      b.wheel(at.x + 50, at.y + 50, 1.2), b.finish();
    else
      b.press(key), b.does(NamedKey::Up);
    EXPECT_NE(b.part(at), last) << key;
  }
  EXPECT_EQ(b.setup(), b.defaults());
}

// The matrix of each choice of M leads to the numbers of the story, at each stage. Each choice shows another
// matrix.
TEST(ViewingView, ShowsThreeMatrices) {
  ViewingWindow b;
  const ViewingStory story{b.picture(), *cornerOf(b.scene().mesh, b.viewing().vertex())};
  const double unit = lengthUnit(b.scene());
  for (const ViewStageRow& row : kViewStages)
    for (const ShownMatrix shown :
         {ShownMatrix::ThisStage, ShownMatrix::AllSoFar, ShownMatrix::ToTheScreen}) {
      const MatrixWithVertex m = matrixOf(story, row.id, shown, unit);
      const glm::dvec4 product = m.matrix * m.from;
      for (int k = 0; k < 4; ++k)
        EXPECT_NEAR(product[k], m.to[k], 1e-9 * (1 + std::abs(m.to[k]))) << row.name;
      const glm::dvec4 last = m.to / m.to.w,
                       here = shownAt(story, shown == ShownMatrix::ToTheScreen ? ViewStage::Viewport : row.id,
                                      unit);
      for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(last[k], here[k] / here.w, 1e-9 * (1 + std::abs(last[k]))) << row.name;
    }
  b.does(NamedKey::Right);
  for (int k = 0; k < 3; ++k) {
    const IndexImage last = b.aboveStatus();
    b.does('M');
    EXPECT_NE(b.aboveStatus(), last);
  }
}

// The words are the story's, rounded, for a scene with several lights and colours too.
TEST(ViewingView, SaysWhatTheStorySays) {
  for (const char* scene : someOf({"teapot", "cubes", "hues", "colored-lights", "textured-cube"}, 2)) {
    ViewingWindow b{scene};
    const ViewingStory story{b.picture(), *cornerOf(b.scene().mesh, b.viewing().vertex())};
    const std::string words = testing::PrintToString(b.bench().report());
    for (const ViewStageRow& row : kViewStages) {
      if (row.id == ViewStage::Clipped || row.id == ViewStage::Snapped) continue;
      const std::string line = fixed(*story.of(row.id).NdotL, 4) + "  " + fixed(story.of(row.id).I, 4);
      EXPECT_NE(words.find(line), std::string::npos) << scene << ' ' << row.name << '\n' << words;
    }
  }
}

// The face at a pixel from outside is the nearest one of all that are there, at every stage of the whole
// scene; what is behind it does not show.
TEST(StageImage, LeavesOutWhatIsHidden) {
  const Picture picture = makePicture(readScene("teapot", 3), PictureSettings{}, 8);
  const Mesh& mesh = picture.scene().mesh;
  const ConvexParts& parts = picture.scene().parts;
  const LitParts lit{picture, picture.palette(CellPlan{TableKind::Linear})};
  const ViewingStory story{picture, {0, 0}};
  const StagePoints points{mesh, story.stages};
  for (const ViewStage stage : {ViewStage::World, ViewStage::Vrc, ViewStage::Sheared, ViewStage::Warped}) {
    const StageImage image{picture, lit, story, points, stage, {}, {200, 120}, 8};
    int covered = 0;
    for (int j = 2; j < 120; j += 9)
      for (int i = 2; i < 200; i += 7) {
        const glm::dvec2 at{i + 0.5, j + 0.5};
        double nearest = -1e300, shown = -1e300;
        for (int k = 0; k < parts.count(); ++k) {
          std::vector<glm::dvec3> p;
          for (const int corner : parts.part(k)) {
            const glm::dvec4 h = story.stages.at(stage, mesh.points[corner]);
            p.push_back(image.camera()(glm::dvec3{h} / h.w));
          }
          for (std::size_t c = 1; c + 1 < p.size(); ++c) {
            const glm::dvec2 a{p[0]}, u = glm::dvec2{p[c]} - a, v = glm::dvec2{p[c + 1]} - a, q = at - a;
            const double area = u.x * v.y - u.y * v.x;
            const double s = (q.x * v.y - q.y * v.x) / area, t = (u.x * q.y - u.y * q.x) / area;
            if (!(s > 0 && t > 0 && s + t < 1)) continue;
            const double z = p[0].z + s * (p[c].z - p[0].z) + t * (p[c + 1].z - p[0].z);
            nearest = std::max(nearest, z);
            if (parts.face[k] == image.faceAt(i, j)) shown = std::max(shown, z);
          }
        }
        EXPECT_NEAR(shown, nearest, 1e-3) << i << ", " << j;
        if (nearest <= -1e300) continue;
        ++covered;
        EXPECT_TRUE(image.shows({at, nearest + 1.0}));
        EXPECT_FALSE(image.shows({at, nearest - 2.0}));
      }
    EXPECT_GT(covered, 10) << rowOf(stage).name;
  }
}

// The light from outside is the picture's own: that of its vertices, or of its faces.
TEST(LitParts, HaveThePicturesIntensities) {
  for (const Shading method : {Shading::Flat, Shading::Gouraud}) {
    PictureSettings settings;
    settings.shading = method;
    const Picture picture = makePicture(readScene("teapot", 4), settings, 8);
    const LitParts lit{picture, picture.palette(CellPlan{TableKind::Linear})};
    const std::vector<FrontBack<double>>& own = picture.shading().intensities(0).I;
    const Mesh& mesh = picture.scene().mesh;
    for (int face = 0; face < mesh.faceCount(); ++face)
      for (int corner = mesh.firstCorner[face]; corner < mesh.firstCorner[face + 1]; ++corner) {
        const auto at = static_cast<std::size_t>(
            method == Shading::Flat ? face : picture.shading().vertices().ofCorner[corner]);
        for (const bool back : {false, true}) EXPECT_EQ(lit.at(corner, back), own[at].seen(back));
      }
  }
}

// A camera in the textbook's terms has the same view, however it was said first.
TEST(TextbooksOf, PlacesTheSameView) {
  for (const char* name : {"teapot", "room"}) {
    const Scene scene = readScene(name, 3);
    for (unsigned seed = 0; seed < 40; ++seed) {
      const PictureSettings settings = randomView(scene, seed, 400, 300);
      for (const CameraSettings& said : {CameraSettings{}, settings.camera}) {
        const Camera camera = placeCamera(scene, said, 4.0 / 3.0);
        const Camera again = placeCamera(scene, textbooksOf(camera, scene), 4.0 / 3.0);
        EXPECT_EQ(again.view, camera.view) << name << ' ' << seed;
        EXPECT_EQ(again.lookAt, camera.lookAt);
        EXPECT_EQ(textbooksOf(again, scene), textbooksOf(camera, scene));
      }
    }
  }
}

// A handle that is dragged by some pixels changes its number by as much as that way is long on its axis, and
// no other number, to the last bit. VRP moves in the plane of the drawing. The numbers are rounded to a step
// that a pixel is at least as long as. One undo takes the drag back, and one each takes back two drags.
TEST(ViewHandles, ADragChangesItsNumberAlone) {
  int dragged = 0;
  for (const bool parallel : {false, true})
    for (const ViewStage stage : {ViewStage::World, ViewStage::Vrc, ViewStage::Sheared}) {
      HandleWindow b{stage, parallel};
      const xnewell::Setup before = b.setup();
      for (const ViewHandleRow& row : kViewHandles) {
        SCOPED_TRACE(testing::Message() << row.is << ", stage " << static_cast<int>(stage) + 1
                                        << (parallel ? ", parallel" : ""));
        const bool expected = stage == ViewStage::World ||
                              (stage == ViewStage::Vrc && row.id != ViewHandle::Vrp) ||
                              row.id == ViewHandle::Front || row.id == ViewHandle::Back;
        const std::optional<glm::ivec2> at = b.find(row.id);
        ASSERT_EQ(at.has_value(), expected);
        if (!at) continue;
        const OutsideCamera camera = b.outside();
        const ViewSpec view = b.camera().view;
        const std::vector<double> was = numbersOf(view);
        const double unit = b.shownUnit();
        const auto [first, count] = numbersBy(row.id);
        const glm::ivec2 by = row.id == ViewHandle::Back ? glm::ivec2{14, 6} : glm::ivec2{-9, -7};
        const glm::dvec3 place = placeByHand(view, view, row.id, stage);
        if (row.id != ViewHandle::PrpU && row.id != ViewHandle::PrpV) {
          const glm::dvec2 drawn = glm::dvec2{camera(place)};
          EXPECT_LT(
              glm::distance(drawn, glm::dvec2{*at - glm::ivec2{b.places().outside.x, b.places().outside.y}}),
              1.0);
        }
        b.dragBy(*at, by);
        EXPECT_FALSE(b.complains());
        std::vector<double> expectedNumbers = was;
        for (int k = 0; k < count; ++k) {
          glm::dvec3 more{0.0};
          double step = 0, change = 0;
          if (count == 3) {
            more = glm::transpose(camera.turn) * glm::dvec3{by.x, -by.y, 0} / camera.scale / unit;
            change = more[k], step = stepBelow(1.0 / camera.scale / unit);
          } else {
            const glm::dvec2 way{camera(placeByHand(grownByHand(view, row.id, unit), view, row.id, stage)) -
                                 camera(place)};
            change = glm::dot(glm::dvec2{by}, way) / glm::dot(way, way);
            step = stepBelow(1.0 / glm::length(way));
          }
          double& number = expectedNumbers[static_cast<std::size_t>(first + k)];
          number = std::round((number / unit + change) / step) * step * unit;
        }
        const std::vector<double> now = numbersOf(b.camera().view);
        for (int k = 0; k < static_cast<int>(now.size()); ++k) {
          const auto which = static_cast<std::size_t>(k);
          if (k >= first && k < first + count) {
            EXPECT_NEAR(now[which], expectedNumbers[which], 1e-12 * (1 + std::abs(now[which]))) << k;
          } else {
            EXPECT_EQ(now[which], was[which]) << k;
          }
        }
        EXPECT_NE(now, was);
        ++dragged;
        b.letGo();
        const xnewell::Setup once = b.setup();
        if (const std::optional<glm::ivec2> again = b.find(row.id)) {
          b.dragBy(*again, {8, 5});
          b.letGo();
          EXPECT_NE(b.setup(), once);
          b.does('u');
          EXPECT_EQ(b.setup(), once);
        }
        b.does('u');
        EXPECT_EQ(b.setup(), before);
      }
    }
  EXPECT_EQ(dragged, 2 * (10 + 9 + 2));
}

// While it is dragged, the handle stays under the pointer, and the drawing and the small pictures show the
// change at once; the number beside is selected. When it is let go, the drawing fits the volume again.
TEST(ViewHandles, StayUnderThePointer) {
  HandleWindow b{ViewStage::World};
  for (const ViewHandle handle : {ViewHandle::Front, ViewHandle::Umax, ViewHandle::Vrp}) {
    SCOPED_TRACE(rowOf(handle).is);
    const glm::ivec2 at = b.find(handle).value();
    const IndexImage outside = b.part(b.places().outside), small = b.part(b.places().small[0]),
                     picture = b.part(b.places().small[5]);
    glm::dvec2 way{12, 9};
    if (handle != ViewHandle::Vrp) {  // along its axis
      const ViewSpec view = b.camera().view;
      way = b.wayOf(handle, grownByHand(view, handle, b.shownUnit()), view);
      way *= (handle == ViewHandle::Front ? -15.0 : 15.0) / glm::length(way);
    }
    const glm::ivec2 by{std::lround(way.x), std::lround(way.y)};
    b.dragBy(at, by);
    EXPECT_LE(glm::distance(glm::dvec2{b.find(handle).value()}, glm::dvec2{at + by}), 2.0);
    EXPECT_NE(b.part(b.places().outside), outside);
    EXPECT_NE(b.part(b.places().small[0]), small);
    if (handle != ViewHandle::Front) {  // the front plane cuts nothing here
      EXPECT_NE(b.part(b.places().small[5]), picture);
    }
    EXPECT_EQ(b.viewing().list().focus(), std::optional{rowOf(handle).number});
    b.letGo();
    b.pointAt(0, 0);
    const Rect area = b.places().outside;
    const IndexImage after = b.part(area);
    ViewingWindow fresh;
    fresh.becomes(b);
    EXPECT_EQ(after, fresh.part(area));
  }
}

// What can be no view is refused with the same sentence as a number that is typed. The number stops one step
// before that, or nearer.
TEST(ViewHandles, StopBeforeWhatIsNoView) {
  struct Pull {
    ViewHandle handle;
    double towards;  // the number grows or shrinks
    double (*room)(const ViewSpec&);
  };
  for (const Pull& pull :
       {Pull{ViewHandle::Front, -1, [](const ViewSpec& v) { return v.front - v.back; }},
        Pull{ViewHandle::Front, 1, [](const ViewSpec& v) { return v.prp.z - v.front; }},
        Pull{ViewHandle::Back, 1, [](const ViewSpec& v) { return v.front - v.back; }},
        Pull{ViewHandle::PrpN, -1, [](const ViewSpec& v) { return v.prp.z - v.front; }},
        Pull{ViewHandle::Umin, 1, [](const ViewSpec& v) { return v.windowMax.x - v.windowMin.x; }},
        Pull{ViewHandle::Vmax, -1, [](const ViewSpec& v) { return v.windowMax.y - v.windowMin.y; }}}) {
    SCOPED_TRACE(testing::Message() << rowOf(pull.handle).is << ' ' << pull.towards);
    HandleWindow b{ViewStage::World};
    const xnewell::Setup before = b.setup();
    const ViewSpec view = b.camera().view;
    const glm::dvec2 way =
        b.wayOf(pull.handle, grownByHand(view, pull.handle, pull.towards * b.shownUnit()), view);
    const glm::dvec2 far = way / glm::length(way) * 2000.0;
    const glm::ivec2 at = b.find(pull.handle).value();
    b.dragBy(at, {std::lround(far.x), std::lround(far.y)});
    EXPECT_TRUE(b.complains());
    const double room = pull.room(b.camera().view) / b.shownUnit();
    EXPECT_GT(room, 0.0);
    EXPECT_LE(room, 2.0 * stepBelow(1.0 / glm::length(way)));
    b.letGo();
    EXPECT_NE(b.setup(), before);
    b.does('u');
    EXPECT_EQ(b.setup(), before);
  }
}

// A handle under the pointer stands out, with its name and its number in the drawing and what to do with it
// below. A press alone changes no number.
TEST(ViewHandles, AreNamedUnderThePointer) {
  HandleWindow b{ViewStage::World};
  b.pointAt(0, 0);
  const Rect area = b.places().outside;
  const xnewell::Setup before = b.setup();
  for (const ViewHandleRow& row : kViewHandles) {
    SCOPED_TRACE(row.is);
    b.pointAt(0, 0);
    const IndexImage still = b.part(area);
    const glm::ivec2 at = b.find(row.id).value();
    b.pointAt(at.x, at.y);
    EXPECT_EQ(b.bench().status(), row.is);
    EXPECT_NE(b.part(area), still);
    EXPECT_EQ(b.image().row(at.y)[at.x], b.plan()[Cell::Q]);
    b.pointAt(0, 0);
    EXPECT_EQ(b.part(area), still);
    ASSERT_TRUE(b.grab(at.x, at.y));
    b.letGo();
    EXPECT_EQ(b.setup(), before);
  }
}

// In windows of all sizes the eye's handle stands clear of the words at the top and at the bottom, also in an
// oblique view, whose PRP lies far out.
TEST(ViewHandles, StandClearOfTheWords) {
  for (const auto& [width, height] : {std::pair{800, 540}, {1024, 768}, {1920, 1080}})
    for (const bool oblique : {false, true}) {
      SCOPED_TRACE(testing::Message() << width << (oblique ? ", oblique" : ""));
      HandleWindow b{ViewStage::World, oblique, "hues", width, height};
      if (oblique) {
        b.does('O');
        b.press('a');
        b.typeValue("120");
      }
      const Rect area = b.places().outside;
      const std::optional<glm::ivec2> eye = b.find(ViewHandle::PrpN);
      ASSERT_TRUE(eye);
      EXPECT_GE(eye->y, area.y + 24);
      EXPECT_LE(eye->y, area.y + area.height - 24);
    }
}

// The images of the stages are kept while nothing that they show changes; a window that has been everywhere
// shows what a new one shows.
TEST(StageImages, AreThoseOfANewWindow) {
  ViewingWindow b;
  for (const char key : {'p', 't', 'H', 'P', 'z'}) {
    SCOPED_TRACE(key);
    b.does(key);
    b.does(NamedKey::Up);
    if (b.bench().list().focus()) b.does(NamedKey::Escape);
    for (int k = 0; k < 6; ++k) b.does(NamedKey::Right);
    for (int k = 0; k < 6; ++k) b.does(NamedKey::Left);
    ViewingWindow fresh;
    fresh.becomes(b);
    for (const char moved : {'t', 'z'})
      if (key == moved || (moved == 't' && key != 'p'))
        fresh.does(moved), fresh.does(NamedKey::Up), fresh.does(NamedKey::Escape);
    for (int stage = 0; stage < 7; ++stage) {
      SCOPED_TRACE(stage);
      EXPECT_EQ(b.part(b.places().outside), fresh.part(b.places().outside));
      for (const Rect& small : b.places().small) EXPECT_EQ(b.part(small), fresh.part(small));
      b.does(NamedKey::Right);
      fresh.does(NamedKey::Right);
    }
    for (int k = 0; k < 6; ++k) b.does(NamedKey::Left);
  }
}

}  // namespace xnewell::THIS_FILE
