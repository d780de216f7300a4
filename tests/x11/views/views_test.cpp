#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "depthsort/oracle.h"
#include "geometry/model/solids.h"
#include "shading/laboratory/profile.h"
#include "shading/picture/picture_cache.h"
#include "tests/support/scene_text.h"
#include "tests/support/seeds.h"
#include "tests/x11/support/ready_workbench.h"
#include "x11/drawing/painter.h"
#include "x11/views/exactness_view.h"
#include "x11/views/views.h"
#include "x11/views/wireframe.h"

namespace xnewell::THIS_FILE {

namespace {

constexpr std::array kDrawn{View::MachBands, View::Normals,  View::Difference,
                            View::Exactness, View::Overdraw, View::Wireframe};

ViewSettings settingsOf(View view, const Scene& scene, int width, int height) {
  ViewSettings s;
  s.view = view;
  s.picture.width = width, s.picture.height = height;
  s.picture.camera = completed({}, scene.camera);
  return s;
}

/// True if all pixels of the area are paper.
bool isPaper(const IndexImage& image, const Rect& area) {
  return std::ranges::count(partOf(image, area).pixels, CellPlan{}[Cell::Paper]) == area.width * area.height;
}

Picture made(const char* name, ColorPlan plan = ColorPlan::Needed, Order order = Order::Newell,
             Shading shading = Shading::Gouraud) {
  Scene scene = readScene(name, 3);
  PictureSettings s;
  s.width = 240, s.height = 180;
  s.shading = shading;
  s.colors = plan;
  s.order = order;
  s.camera = completed({}, scene.camera);
  return makePicture(std::move(scene), s, CellPlan{}[Cell::Well]);
}

}  // namespace

// Every view, from the least size to 1600 x 1200, is as large as asked. Words, plots and pictures keep out of
// the margins and of the gutter between the columns, so nothing is cut off.
TEST(Views, NothingIsCutOff) {
  PictureCache teapot{readScene("teapot", 3)}, cycle{readScene("cycle")}, tori{readScene("tori")};
  for (const View view : kDrawn) {
    const ViewRow& row = rowOf(view);
    for (PictureCache* const pictures : someOf({&teapot, &cycle, &tori}, 1))
      for (const auto& [width, height] :
           {std::pair{row.least.x, row.least.y}, std::pair{row.least.x, 1200}, std::pair{1600, row.least.y},
            std::pair{801, 601}, std::pair{1024, 768}, std::pair{1600, 1200}}) {
        if (kSanitized && width * height > 600'000) continue;
        SCOPED_TRACE(std::string{row.name} + ' ' + pictures->scene().name + ' ' + std::to_string(width) +
                     'x' + std::to_string(height));
        ViewSettings s = settingsOf(view, pictures->scene(), width, height);
        s.picture.shading = Shading::Phong;
        s.picture.colors = pictures == &tori ? ColorPlan::Chosen : ColorPlan::Needed;
        const IndexImage image = drawView(*pictures, s).image;
        ASSERT_EQ(std::pair(image.width, image.height), std::pair(width, height));
        const int margin = 8;
        EXPECT_TRUE(isPaper(image, {0, 0, margin, height}) && isPaper(image, {0, 0, width, margin}));
        EXPECT_TRUE(isPaper(image, {width - margin, 0, margin, height}));
        EXPECT_TRUE(isPaper(image, {0, height - margin, width, margin}));
        if (view == View::MachBands) {
          EXPECT_TRUE(isPaper(image, {width - 16 - 320 - 6, 0, 6, height}));
        }
        if (view == View::Difference) {
          EXPECT_TRUE(isPaper(image, {(width - 16) / 2 + (width % 2), 0, 15, height}));
        }
        EXPECT_GT(std::ranges::count(image.pixels, CellPlan{}[Cell::Ink]), 500);
      }
  }
}

// A view shows what is seen, not how the sort got there: split faces show what whole ones show.
TEST(Views, DoNotDependOnSplits) {
  for (const char* const scene : {"penetrate", "cycle"})
    for (const View view : {View::MachBands, View::Normals}) {
      PictureCache split{readScene(scene)}, whole{readScene(scene)};
      ViewSettings s = settingsOf(view, split.scene(), 800, 600);
      s.picture.shading = Shading::Gouraud;
      const ColoredImage sorted = drawView(split, s);
      EXPECT_GT(split.last().sorted().statistics.splits, 0);
      s.picture.order = Order::Oracle;
      const ColoredImage decided = drawView(whole, s);
      EXPECT_EQ(sorted.image, decided.image);
      EXPECT_EQ(sorted.palette, decided.palette);
    }
}

// A view drawn again is the same, after any other view: no view leaves anything in the picture for the next.
TEST(Views, DoNotDependOnTheOneBefore) {
  const auto drawn = [](PictureCache& pictures, View view) {
    ViewSettings s = settingsOf(view, pictures.scene(), 800, 600);
    s.picture.shading = Shading::Gouraud;
    return drawView(pictures, s).image;
  };
  PictureCache pictures{readScene("teapot", 3)};
  std::vector<IndexImage> first;
  for (const View view : kDrawn) {
    PictureCache fresh{readScene("teapot", 3)};
    first.push_back(drawn(fresh, view));
  }
  EXPECT_NE(first[0], first[2]);
  for (int round = 0; round < 2; ++round)
    for (std::size_t k = 0; k < kDrawn.size(); ++k) EXPECT_EQ(drawn(pictures, kDrawn[k]), first[k]);
}

// Each band is marked on its curve, in the column of its pixel, and nothing else is.
TEST(Views, MarkEveryBand) {
  PictureCache pictures{readScene("teapot")};
  const ViewSettings s = settingsOf(View::MachBands, pictures.scene(), 1600, 1200);
  const IndexImage view = drawView(pictures, s).image;
  const Picture& picture = pictures.last();
  const Scanline line = scanlineOf(picture, defaultScanline(picture), CellPlan{}[Cell::Well]);
  std::vector<std::pair<int, int>> due;  // column; how many marks in it
  for (int x = 0; x < picture.settings().width; ++x)
    due.emplace_back(x, std::ranges::count_if(line.profiles, [x](const Profile& p) {
                       return std::ranges::find(p.bands, x) != p.bands.end();
                     }));
  int all = 0;
  for (const auto& [x, marks] : due) {
    int found = 0;
    for (int j = 1; j < view.height; ++j)
      found += view.row(j)[100 + x] == CellPlan{}[Cell::Alarm] &&
               view.row(j - 1)[100 + x] != CellPlan{}[Cell::Alarm];
    EXPECT_EQ(found, marks) << x;
    all += marks;
  }
  EXPECT_GT(all, 50);
}

// A fine ball from afar shows every normal of its front half once. At each sample the colour is that of the
// sphere's own normal: red to the right, green up, and blue towards the viewer. The larger picture is worked
// on in two bands.
TEST(NormalColors, AreThoseOfTheSphere) {
  PictureCache ball{makeScene("ball", sphere(96, 48), UpAxis::Z)};
  PictureSettings s;
  s.shading = Shading::Phong;
  s.camera.parallel = true;
  for (const int size : {200, 1500}) {
    s.width = s.height = size;
    ball.make(s);
    const RgbImage colors = normalColors(ball.last());
    int first = size, last = 0;
    for (int j = 0; j < size; ++j)
      if (colors.pixel(size / 2, j)[2] > 0) first = std::min(first, j), last = std::max(last, j);
    const double radius = (last + 1 - first) / 2.0;
    EXPECT_GT(radius, 0.4 * size);
    int samples = 0;
    for (int j = 0; j < size; ++j)
      for (int i = 0; i < size; ++i) {
        const double x = (i + 0.5 - size / 2) / radius, y = (size / 2 - j - 0.5) / radius;
        if (x * x + y * y > 0.9) continue;
        ++samples;
        const std::uint8_t* const c = colors.pixel(i, j);
        ASSERT_NEAR(c[0], 127.5 * (x + 1), 4) << i << ", " << j;
        ASSERT_NEAR(c[1], 127.5 * (y + 1), 4);
        ASSERT_NEAR(c[2], 127.5 * (std::sqrt(1 - x * x - y * y) + 1), 4);
      }
    EXPECT_GT(samples, 0.375 * size * size);
  }
}

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
// except where a face hides them. So are the edges of the model, in the colour that is asked for: those in
// front, and the others in dashes if all are shown.
TEST(Shows, MarksOfTheScene) {
  /// Counts the samples of marks within a part and elsewhere.
  const auto marksOf = [](Scene scene, auto&& isWithin) {
    PictureSettings s = scene.settings;
    s.width = 200, s.height = 200;
    s.camera = completed({}, scene.camera);
    const Picture picture = makePicture(std::move(scene), s, CellPlan{}[Cell::Well]);
    const IndexImage marked = withMarks(picture, picture.palette(CellPlan{}));
    std::pair<int, int> counts{0, 0};
    for (int j = 0; j < 200; ++j)
      for (int i = 0; i < 200; ++i)
        if (marked.row(j)[i] != picture.image().row(j)[i]) {
          EXPECT_EQ(marked.row(j)[i], CellPlan{}[Cell::White]);
          ++(isWithin(i, j) ? counts.first : counts.second);
        }
    return counts;
  };
  const std::string view = R"({"camera": {"eye": [0, 0, 5], "look_at": [0, 0, 0], "parallel": 4}, )",
                    square = R"([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]])";
  const auto lineAndLabel = [&](const std::string& z) {
    const std::string text = view + R"("labels": [{"text": "\u03b8", "at": [-0.2, -0.9, )" + z +
                             R"(], "color": [1, 1, 1], "size": 24}], "lines": [{"points": [[-1.5, 0, )" + z +
                             "], [1.5, 0, " + z + R"(]], "color": [1, 1, 1]}], "objects": [{"polygons": [)" +
                             square + ", [[-1.9, -1.9, 1], [-1.8, -1.9, 1], [-1.9, -1.8, 1]]]}]}";
    return marksOf(parsed(text), [](int, int j) { return j > 96 && j < 104; });
  };
  const auto [before, letter] = lineAndLabel("0.5");
  EXPECT_NEAR(before, 150, 8);
  EXPECT_GT(letter, 10);
  const auto [behind, none] = lineAndLabel("-0.5");
  EXPECT_NEAR(behind, 50, 8);
  EXPECT_EQ(none, 0);

  const auto edgesOf = [&](ModelEdges edges) {
    Scene scene = parsed(view + R"("objects": [{"polygons": [)" + square +
                         ", [[-0.5, -0.5, -1], [0.5, -0.5, -1], [0.5, 0.5, -1], [-0.5, 0.5, -1]]]}]}");
    scene.marks.edges = edges, scene.marks.edgeColor = {1, 1, 1};
    return marksOf(std::move(scene),
                   [](int i, int j) { return std::max(std::abs(i - 100), std::abs(j - 100)) < 40; });
  };
  EXPECT_EQ(edgesOf(ModelEdges::None), (std::pair{0, 0}));
  const auto [within, around] = edgesOf(ModelEdges::Visible);
  EXPECT_EQ(within, 0);
  EXPECT_NEAR(around, 400, 8);
  const auto [dashes, outer] = edgesOf(ModelEdges::All);
  EXPECT_NEAR(dashes, 200 * kDash / kDashPeriod, 12);
  EXPECT_EQ(outer, around);
}

// The colour of each sample tells its value: gray from 0 to 1, blue below 0. Only the steps of the scene's
// cells are lost.
TEST(TermsView, ColoursTellTheValues) {
  for (const ColorPlan plan : {ColorPlan::OneHue, ColorPlan::Chosen})
    for (const TermValueRow& row : kTerms) {
      SCOPED_TRACE(std::string{row.name});
      const Picture picture = made("teapot", plan, Order::Newell, Shading::Phong);
      const TermValues found = termValuesOf(picture, row.id);
      const ColoredImage image = termImage(found, picture, CellPlan{}, picture.palette(CellPlan{}));
      const double step = 255.0 / (row.isCosine ? 119 : 239);
      int compared = 0, negative = 0;
      for (std::size_t k = std::size_t{240} * 40; k < found.values.size(); ++k) {  // below the legend
        const Rgb16 color = image.palette[image.image.pixels[k]];
        if (std::isnan(found.values[k])) {
          ASSERT_EQ(image.image.pixels[k], CellPlan{}[Cell::Well]);
        } else if (found.values[k] >= 0.0) {
          ASSERT_NEAR(color.r >> 8, 255.0 * found.values[k], step) << k;
          ASSERT_EQ(color.r, color.b);
        } else {
          ASSERT_EQ(color.r, 0) << k;
          ASSERT_GE(color.b >> 8, 79);
          ++negative;
        }
        compared += !std::isnan(found.values[k]);
      }
      EXPECT_GT(compared, 5'000);
      EXPECT_EQ(negative > 100, row.isCosine);
    }
}

// Every number has a view of its own, by the same name, and each row stands where its view's number says.
TEST(TermsView, AreViews) {
  for (const TermValueRow& row : kTerms) {
    const auto* const view = std::ranges::find(kViews, row.name, &ViewRow::name);
    ASSERT_NE(view, kViews.end());
    EXPECT_EQ(view->term, row.id);
  }
  for (std::size_t k = 0; k < kViews.size(); ++k) EXPECT_EQ(static_cast<std::size_t>(kViews[k].id), k);
}

}  // namespace xnewell::THIS_FILE
