#include <gtest/gtest.h>

#include "shading/laboratory/errors.h"
#include "shading/laboratory/exactness.h"
#include "tests/support/seeds.h"
#include "tests/x11/support/find_text.h"
#include "tests/x11/support/lesson_window.h"
#include "tests/x11/support/ready_workbench.h"
#include "x11/drawing/wording.h"
#include "x11/sides/sides_page.h"

namespace xnewell {

// Views draw pictures of several sizes, and a larger picture has more wrong samples. So whatever counts wrong
// samples names the size of its picture, and at this size the errors count the same.

namespace {

const CellPlan kPlan;

PictureSettings sorted() {
  PictureSettings settings;
  settings.order = Order::ZSort;
  return settings;
}

struct Count {
  std::int64_t wrong = 0, shown = 0, either = 0;  ///< samples: wrong; that show a face; also in the reference
  std::string size;
};

/// Counts in a picture of its own. The errors count wrong faces against the truth. The exact order has to
/// count the same: it differs at the wrong samples, and at those where two faces nearly touch.
Count countIn(const Scene& scene, PictureSettings settings) {
  const Picture picture = makePicture(scene, settings, kPlan[Cell::Well]);
  const Errors errors = errorsOf(picture, picture.palette(CellPlan{}));
  settings.order = Order::Oracle;
  const std::vector<std::uint32_t> ours = picture.faceImage(),
                                   exact = makePicture(scene, settings).faceImage();
  Count count;
  count.wrong = errors.wrongFaces, count.either = errors.samples;
  count.size = std::to_string(settings.width) + " x " + std::to_string(settings.height);
  std::int64_t others = 0;
  for (std::size_t k = 0; k < ours.size(); ++k) {
    count.shown += ours[k] != 0;
    others += ours[k] != exact[k];
  }
  EXPECT_EQ(others - exactnessOf(picture).doubtful, count.wrong);
  EXPECT_GT(count.wrong, 10);
  return count;
}

}  // namespace

TEST(CountedSize, IsNamedByViews) {
  const Scene scene = readScene("teapot", 3);
  PictureCache pictures{scene};
  for (const auto& [width, height] : someOf({std::pair{640, 560}, {800, 600}}, 1))
    for (const View view : {View::Exactness, View::Difference}) {
      SCOPED_TRACE(std::string{rowOf(view).name} + ' ' + std::to_string(width));
      ViewSettings s;
      s.view = view;
      s.picture = sorted();
      s.picture.camera = completed({}, scene.camera);
      s.picture.width = width, s.picture.height = height;
      const IndexImage image = drawView(pictures, s).image;
      const Count count = countIn(scene, pictures.last().settings());
      const bool exactness = view == View::Exactness;
      EXPECT_TRUE(hasRow(image, "samples that show a face",
                         grouped(exactness ? count.shown : count.either) + " of " + count.size,
                         kPlan[Cell::Ink], 1, Voice::Bold));
      EXPECT_TRUE(hasRow(image, exactness ? "wrong" : "wrong face", grouped(count.wrong), kPlan[Cell::Ink], 1,
                         Voice::Bold));
    }
}

TEST(CountedSize, IsNamedByTheWindow) {
  for (const int unit : someOf({2, 1, 3}, 1))
    for (const View view : {View::SideBySide, View::Picture}) {
      SCOPED_TRACE(std::to_string(unit) + (view == View::Picture ? " picture" : " side by side"));
      ReadyWorkbench b{xnewell::Setup{sorted()}, 1, 1};
      b.scale(unit);
      b.resize(unit * 800, unit * 540);  // the least window
      b.switchTo(view);
      b.finish();
      const Rect at = b.layout().frame;
      PictureSettings settings = b.setup().picture;
      settings.width = unit * at.width, settings.height = unit * at.height;
      const Count count = countIn(readScene("teapot", 3), settings);
      if (view == View::Picture)
        EXPECT_EQ(findText(b.image(),
                           "A wrong face at " + grouped(count.wrong) + " of " + grouped(count.shown) +
                               " samples of " + count.size + ".",
                           kPlan[Cell::Alarm], unit)
                      .size(),
                  1u);
      else
        EXPECT_TRUE(
            hasRow(b.image(), "wrong face, of " + count.size, grouped(count.wrong), kPlan[Cell::Ink], unit));
    }
}

TEST(CountedSize, IsNamedByLessons) {
  for (const glm::ivec2 size : {glm::ivec2{800, 540}, {1024, 768}}) {
    SCOPED_TRACE(size.x);
    LessonWindow window{size};
    begin(window, "sorting-by-z");
    window.press('a');  // an order that is wrong
    window.press(NamedKey::Return);
    const IndexImage& image = window.draw();
    const Picture& picture = window.pictures->last();
    const Count count = countIn(picture.scene(), picture.settings());
    EXPECT_EQ(findText(image,
                       grouped(count.wrong) + " of " + grouped(count.shown) + " samples of " + count.size +
                           " show a wrong face",
                       CellPlan{picture.settings().table.kind}[Cell::WellText])
                  .size(),
              1u);
  }
}

}  // namespace xnewell
