#include "x11/views/views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "geometry/model/solids.h"
#include "shading/laboratory/profile.h"
#include "shading/picture/picture_cache.h"
#include "tests/support/seeds.h"
#include "x11/drawing/rect.h"
#include "x11/views/normals_view.h"

namespace xnewell::THIS_FILE {

namespace {

constexpr std::array kDrawn{View::MachBands, View::Normals,  View::Difference,
                            View::Exactness, View::Overdraw, View::Wireframe};

ViewSettings settingsOf(View view, const Scene& scene, int width, int height) {
  ViewSettings s;
  s.view = view;
  s.picture.width = width;
  s.picture.height = height;
  s.picture.camera = completed({}, scene.camera);
  return s;
}

ColoredImage drawn(PictureCache& pictures, View view, int width, int height,
                   Shading shading = Shading::Gouraud) {
  ViewSettings s = settingsOf(view, pictures.scene(), width, height);
  s.picture.shading = shading;
  return drawView(pictures, s);
}

/// True if all pixels of the area are paper.
bool isPaper(const IndexImage& image, const Rect& area) {
  for (int j = area.y; j < area.y + area.height; ++j)
    for (int i = area.x; i < area.x + area.width; ++i)
      if (image.row(j)[i] != CellPlan{}[Cell::Paper]) return false;
  return true;
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
        ASSERT_EQ(image.width, width);
        ASSERT_EQ(image.height, height);
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
  PictureCache pictures{readScene("teapot", 3)};
  std::vector<IndexImage> first;
  for (const View view : kDrawn) {
    PictureCache fresh{readScene("teapot", 3)};
    first.push_back(drawn(fresh, view, 800, 600).image);
  }
  EXPECT_NE(first[0], first[2]);
  for (int round = 0; round < 2; ++round)
    for (std::size_t k = 0; k < kDrawn.size(); ++k)
      EXPECT_EQ(drawn(pictures, kDrawn[k], 800, 600).image, first[k]);
}

// A scanline must lie in the picture that the view shows. If it does not, the message says where the picture
// ends.
TEST(Views, RefuseAScanlineBelowThePicture) {
  PictureCache pictures{readScene("teapot", 3)};
  ViewSettings s = settingsOf(View::MachBands, pictures.scene(), 800, 600);
  s.scanline = 260;
  EXPECT_NO_THROW(static_cast<void>(drawView(pictures, s)));
  EXPECT_EQ(pictures.last().settings().height, 261);
  s.scanline = 261;
  try {
    static_cast<void>(drawView(pictures, s));
    FAIL();
  } catch (const std::invalid_argument& e) {
    EXPECT_EQ(std::string{e.what()},
              "--scanline: 261 is below the picture: in this view its rows are 0 to 260");
  }
}

// The profiles stand exactly below their pixels: the cells of the marked scanline are the strip of the chosen
// method, column by column.
TEST(Views, StripsRepeatTheMarkedScanline) {
  PictureCache pictures{readScene("teapot", 3)};
  ViewSettings s = settingsOf(View::MachBands, pictures.scene(), 800, 600);
  s.picture.shading = Shading::Gouraud;
  s.scanline = 100;
  const IndexImage view = drawView(pictures, s).image;
  const IndexImage image = pictures.last().paint(CellPlan{}[Cell::Well]).image;
  int rows = 0;
  for (int j = 0; j < view.height; ++j) rows += std::equal(image.row(100), image.row(101), view.row(j) + 100);
  EXPECT_GE(rows, 12);  // the strip; in the pictures.last() the line is drawn over it
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

}  // namespace xnewell::THIS_FILE
