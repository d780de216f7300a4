#include "x11/homework/marks_formats.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "shading/color/png.h"
#include "tests/support/temporary_folder.h"
#include "x11/homework/class_marks.h"
#include "x11/homework/hand_ins.h"

namespace xnewell::THIS_FILE {

namespace {

using Json = nlohmann::json;
using Strings = std::vector<std::string>;

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

const std::set<std::string> kVisible{"hidden", "after_due_date", "after_published", "visible"},
    kFormats{"text", "simple_format", "html", "md", "ansi"};
/// gradescope-autograders.readthedocs.io, "Autograder Specifications", "Output format".
const Members kGradescope{{"", 'o'},
                          {"/score", 'n'},
                          {"/execution_time", 'n'},
                          {"/output"},
                          {"/output_format", 's', false, kFormats},
                          {"/test_output_format", 's', false, kFormats},
                          {"/test_name_format", 's', false, kFormats},
                          {"/visibility", 's', false, kVisible},
                          {"/stdout_visibility", 's', false, kVisible},
                          {"/extra_data", 'o'},
                          {"/tests", 'l', true},
                          {"/tests/*", 'o'},
                          {"/tests/*/score", 'n', true},
                          {"/tests/*/max_score", 'n'},
                          {"/tests/*/status", 's', false, {"passed", "failed"}},
                          {"/tests/*/name"},
                          {"/tests/*/name_format", 's', false, kFormats},
                          {"/tests/*/number"},
                          {"/tests/*/output"},
                          {"/tests/*/output_format", 's', false, kFormats},
                          {"/tests/*/tags", 'l'},
                          {"/tests/*/tags/*"},
                          {"/tests/*/visibility", 's', false, kVisible},
                          {"/tests/*/extra_data", 'o'}};
/// Classroom 50's wiki, "Advanced Autograding", "The result.json contract".
const Members kClassroom50{{"", 'o'},
                           {"/schema", 's', true, {"classroom50/result/v1"}},
                           {"/classroom", 't', true},
                           {"/assignment", 't', true},
                           {"/assignment_type", 's', true, {"individual", "group"}},
                           {"/owner", 't', true},
                           {"/submission", 't', true},
                           {"/commit", 't', true},
                           {"/release", 't', true},
                           {"/review", 't', true},
                           {"/datetime", 't', true},
                           {"/graded_at", 't'},
                           {"/score", 'i', true},
                           {"/max-score", 'i', true},
                           {"/tests", 'l', true},
                           {"/tests/*", 'o'},
                           {"/tests/*/test-name", 't', true},
                           {"/tests/*/passed", 'b', true},
                           {"/tests/*/score", 'i', true},
                           {"/tests/*/max-score", 'i', true},
                           {"/tests/*/message"}};  // "extra diagnostic fields are preserved"
/// PrairieLearn's documentation, "External grading", "Grading results".
const Members kPrairieLearn{{"", 'o'},
                            {"/gradable", 'b'},
                            {"/score", 'n', true},
                            {"/message"},
                            {"/output"},
                            {"/format_errors", 'l'},
                            {"/format_errors/*"},
                            {"/images", 'l'},
                            {"/images/*", 'o'},
                            {"/images/*/label"},
                            {"/images/*/url", 't', true},
                            {"/tests", 'l'},
                            {"/tests/*", 'o'},
                            {"/tests/*/name", 't', true},
                            {"/tests/*/description"},
                            {"/tests/*/points", 'n', true},
                            {"/tests/*/max_points", 'n', true},
                            {"/tests/*/message"},
                            {"/tests/*/output"},
                            {"/tests/*/images", 'l'},
                            {"/tests/*/images/*", 'o'},
                            {"/tests/*/images/*/label"},
                            {"/tests/*/images/*/url", 't', true}};

const std::string kDocumentedGradescope = R"({"score": 44.0, "execution_time": 136, "output": "of all",
    "output_format": "simple_format", "test_output_format": "text", "visibility": "after_due_date",
    "stdout_visibility": "visible", "extra_data": {}, "tests": [{"score": 2.0, "max_score": 2.0,
    "status": "passed", "name": "a name", "name_format": "text", "number": "1.1", "output": "many lines",
    "output_format": "text", "tags": ["tag1", "tag2"], "visibility": "visible", "extra_data": {}}]})",
                  kDocumentedClassroom50 = R"({"schema": "classroom50/result/v1", "classroom": "principles",
    "assignment": "hello", "assignment_type": "individual", "owner": "alice",
    "submission": "submit/2026-06-01T14-32-05Z-a1b2c3d", "commit": "https://host/commit/SHA",
    "release": "https://host/releases/tag/submit%2F", "review": "https://host/compare/A...B",
    "datetime": "2026-06-01T14:32:01Z", "graded_at": "2026-06-01T14:33:11Z", "score": 4, "max-score": 5,
    "tests": [{"test-name": "compiles", "passed": true, "score": 4, "max-score": 4},
              {"test-name": "correct", "passed": false, "score": 0, "max-score": 1}]})",
                  kDocumentedPrairieLearn = R"({"gradable": true, "score": 0.25, "message": "done",
    "output": "Test 1 passed", "images": [{"label": "First", "url": "data:image/png;base64,AAAA"}],
    "tests": [{"name": "Test 1", "description": "a thing", "points": 1, "max_points": 1, "message": "none",
    "output": "matched"}, {"name": "Test 2", "points": 0, "max_points": 3,
    "images": [{"label": "First", "url": "data:image/gif;base64,AAAA"}]}]})";

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

/// The elements of an XML file, with what stands in them. It throws for what is not well-formed.
struct Element {
  std::string name, text;
  std::map<std::string, std::string> attributes;
  std::vector<Element> children;
};
class Xml {
 public:
  explicit Xml(std::string text) : text_{std::move(text)} {
    (void)Json(text_).dump();  // throws for what is not UTF-8
    for (const char c : text_)
      if (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t' && c != '\r')
        fail("control character");
    for (const char* none : {"\xEF\xBF\xBE", "\xEF\xBF\xBF"})
      if (text_.find(none) != std::string::npos) fail("no character");
  }
  Element root() {
    if (text_.starts_with("<?xml")) at_ = text_.find("?>") + 2;
    blanks();
    Element all = element();
    blanks();
    if (at_ != text_.size()) fail("text after the end");
    return all;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw std::runtime_error{what + " at " + std::to_string(at_)};
  }
  void blanks() { at_ = std::min(text_.find_first_not_of(" \n", at_), text_.size()); }
  bool take(std::string_view word) {
    if (text_.compare(at_, word.size(), word) != 0) return false;
    at_ += word.size();
    return true;
  }
  std::string name() {
    const std::size_t from = at_;
    while (at_ < text_.size() &&
           (std::isalnum(static_cast<unsigned char>(text_[at_])) != 0 || text_[at_] == '-'))
      ++at_;
    if (at_ == from) fail("no name");
    return text_.substr(from, at_ - from);
  }
  std::string words(std::string_view ends) {
    std::string all;
    for (; at_ < text_.size() && ends.find(text_[at_]) == ends.npos; ++at_) {
      if (text_.compare(at_, 3, "]]>") == 0 || (text_[at_] == '<')) fail("bare mark");
      if (text_[at_] != '&') {
        all += text_[at_];
        continue;
      }
      const std::size_t end = text_.find(';', at_);
      const std::map<std::string, char> kEntities{{"amp", '&'}, {"lt", '<'}, {"gt", '>'}, {"quot", '"'}};
      const auto entity = kEntities.find(text_.substr(at_ + 1, end - at_ - 1));
      if (entity == kEntities.end()) fail("entity");
      all += entity->second, at_ = end;
    }
    return all;
  }
  Element element() {
    Element one;
    if (!take("<")) fail("no element");
    one.name = name();
    for (blanks(); !take(">"); blanks()) {
      if (take("/>")) return one;
      const std::string key = name();
      if (!take("=\"") || one.attributes.contains(key)) fail("attribute");
      one.attributes[key] = words("\"");
      if (!take("\"")) fail("quote");
    }
    for (;;) {
      one.text += words("<");
      if (take("</")) break;
      one.children.push_back(element());
    }
    if (name() != one.name || !take(">")) fail("end of " + one.name);
    return one;
  }

  std::string text_;
  std::size_t at_ = 0;
};

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
std::string junitComplaint(const Element& one) {
  const auto rule = kJUnit.find(one.name);
  if (rule == kJUnit.end()) return one.name + " is not documented";
  for (const std::string& must : rule->second.must)
    if (!one.attributes.contains(must)) return one.name + " lacks " + must;
  for (const auto& [key, value] : one.attributes)
    if (!rule->second.must.contains(key) && !rule->second.may.contains(key)) return one.name + " has " + key;
  int cases = 0, failures = 0;
  for (const Element& child : one.children) {
    if (!rule->second.children.contains(child.name)) return child.name + " in " + one.name;
    if (const std::string what = junitComplaint(child); !what.empty()) return what;
    cases += child.name == "testcase";
    failures += std::ranges::count(child.children, "failure", &Element::name) > 0;
  }
  if (one.name != "testsuite") return "";
  const auto& has = one.attributes;
  return has.at("tests") == std::to_string(cases) && has.at("failures") == std::to_string(failures)
             ? ""
             : "counts";
}
std::string junitComplaint(const std::string& file) { return junitComplaint(Xml{file}.root()); }
const std::string kDocumentedJUnit = R"(<?xml version="1.0" encoding="UTF-8"?>
<testsuites name="all"><testsuite name="one" tests="2" failures="1" errors="0" time="0.1">
<testcase classname="a" name="b" time="0.1"/><testcase name="c"><failure type="x" message="y">z &amp; w</failure>
<system-out>words</system-out></testcase></testsuite></testsuites>)";

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
  std::string example = {};  ///< as the documentation has it
  std::vector<std::pair<std::string, std::string>> spoilt =
      {};  ///< in the example: this in the place of that
};
const std::vector<Checker> kCheckers{
    {MarksFormat::Csv, csvComplaint, "a,b\n\"c,\"\"d\",e\n", {{"b\n", "b,\n"}, {"e", "=e"}}},
    {MarksFormat::Html,
     htmlComplaint,
     "<!DOCTYPE html>\n<html lang=\"en\"><td>a &lt;b></td>",
     {{"&lt;", "<"}, {"<td>", "<script>"}, {"<td>", "<td onclick=\"x\">"}}},
    {MarksFormat::Gradescope,
     gradescopeComplaint,
     kDocumentedGradescope,
     {{"\"score\": 2.0,", ""}, {"\"passed\"", "\"right\""}, {"\"text\"", "\"htm\""}, {"2.0", "\"2\""}}},
    {MarksFormat::Classroom50,
     classroom50Complaint,
     kDocumentedClassroom50,
     {{"/v1", "/v2"},
      {"\"score\": 4,", "\"score\": 4.5,"},
      {"submit/", "main/"},
      {"true", "1"},
      {"\"owner\"", "\"name\""},
      {"T14:32:01Z", " 14:32:01"},
      {"\"max-score\": 4", "\"max-score\": 3"}}},
    {MarksFormat::PrairieLearn,
     prairieLearnComplaint,
     kDocumentedPrairieLearn,
     {{"0.25", "2.5"},
      {"\"score\"", "\"points\""},
      {"\"url\"", "\"src\""},
      {"\"points\": 0", "\"points\": null"}}},
    {MarksFormat::JUnit,
     junitComplaint,
     kDocumentedJUnit,
     {{"&amp;", "&"},
      {"tests=\"2\"", "tests=\"3\""},
      {" name=\"c\"", ""},
      {"<failure", "<fail"},
      {"words", "]]>"},
      {"/>", ">"}}},
};

/// Names that nobody should have.
const Strings kNames{"anna",
                     "=cmd|' /C calc'!A0",
                     "+1",
                     "-1",
                     "@SUM(A1)",
                     "\"quoted\", 'twice'",
                     "two\nlines\r\n",
                     "\ttab",
                     "<script>alert(1)</script>",
                     "</td></tr><img src=x onerror=alert(1)>",
                     "a]]>b",
                     "&amp; &#0; &copy",
                     std::string{"\x01\x1b[31m\x7f\0", 8},
                     "\xFF\xC3(",
                     "\xED\xA0\x80 \xF5\x80\x80\x80 \xC0\xAF",
                     "\xEF\xBF\xBE\xEF\xBF\xBF",
                     "\u00c9mile \u4e2d \U0001F600",
                     "\xc9mile",
                     "{\"a\": 1}\\u0000\\",
                     "; rm -rf /",
                     "=\u202ecod.exe"};

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
    EXPECT_EQ(checker.complaint(checker.example), "");
    for (const auto& [from, to] : checker.spoilt) {
      std::string spoilt = checker.example;
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
        for (const Element all = Xml{file}.root(); const Element& suite : all.children)
          names.insert(suite.attributes.at("name"));
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

// Files are found as course systems give them. What leads round, or is hidden, is counted.
TEST(HandIns, AreFoundAsCourseSystemsGiveThem) {
  const TemporaryFolder folder;
  const auto make = [&](const std::string& path) {
    std::filesystem::create_directories(folder.path() / std::filesystem::path{path}.parent_path());
    folder.write(path, "");
  };
  for (const char* path :
       {"anna/flat.PNG", "anna/deep/er/order.jsonl", "anna/notes.txt", "anna/.hidden.png",
        "__MACOSX/._flat.png", "bert/readme.md", "own.ppm", "Clea Ott_17_assignsubmission_file_/flat.png",
        "Clea Ott_18_assignsubmission_file_/flat.png", "Dan D_9_assignsubmission_file_a_b.png",
        "_assignsubmission_file_x.png", "E_assignsubmission_file_y.png", ".git/x.png"})
    make(path);
  std::filesystem::create_symlink("..", folder.file("anna/loop"));
  std::filesystem::create_symlink("anna", folder.file("zoe"));
  std::filesystem::create_symlink("round.png", folder.file("round.png"));
  const HandIns found = handInsOf(folder.path().string());
  std::vector<Strings> rows;
  for (const HandIn& one : found.files) rows.push_back({one.student, one.path, one.name, one.place});
  const std::vector<Strings> expected{
      {"", "E_assignsubmission_file_y.png", "E_assignsubmission_file_y.png", ""},
      {"", "_assignsubmission_file_x.png", "_assignsubmission_file_x.png", ""},
      {"", "own.ppm", "own.ppm", ""},
      {"", "round.png", "round.png", ""},
      {"Clea Ott (17)", "Clea Ott_17_assignsubmission_file_/flat.png", "flat.png",
       "Clea Ott_17_assignsubmission_file_/"},
      {"Clea Ott (18)", "Clea Ott_18_assignsubmission_file_/flat.png", "flat.png",
       "Clea Ott_18_assignsubmission_file_/"},
      {"Dan D", "Dan D_9_assignsubmission_file_a_b.png", "a_b.png", "Dan D_9_assignsubmission_file_"},
      {"anna", "anna/deep/er/order.jsonl", "order.jsonl", "anna/"},
      {"anna", "anna/flat.PNG", "flat.PNG", "anna/"},
      {"bert", "bert", "", "bert/"}};
  EXPECT_EQ(rows, expected);
  EXPECT_EQ(
      sentenceOf(found.passed),
      "passed over: 3 hidden files (.git, __MACOSX, anna/.hidden.png), 2 linked folders (anna/loop, zoe), "
      "2 other files (anna/notes.txt, bert/readme.md)");
  EXPECT_THROW((void)handInsOf(folder.file("none")), std::system_error);
}

}  // namespace xnewell::THIS_FILE
