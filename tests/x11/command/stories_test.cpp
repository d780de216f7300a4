#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <memory>
#include <regex>
#include <set>

#include "shading/scene/scene_file.h"
#include "tests/x11/support/command_fixture.h"
#include "tests/x11/support/parsed_options.h"
#include "tests/x11/support/story_text.h"
#include "tests/x11/support/x_server.h"
#include "x11/app/lecture.h"
#include "x11/app/workbench.h"
#include "x11/command/read_lecture.h"
#include "x11/lessons/lesson.h"
#include "x11/options/options.h"

namespace xnewell::THIS_FILE {

// Stories are what the program does, line for line, as data: tests/stories/README.md has the lines.

namespace {

/// The files of tests/stories, without their ends.
Strings stories() {
  Strings names;
  for (const std::string& name : filesIn(XNEWELL_STORIES))
    if (name.ends_with(".txt")) names.push_back(name.substr(0, name.size() - 4));
  return names;
}

/// Words between blanks; one in '...' may hold blanks or nothing.
Strings wordsOf(const std::string& text) {
  Strings words;
  bool quoted = false, open = false;
  for (const char c : text) {
    if (c == '\'') quoted = !quoted;
    if (c == ' ' && !quoted) {
      open = false;
      continue;
    }
    if (!open) words.emplace_back(), open = true;
    if (c != '\'') words.back() += c;
  }
  for (std::string& word : words) word = unescaped(word);
  return words;
}

/// Whether a text is as a pattern, in which "..." stands for any text. The pattern may leave out the end of
/// the last line.
bool matches(const std::string& text, const std::string& pattern) {
  std::size_t at = 0;
  for (std::size_t from = 0; from <= pattern.size();) {
    const std::size_t dots = std::min(pattern.find("...", from), pattern.size());
    const std::string part = unescaped(pattern.substr(from, dots - from));
    const bool last = dots == pattern.size();
    const std::size_t found =
        from == 0 ? (text.starts_with(part) ? 0 : text.npos)
        : last    ? (text.size() >= at + part.size() && text.ends_with(part) ? text.size() - part.size()
                                                                             : text.npos)
                  : text.find(part, at);
    if (found == text.npos || (last && from == 0 && text != part))
      return text.ends_with('\n') && matches(text.substr(0, text.size() - 1), pattern);
    at = found + part.size(), from = dots + 3;
  }
  return true;
}

/// A line for each way to take one of <a|b|c>. Behind it, <1> is what the first of them was.
Strings expanded(const std::string& line) {
  static const std::regex kChoice{R"(<([^<>]*\|[^<>]*)>)"};
  std::smatch choice;
  if (!std::regex_search(line, choice, kChoice)) return {line};
  Strings all;
  std::istringstream options{choice.str(1) + '|'};
  for (std::string option; std::getline(options, option, '|');) {
    std::string rest = choice.suffix();
    // The first choice that is left is <1> in what follows, and the next one becomes it.
    for (std::size_t at = 0; (at = rest.find("<1>", at)) != rest.npos; at += option.size())
      rest.replace(at, 3, option);
    for (char digit = '2'; digit < '5'; ++digit)
      for (std::size_t at = 0; (at = rest.find(std::string{'<', digit, '>'}, at)) != rest.npos; ++at)
        rest[at + 1] = static_cast<char>(digit - 1);
    for (const std::string& whole : expanded(rest)) all.push_back(choice.prefix().str() + option + whole);
  }
  return all;
}

/// A window without a server, and what it says.
struct StoryWindow : Workbench {
  static Options optionsOf(const Strings& words) {
    std::vector<const char*> argv{"xnewell", "view"};
    for (const std::string& word : words) argv.push_back(word.c_str());
    return parseOptions(static_cast<int>(argv.size()), argv.data()).value();
  }
  explicit StoryWindow(const Strings& words) : StoryWindow{optionsOf(words)} {}
  explicit StoryWindow(Options options) : StoryWindow{readyScene(options), options} {}
  StoryWindow(Scene scene, const Options& options)
      : Workbench{std::move(scene), setupOf(options), {.copy = [this](const std::string& text) {
                    copied = text.substr(0, text.find_last_not_of('\n') + 1);
                    copied.erase(0, copied.rfind('\n') + 1);
                  }}} {
    const glm::ivec2 size = options.size.value_or(glm::ivec2{1024, 768});
    resize(size.x, size.y);
    begin(options, {});
    finish();
  }
  void finish() {
    for (int k = 0; k < 4 && stale() != Stale::Nothing; ++k) update();
    EXPECT_EQ(stale(), Stale::Nothing);
  }
  /// Keys between blanks: letters, or a name.
  void presses(const Strings& keys) {
    static const std::map<std::string, NamedKey> kNames{{"Right", NamedKey::Right},
                                                        {"End", NamedKey::End},
                                                        {"Back", NamedKey::Backspace},
                                                        {"Return", NamedKey::Return},
                                                        {"Esc", NamedKey::Escape}};
    for (const std::string& key : keys) {
      const auto name = kNames.find(key);
      if (name != kNames.end())
        press(name->second);
      else
        for (const char letter : key) press(letter);
      finish();
    }
  }
  /// What was written last with these words; if nothing is, they may be a part of it.
  void click(const std::string& words) {
    const auto find = [&](bool whole) {
      return std::find_if(writing().rbegin(), writing().rend(), [&](const Written& one) {
        return one.pitch > 0 && (whole ? one.words == words : one.words.find(words) != words.npos);
      });
    };
    const auto one = find(true) != writing().rend() ? find(true) : find(false);
    ASSERT_NE(one, writing().rend()) << words;
    const auto letters = static_cast<int>(2 * one->words.find(words) + words.size());
    const int x = (one->place.x + letters * one->pitch / 2) * layout().unit,
              y = (one->place.y + one->place.height / 2) * layout().unit;
    hover(x, y);
    (void)grab(x, y);
    settle();
    finish();
  }
  std::string copied;
};

/// What is read as a file of this kind.
const std::map<std::string, std::string> kReaders{{"scene", "json"}, {"lesson", "json"}, {"lecture", "json"},
                                                  {"obj", "obj"},    {"mtl", "mtl"},     {"ply", "ply"},
                                                  {"off", "off"},    {"bpt", "bpt"}};

struct Line {
  int number = 0;
  std::string text;
};

class Story : public CommandTest, public testing::WithParamInterface<std::string> {
 protected:
  Story() {
    std::filesystem::remove(file("old.png"));
    std::filesystem::current_path(file("."));
    names_["<data>"] = XNEWELL_DATA_DIR;
    names_["<cxx>"] = XNEWELL_CXX;
    names_["<hindered>"] = builtProgram("tests/xnewell_hindered");
#ifdef XNEWELL_BUILD
    names_["<cmake>"] = XNEWELL_CMAKE;
    names_["<build>"] = XNEWELL_BUILD;
    names_["<flags>"] = XNEWELL_CXX_FLAGS;
#endif
  }
  ~Story() override { std::filesystem::current_path("/"); }

  /// Tells these lines; those from `each` to its `end` once for each of the values.
  void tellAll(const std::vector<Line>& lines) {
    static const std::regex kActs{R"((\$|sh|open|press|click|drag) .*)"},
        kTellsOfTheLast{
            R"((out|err|fact|hides|same -|differ -|shows|asks|warns|told|ribbon|view|status|setup)( .*)?)"};
    bool several = false;  // the line before did more than one thing
    for (auto at = lines.begin(); at != lines.end(); ++at) {
      const std::string line = withNames(at->text, names_);
      if (line.starts_with("needs ")) {
        const std::string program = line.substr(6, line.find(' ', 6) - 6);
        if (RunningProgram{"sh", {"-c", "command -v " + program}, ""}.wait().status == 0) continue;
        missing_ += ' ' + program;
        return;
      }
      if (line.starts_with("each ")) {
        int open = 0;
        const auto end = std::find_if(at, lines.end(), [&](const Line& one) {
          open += one.text.starts_with("each ") - (one.text == "end");
          return open == 0;
        });
        ASSERT_NE(end, lines.end()) << line;
        const std::size_t equals = line.find(" = ");
        std::istringstream values{line.substr(equals + 3) + '|'};
        for (std::string value; std::getline(values, value, '|');) {
          names_['<' + line.substr(5, equals - 5) + '>'] = value;
          tellAll({at + 1, end});
        }
        at = end;
        continue;
      }
      const Strings all = expanded(line);
      if (several && std::regex_match(line, kTellsOfTheLast))
        ADD_FAILURE() << GetParam() << ':' << at->number << ": only the last choice is seen: use each";
      several = all.size() > 1 && std::regex_match(line, kActs);
      for (const std::string& one : all) {
        SCOPED_TRACE(XNEWELL_STORIES + ('/' + GetParam()) + ".txt:" + std::to_string(at->number) + ": " +
                     one);
        tell(one);
        ++told_;
      }
    }
  }

  void tell(const std::string& line) {
    const std::size_t blank = line.find(' ');
    const std::string verb = line.substr(0, blank), rest = blank == line.npos ? "" : line.substr(blank + 1);
    const std::size_t arrow = rest.rfind(" -> "), equals = rest.find(" = ");
    const std::string what = rest.substr(0, arrow), then = arrow == rest.npos ? "" : rest.substr(arrow + 4);
    if (verb == "let") {
      names_["<" + rest.substr(0, equals) + ">"] = rest.substr(equals + 3);
    } else if (verb == "file") {
      write(unescaped(rest.substr(0, equals)), unescaped(rest.substr(equals + 3)));
    } else if (verb == "carried") {
      write(rest.substr(0, equals),
            encodePng(IndexImage{3, 2, 7}, Palette{}, unescaped(rest.substr(equals + 3))));
    } else if (verb == "folder") {
      std::filesystem::create_directory(rest);
    } else if (verb == "server") {
      serve(rest);
    } else if (kReaders.contains(verb)) {
      reader_ = verb, text_ = rest;
    } else if (verb == ":") {
      std::string text = text_;
      if (const std::size_t at = text.find('@'); at != text.npos) text.replace(at, 1, what);
      const std::string said = complaintOf(unescaped(text));
      EXPECT_TRUE(matches(said, then == "ok" ? "" : then)) << said;
    } else if (verb == "?") {
      const std::string said = complaintAll(wordsOf(what));
      EXPECT_TRUE(matches(said, then == "ok" ? "" : then)) << said;
    } else if (verb == "$") {
      const auto before = everything();
      ended(runProgram(wordsOf(what), display_), then, before);
    } else if (verb == "sh") {
      const std::string folder = builtProgram().substr(0, builtProgram().rfind('/'));
      ended(RunningProgram{"sh", {"-c", "PATH='" + folder + ":'$PATH; " + what}, display_}.wait(), then, {});
    } else if (verb == "holds") {
      const std::string text = contents(rest.substr(0, equals));
      EXPECT_TRUE(matches(text, rest.substr(equals + 3))) << text;
    } else if (verb == "hides") {
      EXPECT_EQ(last_.out.find(rest), rest.npos) << last_.out;
    } else if (verb == "lacks") {
      const std::string text = contents(rest.substr(0, equals));
      EXPECT_FALSE(text.empty());
      EXPECT_EQ(text.find(unescaped(rest.substr(equals + 3))), text.npos) << text;
    } else if (verb == "png") {
      const RgbImage image = readPng(rest.substr(0, equals));
      const std::string should = rest.substr(equals + 3), size = should.substr(0, should.find(", "));
      EXPECT_EQ(std::to_string(image.width) + 'x' + std::to_string(image.height), size);
      std::set<std::string> colors;
      for (std::size_t k = 0; k < image.rgb.size(); k += 3) colors.emplace(&image.rgb[k], &image.rgb[k] + 3);
      EXPECT_GE(colors.size(), size == should ? 1u : std::stoul(should.substr(size.size() + 2)));
    } else if (verb == "note") {
      const std::string note = noteInPng(rest.substr(0, equals)).value_or("");
      EXPECT_TRUE(matches(note, rest.substr(equals + 3))) << note;
    } else if (verb == "looks") {
      EXPECT_EQ(readPng(wordsOf(rest).at(0)), readPng(wordsOf(rest).at(1)));
    } else if (verb == "files") {
      EXPECT_EQ(std::to_string(filesIn(rest.substr(0, equals)).size()), rest.substr(equals + 3));
    } else if (verb == "once") {
      const std::string text = contents(rest.substr(0, equals)), part = rest.substr(equals + 3);
      EXPECT_NE(text.find(part), text.npos) << text;
      EXPECT_EQ(text.find(part), text.rfind(part)) << text;
    } else if (verb == "same" || verb == "differ") {
      const Strings two = wordsOf(rest);
      const std::string first = two.at(0) == "-" ? last_.out : contents(two.at(0)),
                        second = contents(two.at(1));
      EXPECT_TRUE((first == second) == (verb == "same") && !first.empty() && !second.empty());
    } else if (verb == "fact") {
      fact(wordsOf(rest));
    } else if (verb == "open") {
      window_ = std::make_unique<StoryWindow>(wordsOf(rest));
    } else if (verb == "press" && window_) {
      window_->presses(wordsOf(rest));
    } else if (verb == "click" && window_) {
      window_->click(unescaped(rest));
    } else if (verb == "shows" && window_) {
      EXPECT_TRUE(std::ranges::any_of(window_->writing(), [&](const Written& one) {
        return matches(one.words, rest);
      })) << rest;
    } else if (verb == "drag" && window_) {  // the picture, from its middle
      const Rect at = window_->layout().picture;
      const int x = at.x + at.width / 2, y = at.y + at.height / 2;
      EXPECT_TRUE(window_->grab(x, y));
      window_->dragTo(x + std::stoi(rest), y + std::stoi(rest.substr(rest.find(',') + 1)));
      window_->settle();
      window_->finish();
    } else if (const auto text = textOf(verb)) {
      EXPECT_TRUE(matches(*text, rest == "nothing" ? "" : rest)) << *text;
    } else {
      ADD_FAILURE() << "no line begins with " << verb;
    }
  }

  /// What a line that begins so compares with its text.
  std::optional<std::string> textOf(const std::string& verb) {
    if (verb == "out") return last_.out;
    if (verb == "err") return last_.err;
    if (!window_) return {};
    const PanelState& panel = window_->panel();
    if (verb == "asks") return panel.typed ? panel.typed->asks : "";
    if (verb == "warns") return panel.typed ? panel.typed->complaint : panel.notice;
    if (verb == "view")
      return std::string{std::ranges::find(kWindowViews, window_->view(), &ViewRow::id)->name};
    if (verb == "told") return panel.told;
    if (verb == "ribbon") return panel.mistake;
    if (verb == "status") return panel.status + "   " + panel.aside;
    if (verb != "setup") return {};
    window_->press('C');
    return window_->copied;
  }

  /// Of a text that is read so, without the name of its file. A model is read by `draw`.
  [[nodiscard]] std::string complaintOf(const std::string& text) const {
    const std::string end = kReaders.at(reader_), name = "a." + end;
    write(name, text);
    std::string said;
    if (end != "json") {
      const bool library = end == "mtl";
      write("of_mtl.obj", "mtllib a.mtl\nusemtl m\n" + kTriangleObj);
      const auto before = everything();
      const Finished drawn = runProgram({"draw", library ? "of_mtl.obj" : name, "-o", "new.png"});
      EXPECT_EQ(drawn.status, 2);
      EXPECT_EQ(std::ranges::count(drawn.err, '\n'), 1);
      EXPECT_EQ(everything(), before);
      said = drawn.err.substr(std::min<std::size_t>(drawn.err.size(), 9));
    } else {
      try {
        if (reader_ == "scene") (void)parseSceneFile(text, name, XNEWELL_DATA_DIR);
        if (reader_ == "lesson") (void)parseLesson(text, name, XNEWELL_DATA_DIR "/lessons");
        if (reader_ == "lecture") (void)readLecture(name);
      } catch (const std::exception& e) {
        said = e.what();
      }
    }
    return said.starts_with(name) ? said.substr(name.size()) : said;
  }

  /// The next programs find this server: a depth, one whose black is 1, none, or any name.
  void serve(const std::string& what) {
    server_.reset(), host_.reset();
    if (what == "nested") host_.emplace(XServer::xvfb(24, 1400, 1000));
    if (what == "nested") server_.emplace(XServer::xephyr(*host_, 8, 320, 240));
    if (what[0] == '8' || what[0] == '2') {  // its options stand behind the depth
      const Strings words = wordsOf(what);
      server_.emplace(XServer::xvfb(std::stoi(words[0]), 1024, 768, {words.begin() + 1, words.end()}));
    }
    display_ = server_ ? server_->name() : what == "none" ? "" : what;
  }

  /// The status, and after a bar the one line with which the program refuses. Then nothing is written. No
  /// text commands a terminal.
  void ended(Finished run, const std::string& then, const std::map<std::string, std::string>& before) {
    last_ = std::move(run);
    EXPECT_EQ(last_.status, std::stoi(then)) << last_.err;
    const std::string all = last_.out.starts_with("\x89PNG") ? last_.err : last_.out + last_.err;
    EXPECT_TRUE(std::ranges::none_of(all, [](char c) {
      return c != '\n' && ((c >= 0 && c < ' ') || c == 0x7F);
    })) << all;
    EXPECT_EQ(all.find("\u009b"), all.npos);
    const std::size_t bar = then.find(" | ");
    if (bar == then.npos) return;
    EXPECT_TRUE(matches(last_.err, "xnewell: " + then.substr(bar + 3))) << last_.err;
    EXPECT_EQ(std::ranges::count(last_.err, '\n'), 1);
    EXPECT_LT(last_.err.size(), 1000u);
    EXPECT_EQ(last_.out, "");
    EXPECT_EQ(everything(), before);
  }

  /// PATH OP VALUE: in the JSON that was printed, a value compared with another. ~: as far as that is
  /// written.
  void fact(const Strings& words) const {
    const Json all = Json::parse(last_.out);
    if (words.at(2) == "none") {
      EXPECT_FALSE(all.contains(Json::json_pointer{words[0]}));
      return;
    }
    const Json is = all.at(Json::json_pointer{words.at(0)}),
               should = words[2][0] == '/' ? all.at(Json::json_pointer{words[2]}) : Json::parse(words[2]);
    const char op = words.at(1).at(0);
    if (op == '~') {
      const auto decimals = static_cast<double>(words[2].size() - words[2].find('.') - 1);
      EXPECT_NEAR(is.get<double>(), should.get<double>(), 0.50001 * std::pow(10, -decimals));
    } else {
      EXPECT_TRUE(op == '=' ? is == should : op == '<' ? is < should : is > should) << is;
    }
  }

  std::map<std::string, std::string> names_;
  std::string reader_, text_;  ///< of the last line `scene`, `lesson`, ...
  std::optional<XServer> host_, server_;
  std::string display_;
  std::unique_ptr<StoryWindow> window_;
  Finished last_;
  int told_ = 0;
  std::string missing_;  ///< programs that lines need and the machine has not
};

}  // namespace

// Each line of the story is true.
TEST_P(Story, Holds) {
  std::ifstream in{XNEWELL_STORIES + ('/' + GetParam()) + ".txt"};
  std::vector<Line> lines;
  int number = 0;
  for (std::string line; std::getline(in, line);)
    if (++number; !line.empty() && line[0] != '#') lines.push_back({number, line});
  tellAll(lines);
  EXPECT_GT(told_, 2);
  if (!missing_.empty()) GTEST_SKIP() << "not here:" << missing_;
}
INSTANTIATE_TEST_SUITE_P(Stories, Story, testing::ValuesIn(stories()),
                         [](const auto& story) { return story.param; });

}  // namespace xnewell::THIS_FILE
