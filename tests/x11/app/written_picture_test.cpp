#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "shading/color/png.h"
#include "shading/figure/write_figure.h"
#include "tests/support/temporary_folder.h"
#include "tests/x11/support/parsed_options.h"
#include "tests/x11/support/ready_workbench.h"
#include "tests/x11/support/watched_viewer.h"
#include "x11/options/shell_words.h"
#include "x11/sides/sides_page.h"

namespace xnewell::THIS_FILE {

namespace {

/// The working directory, for as long as this lives. The program starts in it.
class WorkingIn {
 public:
  explicit WorkingIn(const std::filesystem::path& folder) { std::filesystem::current_path(folder); }
  WorkingIn(const WorkingIn&) = delete;
  WorkingIn& operator=(const WorkingIn&) = delete;
  ~WorkingIn() { std::filesystem::current_path(before_); }

 private:
  std::filesystem::path before_ = std::filesystem::current_path();
};

}  // namespace

// I writes what the window shows, under a new name each time. The file carries the set-up: it opens as the
// same window.
TEST(WrittenPicture, IsTheWindowAndItsSource) {
  const TemporaryFolder folder;
  const WorkingIn here{folder.path()};
  const XServer server = XServer::xvfb(24, 1280, 1024);
  const std::string taken = folder.write("cubes-colours-2.png", "mine");
  const Rect whole = aboveStatus(1024, 768);
  RgbImage shown;
  {
    WatchedViewer viewer{server, "cubes --divisions 4 --size 1024x768"};
    viewer.window.type("ST3");
    ASSERT_TRUE(viewer.window.settles());
    shown = viewer.window.shown(whole);
    viewer.window.type("I");
    ASSERT_TRUE(comesTrue([&] { return std::filesystem::exists(folder.file("cubes-colours.png")); }));
    viewer.window.type("I");
    ASSERT_TRUE(comesTrue([&] { return std::filesystem::exists(folder.file("cubes-colours-3.png")); }));
    EXPECT_EQ(folder.entries(), 3);
    viewer.window.type("1");
    ASSERT_TRUE(viewer.window.settles());
    viewer.window.type("I");  // view 1 has a figure, too
    ASSERT_TRUE(comesTrue([&] { return std::filesystem::exists(folder.file("cubes-picture.svg")); }));
  }
  EXPECT_EQ(std::filesystem::file_size(taken), 4u);
  EXPECT_EQ(folder.entries(), 5);
  EXPECT_NE(noteInFigure(folder.file("cubes-picture.svg")).value_or("").find("xnewell draw cubes"),
            std::string::npos);
  for (const std::string file : {"cubes-colours.png", "cubes-colours-3.png"}) {
    const RgbImage all = readPng(folder.file(file));
    EXPECT_EQ(all.width, 1024);
    EXPECT_EQ(all.height, 768);
    EXPECT_EQ(cropped(all, whole), shown) << file;
    EXPECT_NE(noteInPng(folder.file(file)).value_or("").find(" --whole-window --view colours "),
              std::string::npos);
  }
  const WatchedViewer again{server, folder.file("cubes-colours.png")};
  EXPECT_TRUE(again.window.comesToShow(shown, whole));
}

// The name is that of the scene and the view, without spaces; no option tells a lesson's step.
TEST(WrittenPicture, IsNamedAfterSceneAndView) {
  const TemporaryFolder folder;
  const std::string file = folder.write("my own.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  ReadyWorkbench b{{}, 1024, 768, file};
  EXPECT_EQ(b.pictureName(), "my-own-picture");
  b.type("W");
  b.update();
  EXPECT_EQ(b.pictureName(), "my-own-wireframe");
  const std::string begin =
      "xnewell snapshot '" + file + "' --size 1024x768 --whole-window --view wireframe ";
  EXPECT_TRUE(b.pictureNote().starts_with(begin)) << b.pictureNote();
  b.scale(2);
  b.resize(2048, 1536);
  b.type("2");
  EXPECT_EQ(b.pictureName(), "my-own-depthsort");
  EXPECT_NE(b.pictureNote().find(" --size 2048x1536 --whole-window --view depthsort --scale 2 "),
            std::string::npos);
  b.finish();
  b.press(NamedKey::Right);
  b.press(NamedKey::Right);
  b.type("D");
  b.finish();
  EXPECT_NE(b.pictureNote().find(" --view depthsort --scale 2 --step 2 --controls none "), std::string::npos)
      << b.pictureNote();
  b.type("3");
  b.finish();
  b.press(NamedKey::Right);
  b.finish();
  EXPECT_NE(b.pictureNote().find(" --cell " + std::to_string(b.bench().inspected().value()) + ' '),
            std::string::npos)
      << b.pictureNote();
  b.type("4");
  b.finish();
  const std::string before = b.pictureNote();
  b.press(NamedKey::Up);
  b.finish();
  EXPECT_NE(b.pictureNote().find(" --view machbands --scale 2 --scanline "), std::string::npos);
  EXPECT_NE(b.pictureNote(), before);
  b.type("8");
  b.finish();
  b.press(NamedKey::Right);
  b.finish();
  const glm::ivec2 middle{b.picture().settings().width / 2, b.picture().settings().height / 2};
  EXPECT_NE(
      b.pictureNote().find(" --pixel " + std::to_string(middle.x + 1) + ',' + std::to_string(middle.y) + ' '),
      std::string::npos)
      << b.pictureNote();
  b.type("7");
  b.finish();
  EXPECT_EQ(b.pictureNote(), "");  // the list of lessons
  b.press(NamedKey::Return);
  b.press(NamedKey::PageDown);
  b.finish();
  ASSERT_NE(b.lessons().lesson(), nullptr);
  EXPECT_EQ(b.pictureNote(), "xnewell lesson " + b.lessons().lesson()->name +
                                 " --size 2048x1536 --scale 2 --step " +
                                 std::to_string(b.lessons().step() + 1));
  EXPECT_EQ(b.lessons().step(), 1);
}

// A picture of view 5 has both set-ups and what was compared: a window that begins with its command shows the
// same A and B, whichever keys made them.
TEST(WrittenPicture, HasBothSetupsOfView5) {
  for (const std::string keys : {"5", "5f", "5g", "5ggf", "5gggxS", "5ASBOOff", "5AkT"}) {
    SCOPED_TRACE(keys);
    ReadyWorkbench b{{}, 1024, 768, "cubes"};
    b.type(keys);
    b.finish();
    const std::string note = b.pictureNote();
    std::vector<std::string> said = wordsOf(note).value();
    said.erase(said.begin());  // the program's name
    const Options options = parsed(said, readScene("cubes", 3).settings);
    ASSERT_EQ(options.window.view, View::SideBySide);
    ReadyWorkbench again{{.picture = options.picture, .fill = options.fill}, 1024, 768, "cubes"};
    again.goTo(options.window);
    again.finish();
    EXPECT_EQ(again.pictureNote(), note);
    const SidesLayout at = layoutOfSides(b.layout().body);
    for (const Rect& part : {at.A, at.B, at.difference})  // the times beside them differ
      for (int y = part.y; y < part.y + part.height; ++y)
        ASSERT_TRUE(std::equal(b.image().row(y) + part.x, b.image().row(y) + part.x + part.width,
                               again.image().row(y) + part.x))
            << "row " << y;
  }
}

// A window that begins elsewhere opens view 5 with an order beside the one that it has by then.
TEST(WrittenPicture, View5BeginsWithAnOrderBesideThatOfTheWindow) {
  for (int presses = 0; presses < 9; ++presses) {
    ReadyWorkbench b{{}, 1024, 768, "cubes"};
    b.goTo({});
    b.type(std::string(presses, 'O') + "5");
    b.finish();
    EXPECT_NE(b.pictureNote().find(" --beside order="), std::string::npos) << b.pictureNote();
  }
}

}  // namespace xnewell::THIS_FILE
