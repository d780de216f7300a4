#include "tests/x11/install/installed.h"

#include <gmock/gmock.h>

#include <regex>
#include <set>

#include "shading/color/png.h"

namespace xnewell::THIS_FILE {

namespace {

namespace fs = std::filesystem;

/// A line of the file matches the whole pattern, and this is what its first group holds.
std::string lineOf(const fs::path& path, const std::string& pattern) {
  std::ifstream in{path};
  EXPECT_TRUE(in) << path;
  std::smatch found;
  for (std::string line; std::getline(in, line);)
    if (std::regex_match(line, found, std::regex{pattern})) return found.str(1);
  ADD_FAILURE() << path << " has no line " << pattern;
  return "";
}

}  // namespace

// The installed program finds models, scenes, textures and lessons wherever its folder was moved to and
// wherever it is called, and does the same as the program in the build folder.
TEST_F(InstalledTest, DoesWhatTheBuiltOneDoes) {
  for (const std::string scene : {"teapot", "textured-cube", "cycle"}) {
    const std::string a = file("a.png"), b = file("b.png");
    const Finished done = run("draw " + scene + " --size 200x150 -o '" + a + "'");
    ASSERT_EQ(done.status, 0) << done.err;
    ASSERT_EQ(runProgram({"draw", scene, "--size", "200x150", "-o", b}).status, 0);
    EXPECT_EQ(textOfFile(a), textOfFile(b)) << scene;
  }
  const std::string scenes = run("scenes").out;
  EXPECT_GT(std::ranges::count(scenes, '\n'), 30);
  EXPECT_EQ(scenes, runProgram({"scenes"}).out);
  const Finished lesson = run("lesson cycles --frames '" + file("frames").string() + "'");
  EXPECT_EQ(lesson.status, 0) << lesson.err;
  EXPECT_FALSE(fs::is_empty(file("frames")));
}

// Its data comes from its own folder: a scene that is added there is a built-in scene.
TEST_F(InstalledTest, ReadsItsOwnData) {
  const fs::path card = installed("share/xnewell/scenes/new-card.json");
  std::ofstream{card}
      << R"({"shows": "one card", "objects": [{"polygons": [[[-1,-1,0],[1,-1,0],[1,1,0]]]}]})";
  EXPECT_THAT(run("scenes").out, testing::ContainsRegex("new-card +one card"));
  EXPECT_EQ(run("draw new-card --size 20x20 -o '" + file("card.png").string() + "'").status, 0);
  fs::remove(card);
}

// Without its data, the program says in one line where they belong. It still draws other files.
TEST_F(InstalledTest, WithoutDataSaysWhereTheyBelong) {
  const fs::path data = installed("share/xnewell"), away = file("away"), triangle = file("triangle.obj");
  std::ofstream{triangle} << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  fs::rename(data, away);
  const Finished done = run("scenes"),
                 other = run("draw '" + triangle.string() + "' -o '" + file("t.png").string() + "'");
  fs::rename(away, data);
  EXPECT_EQ(done.status, 1);
  EXPECT_EQ(done.out, "");
  EXPECT_THAT(done.err, testing::StartsWith("xnewell: the scenes and lessons of the program are missing; "
                                            "they belong in " +
                                            data.string()));
  EXPECT_EQ(std::ranges::count(done.err, '\n'), 1);
  EXPECT_EQ(other.status, 0) << other.err;
}

// A packager's DESTDIR comes before the prefix.
TEST_F(InstalledTest, KnowsDestdir) {
  const fs::path staging = file("staging");
  const Finished done =
      inFolder("/", "DESTDIR='" + staging.string() +
                        "' " XNEWELL_CMAKE " --install '" XNEWELL_BUILD "' --prefix /opt/xnewell");
  ASSERT_EQ(done.status, 0) << done.err;
  EXPECT_TRUE(fs::exists(staging / "opt/xnewell/bin/xnewell"));
  EXPECT_EQ(inFolder("/", "'" + (staging / "opt/xnewell/bin/xnewell").string() + "' scenes").status, 0);
}

// Program, man page, metainfo and the Debian package have the same version, and the same day of its release.
TEST_F(InstalledTest, HasOneVersion) {
  const Finished said = run("--version");
  EXPECT_EQ(said.status, 0);
  std::smatch version;
  ASSERT_TRUE(std::regex_match(said.out, version, std::regex{"xnewell (\\d+\\.\\d+\\.\\d+)\n"})) << said.out;
  const std::string number = version.str(1);
  const fs::path man = installed("share/man/man1/xnewell.1"),
                 metainfo = installed("share/metainfo/example.xnewell.xnewell.metainfo.xml");
  EXPECT_EQ(lineOf(man, R"x(\.TH XNEWELL 1 \S+ "xnewell (\S+)")x"), number);
  EXPECT_EQ(lineOf(metainfo, R"x(\s*<release version="(\S+)" date="\S+"/>)x"), number);
  EXPECT_EQ(lineOf(man, R"x(\.TH XNEWELL 1 (\S+) .*)x"),
            lineOf(metainfo, R"x(\s*<release version="\S+" date="(\S+)"/>)x"));
}

// Each icon has the size that its folder says, and more than one colour.
TEST_F(InstalledTest, HasIcons) {
  int icons = 0;
  for (const auto& entry : fs::recursive_directory_iterator{installed("share/icons/hicolor")}) {
    if (!entry.is_regular_file()) continue;
    ++icons;
    EXPECT_EQ(entry.path().filename(), "xnewell.png");
    const RgbImage icon = readPng(entry.path().string());
    EXPECT_EQ(entry.path().parent_path().parent_path().filename(),
              std::to_string(icon.width) + "x" + std::to_string(icon.height));
    std::set<std::string> colors;
    for (std::size_t k = 0; k + 3 <= icon.rgb.size(); k += 3)
      colors.insert({static_cast<char>(icon.rgb[k]), static_cast<char>(icon.rgb[k + 1]),
                     static_cast<char>(icon.rgb[k + 2])});
    EXPECT_GT(colors.size(), 20u);
  }
  EXPECT_GE(icons, 4);
}

// The documents lead to each other and to their pictures, and the metainfo shows pictures that exist. Links
// to sources, data and scripts lead into the source tree, which is not installed.
TEST_F(InstalledTest, HasDocumentsWhoseLinksExist) {
  const fs::path documents = installed("share/doc/xnewell");
  int links = 0;
  for (const auto& entry : fs::recursive_directory_iterator{documents}) {
    if (entry.path().extension() != ".md") continue;
    const std::string text = textOfFile(entry.path());
    const std::regex link{R"(\]\(([^)#:]+\.(?:md|png))[^)]*\))"};
    for (std::sregex_iterator at{text.begin(), text.end(), link}, end; at != end; ++at, ++links)
      EXPECT_TRUE(fs::exists(entry.path().parent_path() / at->str(1))) << entry.path() << ": " << at->str(1);
  }
  EXPECT_GT(links, 40);
  EXPECT_TRUE(fs::exists(documents / "LICENSE"));
  const std::string metainfo = textOfFile(installed("share/metainfo/example.xnewell.xnewell.metainfo.xml"));
  const std::regex picture{"/(data/pictures/[^<]+\\.png)</image>"};
  int pictures = 0;
  for (std::sregex_iterator at{metainfo.begin(), metainfo.end(), picture}, end; at != end; ++at, ++pictures)
    EXPECT_TRUE(fs::exists(documents / at->str(1))) << at->str(1);
  EXPECT_GT(pictures, 2);
}

// The desktop's own programs find nothing wrong. They are not needed to build or test.
TEST_F(InstalledTest, DesktopFilesAreValid) {
  const Finished entry = inFolder(installed("share/applications"), "desktop-file-validate xnewell.desktop");
  const Finished metainfo = inFolder(installed("share/metainfo"), "appstreamcli validate --no-net *.xml");
  if (entry.status == 127 && metainfo.status == 127) GTEST_SKIP() << "desktop-file-utils, appstream";
  EXPECT_TRUE(entry.status == 0 || entry.status == 127);
  EXPECT_EQ(entry.out, "");
  EXPECT_TRUE(metainfo.status == 0 || metainfo.status == 127) << metainfo.out;
}

}  // namespace xnewell::THIS_FILE
