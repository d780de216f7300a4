#include "shading/picture/picture_cache.h"
#include "x11/views/views.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "depthsort/oracle.h"
#include "tests/support/scene_text.h"
#include "tests/support/seeds.h"
#include "x11/views/wireframe.h"

namespace xnewell::THIS_FILE {

namespace {

Picture made(const char* name, ColorPlan plan = ColorPlan::Needed, Order order = Order::Newell) {
  Scene scene = readScene(name, 3);
  PictureSettings s;
  s.width = 240, s.height = 180;
  s.shading = Shading::Gouraud;
  s.colors = plan;
  s.order = order;
  s.camera = completed({}, scene.camera);
  return makePicture(std::move(scene), s, CellPlan{}[Cell::Well]);
}

}  // namespace

// Everything that can be shown has the picture's size and place and leaves the picture as it was. All but the
// normals and the terms are drawn in the tool's own cells and change no colour.
TEST(Shows, KeepThePictureAndItsColours) {
  for (const auto& [scene, plan] : someOf({std::pair{"tori", ColorPlan::Cube},
                                           {"hues", ColorPlan::Hues},
                                           {"hues", ColorPlan::Chosen},
                                           {"teapot", ColorPlan::OneHue}},
                                          2))
    for (const OrderRow& order : kOrders) {
      if (plan != ColorPlan::OneHue && order.id != Order::Newell) continue;
      const Picture picture = made(scene, plan, order.id);
      const PictureSettings& settings = picture.settings();
      const Palette palette = picture.palette(CellPlan{});
      CachedGroundTruth truth;
      for (const ViewRow& row : kViews) {
        if (row.key != 0 && row.id != View::Picture) continue;  // views of the window alone
        SCOPED_TRACE(std::string{scene} + ' ' + std::string{order.name} + ' ' + std::string{row.name});
        const ShownPicture shown = shownAs(row.id, picture, palette, CellPlan{}, truth);
        ASSERT_EQ(shown.image.width, settings.width);
        ASSERT_EQ(shown.image.height, settings.height);
        EXPECT_EQ(shown.image == picture.image(), row.id == View::Picture);
        EXPECT_EQ(shown.palette == palette, !row.hasOwnColors() || plan == ColorPlan::Cube);
        EXPECT_EQ(shown.finding.empty(), row.id == View::Picture);
        EXPECT_EQ(withInterface(shown.palette, CellPlan{}), shown.palette);
        if (row.id != View::Picture && !row.hasOwnColors()) {
          EXPECT_TRUE(std::ranges::none_of(shown.image.pixels, [](int c) { return c > 10 && c < 251; }));
        }
        EXPECT_GT(std::ranges::count(shown.image.pixels, CellPlan{}[Cell::Well]), 1000);
        const bool hasLegend =
            row.id == View::Overdraw || row.id == View::Difference || row.id == View::Exactness;
        EXPECT_EQ(shown.image.row(12)[12] == CellPlan{}[Cell::WellLine], hasLegend);
      }
    }
}

// The ground is where the picture's ground is: nothing is shown where nothing is, except for the legend, and
// for lines at the border. The difference shows as well what the picture lacks.
TEST(Shows, TheGroundStays) {
  const Picture picture = made("teapot");
  const std::uint8_t well = CellPlan{}[Cell::Well];
  for (const View show : {View::Overdraw, View::Difference, View::Exactness, View::Normals}) {
    CachedGroundTruth truth;
    const ShownPicture shown = shownAs(show, picture, picture.palette(CellPlan{}), CellPlan{}, truth);
    const std::vector<int>& due = truth.of(picture).reference().faces();
    int differ = 0;
    for (std::size_t k = std::size_t{24} * 240; k < shown.image.pixels.size(); ++k) {  // below the legend
      const bool nothing =
          picture.image().pixels[k] == well && (show != View::Difference || due[k] == kNothing);
      differ += (shown.image.pixels[k] == well) != nothing;
    }
    EXPECT_LE(differ, show == View::Normals ? 400 : 0);  // needles reach beyond the border
  }
}

// Lines and labels of a scene are drawn over its picture, in the cell that looks most like their colour,
// except where a face hides them.
TEST(Shows, MarksOfTheScene) {
  const auto drawn = [](const char* z) {
    Scene scene = parsed(std::string{R"({"camera": {"eye": [0, 0, 5], "look_at": [0, 0, 0], "parallel": 4},
      "labels": [{"text": "\u03b8", "at": [-0.2, -0.9, )"} +
                         z + R"(], "color": [1, 1, 1], "size": 24}],
      "lines": [{"points": [[-1.5, 0, )" +
                         z + R"(], [1.5, 0, )" + z + R"(]], "color": [1, 1, 1]}],
      "objects": [{"polygons": [[[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]],
        [[-1.9, -1.9, 1], [-1.8, -1.9, 1], [-1.9, -1.8, 1]]]}]})");
    PictureSettings s = scene.settings;
    s.width = 200, s.height = 200;
    s.camera = completed({}, scene.camera);
    const Picture picture = makePicture(std::move(scene), s, CellPlan{}[Cell::Well]);
    const IndexImage marked = withMarks(picture, picture.palette(CellPlan{}));
    int line = 0, label = 0;
    for (int j = 0; j < 200; ++j)
      for (int i = 0; i < 200; ++i)
        if (marked.row(j)[i] != picture.image().row(j)[i]) {
          EXPECT_EQ(marked.row(j)[i], CellPlan{}[Cell::White]);
          ++(j > 96 && j < 104 ? line : label);
        }
    return std::pair{line, label};
  };
  const auto [before, letter] = drawn("0.5");
  EXPECT_NEAR(before, 150, 8);
  EXPECT_GT(letter, 10);
  const auto [behind, none] = drawn("-0.5");
  EXPECT_NEAR(behind, 50, 8);
  EXPECT_EQ(none, 0);
}

// Edges of the model are drawn over its picture in the colour that is asked for: those in front, and the
// others in dashes if all are shown.
TEST(Shows, EdgesOfTheModel) {
  const auto changed = [](ModelEdges edges) {
    Scene scene = parsed(R"({"camera": {"eye": [0, 0, 5], "look_at": [0, 0, 0], "parallel": 4}, "objects": [
      {"polygons": [[[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]],
                    [[-0.5, -0.5, -1], [0.5, -0.5, -1], [0.5, 0.5, -1], [-0.5, 0.5, -1]]]}]})");
    scene.marks.edges = edges, scene.marks.edgeColor = {1, 1, 1};
    PictureSettings s = scene.settings;
    s.width = 200, s.height = 200;
    s.camera = completed({}, scene.camera);
    const Picture picture = makePicture(std::move(scene), s, CellPlan{}[Cell::Well]);
    const IndexImage marked = withMarks(picture, picture.palette(CellPlan{}));
    std::pair<int, int> counts{0, 0};  // within the square of the outer edges, and on them
    for (int j = 0; j < 200; ++j)
      for (int i = 0; i < 200; ++i)
        if (marked.row(j)[i] != picture.image().row(j)[i]) {
          EXPECT_EQ(marked.row(j)[i], CellPlan{}[Cell::White]);
          ++(std::max(std::abs(i - 100), std::abs(j - 100)) < 40 ? counts.first : counts.second);
        }
    return counts;
  };
  EXPECT_EQ(changed(ModelEdges::None), (std::pair{0, 0}));
  const auto [within, around] = changed(ModelEdges::Visible);
  EXPECT_EQ(within, 0);
  EXPECT_NEAR(around, 400, 8);
  const auto [dashes, outer] = changed(ModelEdges::All);
  EXPECT_NEAR(dashes, 200 * kDash / kDashPeriod, 12);
  EXPECT_EQ(outer, around);
}

}  // namespace xnewell::THIS_FILE
