#include "x11/homework/class_marks.h"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <new>
#include <set>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include "geometry/files/parse_error.h"
#include "geometry/files/text_file.h"
#include "geometry/files/visible.h"
#include "shading/color/png.h"
#include "shading/picture/picture_cache.h"
#include "x11/drawing/wording.h"
#include "x11/homework/answer_file.h"
#include "x11/homework/html.h"
#include "x11/homework/judge_run.h"
#include "x11/homework/reports.h"

namespace xnewell {

namespace {

constexpr std::size_t kMostSizes = 4;  ///< of pictures, for which what they share is kept
constexpr int kSmallWidth = 240;       ///< of a picture on the page, in pixels

/// A picture at most kSmallWidth wide: every n-th pixel of it.
std::string smallPng(const RgbImage& image) {
  const int step = std::max(1, (std::max(image.width, image.height) + kSmallWidth - 1) / kSmallWidth);
  RgbImage small{(image.width + step - 1) / step, (image.height + step - 1) / step};
  for (int j = 0; j < small.height; ++j)
    for (int i = 0; i < small.width; ++i) std::copy_n(image.pixel(i * step, j * step), 3, small.pixel(i, j));
  return encodePng(small);
}

std::string csvField(const std::string& text) {
  std::string field = text;
  if (!field.empty() && std::string_view{"=+-@"}.find(field[0]) != std::string_view::npos)
    field.insert(0, 1, '\'');
  if (field.find_first_of(",\"\n\r") == std::string::npos) return field;
  std::string quoted = "\"";
  for (const char c : field) quoted += c == '"' ? std::string{"\"\""} : std::string{c};
  return quoted + '"';
}

std::string share(const std::optional<double>& v) { return v ? fixed(*v, 3) : ""; }

}  // namespace

Marker::Marker(Scene scene, PictureSettings settings, std::optional<glm::ivec2> size, bool pictures,
               RightAnswer rightAnswer)
    : scene_{std::move(scene)},
      settings_{std::move(settings)},
      size_{size},
      pictures_{pictures},
      rightAnswer_{std::move(rightAnswer)} {}

void Marker::markPicture(MarkedFile& row, const std::string& path) {
  const HandedIn handed = readHandedIn(path);
  const glm::ivec2 size = size_.value_or(glm::ivec2{handed.picture.width, handed.picture.height});
  if (diagnosers_.size() >= kMostSizes && !diagnosers_.contains({size.x, size.y})) diagnosers_.clear();
  std::unique_ptr<Diagnoser>& diagnoser = diagnosers_[{size.x, size.y}];
  if (!diagnoser) {
    PictureSettings settings = settings_;
    settings.width = size.x, settings.height = size.y;
    if (const std::string why = whyNotDiagnosed(scene_, settings); !why.empty())
      throw std::invalid_argument{why};
    diagnoser = std::make_unique<Diagnoser>(scene_, settings);
  }
  const Diagnosis d = (*diagnoser)(handed);
  row.verdict = nameOf(d.verdict), row.words = verdictOf(d);
  std::set<std::string_view> terms;
  std::set<std::string> names;
  if (d.verdict == Marking::Outlines) row.mistakes = "outlines", row.pixel = {d.outlines.i, d.outlines.j};
  for (const Fit& fit : d.found) {
    if (d.verdict == Marking::Right || d.verdict == Marking::Outlines) break;
    if (names.insert(nameOf(fit)).second) row.mistakes += (row.mistakes.empty() ? "" : " ") + nameOf(fit);
    if (terms.insert(fit.first->term).second)
      row.terms += (row.terms.empty() ? "" : "; ") + std::string{fit.first->term};
  }
  if (!d.found.empty()) row.explained = d.found[0].explained, row.informative = d.found[0].informative;
  if (d.pixel) row.pixel = {d.pixel->i, d.pixel->j}, row.face = d.pixel->face;
  if (pictures_) row.picture = smallPng(handed.picture);
}

const Picture& Marker::planesAt(glm::ivec2 size) {
  if (planes_.size() >= kMostSizes && !planes_.contains({size.x, size.y})) planes_.clear();
  auto planes = planes_.find({size.x, size.y});
  if (planes == planes_.end()) {
    PictureSettings settings = settings_;
    settings.order = Order::Unsorted;
    settings.width = size.x, settings.height = size.y;
    planes = planes_.emplace(std::pair{size.x, size.y}, makePicture(scene_, settings).withPlanes()).first;
  }
  return planes->second;
}

void Marker::markOrder(MarkedFile& row, const std::string& path) {
  const glm::ivec2 usual = size_.value_or(glm::ivec2{settings_.width, settings_.height});
  glm::ivec2 size = usual;
  if (isRunFile(path)) {
    const RunFile run{path};
    size = run.size().value_or(usual);
    const RunReport report = judgeRun(planesAt(size), run);
    row.verdict = report.wrong.empty() ? "right" : "wrong", row.words = verdictOf(report);
    for (const FalseStep& step : report.wrong)
      row.mistakes += (row.mistakes.empty() ? "" : " ") + std::string{nameOf(step.kind)};
  } else {
    const auto [steps, own] = readPaintOrder(path, scene_.mesh.faceCount());
    size = own.value_or(usual);
    const OrderReport report = judgeOrder(planesAt(size), steps);
    row.verdict = report.isRight() ? "right" : "wrong", row.words = verdictOf(report, steps);
    if (!report.isRight()) row.mistakes = kindOf(report);
    if (report.first) {
      row.pixel = {report.first->i, report.first->j};
      row.face = steps[report.first->shown].face;
    }
  }
  if (row.verdict != "right") row.terms = "order";
  if (size != usual) row.words += "; judged at " + sizeText(size.x, size.y);
}

void Marker::markAnswers(MarkedFile& row, const std::string& path) const {
  std::set<std::pair<std::string, int>> seen;
  std::set<std::string> lessons;
  for (const AnsweredQuestion& one : readAnswers(path)) {
    const std::string where = "step " + std::to_string(one.step) + " of " + inQuotes(one.lesson);
    const int right = rightAnswer_(one.lesson, one.step).value_or(one.right);
    if (right < 0) throw ParseError{path, 0, where + " asks nothing"};
    if (!seen.emplace(one.lesson, one.step).second) throw ParseError{path, 0, where + " is answered twice"};
    lessons.insert(one.lesson);
    ++row.asked;
    row.right += one.tries.front() == right;
  }
  row.verdict = "answers";
  row.words = std::to_string(row.right) + " of " + std::to_string(row.asked) +
              " right at the first try, in " + counted(std::ssize(lessons), "lesson");
}

MarkedFile Marker::mark(const std::string& folder, const std::string& name) {
  MarkedFile row{.file = name};
  const std::string path = (std::filesystem::path{folder} / name).string();
  try {
    if (name.ends_with(".jsonl"))
      markOrder(row, path);
    else if (name.ends_with(".json"))
      markAnswers(row, path);
    else
      markPicture(row, path);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& e) {
    row = {.file = name, .verdict = "unreadable"};
    std::string what = e.what();
    if (what.starts_with(path)) what = name + what.substr(path.size());
    row.words = "unreadable: " + what;
  }
  return row;
}

/// True if a file is handed in by its name: a picture of any kind, also of those that cannot be read, an
/// order, or answers; also a folder or a link to nothing of such a name. A text that explains the folder is
/// not.
bool isHandedIn(std::string name) {
  for (char& c : name)
    if ('A' <= c && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  for (const char* end : {".jsonl", ".json", ".png", ".ppm", ".pgm", ".pnm", ".xwd", ".jpg", ".jpeg", ".gif",
                          ".bmp", ".tif", ".tiff", ".webp"})
    if (name.ends_with(end)) return true;
  return false;
}

std::vector<std::string> handedInFiles(const std::string& folder) {
  std::vector<std::string> names;
  std::error_code error;
  std::filesystem::directory_iterator entries{folder, error};
  if (error) throw std::system_error{error.value(), std::generic_category(), folder};
  for (const auto& entry : entries) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with('.') && isHandedIn(name)) names.push_back(name);
  }
  std::ranges::sort(names);
  return names;
}

std::string marksAsCsv(const std::vector<MarkedFile>& rows) {
  std::string csv = "file,verdict,mistakes,term,explained,informative,pixel,face,answers,words\n";
  for (const MarkedFile& row : rows) {
    const std::string pixel =
        row.pixel ? std::to_string(row.pixel->first) + ' ' + std::to_string(row.pixel->second) : "";
    bool first = true;
    for (const std::string& field :
         {visible(row.file), row.verdict, row.mistakes, row.terms, share(row.explained),
          share(row.informative), pixel, row.face ? std::to_string(*row.face) : "",
          row.asked > 0 ? std::to_string(row.right) + " of " + std::to_string(row.asked) : "",
          visible(row.words)}) {
      csv += (first ? "" : ",") + csvField(field);
      first = false;
    }
    csv += '\n';
  }
  return csv;
}

std::string summaryOf(const std::vector<MarkedFile>& rows) {
  std::map<std::string, int> verdicts, mistakes;
  int right = 0, asked = 0;
  for (const MarkedFile& row : rows) {
    ++verdicts[row.verdict];
    right += row.right, asked += row.asked;
    if (row.verdict == "allowed") continue;
    std::string names = row.mistakes;
    std::ranges::replace(names, '+', ' ');
    std::istringstream words{names};
    for (std::string word; words >> word;) ++mistakes[word];
  }
  const auto listed = [](const std::map<std::string, int>& counts) {
    std::vector<std::pair<int, std::string>> all;
    for (const auto& [name, count] : counts) all.emplace_back(-count, name);
    std::ranges::sort(all);
    std::string words;
    for (const auto& [count, name] : all)
      words += (words.empty() ? "" : ", ") + std::to_string(-count) + ' ' + name;
    return words;
  };
  std::string summary =
      counted(static_cast<std::int64_t>(rows.size()), "file") + ": " + listed(verdicts) + '\n';
  if (!mistakes.empty()) summary += "mistakes: " + listed(mistakes) + '\n';
  if (asked > 0)
    summary +=
        "answers: " + std::to_string(right) + " of " + std::to_string(asked) + " right at the first try\n";
  return summary;
}

std::string marksAsHtml(const std::string& title, const std::vector<MarkedFile>& rows) {
  std::string page = R"(<!DOCTYPE html>
<html lang="en">
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; img-src data:; style-src 'unsafe-inline'">
<style>
body { font: 11pt/1.4 sans-serif; margin: 2em }
table { border-collapse: collapse }
td, th { border-top: 1px solid #bbb; padding: 0.4em 0.8em; text-align: left; vertical-align: top }
img { max-width: 240px; image-rendering: pixelated }
</style>
)";
  page += element("title", title) + element("h1", title);
  std::istringstream summary{summaryOf(rows)};
  for (std::string line; std::getline(summary, line);) page += element("p", line);
  page += "<table>\n<tr><th>file</th><th>picture</th><th>verdict</th><th>where</th></tr>\n";
  for (const MarkedFile& row : rows) {
    const std::string where = row.pixel ? "pixel " + std::to_string(row.pixel->first) + "," +
                                              std::to_string(row.pixel->second) +
                                              (row.face ? ", face " + std::to_string(*row.face) : "")
                                        : "";
    page += "<tr>" + element("td", visible(row.file)) + "<td>" +
            (row.picture.empty() ? "" : imageElement(row.picture)) + "</td>" +
            element("td", visible(row.words)) + element("td", where) + "</tr>\n";
  }
  return page + "</table>\n</html>\n";
}

}  // namespace xnewell
