#include "x11/homework/class_marks.h"

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <new>
#include <set>
#include <sstream>
#include <stdexcept>

#include "geometry/files/parse_error.h"
#include "geometry/files/text_file.h"
#include "shading/color/png.h"
#include "shading/picture/picture_cache.h"
#include "x11/drawing/wording.h"
#include "x11/homework/hand_ins.h"
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

/// What is the same is black; the difference of a channel counts four times. `faces` are those of the right
/// picture, from 1. Any ground is right if it is one colour.
RgbImage differenceOf(const RgbImage& yours, const RgbImage& right, const std::vector<std::uint32_t>& faces) {
  RgbImage apart{right.width, right.height};
  const auto ground = static_cast<std::size_t>(std::ranges::find(faces, 0U) - faces.begin());
  for (std::size_t k = 0; k < apart.rgb.size(); ++k) {
    const int wanted = faces[k / 3] == 0 ? yours.rgb[3 * ground + k % 3] : right.rgb[k];
    apart.rgb[k] = static_cast<std::uint8_t>(std::min(255, 4 * std::abs(yours.rgb[k] - wanted)));
  }
  return apart;
}

/// What is kept for a size; `make` makes it. Only a few sizes are kept.
template <class Kept, class Make>
Kept& keptFor(std::map<std::pair<int, int>, Kept>& kept, glm::ivec2 size, const Make& make) {
  const std::pair key{size.x, size.y};
  if (const auto at = kept.find(key); at != kept.end()) return at->second;
  if (kept.size() >= kMostSizes) kept.clear();
  return kept.emplace(key, make()).first->second;
}

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
  const std::unique_ptr<Diagnoser>& diagnoser = keptFor(diagnosers_, size, [&] {
    PictureSettings settings = settings_;
    settings.width = size.x, settings.height = size.y;
    if (const std::string why = whyNotDiagnosed(scene_, settings); !why.empty())
      throw std::invalid_argument{why};
    return std::make_unique<Diagnoser>(scene_, settings);
  });
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
  if (pictures_) showPictures(row, handed.picture, *diagnoser);
}

void Marker::showPictures(MarkedFile& row, const RgbImage& yours, Diagnoser& diagnoser) {
  const PictureSettings& settings = diagnoser.picture().settings();
  const RgbImage& right = keptFor(right_, {settings.width, settings.height}, [&] {
    return diagnoser.pictureBy(diagnoser.approachWith(hypotheses().front()));
  });
  row.pictures = {{"yours", smallPng(yours)}, {"right", smallPng(right)}};
  if (yours.width == right.width && yours.height == right.height)
    row.pictures.push_back(
        {"difference x 4", smallPng(differenceOf(yours, right, diagnoser.picture().faceImage()))});
}

const Picture& Marker::planesAt(glm::ivec2 size) {
  return keptFor(planes_, size, [&] {
    PictureSettings settings = settings_;
    settings.order = Order::Unsorted;
    settings.width = size.x, settings.height = size.y;
    return makePicture(scene_, settings).withPlanes();
  });
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

double pointsFor(const MarkedFile& row, double most) {
  if (row.asked > 0) return most * row.right / row.asked;
  return row.verdict == "right" || row.verdict == "allowed" ? most : 0;
}

std::vector<std::span<const MarkedFile>> byStudent(const ClassMarks& marks) {
  std::vector<std::span<const MarkedFile>> all;
  for (std::size_t from = 0, to = 0; from < marks.rows.size(); from = to) {
    const std::string& student = marks.rows[from].student;
    to = from + 1;
    while (to < marks.rows.size() && marks.rows[to].student == student &&
           !(student.empty() && marks.stages.empty()))
      ++to;
    all.push_back(std::span{marks.rows}.subspan(from, to - from));
  }
  return all;
}

std::string summaryOf(const ClassMarks& marks) {
  const std::vector<MarkedFile>& rows = marks.rows;
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
  const auto missing = verdicts.find("missing");
  std::string summary =
      counted(std::ssize(rows) - (missing == verdicts.end() ? 0 : missing->second), "file") + ": " +
      listed(verdicts) + '\n';
  if (!marks.stages.empty()) {
    double points = 0, most = 0;
    for (const MarkedFile& row : rows) points += row.points, most += row.most;
    const std::size_t students = byStudent(marks).size();
    summary += counted(static_cast<std::int64_t>(students), "student") + ": " +
               significant(points / static_cast<double>(students), 4) + " of " +
               significant(most / static_cast<double>(students), 4) + " points in the mean\n";
  }
  if (!mistakes.empty()) summary += "mistakes: " + listed(mistakes) + '\n';
  if (asked > 0)
    summary +=
        "answers: " + std::to_string(right) + " of " + std::to_string(asked) + " right at the first try\n";
  return summary;
}

}  // namespace xnewell
