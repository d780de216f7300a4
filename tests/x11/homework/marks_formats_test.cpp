#include "x11/homework/marks_formats.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "shading/color/png.h"
#include "shading/picture/picture_cache.h"
#include "tests/support/temporary_folder.h"
#include "tests/x11/support/story_text.h"
#include "x11/homework/class_marks.h"

namespace xnewell::THIS_FILE {

namespace {

using Json = nlohmann::json;
using Strings = std::vector<std::string>;

const std::string kDocumented = XNEWELL_DATA_DIR "/../tests/x11/homework/documented/";

/// ---- What the documentation of each system says of its file. Nothing here is shared with what writes them.

/// A member of a JSON file: its path, with * for each item of a list, what it is, and the words that it may
/// be. `must`: it is there wherever the object around it is.
struct Member {
  std::string path;
  char is = 's';  ///< string, text that is not empty, number from 0, integer from 0, boolean, list, object
  bool must = false;
  std::set<std::string> words = {};
};
using Members = std::vector<Member>;

bool fits(const Json& value, const Member& member) {
  switch (member.is) {
    case 's':
      return value.is_string() && (member.words.empty() || member.words.contains(value.get<std::string>()));
    case 't':
      return value.is_string() && !value.get<std::string>().empty();
    case 'n':
      return value.is_number() && value.get<double>() >= 0;
    case 'i':
      return value.is_number_integer() && value.get<double>() >= 0;
    case 'b':
      return value.is_boolean();
    case 'l':
      return value.is_array();
    default:
      return value.is_object();
  }
}
/// What is wrong first; "" if nothing is.
std::string complaint(const Json& value, const Members& members, const std::string& path = "") {
  const auto known = std::ranges::find(members, path, [](const Member& m) { return m.path; });
  if (known == members.end()) return path + " is not documented";
  if (!fits(value, *known)) return path + " is " + value.dump();
  for (const Member& m : members)
    if (m.must && value.is_object() && m.path.substr(0, m.path.rfind('/')) == path &&
        !m.path.ends_with('*') && !value.contains(m.path.substr(m.path.rfind('/') + 1)) && m.path != path)
      return m.path + " is missing";
  for (const auto& [key, one] : value.items()) {
    if (!value.is_structured()) break;
    if (const std::string what = complaint(one, members, path + '/' + (value.is_array() ? "*" : key));
        !what.empty())
      return what;
  }
  return "";
}

/// The members that a text names: each path, what it is, `!` where it must be there, and after = its words.
Members membersOf(const std::string& text) {
  Members all;
  std::istringstream in{text};
  for (std::string path, is; in >> path >> is;) {
    all.push_back({path == "." ? "" : path, is[0], is.find('!') != is.npos});
    std::istringstream words{is.substr(std::min(is.find('='), is.size() - 1) + 1)};
    for (std::string word; std::getline(words, word, ',');) all.back().words.insert(word);
  }
  return all;
}

/// What a system's documentation says, in documented/NAME.txt: lines `member` with the members of its file,
/// lines `spoilt THIS -> THAT`, and an example.
struct Documented {
  explicit Documented(std::string_view name) {
    std::ifstream in{kDocumented + std::string{name} + ".txt"};
    for (std::string line; std::getline(in, line);) {
      const std::size_t arrow = line.find(" ->");
      if (line.starts_with("member "))
        members += line.substr(7) + '\n';
      else if (line.starts_with("spoilt "))
        spoilt.emplace_back(unescaped(line.substr(7, arrow - 7)),
                            unescaped(line.substr(std::min(arrow + 4, line.size()))));
      else if (!line.starts_with('#'))
        example += line + '\n';
    }
  }
  std::string members, example;
  std::vector<std::pair<std::string, std::string>> spoilt;
};
const Members kGradescope = membersOf(Documented{"gradescope"}.members),
              kClassroom50 = membersOf(Documented{"classroom50"}.members),
              kPrairieLearn = membersOf(Documented{"prairielearn"}.members);

/// Rules between members.
std::string gradescopeComplaint(const std::string& file) { return complaint(Json::parse(file), kGradescope); }
std::string classroom50Complaint(const std::string& file) {
  const Json json = Json::parse(file);
  if (const std::string what = complaint(json, kClassroom50); !what.empty()) return what;
  const std::regex instant{R"(\d{4}-\d\d-\d\dT([01]\d|2[0-3]):[0-5]\d:[0-5]\dZ)"};
  if (!std::regex_match(json["datetime"].get<std::string>(), instant)) return "datetime";
  if (!json["submission"].get<std::string>().starts_with("submit/")) return "submission";
  std::int64_t score = 0, most = 0;
  for (const Json& test : json["tests"]) {
    if (test["score"] > test["max-score"]) return "more than max-score";
    score += test["score"].get<int>(), most += test["max-score"].get<int>();
  }
  return json["score"] == score && json["max-score"] == most ? "" : "sums";
}
std::string prairieLearnComplaint(const std::string& file) {
  if (file.size() > 1'000'000) return "more than 1 MB";
  const Json json = Json::parse(file);
  if (const std::string what = complaint(json, kPrairieLearn); !what.empty()) return what;
  return json["score"] <= 1 ? "" : "score above 1";
}

/// The elements of an XML file, inner ones first; the last is the root. It throws for what is not
/// well-formed.
struct Element {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::vector<std::size_t> children;
};
std::vector<Element> elementsOf(std::string text) {
  const auto check = [](bool good, const std::string& what) {
    if (!good) throw std::runtime_error{what};
  };
  (void)Json(text).dump();  // throws for what is not UTF-8
  static const std::regex kNone{"[\\x01-\\x08\\x0b\\x0c\\x0e-\\x1f]|\xEF\xBF\xBE|\xEF\xBF\xBF"},
      kBare{"&(?!(amp|lt|gt|quot);)|]]>"}, kAttribute{R"re(\s+([\w-]+)="([^"]*)")re"},
      kInner{R"re(<([A-Za-z][\w-]*)((?:\s+[\w-]+="[^"<]*")*)\s*(?:/>|>([^<]*)</\1>))re"},
      kMark{"\x01(\\d+)\x01"};
  check(text.find('\0') == text.npos && !std::regex_search(text, kNone), "no character");
  check(!std::regex_search(text, kBare), "bare mark");
  if (text.starts_with("<?xml")) text.erase(0, text.find("?>") + 2);
  std::vector<Element> all;
  for (std::smatch m; std::regex_search(text, m, kInner);) {
    Element& one = all.emplace_back(Element{m.str(1), {}, {}});
    const std::string attributes = m.str(2), inside = m.str(3);
    for (std::sregex_iterator at{attributes.begin(), attributes.end(), kAttribute}, end; at != end; ++at)
      check(one.attributes.emplace(at->str(1), at->str(2)).second, "attribute twice");
    for (std::sregex_iterator at{inside.begin(), inside.end(), kMark}, end; at != end; ++at)
      one.children.push_back(std::stoul(at->str(1)));
    text = m.prefix().str() + '\x01' + std::to_string(all.size() - 1) + '\x01' + m.suffix().str();
  }
  check(std::regex_match(text, std::regex{"\\s*\x01\\d+\x01\\s*"}), "not well-formed: " + text);
  return all;
}

/// Jenkins' schema of what JUnit writes (junit-10.xsd): children, attributes that must be there, others.
struct ElementRule {
  std::set<std::string> children, must, may;
};
const std::map<std::string, ElementRule> kJUnit{
    {"testsuites", {{"testsuite"}, {}, {"name", "time", "tests", "failures", "errors"}}},
    {"testsuite",
     {{"testsuite", "properties", "testcase", "system-out", "system-err"},
      {"name", "tests", "failures", "errors"},
      {"group", "time", "skipped", "timestamp", "hostname", "id", "package", "file", "log", "url",
       "version"}}},
    {"testcase",
     {{"skipped", "errors", "failure", "system-out", "system-err"},
      {"name"},
      {"time", "classname", "group"}}},
    {"failure", {{}, {}, {"type", "message"}}},
    {"system-out", {}}};
std::string junitComplaint(const std::string& file) {
  const std::vector<Element> all = elementsOf(file);
  for (const Element& one : all) {
    const auto rule = kJUnit.find(one.name);
    if (rule == kJUnit.end()) return one.name + " is not documented";
    for (const std::string& must : rule->second.must)
      if (!one.attributes.contains(must)) return one.name + " lacks " + must;
    for (const auto& [key, value] : one.attributes)
      if (!rule->second.must.contains(key) && !rule->second.may.contains(key))
        return one.name + " has " + key;
    int cases = 0, failures = 0;
    for (const std::size_t child : one.children) {
      if (!rule->second.children.contains(all[child].name)) return all[child].name + " in " + one.name;
      cases += all[child].name == "testcase";
      failures += std::ranges::any_of(all[child].children, [&](auto k) { return all[k].name == "failure"; });
    }
    if (one.name == "testsuite" && (one.attributes.at("tests") != std::to_string(cases) ||
                                    one.attributes.at("failures") != std::to_string(failures)))
      return "counts";
  }
  return all.back().name == "testsuites" ? "" : "root";
}
/// RFC 4180: the fields of each line.
std::vector<Strings> csvOf(const std::string& file) {
  std::vector<Strings> lines{{""}};
  bool quoted = false;
  for (std::size_t k = 0; k < file.size(); ++k) {
    const char c = file[k];
    if (c == '"' && quoted && k + 1 < file.size() && file[k + 1] == '"')
      lines.back().back() += '"', ++k;
    else if (c == '"')
      quoted = !quoted;
    else if (c == ',' && !quoted)
      lines.back().emplace_back();
    else if (c == '\n' && !quoted)
      lines.push_back({""});
    else
      lines.back().back() += c;
  }
  lines.pop_back();
  return lines;
}
std::string csvComplaint(const std::string& file) {
  const std::vector<Strings> lines = csvOf(file);
  for (const Strings& line : lines) {
    if (line.size() != lines[0].size()) return "a line of " + std::to_string(line.size()) + " fields";
    for (const std::string& field : line)
      if (!field.empty() && std::string_view{"=+-@\t\r"}.find(field[0]) != std::string_view::npos)
        return "a formula: " + field;
  }
  return lines.size() > 1 ? "" : "no lines";
}

/// The page's own elements alone, and no attribute of another's making.
std::string htmlComplaint(const std::string& file) {
  static const std::set<std::string> kOurs{"html", "meta", "style", "title", "h1",     "p",         "table",
                                           "tr",   "th",   "td",    "img",   "figure", "figcaption"};
  const std::regex tag{R"(<(!DOCTYPE html|/?(\w+)([^<>]*))>)"};
  std::string rest;
  std::size_t from = 0;
  for (std::sregex_iterator at{file.begin(), file.end(), tag}, end; at != end; ++at) {
    rest += file.substr(from, static_cast<std::size_t>(at->position()) - from);
    from = static_cast<std::size_t>(at->position() + at->length());
    if (at->str(1) == "!DOCTYPE html") continue;
    if (!kOurs.contains(at->str(2))) return "<" + at->str(2) + ">";
    static const std::regex own{
        R"( alt="" src="data:image/png;base64,[A-Za-z0-9+/=]*"| lang="en"| charset="utf-8"| http-equiv="Content-Security-Policy" content="default-src 'none'; img-src data:; style-src 'unsafe-inline'")"};
    if (!at->str(3).empty() && !std::regex_match(at->str(3), own)) return at->str(3);
  }
  rest += file.substr(from);
  return rest.find('<') == rest.npos ? "" : "a bare <: " + rest.substr(rest.find('<'), 40);
}

struct Checker {
  MarksFormat format;
  std::string (*complaint)(const std::string& file);
};
constexpr std::array kCheckers{
    Checker{MarksFormat::Csv, csvComplaint},
    Checker{MarksFormat::Html, htmlComplaint},
    Checker{MarksFormat::Gradescope, gradescopeComplaint},
    Checker{MarksFormat::Classroom50, classroom50Complaint},
    Checker{MarksFormat::PrairieLearn, prairieLearnComplaint},
    Checker{MarksFormat::JUnit, junitComplaint},
};

/// Names that nobody should have.
const Strings kNames = [] {
  Strings names;
  std::ifstream in{kDocumented + "names.txt"};
  for (std::string line; std::getline(in, line);) names.push_back(unescaped(line));
  return names;
}();

struct Environment {
  Environment() {
    for (const char* const name : rowOf(MarksFormat::Classroom50).variables) ::setenv(name, "x", 1);
    ::setenv("ASSIGNMENT_TYPE", "individual", 1);
    ::setenv("SUBMISSION_TAG", "submit/2026-06-01T14-32-05Z-a1b2c3d", 1);
  }
  ~Environment() {
    for (const char* const name : rowOf(MarksFormat::Classroom50).variables) ::unsetenv(name);
  }
};

/// A row a name, some of students with stages, with each kind of content.
ClassMarks hostile(bool staged) {
  ClassMarks marks{kNames[8], {}, {}};
  const std::string png = encodePng(RgbImage{2, 2});
  if (staged) marks.stages = {kNames[1], kNames[9]};
  for (const std::string& name : kNames)
    for (int k = 0; k < (staged ? 2 : 1); ++k)
      marks.rows.push_back({.file = name + ".png",
                            .student = staged ? name : "",
                            .stage = staged ? marks.stages[k] : "",
                            .points = k == 0 ? 0.5 : 1.0,
                            .verdict = k == 0 ? "unreadable" : "right",
                            .words = "unreadable: " + name,
                            .pixel = std::pair{1, 2},
                            .face = 3,
                            .pictures = {{"yours", png}, {"right", png}}});
  return marks;
}

}  // namespace

// The checkers take what the documentation of each system shows, and refuse it spoilt.
TEST(MarksFormats, AreCheckedAsDocumented) {
  ASSERT_EQ(kCheckers.size(), kMarksFormats.size());
  for (const Checker& checker : kCheckers) {
    SCOPED_TRACE(rowOf(checker.format).name);
    const Documented documented{rowOf(checker.format).name};
    EXPECT_EQ(checker.complaint(documented.example), "");
    EXPECT_FALSE(documented.spoilt.empty());
    for (const auto& [from, to] : documented.spoilt) {
      std::string spoilt = documented.example;
      ASSERT_NE(spoilt.find(from), spoilt.npos) << from;
      spoilt.replace(spoilt.find(from), from.size(), to);
      std::string what;
      try {
        what = checker.complaint(spoilt);
      } catch (const std::exception& e) {
        what = e.what();
      }
      EXPECT_NE(what, "") << from << " -> " << to;
    }
  }
}

// Whatever names files and students have, each format holds what its system documents, and has a row of its
// own for each of them.
TEST(MarksFormats, HoldHostileNames) {
  const Environment set;
  for (const bool staged : {false, true})
    for (const Checker& checker : kCheckers) {
      SCOPED_TRACE(rowOf(checker.format).name);
      const ClassMarks marks = hostile(staged);
      const std::string file = rowOf(checker.format).text(marks);
      EXPECT_EQ(checker.complaint(file), "") << file;
      const Json json = Json::parse(file, nullptr, false);
      if (checker.format == MarksFormat::Gradescope)
        for (const Json& test : json["tests"]) {
          const std::string html = test["output"];
          EXPECT_EQ(htmlComplaint(html), "") << html;
          EXPECT_NE(html.find("<img"), html.npos);
        }
      std::set<std::string> names;
      if (checker.format == MarksFormat::Csv)
        for (const Strings& line : csvOf(file)) names.insert(line[0]);
      else if (checker.format == MarksFormat::JUnit)
        for (const Element& one : elementsOf(file)) {
          if (one.name == "testsuite") names.insert(one.attributes.at("name"));
        }
      else if (!staged && checker.format != MarksFormat::Html)
        for (const Json& test : json["tests"])
          names.insert(
              test[checker.format == MarksFormat::Classroom50 ? "test-name" : "name"].get<std::string>());
      else
        continue;
      EXPECT_EQ(names.size(), kNames.size() + (checker.format == MarksFormat::Csv));
    }
}

// Points add up; what a picture should have been stands in the files that show pictures. PrairieLearn takes 1
// MB: pictures without room are left out. What nobody can read is not graded there.
TEST(MarksFormats, HavePointsAndPictures) {
  const Environment set;
  ClassMarks marks = hostile(true);
  marks.rows.resize(2);
  marks.rows[0].most = 3, marks.rows[0].points = 1.5, marks.rows[1].points = 1;
  const auto json = [&](MarksFormat format) { return Json::parse(rowOf(format).text(marks)); };
  EXPECT_EQ(json(MarksFormat::Gradescope)["score"], 2.5);
  EXPECT_EQ(json(MarksFormat::Classroom50)["score"], 2);
  EXPECT_EQ(json(MarksFormat::Classroom50)["max-score"], 4);
  EXPECT_EQ(json(MarksFormat::PrairieLearn)["score"], 2.5 / 4);
  EXPECT_EQ(csvOf(rowOf(MarksFormat::Csv).text(marks))[1][1], "2.5");
  EXPECT_EQ(json(MarksFormat::PrairieLearn)["tests"][0]["images"].size(), 2u);
  marks.rows[0].pictures.assign(9, {"yours", std::string(120'000, 'x')});
  const std::string bounded = rowOf(MarksFormat::PrairieLearn).text(marks);
  EXPECT_EQ(prairieLearnComplaint(bounded), "");
  EXPECT_EQ(Json::parse(bounded)["tests"][0]["images"].size(), 4u);
  EXPECT_EQ(json(MarksFormat::PrairieLearn)["gradable"], true);
  marks.rows.resize(1);
  EXPECT_EQ(json(MarksFormat::PrairieLearn)["gradable"], false);
}

// A right picture's difference is black; one without its ambient term is darker everywhere.
TEST(ClassMarks, ShowTheDifference) {
  const TemporaryFolder folder;
  const Scene scene = readScene("bench-n3");
  PictureSettings settings = scene.settings;
  settings.camera = scene.camera, settings.width = 160, settings.height = 120;
  const CellPlan plan;
  Marker marker{scene, settings, {}, true};
  for (const Mistake mistake : {Mistake::None, Mistake::NoAmbient}) {
    PictureSettings s = settings;
    s.light.mistake = mistake;
    const Picture picture = makePicture(scene, s, plan[Cell::Well]);
    const std::string name = mistake == Mistake::None ? "right.png" : "wrong.png";
    writePng(folder.file(name), picture.image(), picture.palette(plan));
    const MarkedFile row = marker.mark(folder.path().string(), name);
    ASSERT_EQ(row.pictures.size(), 3u);
    folder.write("shown.png", row.pictures[2].png);
    const RgbImage apart = readPng(folder.file("shown.png"));
    EXPECT_EQ(std::ranges::count(apart.rgb, 0) == std::ssize(apart.rgb), mistake == Mistake::None);
  }
}

}  // namespace xnewell::THIS_FILE
