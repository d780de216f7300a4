#include "x11/command/tell_homework.h"

#include <array>
#include <cmath>
#include <iostream>
#include <optional>

#include "geometry/files/output_file.h"
#include "shading/diagnose/diagnose.h"
#include "shading/diagnose/pair_scene.h"
#include "shading/picture/picture_cache.h"
#include "x11/drawing/wording.h"
#include "x11/homework/class_marks.h"
#include "x11/homework/diagnosis_report.h"
#include "x11/homework/diagnosis_sheet.h"
#include "x11/homework/judgement_report.h"
#include "x11/homework/questions.h"
#include "x11/options/exit_status.h"
#include "x11/terminal/check_writable.h"
#include "x11/terminal/doing.h"
#include "x11/terminal/interrupt.h"

namespace xnewell {

namespace {

/// The scenes that are made to part mistakes.
constexpr std::array<const char*, 2> kBenches{"bench", "bench-n3"};

PictureSettings sized(const Options& options, glm::ivec2 usual) {
  PictureSettings settings = options.picture;
  const glm::ivec2 size = options.size.value_or(usual);
  settings.width = size.x, settings.height = size.y;
  return settings;
}

void refuseWhatIsNotDiagnosed(const Scene& scene, const PictureSettings& settings) {
  if (const std::string why = whyNotDiagnosed(scene, settings); !why.empty()) throw UsageError{why};
}

/// What parts the first two mistakes of a class: the picture of a bench where they differ most.
PartedBy partedBy(const Diagnosis& d, const PictureSettings& settings) {
  if (d.verdict != Marking::OneOf) return {};
  const Hypothesis &a = *d.found[0].first, &b = *d.found[1].first;
  const std::string both = std::string{a.key} + " and " + std::string{b.key};
  Diagnoser::Parting best;
  std::string where;
  double most = 2.0;  // shades; less is easily the rounding of another program
  for (const char* bench : kBenches) {
    Scene scene = readScene(bench);
    PictureSettings s = scene.settings;
    s.shading = settings.shading, s.table = settings.table, s.camera = scene.camera;
    s.width = 640, s.height = 480;
    Diagnoser other{std::move(scene), s};
    const Diagnoser::Parting parting = other.partingOf(a, b);
    if (std::abs(parting.first - parting.second) <= most) continue;
    most = std::abs(parting.first - parting.second), best = parting;
    where = std::string{bench} + " --size 640x480 --shade " + std::string{rowOf(s.shading).name};
  }
  if (where.empty())
    return {"no picture of bench or bench-n3 tells " + both +
            " apart by its colours; the cells of a PNG may"};
  return {"to tell " + both + " apart, draw " + where + ": at pixel " + std::to_string(best.at.i) + "," +
          std::to_string(best.at.j) + " the first shows " + fixed(best.first, 0) + ", the second " +
          fixed(best.second, 0) + "; right is " + fixed(best.right, 0)};
}

}  // namespace

int tellDiagnosis(const Options& options, Scene scene) {
  if (!options.output.empty()) checkWritable(options.output);
  const HandedIn handed = readHandedIn(options.handedIn);
  const PictureSettings settings = sized(options, {handed.picture.width, handed.picture.height});
  refuseWhatIsNotDiagnosed(scene, settings);
  std::optional<Doing> comparing{"comparing"};
  Diagnoser diagnoser{std::move(scene), settings};
  const Diagnosis d = diagnoser(handed);
  const PartedBy parted = partedBy(d, settings);
  comparing.reset();
  (options.json ? printDiagnosisAsJson : printDiagnosis)(d, parted, std::cout);
  std::cout.flush();
  if (!options.output.empty()) writeFile(options.output, diagnosisSheet(diagnoser, handed, d));
  return d.verdict == Marking::Right || d.verdict == Marking::Allowed ? kDone : kOutside;
}

int tellJudgement(const Options& options, Scene scene) {
  if (!options.output.empty()) checkWritable(options.output);
  const std::vector<PaintStep> steps = readPaintSteps(options.handedIn, scene.mesh.faceCount());
  std::optional<Doing> judging{"judging"};
  PictureSettings settings = sized(options, kPictureSize);
  settings.order = Order::Unsorted, settings.adapt = 0;
  const Picture picture = makePicture(std::move(scene), settings).withPlanes();
  const OrderReport report = judgeOrder(picture, steps);
  judging.reset();
  (options.json ? printJudgementAsJson : printJudgement)(report, steps, std::cout);
  std::cout.flush();
  if (!options.output.empty() && report.first)
    writeFile(options.output, pairAsScene(picture, *report.first, steps));
  return report.isRight() ? kDone : kOutside;
}

int gradeFolder(const Options& options, Scene scene) {
  for (const std::string* file : {&options.output, &options.page})
    if (!file->empty()) checkWritable(*file);
  refuseWhatIsNotDiagnosed(scene, options.picture);
  const std::vector<std::string> names = handedInFiles(options.handedIn);
  awaitInterrupt();
  const std::string title = "Marks: " + titleOf(scene);
  PictureSettings settings = sized(options, kPictureSize);
  Marker marker{std::move(scene), settings, options.size, !options.page.empty()};
  std::vector<MarkedFile> rows;
  std::optional<Doing> marking;
  for (const std::string& name : names) {
    marking.reset();  // each message replaces the one before
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
  if (!options.gift.empty()) checkWritable(options.gift);
  std::optional<Doing> making{"making questions"};
  const QuestionScene about{scene, sized(options, kPictureSize)};
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
