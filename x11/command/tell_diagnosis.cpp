#include "x11/command/tell_diagnosis.h"

#include <array>
#include <iostream>
#include <optional>

#include "geometry/files/output_file.h"
#include "shading/diagnose/diagnose.h"
#include "x11/command/check_writable.h"
#include "x11/command/diagnosis_report.h"
#include "x11/command/diagnosis_sheet.h"
#include "x11/command/doing.h"
#include "x11/drawing/wording.h"
#include "x11/options/exit_status.h"

namespace xnewell {

namespace {

/// The scenes that are made to part mistakes.
constexpr std::array<const char*, 2> kBenches{"bench", "bench-n3"};

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
  if (where.empty()) return {"no picture of bench or bench-n3 tells " + both + " apart by its colours"};
  return {"to tell " + both + " apart, draw " + where + ": at pixel " + std::to_string(best.at.i) + "," +
          std::to_string(best.at.j) + " the first shows " + fixed(best.first, 0) + ", the second " +
          fixed(best.second, 0) + "; right is " + fixed(best.right, 0)};
}

}  // namespace

int tellDiagnosis(Options& options, Scene scene) {
  if (!options.output.empty()) checkWritable(options.output);
  const HandedIn handed = readHandedIn(options.handedIn);
  PictureSettings settings = options.picture;
  const glm::ivec2 size = options.size.value_or(glm::ivec2{handed.picture.width, handed.picture.height});
  settings.width = size.x, settings.height = size.y;
  if (const std::string why = whyNotDiagnosed(scene, settings); !why.empty()) throw UsageError{why};
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

}  // namespace xnewell
