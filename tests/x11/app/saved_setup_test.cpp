#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/support/temporary_folder.h"
#include "tests/x11/support/ready_workbench.h"

namespace xnewell::THIS_FILE {

// A set-up that was changed, saved and opened again gives the same window. An existing file is replaced only
// if that is confirmed. If a file cannot be read or written, one line says so.
TEST(SavedSetup, OpensAsTheSameWindow) {
  const TemporaryFolder folder;
  const std::string file = folder.file("mine.json");
  ReadyWorkbench b;
  b.type("STO]");
  b.drag(40, 10);
  b.settle();
  b.type("w");
  for (int k = 0; k < 60; ++k) b.press({NamedKey::Backspace});
  b.type(file);
  b.press({NamedKey::Return});
  ASSERT_TRUE(std::filesystem::exists(file));
  b.update();
  const xnewell::Setup saved = b.setup();
  const Rect at = b.layout().picture;
  const auto pictureOf = [&] {
    std::vector<std::uint8_t> pixels;
    for (int j = at.y; j < at.y + at.height; ++j)
      pixels.insert(pixels.end(), b.image().row(j) + at.x, b.image().row(j) + at.x + at.width);
    return pixels;
  };
  const std::vector<std::uint8_t> picture = pictureOf();
  b.type("SSrNKs");
  b.type("q");
  EXPECT_FALSE(b.quitAsked());  // the change has not been saved
  b.type("sq");
  EXPECT_FALSE(b.quitAsked());  // another key came between
  b.type("e");
  EXPECT_EQ(b.view(), View::Picture);
  b.press({NamedKey::Return});  // the file that it knows
  b.update();
  EXPECT_TRUE(b.complains());
  EXPECT_NE(b.setup(), saved);
  b.press({NamedKey::Return});
  b.update();
  EXPECT_EQ(b.setup(), saved);
  EXPECT_EQ(pictureOf(), picture);
  b.type("q");
  EXPECT_TRUE(b.quitAsked());

  b.type("w");
  b.press({NamedKey::Return});  // the same file
  b.update();
  EXPECT_TRUE(b.complains());
  EXPECT_TRUE(b.isAsking());
  b.press({NamedKey::Return});
  EXPECT_FALSE(b.isAsking());

  const std::string other = folder.write("other.json", "mine");
  b.type("w");
  b.type(other);
  b.press({NamedKey::Return});
  b.update();
  EXPECT_TRUE(b.complains());
  EXPECT_EQ(std::filesystem::file_size(other), 4u);
  b.press({NamedKey::Return});
  EXPECT_GT(std::filesystem::file_size(other), 100u);
  for (const std::string& bad :
       {folder.file("none.json"), folder.write("bad.json", "{"), folder.file("x/y.obj")}) {
    b.type("e");
    b.type(bad);
    b.press({NamedKey::Return});
    b.update();
    EXPECT_TRUE(b.complains()) << bad;
    EXPECT_EQ(b.setup(), saved);
    b.press({NamedKey::Escape});
  }

  // A scene of its own objects is no set-up. It would be lost.
  const std::string own = R"({"objects": [{"solid": "cube"}]})", scene = folder.write("scene.json", own);
  b.type("e");
  b.type(scene);
  b.press({NamedKey::Return});
  b.update();
  EXPECT_EQ(b.picture().scene().name, scene);
  b.type("w");
  for (int k = 0; k < 200; ++k) b.press({NamedKey::Backspace});
  b.type(scene);
  b.press({NamedKey::Return});
  b.press({NamedKey::Return});
  b.update();
  EXPECT_TRUE(b.complains());
  EXPECT_TRUE(b.isAsking());
  std::ifstream kept{scene};
  EXPECT_EQ((std::string{std::istreambuf_iterator<char>{kept}, {}}), own);
  b.press({NamedKey::Escape});

  // Up and down offer the built-in scenes.
  b.type("e");
  b.press({NamedKey::Down});
  b.press({NamedKey::Down});
  b.press({NamedKey::Up});
  b.press({NamedKey::Return});
  b.update();
  EXPECT_EQ(b.picture().scene().name, builtInScenes().front().name);
  b.type("e");
  b.press({NamedKey::Up});
  b.press({NamedKey::Return});
  b.update();
  EXPECT_EQ(b.picture().scene().name, builtInScenes().back().name);
}

}  // namespace xnewell::THIS_FILE
