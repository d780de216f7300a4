#include "x11/views/shows.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace xnewell {

namespace {

struct Painted {
  Picture picture;
  ColoredImage image;
  explicit Painted(const char* scene, ColorPlan plan = ColorPlan::Needed, Order order = Order::Newell)
      : picture{readScene(scene, 3)} {
    PictureSettings s;
    s.width = 240, s.height = 180;
    s.shading = Shading::Gouraud;
    s.colors = plan;
    s.order = order;
    s.camera = inSceneUnits(completed({}, picture.scene().camera), picture.scene());
    picture.make(s);
    picture.paint(image.image, CellPlan{}[Cell::Well]);
    image.palette = picture.palette(CellPlan{});
  }
};

}  // namespace

// Everything that can be shown has the picture's size and place and leaves the picture as it was, with one
// hue, with several and with colours, in any order. All but the normals are drawn in the tool's own cells and
// change no colour.
TEST(Shows, KeepThePictureAndItsColours) {
  for (const auto& [scene, plan] : {std::pair{"teapot", ColorPlan::OneHue},
                                    {"hues", ColorPlan::Hues},
                                    {"hues", ColorPlan::Chosen},
                                    {"tori", ColorPlan::Cube}})
    for (const OrderRow& order : kOrders) {
      Painted p{scene, plan, order.id};
      const PictureSettings settings = p.picture.settings();
      for (const ShowRow& row : kShows) {
        SCOPED_TRACE(std::string{scene} + ' ' + std::string{order.name} + ' ' + std::string{row.name});
        const ShownPicture shown = shownAs(row.id, p.picture, p.image, CellPlan{});
        ASSERT_EQ(shown.image.width, settings.width);
        ASSERT_EQ(shown.image.height, settings.height);
        EXPECT_EQ(shown.image == p.image.image, row.id == Show::Shaded);
        EXPECT_EQ(shown.palette == p.image.palette, row.id != Show::Normals || plan == ColorPlan::Cube);
        EXPECT_EQ(shown.finding.empty(), row.id == Show::Shaded || row.id == Show::Normals);
        EXPECT_EQ(withInterface(shown.palette, CellPlan{}), shown.palette);
        if (row.id != Show::Shaded && row.id != Show::Normals) {
          EXPECT_TRUE(std::ranges::none_of(shown.image.pixels, [](int c) { return c > 10 && c < 251; }));
        }
        EXPECT_GT(std::ranges::count(shown.image.pixels, CellPlan{}[Cell::Well]), 1000);
        const bool hasLegend = row.id == Show::Overdraw || row.id == Show::Difference;
        EXPECT_EQ(shown.image.row(12)[12] == CellPlan{}[Cell::WellLine], hasLegend);
        EXPECT_EQ(p.picture.settings(), settings);
        IndexImage again;
        p.picture.paint(again, CellPlan{}[Cell::Well]);
        ASSERT_EQ(again, p.image.image);
        ASSERT_EQ(p.picture.palette(CellPlan{}), p.image.palette);
      }
    }
}

// The ground is where the picture's ground is: nothing is shown where nothing is, except for the legend, and
// for lines at the border.
TEST(Shows, TheGroundStays) {
  Painted p{"teapot"};
  const std::uint8_t well = CellPlan{}[Cell::Well];
  for (const Show show : {Show::Overdraw, Show::Difference, Show::Normals}) {
    const ShownPicture shown = shownAs(show, p.picture, p.image, CellPlan{});
    int differ = 0;
    for (std::size_t k = std::size_t{24} * 240; k < shown.image.pixels.size(); ++k)  // below the legend
      differ += (shown.image.pixels[k] == well) != (p.image.image.pixels[k] == well);
    EXPECT_LE(differ, show == Show::Normals ? 400 : 0);  // needles reach beyond the border
  }
}

}  // namespace xnewell
