#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <random>

#include "geometry/files/text_file.h"
#include "shading/color/png.h"
#include "shading/figure/write_figure.h"
#include "tests/support/seeds.h"
#include "tests/support/temporary_folder.h"
#include "tests/x11/support/parsed_options.h"
#include "tests/x11/support/ready_workbench.h"
#include "tests/x11/support/watched_viewer.h"
#include "x11/app/workbench.h"
#include "x11/options/shell_words.h"
#include "x11/sides/sides_page.h"

namespace xnewell::THIS_FILE {

namespace {

using Stale = Workbench::Stale;

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

// Every key of a setting changes what is seen. Undo takes it back exactly, redo brings it again, and reset
// returns to the start.
TEST(Workbench, EveryKeyDoesSomethingAndIsUndone) {
  // With few shades of the corrected table, even a change of the rule that picks a shade can be seen.
  xnewell::Setup setup;
  setup.picture.table.kind = TableKind::Corrected, setup.picture.table.shades = 24;
  ReadyWorkbench b{setup};
  const auto seen = [&] {
    b.finish();
    return std::pair{b.aboveStatus(), b.palette()};
  };
  const auto start = seen();
  const auto isUndone = [&](const Key& key, const auto& before) {
    SCOPED_TRACE(nameOf(key));
    b.press(key);
    const auto after = seen();
    EXPECT_NE(after, before);
    b.does('u');
    EXPECT_EQ(seen(), before);
    b.does('U');
    EXPECT_EQ(seen(), after);
    b.does('r');
    EXPECT_EQ(seen(), before);
  };
  for (const char key : std::string{"[]LVSOFPKTHBJ+-"}) isUndone(key, start);
  for (const char focus : std::string{"ipadncoltz"}) {
    SCOPED_TRACE(focus);
    b.does(focus);
    const auto focused = seen();
    EXPECT_NE(focused, start);
    isUndone(NamedKey::Left, focused);
    isUndone({NamedKey::Up, 0, true}, focused);
    if (focus == 'l' || focus == 't' || focus == 'z') continue;
    isUndone(NamedKey::Home, focused);
    isUndone(NamedKey::End, focused);
  }
  b.does('s');
  EXPECT_EQ(seen(), start);
  b.does(NamedKey::Tab);
  EXPECT_NE(seen(), start);
  b.does({NamedKey::Tab, 0, true});
  EXPECT_EQ(seen(), start);
}

// Drags add up: ten drags of 3 pixels turn the scene like one of 30, whether or not a frame is drawn between
// them.
TEST(Workbench, DragsAddUp) {
  ReadyWorkbench one, many;
  one.drag(30, 0);
  const Rect& at = many.layout().picture;
  ASSERT_TRUE(many.grab(at.x, at.y));
  for (int i = 1; i <= 10; ++i) {
    many.dragTo(at.x + 3 * i, at.y);
    if (i % 3 == 0) many.update();
  }
  const glm::dvec3 a = *one.setup().picture.camera.eye, b = *many.setup().picture.camera.eye;
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], 1e-12);
}

// At sizes from 1 x 1 up, every pixel is drawn. Where there is no room for the controls, the picture fills
// the window.
TEST(Workbench, EverySizeDraws) {
  const std::vector<glm::ivec2> sizes{{1, 1},     {7, 900},    {800, 599},  {799, 600},   {800, 540},
                                      {800, 539}, {1023, 767}, {1024, 768}, {1600, 1200}, {2500, 700}};
  for (const glm::ivec2 size : sizes) {
    const int w = size.x, h = size.y;
    SCOPED_TRACE(testing::Message() << w << " x " << h);
    ReadyWorkbench b{{}, w, h};
    EXPECT_EQ(b.image().width, w);
    EXPECT_EQ(b.image().height, h);
    EXPECT_EQ(b.layout().roomy, w >= 800 && h >= 540);
    const Rect& at = b.layout().picture;
    EXPECT_EQ(intersection(at, {0, 0, w, h}), at);
    const Rect& status = b.layout().status;  // its words end before the margin
    for (int y = status.y + 1; y < status.y + status.height; ++y)
      EXPECT_EQ(std::ranges::count(b.image().row(y) + w - kMargin, b.image().row(y) + w, *b.image().row(y)),
                kMargin);
    b.type("?");
    b.update();
  }
}

// The frame after any keys is the frame of a fresh start with the same setup: nothing is left over from
// before.
TEST(Workbench, NothingLingers) {
  std::mt19937 rng{7};
  constexpr std::string_view kLetters = "ipadsnc0lLVSOFPKTHBJ[]uUr+-=?tz133hmgj";
  ReadyWorkbench b;
  for (int trial = 0; trial < 40; ++trial) {
    SCOPED_TRACE(trial);
    for (int k = 0; k < 6; ++k) {
      if (rng() % 3)
        b.press({NamedKey::Letter, kLetters[rng() % kLetters.size()]});
      else
        b.press({std::array{NamedKey::Left, NamedKey::Right, NamedKey::Up, NamedKey::Down, NamedKey::Home,
                            NamedKey::End, NamedKey::Tab}[rng() % 7],
                 0, rng() % 2 == 0});
      if (rng() % 2) b.update();
    }
    b.press(NamedKey::Escape);
    b.type("1");
    b.update();
    if (b.bench().list().find({0, 100})) b.press('h');  // the opening page stays until it is put away
    b.type("s");
    b.update();
    ReadyWorkbench fresh{b.setup()};
    fresh.type("s");
    fresh.update();
    EXPECT_EQ(b.palette(), fresh.palette());
    // The marks of the sliders' defaults differ, so only the part left of the controls is compared.
    const Rect left{0, 0, b.layout().controls.x - 8, b.layout().status.y};
    ASSERT_EQ(b.part(left), fresh.part(left));
  }
}

// The camera keys never lead to a view that cannot be drawn. The test takes a thousand steps in each
// direction.
TEST(Workbench, TheCameraSurvivesAnyKeys) {
  ReadyWorkbench b{{}, 300, 200};
  for (const char mode : {'t', 'z'}) {
    b.type({&mode, 1});
    for (const NamedKey key : {NamedKey::Up, NamedKey::Left, NamedKey::Down, NamedKey::Right}) {
      for (int i = 0; i < 300; ++i) b.press({key, 0, true});
      EXPECT_NO_THROW(b.update());
      b.press('P');
      EXPECT_NO_THROW(b.update());
    }
  }
}

// As soon as the shading interpolates, the server no longer fills, in any view and whichever way the shading
// was chosen.
TEST(Workbench, NoViewLeavesTheServerWhatItCannotFill) {
  for (const std::string_view keys : someOf({"S", "5AS", "5Agg", "5Sx", "5ASux", "5BSx1"}, 2)) {
    SCOPED_TRACE(keys);
    ReadyWorkbench b;
    b.type("FF");
    EXPECT_EQ(b.setup().fill, Fill::Scanline);
    b.type("F");
    b.update();
    ASSERT_TRUE(b.serverFills());
    for (const char key : keys) {
      b.does(key);
    }
    b.does("1");
    EXPECT_EQ(b.serverFills(), !rowOf(b.setup().picture.shading).interpolates);
    if (b.serverFills()) {
      EXPECT_EQ(b.picture().cells().size(), b.picture().snapped().faces.size());
    }
  }
}

// Wrong faces are not counted while the picture is dragged, and are counted afterwards.
TEST(Workbench, CountsWrongFacesWhenSettled) {
  ReadyWorkbench b;
  const IndexImage counted = b.image();
  b.drag(3, 3);
  b.settle();
  b.update();
  b.type("u");
  b.update();
  EXPECT_EQ(b.stale(), Stale::Nothing);  // nothing was left out
  b.drag(3, 3);
  b.update(true);
  b.settle();
  EXPECT_EQ(b.stale(), Stale::Everything);
  b.update();
  EXPECT_EQ(b.stale(), Stale::Nothing);
  b.type("u");
  b.update();
  EXPECT_TRUE(std::equal(counted.row(600), counted.row(663), b.image().row(600)));
}

// C gives what the view says, as comments of a shell, and the command of its set-up: of the picture, or of
// the window with another view. No command opens a lesson at a step, so there it is the picture's.
TEST(Workbench, AnyViewsSetupIsACommand) {
  std::string copied;
  Workbench b{readScene("teapot", 3), {}, {.copy = [&](const std::string& text) { copied += text; }}};
  b.resize(1024, 768);
  for (const ViewRow& row : kWindowViews) {
    SCOPED_TRACE(row.name);
    b.switchTo(row.id);
    b.update();
    b.change('S', [&](xnewell::Setup& s) { s.picture.shading = Shading::Phong; });
    copied.clear();
    b.press('C');
    const bool picture = row.id == View::Picture || row.id == View::Lesson;
    const std::size_t last = copied.rfind('\n') + 1;
    EXPECT_TRUE(copied.substr(last).starts_with(
        picture
            ? "xnewell draw teapot --size "
            : "xnewell snapshot teapot --size 1024x768 --whole-window --view " + std::string{row.name} + ' '))
        << copied;
    EXPECT_NE(copied.find(" --divisions 3 --shade phong -o picture.png", last), std::string::npos) << copied;
    EXPECT_GT(last, 0u);
    for (std::size_t at = 0; at < last; at = copied.find('\n', at) + 1)
      ASSERT_EQ(copied.substr(at, 2), "# ") << copied;
  }
}

// A set-up that was changed, saved and opened again gives the same window. An existing file is replaced only
// if that is confirmed, and never a scene of its own objects, which would be lost.
TEST(SavedSetup, OpensAsTheSameWindow) {
  const TemporaryFolder folder;
  const std::string file = folder.file("mine.json");
  ReadyWorkbench b;
  const auto takes = [&](char key, const std::string& name) {
    b.press(key);
    b.type(name);
    b.does(NamedKey::Return);
    return !b.complains();
  };
  b.type("STO]");
  b.drag(40, 10);
  b.settle();
  EXPECT_TRUE(takes('w', file));
  ASSERT_TRUE(std::filesystem::exists(file));
  const xnewell::Setup saved = b.setup();
  const IndexImage picture = b.part(b.layout().picture);
  b.type("SSrNKs");
  b.type("q");
  EXPECT_FALSE(b.quitAsked());  // the change has not been saved
  b.type("sq");
  EXPECT_FALSE(b.quitAsked());   // another key came between
  EXPECT_FALSE(takes('e', ""));  // the file that it knows
  EXPECT_EQ(b.view(), View::Picture);
  EXPECT_NE(b.setup(), saved);
  b.does(NamedKey::Return);
  EXPECT_EQ(b.setup(), saved);
  EXPECT_EQ(b.part(b.layout().picture), picture);
  b.type("q");
  EXPECT_TRUE(b.quitAsked());

  const std::string other = folder.write("other.json", "mine"), own = R"({"objects": [{"solid": "cube"}]})",
                    scene = folder.write("scene.json", own);
  EXPECT_FALSE(takes('w', other));
  EXPECT_EQ(std::filesystem::file_size(other), 4u);
  b.does(NamedKey::Return);
  EXPECT_FALSE(b.isAsking());
  EXPECT_GT(std::filesystem::file_size(other), 100u);
  EXPECT_TRUE(takes('e', scene));
  EXPECT_EQ(b.picture().scene().name, scene);
  EXPECT_FALSE(takes('w', scene));
  b.does(NamedKey::Return);
  EXPECT_TRUE(b.complains());
  EXPECT_EQ(readTextFile(scene), own);
  b.press(NamedKey::Escape);

  // Up and down offer the built-in scenes.
  const std::vector<BuiltInScene>& all = builtInScenes();
  b.press('e');
  for (const NamedKey key : {NamedKey::Down, NamedKey::Down, NamedKey::Up, NamedKey::Return}) b.does(key);
  EXPECT_EQ(b.picture().scene().name, all.front().name);
  b.press('e');
  for (const NamedKey key : {NamedKey::Up, NamedKey::Return}) b.does(key);
  EXPECT_EQ(b.picture().scene().name, all.back().name);
}

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

// The name is that of the scene and the view, without spaces. No option tells a lesson's step in a picture,
// so there it is a lesson's command.
TEST(WrittenPicture, IsNamedAfterSceneAndView) {
  const TemporaryFolder folder;
  ReadyWorkbench b{{}, 1024, 768, folder.write("my own.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")};
  for (const auto& [key, view] :
       {std::pair{'1', "picture"}, {'W', "wireframe"}, {'2', "depthsort"}, {'3', "colours"}}) {
    b.does(key);
    EXPECT_EQ(b.pictureName(), std::string{"my-own-"} + view);
  }
  b.does('7');
  EXPECT_EQ(b.pictureNote(), "");  // the list of lessons
  b.press(NamedKey::Return);
  b.does(NamedKey::PageDown);
  EXPECT_EQ(b.pictureNote(), "xnewell lesson " + b.lessons().lesson()->name + " --size 1024x768 --step 2");
}

// A picture of view 5 has both set-ups and what was compared: a window that begins with its command shows the
// same A and B, whichever keys made them.
TEST(WrittenPicture, HasBothSetupsOfView5) {
  for (const std::string keys : {"5", "5f", "5g", "5ggf", "5gggxS", "5ASBOOff", "5AkT"}) {
    SCOPED_TRACE(keys);
    ReadyWorkbench b{{}, 1024, 768, "cubes"};
    b.does(keys);
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
      EXPECT_EQ(b.part(part), again.part(part));
  }
}

}  // namespace xnewell::THIS_FILE
