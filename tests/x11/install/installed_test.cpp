#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "shading/color/png.h"
#include "tests/support/temporary_folder.h"
#include "tests/x11/support/program.h"

namespace xnewell::THIS_FILE {

// What `cmake --install` puts into a folder, which is then moved to another place: the program with its data
// and documents, the man page and completions, and the library, with which the example is built.

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using Names = std::set<std::string>;

constexpr const char* kMan = "share/man/man1/xnewell.1";
constexpr const char* kBash = "share/bash-completion/completions/xnewell";
constexpr const char* kZsh = "share/zsh/site-functions/_xnewell";
constexpr const char* kFish = "share/fish/vendor_completions.d/xnewell.fish";

/// What a pattern's first group finds in each line.
Names found(const std::string& text, const std::string& pattern) {
  Names names;
  std::istringstream in{text};
  std::smatch match;
  const std::regex wanted{pattern};
  for (std::string line; std::getline(in, line);)
    if (std::regex_search(line, match, wanted)) names.insert(match.str(1));
  return names;
}

/// As --help and `scenes` print them.
struct Told {
  std::string help = runProgram({"--help"}).out, list = runProgram({"scenes"}).out;
  Names commands = found(help, R"(^  xnewell \[?([a-z-]+))"),
        options = found(help, R"(^  (?:-\w,)?(--[\w-]+) )"), lessons = found(list, "^lesson (\\S+)"),
        lectures = found(list, "^lecture (\\S+)"), scenes = found(list, "^(?!lesson |lecture )(\\S+)");
};

std::string replacedAll(std::string text, const std::string& what, const std::string& with) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += with.size())
    text.replace(at, what.size(), with);
  return text;
}

std::string textOfFile(const std::filesystem::path& file) {
  std::ifstream in{file, std::ios::binary};
  return {std::istreambuf_iterator<char>{in}, {}};
}

/// Runs a command of the shell in a folder, without a display.
Finished inFolder(const std::filesystem::path& folder, const std::string& command) {
  RunningProgram shell{"bash", {"-c", "cd \"$0\" && " + command, folder.string()}, ""};
  return shell.wait();
}

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

/// Two plates through each other, and three bars of which each is over the next one. The last is a
/// hexagon with a dent behind all of them.
constexpr const char* kCrossing = R"(v -2 -1 0.3000
v 0.1000 -1 -0.7000
v 0.1000 1 -0.7000
v -2 1 0.3000
v -2 -0.8000 -0.7000
v 0.1000 -0.9000 0.3000
v 0.1000 0.8000 0.3000
v -2 0.9000 -0.7000
f 1 2 3 4
f 5 6 7 8
v 0.5000 -1 0.4000
v 0.9000 -1 0.4000
v 2.5000 1 -0.4000
v 2.1000 1 -0.4000
f 9 10 11 12
v 2.4000 -0.9000 0.4000
v 2.8000 -0.9000 0.4000
v 0.9000 1.1000 -0.5000
v 0.5000 1.1000 -0.4000
f 13 14 15 16
v 3 0.5000 0.4500
v 3 0.9000 0.4000
v 0.3000 0.1000 -0.4000
v 0.3000 -0.3000 -0.3500
f 17 18 19 20
v -3 -2 -2
v 3.5000 -2 -2
v 0.3000 -0.1000 -2
v 3.5000 2 -2
v -3 2 -2
f 21 22 23 24 25
)";

/// Paints the pieces over each other: at each centre of a pixel, the last one whose outline is around it.
/// Returns face number + 1, 0 where there is none.
std::vector<int> painted(const std::string& lines, int width, int height) {
  std::vector<int> shown(static_cast<std::size_t>(width) * height, 0);
  std::istringstream in{lines};
  for (std::string line; std::getline(in, line);) {
    const auto piece = nlohmann::json::parse(line);
    const auto corners = piece.at("piece").get<std::vector<std::array<double, 2>>>();
    for (int j = 0; j < height; ++j)
      for (int i = 0; i < width; ++i) {
        const double x = i + 0.5, y = j + 0.5;
        bool left = true, right = true;
        for (std::size_t k = 0; k < corners.size(); ++k) {
          const auto &a = corners[k], &b = corners[(k + 1) % corners.size()];
          const double side = (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
          left = left && side >= 0;
          right = right && side <= 0;
        }
        if (left || right) shown[static_cast<std::size_t>(j) * width + i] = piece.at("face").get<int>() + 1;
      }
  }
  return shown;
}

class InstalledTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TemporaryFolder;
    const std::filesystem::path first = folder_->file("first");
    const Finished done = inFolder(
        "/", XNEWELL_CMAKE " --install '" XNEWELL_BUILD "' --prefix '" + (first / "usr").string() + "'");
    ASSERT_EQ(done.status, 0) << done.err;
    std::filesystem::rename(first, folder_->file("another place"));
  }
  static void TearDownTestSuite() {
    delete folder_;
    folder_ = nullptr;
  }

  [[nodiscard]] static std::filesystem::path file(const std::string& name) { return folder_->file(name); }
  [[nodiscard]] static std::filesystem::path installed(const std::string& path) {
    return file("another place") / "usr" / path;
  }
  /// Runs the installed program in the root folder.
  [[nodiscard]] static Finished run(const std::string& words) {
    return inFolder("/", "'" + installed("bin/xnewell").string() + "' " + words);
  }

 private:
  inline static TemporaryFolder* folder_ = nullptr;
};

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

class ManualTest : public InstalledTest {
 protected:
  const Told told;

  /// The lines that a command prints, in the folder of the project's data. `xnewell` is the installed one.
  [[nodiscard]] static Names lines(const std::string& command) {
    const Finished done =
        inFolder(XNEWELL_DATA_DIR, "export PATH=\"" + installed("bin").string() + ":$PATH\"; " + command);
    EXPECT_EQ(done.err, "") << command;
    return found(done.out, "^([^\\t]+)");
  }
  [[nodiscard]] static bool has(const std::string& shell) {
    return inFolder("/", "command -v " + shell).status == 0;
  }
  /// What a shell must propose. `propose` gives its proposals for a line.
  void expectCompletions(const std::function<Names(const std::string&)>& propose) const {
    Names first = told.scenes;
    first.insert(told.commands.begin(), told.commands.end());
    for (const std::string folder :
         {"lectures/", "lessons/", "pictures/", "scenes/", "textures/", "square.bpt", "teapot.bpt"})
      first.insert(folder);
    // A folder may be shown without its slash, and a name that is a scene's and a file's once.
    const auto plain = [](const Names& names) {
      Names all;
      for (std::string name : names) all.insert(name.substr(0, name.find_last_not_of('/') + 1));
      return all;
    };
    EXPECT_EQ(plain(propose("xnewell ")), plain(first));
    EXPECT_EQ(propose("xnewell dr"), Names{"draw"});
    EXPECT_EQ(propose("xnewell draw tea"), (Names{"teapot", "teapot.bpt"}));
    EXPECT_EQ(propose("xnewell draw scenes/cyc"), propose("xnewell scenes/cyc"));
    EXPECT_EQ(propose("xnewell draw scenes/cyc").size(), 1u);
    EXPECT_EQ(propose("xnewell --size 3x4 draw nested"), Names{"nested-cycles"});
    EXPECT_EQ(propose("xnewell draw teapot --order z"),
              (Names{"zbuffer16", "zbuffer24", "zbuffer32", "zmean", "zsort"}));
    EXPECT_EQ(propose("xnewell draw --shade g"), Names{"gouraud"});
    EXPECT_EQ(propose("xnewell --view mach"), Names{"machbands"});
    EXPECT_EQ(propose("xnewell --view sideb"), Names{"sidebyside"});
    EXPECT_EQ(propose("xnewell lesson cy"), Names{"cycles"});
    EXPECT_EQ(propose("xnewell lecture fi"), Names{"first-hour"});
    EXPECT_EQ(propose("xnewell --hal"), Names{"--half-vector"});
    EXPECT_EQ(propose("xnewell draw cycle -o pictures/windo").size(), 1u);
    EXPECT_EQ(propose("xnewell draw cycle --size 1"), Names{});
  }
};

// --help, `scenes` and these tests speak of the same things.
TEST_F(ManualTest, KnowsItsSources) {
  EXPECT_TRUE(told.commands.contains("draw") && told.commands.contains("scenes"));
  EXPECT_TRUE(told.options.contains("--output") && told.options.contains("--version"));
  EXPECT_GT(told.options.size(), 60u);
  EXPECT_TRUE(told.scenes.contains("teapot") && told.lessons.contains("cycles"));
}

// The man page has every command, option, scene and lesson, and nothing else in bold in a place of an option.
TEST_F(ManualTest, ManPageHasEverything) {
  const std::string page = replacedAll(textOfFile(installed(kMan)), "\\-", "-");
  Names entries = found(page, R"(^(?:\\fB-\w\\fR, )?\\fB(--[\w-]+)\\fR)");
  EXPECT_EQ(entries, told.options);
  for (const std::string& command : told.commands)
    EXPECT_TRUE(std::regex_search(page, std::regex{R"(\n\\fBxnewell \[?)" + command + R"(\]?\\fR)"}))
        << command;
  for (const Names* names : {&told.scenes, &told.lessons, &told.lectures})
    for (const std::string& name : *names) EXPECT_THAT(page, HasSubstr("\n\\fB" + name + "\\fR\n"));
  for (const std::string status : {"0", "1", "2", "130"})
    EXPECT_THAT(page, HasSubstr("\n\\fB" + status + "\\fR\n"));
}

// What --help says about an option stands in the man page word for word, and reads there as it was written.
TEST_F(ManualTest, ManPageReadsAsTheHelp) {
  if (!has("man")) GTEST_SKIP() << "man is not installed";
  const Finished read =
      inFolder("/", "LC_ALL=C.UTF-8 MANWIDTH=2000 MAN_KEEP_FORMATTING= man --warnings -l '" +
                        installed(kMan).string() + "' | col -bx");
  EXPECT_EQ(read.status, 0);
  EXPECT_EQ(read.err, "");
  const auto blanks = [](const std::string& text) {
    return std::regex_replace(replacedAll(text, "`", ""), std::regex{"\\s+"}, " ");
  };
  const std::string page = blanks(read.out);
  for (const std::string& line : found(told.help, R"(^  (?:-\w,)?--[\w-]+ +(.+)$)"))
    EXPECT_THAT(page, HasSubstr(blanks(line)));
  for (const std::string& line : found(told.list, "^(?:lesson |lecture )?\\S+ +(.+)$"))
    EXPECT_THAT(page, HasSubstr(blanks(line)));
}

TEST_F(ManualTest, ManPageSatisfiesMandoc) {
  if (!has("mandoc")) GTEST_SKIP() << "mandoc is not installed";
  const Finished lint = inFolder("/", "mandoc -T lint '" + installed(kMan).string() + "'");
  EXPECT_EQ(lint.out, "");
  EXPECT_EQ(lint.status, 0);
}

TEST_F(ManualTest, BashCompletes) {
  const std::string source = ". '" + installed(kBash).string() + "'; ";
  const auto typed = [&](const std::string& words) {
    return lines(source + "COMP_WORDS=(" + words +
                 ") COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _xnewell; printf "
                 "'%s\\n' \"${COMPREPLY[@]}\"");
  };
  expectCompletions([&](const std::string& line) { return typed(line.ends_with(' ') ? line + "''" : line); });
  EXPECT_EQ(typed("xnewell draw --order '=' ne"), Names{"newell"});  // as bash splits --order=ne
  EXPECT_EQ(typed("xnewell draw --cull '='"), (Names{"back", "none"}));
  EXPECT_EQ(typed("xnewell --order '=' newell draw cyc"), Names{"cycle"});
}

TEST_F(ManualTest, ZshCompletes) {
  if (!has("zsh")) GTEST_SKIP() << "zsh is not installed";
  const std::string tool = std::string{"zsh -f '"} + XNEWELL_DATA_DIR +
                           "/../tests/x11/install/complete.zsh' '" + installed(kZsh).string() + "' ";
  const auto typed = [&](const std::string& line) { return lines(tool + "'" + line + "'"); };
  // zsh proposes the last part of a path.
  expectCompletions(typed);
  EXPECT_EQ(typed("xnewell draw --order=ne"), Names{"--order=newell"});
}

TEST_F(ManualTest, FishCompletes) {
  if (!has("fish")) GTEST_SKIP() << "fish is not installed";
  const auto typed = [&](const std::string& line) {
    return lines("HOME='" + file("home").string() + "' fish --no-config -c \"source '" +
                 installed(kFish).string() + "'; complete -C '" + line + "'\"");
  };
  expectCompletions(typed);
  EXPECT_EQ(typed("xnewell draw --order=ne"), Names{"--order=newell"});
}

class ExampleTest : public InstalledTest {
 protected:
  static std::string quoted(const std::filesystem::path& path) { return "'" + path.string() + "'"; }
  static std::string source() { return XNEWELL_DATA_DIR "/../x11/example"; }
};

// The example is built against the installed package with CMake. It finds an order of painting that shows, at
// every sample, the face that `xnewell draw` finds without any order, and it draws the same picture.
TEST_F(ExampleTest, PaintsWhatTheProgramShows) {
  const Finished configured =
      inFolder("/", XNEWELL_CMAKE " -G Ninja -S '" + source() + "' -B " + quoted(file("example")) +
                        " -DCMAKE_PREFIX_PATH=" + quoted(installed("")) +
                        " -DCMAKE_CXX_COMPILER='" XNEWELL_CXX "' -DCMAKE_CXX_FLAGS='" XNEWELL_CXX_FLAGS "'");
  ASSERT_EQ(configured.status, 0) << configured.err;
  const Finished built = inFolder("/", XNEWELL_CMAKE " --build " + quoted(file("example")));
  ASSERT_EQ(built.status, 0) << built.out;

  const std::string program = quoted(file("example/painted")) + ' ';
  const std::filesystem::path model = file("crossing.obj"), a = file("a.png"), b = file("b.png"),
                              ids = file("ids.png");
  std::ofstream{model} << kCrossing;
  const Finished order = inFolder("/", program + quoted(model) + ' ' + quoted(a));
  ASSERT_EQ(order.status, 0) << order.err;
  ASSERT_EQ(run("draw " + quoted(model) + " --size 400x300 --bare -o " + quoted(b)).status, 0);
  EXPECT_EQ(textOfFile(a), textOfFile(b));

  ASSERT_EQ(run("draw " + quoted(model) + " --size 400x300 --order oracle -o " + quoted(b) + " --ids " +
                quoted(ids))
                .status,
            0);
  const RgbImage faces = readPng(ids.string());
  const std::vector<int> shown = painted(order.out, 400, 300);
  int wrong = 0, seen = 0;
  for (std::size_t k = 0; k < shown.size(); ++k) {
    const int right = faces.rgb[3 * k] * 65536 + faces.rgb[3 * k + 1] * 256 + faces.rgb[3 * k + 2];
    wrong += shown[k] != right;
    seen += right != 0;
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(seen, 20'000);
  EXPECT_GT(std::ranges::count(order.out, '\n'), 7) << "two crossings, and two parts of the dented face";

  const Finished refused = inFolder("/", program + "/nowhere.obj " + quoted(a));
  EXPECT_EQ(refused.status, 1);
  EXPECT_EQ(refused.err, "painted: /nowhere.obj: No such file or directory\n");
}

// pkg-config gives what a compiler needs.
TEST_F(ExampleTest, BuildsWithPkgConfig) {
  std::string folder;
  for (const auto& entry : std::filesystem::recursive_directory_iterator{installed("")})
    if (entry.path().filename() == "xnewell.pc") folder = entry.path().parent_path().string();
  ASSERT_NE(folder, "");
  if (inFolder("/", "command -v pkg-config").status != 0) GTEST_SKIP() << "pkg-config is not installed";
  // pkg-config writes blanks in paths as "\ ".
  const Finished done = inFolder("/", "export PKG_CONFIG_PATH='" + folder +
                                          "' && eval \"'" XNEWELL_CXX "' " XNEWELL_CXX_FLAGS " -std=c++20 '" +
                                          source() + "/painted.cpp' -o " + quoted(file("painted")) +
                                          " $(pkg-config --cflags --libs xnewell)\"");
  ASSERT_EQ(done.status, 0) << done.err;
  EXPECT_EQ(inFolder("/", quoted(file("painted"))).status, 2);
}

}  // namespace xnewell::THIS_FILE
