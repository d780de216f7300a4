#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/files/input_file.h"
#include "geometry/files/output_file.h"
#include "geometry/files/text_file.h"
#include "shading/diagnose/diagnose.h"
#include "shading/diagnose/pair_scene.h"
#include "shading/diagnose/scene_for.h"
#include "shading/picture/picture_cache.h"
#include "x11/command/commands.h"
#include "x11/command/report.h"
#include "x11/homework/class_marks.h"
#include "x11/homework/judge_run.h"
#include "x11/homework/questions.h"
#include "x11/homework/reports.h"
#include "x11/lessons/lesson.h"
#include "x11/options/exit_status.h"
#include "x11/terminal/terminal.h"

namespace xnewell {

namespace {

/// The picture that a file with this size, if it says one, is about.
Picture pictureFor(const Options& options, Scene scene, const std::string& file,
                   std::optional<glm::ivec2> size) {
  if (size && options.size && *size != *options.size)
    throw UsageError{file + " is for a picture of " + sizeText(size->x, size->y) + ", and --size says " +
                     sizeText(options.size->x, options.size->y) + ": leave --size out"};
  PictureSettings settings = settingsOf(options, size.value_or(kPictureSize));
  settings.order = Order::Unsorted, settings.adapt = 0;
  return makePicture(std::move(scene), settings).withPlanes();
}

void refuseWhatIsNotDiagnosed(const Scene& scene, const PictureSettings& settings) {
  if (const std::string why = whyNotDiagnosed(scene, settings); !why.empty()) throw UsageError{why};
}

/// What tells the first two mistakes of a class apart: a picture of a bench with this method and table.
PartedBy partedBy(const Diagnosis& d, const PictureSettings& settings) {
  if (d.verdict != Marking::OneOf || d.found[0].number || d.found[1].number) return {};
  const std::string_view a = d.found[0].first->key, b = d.found[1].first->key;
  std::vector<PartingPicture> pictures = benchPictures();
  std::erase_if(pictures, [&](const PartingPicture& p) {
    return p.method != settings.shading || p.table != settings.table.kind;
  });
  PartedBy parted;
  parted.sentence = partingSentence(a, b, sceneFor(a, b, pictures));
  return parted;
}

/// What a right picture cannot show, and how much of it a bench does, with this method and table.
void addHidden(PartedBy& parted, Diagnoser& diagnoser, const PictureSettings& settings) {
  constexpr std::string_view kBench = "bench-n3";
  parted.hidden = diagnoser.whatCannotBeSeen();
  if (parted.hidden.empty()) return;
  Scene scene = readScene(std::string{kBench});
  PictureSettings s = scene.settings;
  s.camera = scene.camera, s.shading = settings.shading, s.table = settings.table;
  s.width = kPartingSize.x, s.height = kPartingSize.y;
  Diagnoser bench{std::move(scene), s};
  const std::vector<std::string_view> there = bench.whatCannotBeSeen();
  const auto shows = std::ranges::count_if(
      parted.hidden, [&](std::string_view key) { return std::ranges::find(there, key) == there.end(); });
  const bool all = shows == std::ssize(parted.hidden);
  if (shows > 0)
    parted.shownBy =
        std::string{kBench} + " shows " +
        (all ? "these" : std::to_string(shows) + " of these " + std::to_string(parted.hidden.size()));
}

/// The two keys of --scene-for.
std::pair<std::string_view, std::string_view> twoKeys(const std::string& said) {
  const std::size_t comma = said.find(',');
  if (comma == std::string::npos || said.find(',', comma + 1) != std::string::npos)
    throw UsageError{"--scene-for: " + inQuotes(said) + " is not two mistakes, such as RV-abs,RV-unclamped"};
  const auto known = [](const std::string& word) {
    if (const Hypothesis* const row = hypothesisNamed(word)) return row->key;
    std::string nearest;
    for (const std::string_view key : nearestKeys(word, 3))
      nearest += (nearest.empty() ? "" : ", ") + std::string{key};
    throw UsageError{"--scene-for: no mistake is called " + inQuotes(word) + "; the nearest names are " +
                     nearest};
  };
  const std::pair keys{known(said.substr(0, comma)), known(said.substr(comma + 1))};
  if (keys.first == keys.second)
    throw UsageError{"--scene-for: both are " + std::string{keys.first} + ": name two mistakes"};
  return keys;
}

/// The answer that holds at a step of one of the program's own lessons, as RightAnswer has it.
std::optional<int> rightAnswerOf(const std::string& name, int step) {
  static const std::vector<LessonEntry> lessons = builtInLessons();
  const auto entry = std::ranges::find(lessons, name, &LessonEntry::name);
  if (entry == lessons.end()) return std::nullopt;
  static std::map<std::string, Lesson> read;
  if (!read.contains(name)) read.emplace(name, readLesson(entry->file));
  const auto& steps = read.at(name).steps;
  if (step > std::ssize(steps) || !steps[step - 1].question) return -1;
  const auto& answers = steps[step - 1].question->answers;
  return static_cast<int>(std::ranges::find(answers, true, &LessonAnswer::holds) - answers.begin());
}

}  // namespace

int tellDiagnosis(const Options& options, Scene scene) {
  const HandedIn handed = readHandedIn(options.handedIn);
  const PictureSettings settings = settingsOf(options, {handed.picture.width, handed.picture.height});
  refuseWhatIsNotDiagnosed(scene, settings);
  std::optional<Doing> comparing{"comparing"};
  Diagnoser diagnoser{std::move(scene), settings};
  const Diagnosis d = diagnoser(handed);
  PartedBy parted = partedBy(d, settings);
  if (d.verdict == Marking::Right || d.verdict == Marking::Allowed) addHidden(parted, diagnoser, settings);
  comparing.reset();
  print(options, pageOf(d, parted));
  if (!options.output.empty()) writeFile(options.output, diagnosisSheet(diagnoser, handed, d));
  return d.verdict == Marking::Right || d.verdict == Marking::Allowed ? kDone : kOutside;
}

int tellSceneFor(const Options& options) {
  const auto [a, b] = twoKeys(options.sceneFor);
  std::optional<Doing> trying{"drawing the benches"};
  SceneFor found = sceneFor(a, b, benchPictures());
  if (!found.picture || found.byCells) {
    trying.emplace("drawing other scenes");
    const int tried = found.tried;
    const SceneFor other = sceneFor(a, b, otherPictures());
    if ((other.picture && !(found.picture && other.byCells)) || tried == 0) found = other;
    found.tried = tried + other.tried;
    found.parting.shades = std::max(found.parting.shades, other.parting.shades);
  }
  trying.reset();
  print(options, pageOf(a, b, found));
  return found.picture ? kDone : kOutside;
}

int tellJudgement(const Options& options, Scene scene) {
  const auto [steps, size] = readPaintOrder(options.handedIn, scene.mesh.faceCount());
  std::optional<Doing> judging{"judging"};
  const Picture picture = pictureFor(options, std::move(scene), options.handedIn, size);
  const OrderReport report = judgeOrder(picture, steps);
  judging.reset();
  print(options, pageOf(report, steps));
  if (!options.output.empty() && report.first)
    writeFile(options.output, pairAsScene(picture, *report.first, steps));
  return report.isRight() ? kDone : kOutside;
}

int tellRun(const Options& options, Scene scene) {
  const RunFile run{options.window.run};
  std::optional<Doing> judging{"judging"};
  const RunReport report =
      judgeRun(pictureFor(options, std::move(scene), options.window.run, run.size()), run);
  judging.reset();
  print(options, pageOf(report));
  return report.wrong.empty() ? kDone : kOutside;
}

int gradeFolder(const Options& options, Scene scene) {
  refuseWhatIsNotDiagnosed(scene, options.picture);
  const std::vector<std::string> names = handedInFiles(options.handedIn);
  if (names.empty())
    throw UsageError{"grade: no picture, order (.jsonl) or answers (.json) is in " + options.handedIn};
  for (const std::string& name : names)
    rememberInput((std::filesystem::path{options.handedIn} / name).string());
  checkOutputs(outputsOf(options));
  awaitInterrupt();
  const std::string title = "Marks: " + titleOf(scene);
  PictureSettings settings = settingsOf(options);
  Marker marker{std::move(scene), settings, options.size, !options.page.empty(), rightAnswerOf};
  std::vector<MarkedFile> rows;
  std::optional<Doing> marking;
  for (const std::string& name : names) {
    marking.emplace("marking file " + std::to_string(rows.size() + 1) + " of " +
                    std::to_string(names.size()));
    rows.push_back(marker.mark(options.handedIn, name));
    if (wasInterrupted()) return kInterrupted;
  }
  marking.reset();
  const std::string csv = marksAsCsv(rows), page = options.page.empty() ? "" : marksAsHtml(title, rows);
  std::vector<OutputFile> files;
  if (!options.output.empty()) files.push_back({options.output, csv});
  if (!options.page.empty()) files.push_back({options.page, page});
  writeFiles(files);
  std::cout << summaryOf(rows);
  return kDone;
}

int tellQuestions(const Options& options, const Scene& scene) {
  std::optional<Doing> making{"making questions"};
  const QuestionScene about{scene, settingsOf(options)};
  const std::vector<ExamQuestion> questions =
      makeQuestions(about, options.questions, static_cast<unsigned>(options.seed));
  making.reset();
  if (static_cast<int>(questions.size()) < options.questions)
    throw UsageError{"--count: this scene has " + std::to_string(questions.size()) + " different questions"};
  if (!options.gift.empty()) writeFile(options.gift, questionsAsGift(questions));
  std::cout << questionsAsText(questions);
  return kDone;
}

}  // namespace xnewell
