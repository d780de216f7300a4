#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "geometry/files/input_file.h"
#include "geometry/files/output_file.h"
#include "geometry/files/parse_error.h"
#include "geometry/files/text_file.h"
#include "shading/diagnose/diagnose.h"
#include "shading/diagnose/scene_for.h"
#include "shading/picture/picture_cache.h"
#include "x11/app/lecture.h"
#include "x11/command/commands.h"
#include "x11/command/report.h"
#include "x11/drawing/wording.h"
#include "x11/homework/class_marks.h"
#include "x11/homework/hand_ins.h"
#include "x11/homework/judge_run.h"
#include "x11/homework/marks_formats.h"
#include "x11/homework/questions.h"
#include "x11/homework/reports.h"
#include "x11/lessons/lesson.h"
#include "x11/options/exit_status.h"
#include "x11/options/options.h"
#include "x11/options/shell_words.h"
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
  if (isRunFile(options.handedIn))
    throw UsageError{options.handedIn + ": a run of a depth sort, and no order: say --run " +
                     quoted(options.handedIn)};
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

namespace {

/// What is right for a stage: the command line, with the options of the rubric in place of its own, or the
/// rubric's scene and options alone.
Options optionsOf(const Stage& stage, const Options& options) {
  std::vector<std::string> words{"xnewell", "grade"};
  const bool isScene = !stage.words.front().starts_with('-');
  words.push_back(isScene ? stage.words.front() : options.scene);
  words.push_back(options.handedIn);
  words.insert(words.end(), stage.words.begin() + (isScene ? 1 : 0), stage.words.end());
  for (std::size_t k = 0; k < options.given.size() && !isScene; ++k)
    if (const std::string& name = options.given[k];
        name.starts_with("--") && std::ranges::none_of(stage.words, [&](const std::string& word) {
          return word == name || word.starts_with(name + '=');
        }))
      words.push_back(name + '=' + options.values[k]);
  if (isScene) words.push_back("--output=" + options.output);
  std::vector<const char*> arguments;
  for (const std::string& word : words) arguments.push_back(word.c_str());
  for (const char* const none : {"-h", "--help", "--version"})
    if (std::ranges::find(words, none) != words.end())
      throw UsageError{std::string{none} + ": a stage has options of a picture"};
  return *parseOptions(static_cast<int>(arguments.size()), arguments.data());
}

/// The markers of a class, one for each thing that is right.
class Markers {
 public:
  Markers(const Options& options, Scene scene, bool pictures) : options_{options}, pictures_{pictures} {
    add({}, options, std::move(scene));
  }
  void add(const Stage& stage) try {
    if (stage.words.empty() || markers_.contains(stage.words)) return;
    Options own = optionsOf(stage, options_);
    Scene scene = readyScene(own);
    refuseWhatIsNotDiagnosed(scene, own.picture);
    add(stage.words, own, std::move(scene));
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& e) {
    throw ParseError{options_.rubric, stage.line, e.what()};
  }
  [[nodiscard]] Marker& of(const Stage& stage) { return markers_.at(stage.words); }

 private:
  void add(const std::vector<std::string>& words, const Options& own, Scene scene) {
    const PictureSettings settings = settingsOf(own);
    markers_.try_emplace(words, std::move(scene), settings, own.size, pictures_, rightAnswerOf);
  }

  const Options& options_;
  bool pictures_;
  std::map<std::vector<std::string>, Marker> markers_;
};

/// A page for each student, below the folder of --feedback.
std::vector<std::pair<std::string, std::string>> feedbackOf(const Options& options, const ClassMarks& marks) {
  std::vector<std::pair<std::string, std::string>> pages;
  for (const std::span<const MarkedFile> rows : byStudent(marks)) {
    const std::string name =
        !rows[0].place.empty() || !marks.stages.empty() ? rows[0].place : rows[0].file + '-';
    const ClassMarks own{marks.title, marks.stages, {rows.begin(), rows.end()}};
    pages.emplace_back((std::filesystem::path{options.feedback} / (name + "feedback.html")).string(),
                       rowOf(MarksFormat::Html).text(own));
  }
  return pages;
}

/// Refuses a format whose environment is another.
void checkVariables(const MarksFormatRow& format) {
  std::string missing;
  for (const char* const variable : format.variables)
    if (const char* const value = std::getenv(variable); value == nullptr || *value == '\0')
      missing += (missing.empty() ? "" : ", ") + std::string{variable};
  if (!missing.empty())
    throw UsageError{"--format " + std::string{format.name} +
                     " needs variables of the environment, which the "
                     "runner of that system sets: " +
                     missing};
}

/// What is handed in for the stages. What is for none has no name.
HandIns handInsFor(const Options& options, const std::vector<Stage>& rubric) {
  const MarksFormatRow& format = rowOf(options.format);
  HandIns handed = handInsOf(options.handedIn);
  std::map<std::string, std::string> owners;  // by stage, or by name
  for (HandIn& one : handed.files) {
    const auto stage = std::ranges::find_if(rubric, [&](const Stage& s) { return isOf(s, one.name); });
    if (!one.name.empty() && stage == rubric.end())
      handed.passed["unasked file"].push_back(one.path), one.name.clear();
    if (one.name.empty()) continue;
    rememberInput((std::filesystem::path{options.handedIn} / one.path).string());
    const auto owner = owners.try_emplace(stage->name.empty() ? one.name : stage->name, one.student).first;
    if (format.ofOne && !owner->second.empty() && !one.student.empty() && owner->second != one.student)
      throw UsageError{"--format " + std::string{format.name} + " is for one student, and " +
                       options.handedIn + " has the hand-ins of several, such as " + inQuotes(owner->second) +
                       " and " + inQuotes(one.student)};
  }
  if (format.ofOne) {
    std::erase_if(handed.files, [](const HandIn& one) { return one.name.empty(); });
    for (HandIn& one : handed.files) one.student.clear(), one.place.clear();
  }
  if (handed.files.empty() && options.rubric.empty())
    throw UsageError{"grade: no picture, order (.jsonl) or answers (.json) is in " + options.handedIn};
  if (handed.files.empty()) handed.files.push_back({});
  return handed;
}

}  // namespace

int gradeFolder(const Options& options, Scene scene) {
  refuseWhatIsNotDiagnosed(scene, options.picture);
  const MarksFormatRow& format = rowOf(options.format);
  checkVariables(format);
  std::vector<Stage> rubric{{}};  // without a rubric, one stage that every file is of
  if (!options.rubric.empty()) rubric = readRubric(options.rubric);
  const HandIns handed = handInsFor(options, rubric);
  checkOutputs(outputsOf(options));
  awaitInterrupt();
  ClassMarks marks{"Marks: " + titleOf(scene), {}, {}};
  Markers markers{options, std::move(scene),
                  format.pictures || !options.page.empty() || !options.feedback.empty()};
  for (const Stage& stage : rubric) {
    markers.add(stage);
    if (!stage.name.empty()) marks.stages.push_back(stage.name);
  }
  std::optional<Doing> marking;
  int done = 0;
  const auto sameStudent = [](const HandIn& a, const HandIn& b) { return a.student == b.student; };
  for (auto from = handed.files.begin(), to = from; from != handed.files.end(); from = to) {
    to = std::find_if_not(from, handed.files.end(),
                          [&](const HandIn& one) { return sameStudent(one, *from); });
    for (const Stage& stage : rubric) {
      MarkedFile best{.file = stage.name.empty() ? from->path : "",
                      .verdict = "missing",
                      .words = "nothing is handed in"};
      const auto add = [&](MarkedFile row, const HandIn& one) {
        row.student = one.student, row.stage = stage.name, row.place = one.place;
        row.most = stage.points, row.points = pointsFor(row, row.most);
        marks.rows.push_back(std::move(row));
      };
      int ofStage = 0;
      for (const HandIn& one : std::span{from, to}) {
        if (one.name.empty() || !isOf(stage, one.name)) continue;
        marking.emplace("marking file " + std::to_string(++done) + " of " +
                        std::to_string(handed.files.size()));
        MarkedFile marked = markers.of(stage).mark(options.handedIn, one.path);
        if (wasInterrupted()) return kInterrupted;
        if (stage.name.empty())
          add(std::move(marked), one);
        else if (ofStage == 0 || pointsFor(marked, 1) > pointsFor(best, 1))
          best = std::move(marked);
        ++ofStage;
      }
      if (ofStage > 0 && stage.name.empty()) continue;
      if (ofStage > 1) best.words += " (the best of " + std::to_string(ofStage) + " files for this stage)";
      add(std::move(best), *from);
    }
  }
  marking.reset();
  std::vector<std::pair<std::string, std::string>> written{{options.output, format.text(marks)}};
  if (!options.page.empty()) written.emplace_back(options.page, rowOf(MarksFormat::Html).text(marks));
  if (!options.feedback.empty())
    for (auto& page : feedbackOf(options, marks)) {
      makeFolder(std::filesystem::path{page.first}.parent_path().string());
      written.push_back(std::move(page));
    }
  std::vector<OutputFile> files;
  for (const auto& [name, text] : written) files.push_back({name, text});
  writeFiles(files);
  std::cout << summaryOf(marks);
  if (const std::string passed = sentenceOf(handed.passed); !passed.empty()) std::cout << passed << '\n';
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
  const QuestionTexts texts = questionsAsText(questions);
  const std::string gift = options.gift.empty() ? "" : questionsAsGift(questions, about.png);
  std::vector<OutputFile> files;
  if (!options.gift.empty()) files.push_back({options.gift, gift});
  if (!options.solutions.empty()) files.push_back({options.solutions, texts.solved});
  writeFiles(files);
  std::cout << texts.asked << (options.solutions.empty() ? "Solutions\n\n" + texts.solved : "");
  return kDone;
}

}  // namespace xnewell
