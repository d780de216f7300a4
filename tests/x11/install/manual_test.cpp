#include <gmock/gmock.h>

#include <algorithm>
#include <regex>
#include <set>
#include <sstream>

#include "tests/x11/install/installed.h"

namespace xnewell::THIS_FILE {

namespace {

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

}  // namespace

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

}  // namespace xnewell::THIS_FILE
