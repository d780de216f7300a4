#include "x11/homework/marks_formats.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <nlohmann/json.hpp>
#include <sstream>

#include "geometry/files/parse_error.h"
#include "x11/drawing/wording.h"
#include "x11/homework/class_marks.h"
#include "x11/homework/reports.h"

namespace xnewell {

namespace {

using Json = nlohmann::ordered_json;
using Rows = std::span<const MarkedFile>;

struct Points {
  double earned = 0, most = 0;
};
Points pointsOf(Rows rows) {
  Points all;
  for (const MarkedFile& row : rows) all.earned += row.points, all.most += row.most;
  return all;
}

std::string text(double points) { return significant(points, 4); }
std::string text(const Points& points) {
  return text(points.earned) + " of " + text(points.most) + " points";
}

/// What a row is about: its stage, or its file.
std::string nameOf(const MarkedFile& row) { return row.stage.empty() ? visible(row.file) : row.stage; }
std::string nameOf(Rows rows) { return visible(rows[0].student.empty() ? rows[0].file : rows[0].student); }

std::string whereOf(const MarkedFile& row) {
  if (!row.pixel) return "";
  return "pixel " + std::to_string(row.pixel->first) + "," + std::to_string(row.pixel->second) +
         (row.face ? ", face " + std::to_string(*row.face) : "");
}
bool isFull(const MarkedFile& row) { return row.points >= row.most; }
std::string wordsOf(const MarkedFile& row) {
  const std::string where = whereOf(row);
  return visible(row.words) + (where.empty() ? "" : " (" + where + ")");
}

/// ---- CSV

std::string csvLine(const std::vector<std::string>& fields) {
  std::string line;
  for (std::string field : fields) {
    if (!field.empty() && std::string_view{"=+-@"}.find(field[0]) != std::string_view::npos)
      field.insert(0, 1, '\'');
    if (field.find_first_of(",\"\n\r") != std::string::npos) {
      for (std::size_t k = 0; (k = field.find('"', k)) != std::string::npos; k += 2) field.insert(k, 1, '"');
      field = '"' + field + '"';
    }
    line += field + ',';
  }
  line.back() = '\n';
  return line;
}

std::string asCsv(const ClassMarks& marks) {
  const auto share = [](const std::optional<double>& v) { return v ? fixed(*v, 3) : ""; };
  std::string csv;
  if (marks.stages.empty()) {
    const bool named =
        std::ranges::any_of(marks.rows, [](const MarkedFile& r) { return !r.student.empty(); });
    csv = "file,verdict,mistakes,term,explained,informative,pixel,face,answers,words";
    csv += named ? ",student\n" : "\n";
    for (const MarkedFile& row : marks.rows) {
      std::vector<std::string> fields{
          visible(row.file),
          row.verdict,
          row.mistakes,
          row.terms,
          share(row.explained),
          share(row.informative),
          row.pixel ? std::to_string(row.pixel->first) + ' ' + std::to_string(row.pixel->second) : "",
          row.face ? std::to_string(*row.face) : "",
          row.asked > 0 ? std::to_string(row.right) + " of " + std::to_string(row.asked) : "",
          visible(row.words)};
      if (named) fields.push_back(visible(row.student));
      csv += csvLine(fields);
    }
    return wellFormed(csv);
  }
  std::vector<std::string> head{"student", "points", "of"};
  head.insert(head.end(), marks.stages.begin(), marks.stages.end());
  head.emplace_back("words");
  csv = csvLine(head);
  for (const Rows rows : byStudent(marks)) {
    const Points all = pointsOf(rows);
    std::vector<std::string> fields{visible(rows[0].student), text(all.earned), text(all.most)};
    std::string words;
    for (const MarkedFile& row : rows) {
      fields.push_back(text(row.points));
      if (!isFull(row)) words += (words.empty() ? "" : "; ") + row.stage + ": " + wordsOf(row);
    }
    fields.push_back(words);
    csv += csvLine(fields);
  }
  return wellFormed(csv);
}

/// ---- HTML

std::string figuresOf(const MarkedFile& row) {
  std::string all;
  for (const MarkedFile::Shown& one : row.pictures)
    all += "<figure>" + imageElement(one.png) + element("figcaption", one.label) + "</figure>\n";
  return all;
}

std::string asHtml(const ClassMarks& marks) {
  std::string page = R"(<!DOCTYPE html>
<html lang="en">
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; img-src data:; style-src 'unsafe-inline'">
<style>
body { font: 11pt/1.4 sans-serif; margin: 2em }
table { border-collapse: collapse }
td, th { border-top: 1px solid #bbb; padding: 0.4em 0.8em; text-align: left; vertical-align: top }
figure { display: inline-block; margin: 0 0.4em 0 0 }
figcaption { font-size: smaller }
img { max-width: 240px; image-rendering: pixelated }
</style>
)";
  page += element("title", marks.title) + element("h1", marks.title);
  std::istringstream summary{summaryOf(marks)};
  for (std::string line; std::getline(summary, line);) page += element("p", line);
  const bool staged = !marks.stages.empty();
  if (staged) {
    page += "<table>\n<tr><th>student</th>";
    for (const std::string& stage : marks.stages) page += element("th", stage);
    page += "<th>points</th></tr>\n";
    for (const Rows rows : byStudent(marks)) {
      page += "<tr>" + element("td", visible(rows[0].student));
      for (const MarkedFile& row : rows) page += element("td", text(row.points));
      page += element("td", text(pointsOf(rows))) + "</tr>\n";
    }
    page += "</table>\n<p></p>\n";
  }
  page += "<table>\n<tr><th>file</th><th>picture</th><th>verdict</th><th>where</th></tr>\n";
  for (const MarkedFile& row : marks.rows)
    page += "<tr>" +
            element("td", row.file.empty() ? visible(row.student) + ": " + row.stage : visible(row.file)) +
            "<td>" + figuresOf(row) + "</td>" + element("td", visible(row.words)) +
            element("td", whereOf(row)) + "</tr>\n";
  return wellFormed(page + "</table>\n</html>\n");
}

/// ---- Results of course systems

/// JSON is UTF-8.
std::string dumped(const Json& json) { return json.dump(2) + '\n'; }

std::string asGradescope(const ClassMarks& marks) {
  Json tests = Json::array();
  for (const MarkedFile& row : marks.rows)
    tests.push_back({{"score", row.points},
                     {"max_score", row.most},
                     {"status", isFull(row) ? "passed" : "failed"},
                     {"name", wellFormed(nameOf(row))},
                     {"name_format", "text"},
                     {"output", wellFormed(element("p", wordsOf(row)) + figuresOf(row))},
                     {"output_format", "html"},
                     {"visibility", "visible"}});
  return dumped({{"score", pointsOf(marks.rows).earned},
                 {"output", text(pointsOf(marks.rows))},
                 {"output_format", "text"},
                 {"stdout_visibility", "hidden"},
                 {"tests", tests}});
}

/// The runner sets these.
constexpr std::array kClassroom50{"CLASSROOM",      "ASSIGNMENT", "ASSIGNMENT_TYPE", "USERNAME",
                                  "SUBMISSION_TAG", "COMMIT_URL", "RELEASE_URL"};
std::string variable(const char* name, const char* usual = "") {
  const char* const value = std::getenv(name);
  return wellFormed(value != nullptr && *value != '\0' ? value : usual);
}
/// Whole points alone, so they are rounded down.
std::string asClassroom50(const ClassMarks& marks) {
  const auto whole = [](double points) { return static_cast<std::int64_t>(std::floor(points)); };
  Json tests = Json::array();
  std::int64_t score = 0, most = 0;
  for (const MarkedFile& row : marks.rows) {
    tests.push_back({{"test-name", wellFormed(nameOf(row))},
                     {"passed", isFull(row)},
                     {"score", whole(row.points)},
                     {"max-score", whole(row.most)},
                     {"message", wellFormed(wordsOf(row))}});
    score += whole(row.points), most += whole(row.most);
  }
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  std::array<char, 32> instant{};
  std::strftime(instant.data(), instant.size(), "%Y-%m-%dT%H:%M:%SZ", ::gmtime_r(&now, &utc));
  return dumped({{"schema", "classroom50/result/v1"},
                 {"classroom", variable("CLASSROOM")},
                 {"assignment", variable("ASSIGNMENT")},
                 {"assignment_type", variable("ASSIGNMENT_TYPE")},
                 {"owner", variable("USERNAME")},
                 {"submission", variable("SUBMISSION_TAG")},
                 {"commit", variable("COMMIT_URL")},
                 {"release", variable("RELEASE_URL")},
                 {"review", variable("REVIEW_URL", std::getenv("COMMIT_URL"))},
                 {"datetime", instant.data()},
                 {"score", score},
                 {"max-score", most},
                 {"tests", tests}});
}

/// The file may have 1 MB. Pictures for which there is no room are left out.
constexpr std::size_t kMostImages = 700'000;

std::string asPrairieLearn(const ClassMarks& marks) {
  Json tests = Json::array(), errors = Json::array();
  std::size_t bytes = 0;
  for (const MarkedFile& row : marks.rows) {
    Json images = Json::array();
    for (const MarkedFile::Shown& one : row.pictures)
      if (Json image{{"label", one.label}, {"url", imageUrl(one.png)}};
          bytes + image.dump().size() < kMostImages) {
        bytes += image.dump().size();
        images.push_back(std::move(image));
      }
    tests.push_back({{"name", wellFormed(nameOf(row))},
                     {"points", row.points},
                     {"max_points", row.most},
                     {"message", wellFormed(wordsOf(row))},
                     {"images", std::move(images)}});
    if (row.verdict == "unreadable") errors.push_back(wellFormed(row.words));
  }
  const Points all = pointsOf(marks.rows);
  const bool gradable = errors.size() < marks.rows.size();
  Json result{{"gradable", gradable},
              {"score", all.most > 0 ? all.earned / all.most : 0.0},
              {"message", text(all)},
              {"tests", std::move(tests)}};
  if (!gradable) result["format_errors"] = std::move(errors);
  return dumped(result);
}

std::string asJUnit(const ClassMarks& marks) {
  const auto attribute = [](std::string_view name, const std::string& value) {
    return ' ' + std::string{name} + "=\"" + inHtml(wellFormed(value)) + '"';
  };
  const auto counts = [&](Rows rows) {
    return attribute("tests", std::to_string(rows.size())) +
           attribute("failures", std::to_string(rows.size() - std::ranges::count_if(rows, isFull))) +
           attribute("errors", "0");
  };
  std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites" +
                    attribute("name", marks.title) + counts(marks.rows) + ">\n";
  for (const Rows rows : byStudent(marks)) {
    const std::string student = nameOf(rows);
    xml += "<testsuite" + attribute("name", student) + counts(rows) + ">\n";
    for (const MarkedFile& row : rows) {
      xml += "<testcase" + attribute("classname", student) + attribute("name", nameOf(row)) + ">\n";
      if (!isFull(row))
        xml += "<failure" + attribute("type", row.verdict) + attribute("message", wordsOf(row)) + "/>\n";
      xml += element("system-out", wellFormed(text(Points{row.points, row.most}) + ": " + wordsOf(row))) +
             "</testcase>\n";
    }
    xml += "</testsuite>\n";
  }
  return xml + "</testsuites>\n";
}

}  // namespace

constinit const std::array<MarksFormatRow, 6> kMarksFormats{
    MarksFormatRow{MarksFormat::Csv, "csv", asCsv},
    MarksFormatRow{MarksFormat::Html, "html", asHtml, true},
    MarksFormatRow{MarksFormat::Gradescope, "gradescope", asGradescope, true, true},
    MarksFormatRow{MarksFormat::Classroom50, "classroom50", asClassroom50, false, true, kClassroom50},
    MarksFormatRow{MarksFormat::PrairieLearn, "prairielearn", asPrairieLearn, true, true},
    MarksFormatRow{MarksFormat::JUnit, "junit", asJUnit},
};

}  // namespace xnewell
