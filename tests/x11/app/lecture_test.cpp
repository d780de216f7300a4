#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "tests/x11/support/command_fixture.h"
#include "tests/x11/support/find_text.h"
#include "tests/x11/support/ready_workbench.h"
#include "x11/command/read_lecture.h"
#include "x11/lessons/lesson_view.h"
#include "x11/scanline/scanline_view.h"
#include "x11/stepper/sort_view.h"
#include "x11/viewing/viewing_view.h"

namespace xnewell::THIS_FILE {

namespace {

class LectureTest : public CommandTest {
 protected:
  std::string lecture(const std::string& pages) const {
    return write("lecture.json", "{\"pages\": [" + pages + "]}");
  }
};

/// A workbench that shows a lecture, and what it tells the teacher.
struct Shown : ReadyWorkbench {
  explicit Shown(const std::string& file, double seconds = 0) {
    lecture({readLecture(file), seconds});
    finish();
  }
  /// The view without the bar above it, which names the page.
  [[nodiscard]] IndexImage body() const { return bodyOf(*this); }
  static IndexImage bodyOf(const ReadyWorkbench& b) {
    return b.part({0, 40, b.image().width, b.layout().status.y - 40});
  }
};

const std::string kThree =
    R"({"title": "Flat", "show": "teapot --divisions 3 --shade flat --ks 0.7"},
       {"title": "Cells", "show": "xnewell snapshot teapot --divisions 3 --size 1024x768 --whole-window --shade phong --view colours -o a.png"},
       {"title": "Cycle", "show": "cycle --view depthsort --step 12"})";

}  // namespace

// PgDn and PgUp turn the pages, in every view. A page shows what a window with its scene and set-up alone
// shows. Coming back, it is as it was at first, whatever was changed.
TEST_F(LectureTest, PagesTurn) {
  Shown shown{lecture(kThree)};
  xnewell::Setup flat;
  flat.picture.shading = Shading::Flat, flat.picture.light.ks = 0.7;
  const IndexImage first = shown.body();
  EXPECT_EQ(first, Shown::bodyOf(ReadyWorkbench{flat}));
  shown.does("SJ");
  EXPECT_NE(shown.body(), first);
  shown.does(NamedKey::PageDown);
  EXPECT_EQ(shown.view(), View::Colors);
  EXPECT_EQ(shown.setup().picture.shading, Shading::Phong);
  shown.does(NamedKey::PageDown);
  EXPECT_EQ(shown.view(), View::DepthSort);
  EXPECT_EQ(shown.stepper().view().step, 12);
  const IndexImage third = shown.body();
  shown.does(NamedKey::PageDown);  // there is none
  EXPECT_EQ(shown.view(), View::DepthSort);
  EXPECT_EQ(shown.body(), third);
  shown.does(NamedKey::PageUp);
  shown.does(NamedKey::PageUp);
  EXPECT_EQ(shown.body(), first);
  shown.does(NamedKey::PageUp);
  EXPECT_EQ(shown.body(), first);
}

// A page opens view 9 at a stage with a vertex, and view 0 at a polygon and a step, again and again.
TEST_F(LectureTest, PagesOpenTheViewingAndTheScanline) {
  Shown shown{lecture(
      R"({"title": "Shear", "show": "teapot --divisions 3 --view viewing --step 3 --viewing 12.2 --prp=-4,1,12"},
         {"title": "Rows", "show": "teapot --divisions 3 --view scanline --scanline 40 --step 9"})")};
  for (int times = 0; times < 2; ++times) {
    ASSERT_EQ(shown.view(), View::Viewing);
    const auto& viewing = dynamic_cast<const ViewingView&>(shown.bench());
    EXPECT_EQ(viewing.stage(), 3);
    EXPECT_EQ(viewing.vertex(), "12.2");
    EXPECT_EQ(shown.setup().picture.camera.prp, (glm::dvec3{-4, 1, 12}));
    shown.does(NamedKey::Right);
    shown.does(NamedKey::PageDown);
    ASSERT_EQ(shown.view(), View::Scanline);
    const auto& rows = dynamic_cast<const ScanlineView&>(shown.bench());
    EXPECT_EQ(rows.polygon(), "40");
    EXPECT_EQ(rows.view().step, 9);
    EXPECT_FALSE(shown.complains());
    shown.does(NamedKey::Right);
    shown.does(NamedKey::PageUp);
  }
}

// The last line names the page keys first. A warning ends with its page. 7 on a page without a lesson opens
// the list, also after another page had a lesson.
TEST_F(LectureTest, EachPageBeginsAnew) {
  Shown shown{lecture(
      R"({"title": "Cards", "lesson": "five-tests"}, {"title": "Cycle", "show": "cycle --view depthsort"},
                 {"title": "Teapot", "show": "teapot"})")};
  const int steps = static_cast<int>(shown.lessons().lesson()->steps.size());
  for (int step = 0; step < steps; ++step) shown.does(NamedKey::PageDown);
  ASSERT_EQ(shown.view(), View::DepthSort);
  EXPECT_EQ(legendOf(shown.keys()).front().does, "page");
  shown.does(NamedKey::Left);  // the run is at its start
  EXPECT_TRUE(shown.complains());
  shown.does(NamedKey::PageDown);
  EXPECT_FALSE(shown.complains());
  shown.does('7');
  EXPECT_TRUE(shown.lessons().showsList());
}

// Inside a lesson the steps come first; after its last step comes the next page. The page after it has its
// own scene again.
TEST_F(LectureTest, StepsOfALessonComeFirst) {
  Shown shown{
      lecture(R"({"title": "Cards", "lesson": "five-tests"}, {"title": "Teapot", "show": "teapot"})")};
  const auto& lesson = dynamic_cast<const LessonView&>(shown.bench());
  const int steps = static_cast<int>(lesson.lesson()->steps.size());
  for (int step = 0; step < steps; ++step) {
    EXPECT_EQ(shown.view(), View::Lesson);
    EXPECT_EQ(lesson.step(), step);
    shown.does(NamedKey::PageDown);
  }
  EXPECT_EQ(shown.view(), View::Picture);
  EXPECT_EQ(shown.scene().name, "teapot");
  shown.does(NamedKey::PageUp);
  EXPECT_EQ(lesson.step(), 0);
  shown.does('2');  // to the stepper, with the lesson's scene
  shown.does(NamedKey::PageDown);
  EXPECT_EQ(shown.scene().name, "teapot");
  EXPECT_EQ(shown.view(), View::Picture);
}

// With --play the pages turn by themselves, and after the last comes the first. A key makes the page wait.
TEST_F(LectureTest, PlaysByItself) {
  using namespace std::chrono_literals;
  const std::string file = lecture(kThree);
  const Shown still{file};
  EXPECT_FALSE(still.moving());
  Shown shown{file, 0.3};
  EXPECT_TRUE(shown.moving());
  std::string views;
  for (int k = 0; k < 3; ++k) {
    shown.tick();
    views += std::to_string(static_cast<int>(shown.view()));
    std::this_thread::sleep_for(310ms);
    if (k == 1) shown.press('?');  // somebody is there
    if (k == 1) shown.press('?');
    shown.tick();
    views += std::to_string(static_cast<int>(shown.view())) + ' ';
    shown.finish();
  }
  EXPECT_EQ(views, "02 22 21 ");
  std::this_thread::sleep_for(310ms);
  shown.tick();
  EXPECT_EQ(shown.view(), View::Picture);
}

// A page keeps the controls that it names in the drawer, and only these. They work there as elsewhere, and so
// do the keys of all others. The word none puts all away, and a page that names none leaves the drawer shut
// or opens it whole.
TEST_F(LectureTest, PagesNameControls) {
  Shown shown{lecture(
      R"({"title": "A", "show": "teapot --controls Ssn"}, {"title": "B", "show": "teapot --controls none"},
         {"title": "C", "show": "teapot"}, {"title": "D", "show": "cycle --view depthsort --controls none"})")};
  const auto keys = [&] {
    std::string all;
    for (const auto& [id, place] : shown.bench().list().places())
      if (!place.bare) all += id.key;
    return all;
  };
  EXPECT_EQ(keys(), "Ssn");
  EXPECT_EQ(shown.layout().drawer, Drawer::Few);
  const int beside = shown.layout().picture.width;
  const Rect n = shown.bench().list().find({'n'})->track;
  EXPECT_FALSE(shown.grab(n.x + n.width / 2, n.y + 200));
  shown.click(n.x + n.width / 2, n.y);
  EXPECT_NE(shown.setup().picture.light.n, xnewell::Setup{}.picture.light.n);
  const double ka = shown.setup().picture.light.ka;
  shown.type("a");
  shown.press(NamedKey::Left);
  EXPECT_LT(shown.setup().picture.light.ka, ka);
  shown.does('D');
  EXPECT_EQ(keys(), "");
  EXPECT_GT(shown.layout().picture.width, beside);
  EXPECT_TRUE(intersection(shown.layout().picture, shown.layout().finding).empty());
  shown.does('D');
  EXPECT_EQ(keys(), "Ssn");
  shown.does(NamedKey::PageDown);
  EXPECT_EQ(shown.layout().drawer, Drawer::Shut);
  EXPECT_EQ(keys(), "");
  shown.does(NamedKey::PageDown);
  EXPECT_EQ(shown.layout().drawer, Drawer::Whole);
  shown.does(NamedKey::PageDown);
  EXPECT_EQ(shown.layout().drawer, Drawer::Shut);
}

// The lecture that comes with the program can be read, and it is a lecture of several views.
TEST_F(LectureTest, TheFirstHour) {
  const std::vector<Page> pages = readLecture("first-hour");
  EXPECT_GE(pages.size(), 5u);
  EXPECT_TRUE(pages.back().lesson);
}

// A long title of a page is whole, also in views beside whose names it has no room.
TEST_F(LectureTest, TitlesAreWhole) {
  const std::string title = "Why does the sort cut this polygon, and not another one?";
  Shown b{lecture("{\"title\": \"" + title + "\", \"show\": \"cycle --view depthsort\"}")};
  EXPECT_FALSE(findText(b.image(), title, b.plan()[Cell::Soft]).empty());
}

}  // namespace xnewell::THIS_FILE
