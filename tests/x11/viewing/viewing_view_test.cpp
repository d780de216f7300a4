#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "shading/scene/units.h"
#include "tests/support/model_view.h"
#include "tests/support/seeds.h"
#include "tests/x11/viewing/viewing_window.h"
#include "x11/drawing/wording.h"
#include "x11/viewing/view_controls.h"

namespace xnewell::THIS_FILE {

// The arrows go from stage to stage, also after s; a click on a small picture or on a row of the table goes
// there. At the ends the stage stays.
TEST(ViewingView, KeysAndThePointerChooseTheStage) {
  ViewingWindow b;
  EXPECT_EQ(b.viewing().stage(), 1);
  EXPECT_TRUE(b.words().starts_with("1 world: ")) << b.words();
  b.does(NamedKey::Right);
  EXPECT_TRUE(b.words().starts_with("2 VRC: ")) << b.words();
  b.does(NamedKey::Left);
  b.does(NamedKey::Left);
  EXPECT_EQ(b.viewing().stage(), 1);
  b.press('s');
  for (int k = 0; k < 9; ++k) b.press(NamedKey::Right);
  b.finish();
  EXPECT_EQ(b.viewing().stage(), 7);
  for (int k = 0; k < 7; ++k) {
    const Rect small = b.places().small[static_cast<std::size_t>(k)];
    (void)b.grab(small.x + 5, small.y + 5);
    b.settle();
    b.finish();
    EXPECT_EQ(b.viewing().stage(), k + 1);
  }
  // The rows of the table are below its two heads.
  const Rect table = b.places().table;
  (void)b.grab(table.x + 40, table.y + 30 + 3 * b.places().pitch - 4);
  b.settle();
  EXPECT_EQ(b.viewing().stage(), 3);
}

// A number that is typed becomes that number of the view, and all the others stay, to the last bit after the
// first change. Undo brings back the view that was.
TEST(ViewingView, ANumberChangesTheViewAlone) {
  ViewingWindow b;
  const xnewell::Setup before = b.setup();
  const std::vector<std::pair<std::string, int>> keys{
      {"v", 0},  {"vv", 1},  {"vvv", 2},  {"n", 3},     {"nn", 4},  {"nnn", 5},
      {"y", 6},  {"yy", 7},  {"yyy", 8},  {"p", 9},     {"pp", 10}, {"ppp", 11},
      {"o", 12}, {"oo", 13}, {"ooo", 14}, {"oooo", 15}, {"f", 16},  {"b", 17}};
  const double file = std::ldexp(1.0, b.scene().exponent);
  for (const auto& [letters, which] : keys) {
    SCOPED_TRACE(letters);
    b.bench().enter();  // nothing is selected
    const std::vector<double> was = numbersOf(b.camera().view);
    for (const char c : letters) b.press(c);
    const bool direction = which >= 3 && which <= 8;
    const double shown = was[static_cast<std::size_t>(which)] * (direction ? 1.0 : file);
    const double next = std::round((shown + 0.25) * 100) / 100;
    b.typeValue(std::to_string(next));
    EXPECT_FALSE(b.complains());
    const std::vector<double> now = numbersOf(b.camera().view);
    for (int k = 0; k < static_cast<int>(now.size()); ++k) {
      const double is = now[static_cast<std::size_t>(k)], old = was[static_cast<std::size_t>(k)];
      if (k != which)
        EXPECT_EQ(is, old) << k;
      else
        EXPECT_NEAR(is * (direction ? 1.0 : file), next, 1e-12);
    }
  }
  for (std::size_t k = 0; k < keys.size(); ++k) b.press('u');
  EXPECT_EQ(b.setup(), before);
}

// A change is seen outside, in the picture, in the numbers and in view 1.
TEST(ViewingView, AChangeIsSeenEverywhere) {
  ViewingWindow b;
  for (int k = 0; k < 2; ++k) b.does(NamedKey::Right);
  const IndexImage outside = b.part(b.places().outside), small = b.part(b.places().small[5]);
  const std::string words = b.words();
  b.press('1');
  b.finish();
  const IndexImage picture = b.picture().image();
  b.press('9');
  b.finish();
  EXPECT_EQ(b.part(b.places().outside), outside) << "nothing has changed yet";
  b.press('p');
  b.typeValue("-4");
  EXPECT_NE(b.part(b.places().outside), outside);
  EXPECT_NE(b.part(b.places().small[5]), small);
  EXPECT_NE(b.words(), words);
  EXPECT_NE(b.words().find("Shade in the world, not behind the shear."), std::string::npos) << b.words();
  b.press('1');
  b.finish();
  EXPECT_NE(b.picture().image(), picture);
}

// P keeps all numbers and only projects in parallel; O and a then move PRP so that a line along n is drawn as
// long as it is, or half as long, at the angle, and still is when the window changes. In perspective they say
// why they do nothing.
TEST(ViewingView, ObliqueProjections) {
  ViewingWindow b;
  b.does('O');
  EXPECT_TRUE(b.complains());
  const ViewSpec before = b.camera().view;
  b.does('P');
  ViewSpec expected = before;
  expected.projection = Projection::Parallel;
  EXPECT_EQ(b.camera().view, expected);
  b.does('O');
  EXPECT_NEAR(leanOf(b.camera().view).length, 1.0, 1e-12);
  EXPECT_NEAR(leanOf(b.camera().view).angle, 45.0, 1e-9);
  b.press('a');
  b.typeValue("120");
  EXPECT_NEAR(leanOf(b.camera().view).length, 1.0, 1e-12);
  EXPECT_NEAR(leanOf(b.camera().view).angle, 120.0, 1e-9);
  b.does('O');
  EXPECT_NEAR(leanOf(b.camera().view).length, 0.5, 1e-12);
  EXPECT_NEAR(leanOf(b.camera().view).angle, 120.0, 1e-9);
  b.press('o');  // the window, which is no more in the middle
  b.typeValue("-7");
  EXPECT_EQ(b.camera().view.windowMin.x, -7 / std::ldexp(1.0, b.scene().exponent));
  EXPECT_NEAR(leanOf(b.camera().view).length, 0.5, 1e-12);
  EXPECT_NEAR(leanOf(b.camera().view).angle, 120.0, 1e-9);
  b.press('u');
  b.does('O');
  EXPECT_LT(leanOf(b.camera().view).length, 1e-12);
  b.does('P');
  ViewSpec back = b.camera().view;
  EXPECT_NEAR(glm::length(back.prp - before.prp), 0.0, 1e-12);
  back.prp = before.prp;
  EXPECT_EQ(back, before);
}

// A click outside chooses the nearest corner of the face under the pointer, at every stage with a scene; a
// drag turns the outside view and leaves the scene's camera and the vertex as they are.
TEST(ViewingView, AClickChoosesAVertexAndADragTurns) {
  ViewingWindow b;
  const Rect at = b.places().outside;
  for (int stage = 1; stage <= 6; ++stage, b.does(NamedKey::Right)) {
    ASSERT_EQ(b.viewing().stage(), stage);
    const LitParts lit{b.picture(), b.palette()};
    const ViewingStory story{b.picture(), *cornerOf(b.scene().mesh, b.viewing().vertex())};
    const StageImage drawn{b.picture(),
                           lit,
                           story,
                           StagePoints{b.scene().mesh, story.stages},
                           static_cast<ViewStage>(stage - 1),
                           turnAt(static_cast<ViewStage>(stage - 1), {}),
                           {at.width, at.height},
                           b.ground(),
                           kWordBand};
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
  for (const char key : {'t', 'z'}) {
    const IndexImage last = b.part(at);
    b.press(key);
    b.does(NamedKey::Up);
    EXPECT_NE(b.part(at), last) << key;
  }
  const IndexImage last = b.part(at);
  b.wheel(at.x + 50, at.y + 50, 1.2);
  b.finish();
  EXPECT_NE(b.part(at), last);
  EXPECT_EQ(b.setup(), b.defaults());
}

// Each choice of M shows another matrix, whose numbers are those of the story; at 1 and 7 too.
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
        EXPECT_NEAR(last[k], here[k] / here.w, 1e-9 * (1 + std::abs(last[k])))
            << row.name << ' ' << kShownMatrices[static_cast<std::size_t>(shown)];
    }
  b.does(NamedKey::Right);
  IndexImage last = b.image();
  for (int k = 0; k < 3; ++k) {
    b.does('M');
    EXPECT_NE(b.image(), last);
    last = b.image();
  }
}

// The words are the story's, rounded, for a scene with several lights and colours too; without light of a
// point the page says so.
TEST(ViewingView, SaysWhatTheStorySays) {
  for (const char* scene : someOf({"teapot", "cubes", "hues", "colored-lights", "textured-cube"}, 2)) {
    ViewingWindow b{scene};
    const ViewingStory story{b.picture(), *cornerOf(b.scene().mesh, b.viewing().vertex())};
    for (const ViewStageRow& row : kViewStages) {
      if (row.id == ViewStage::Clipped || row.id == ViewStage::Snapped) continue;
      const std::string line = fixed(*story.of(row.id).NdotL, 4) + "  " + fixed(story.of(row.id).I, 4);
      EXPECT_NE(b.words().find(line), std::string::npos) << scene << ' ' << row.name << '\n' << b.words();
    }
  }
  ViewingWindow b;
  b.change('[', [](xnewell::Setup& s) { s.picture.light.Ia = 1, s.picture.light.Ip = 0; });
  b.finish();
  EXPECT_NE(b.words().find("All light is ambient."), std::string::npos) << b.words();
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

}  // namespace xnewell::THIS_FILE
