#pragma once

#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "shading/diagnose/diagnose.h"
#include "shading/diagnose/scene_for.h"

namespace xnewell {

/// A diagnosis in words and as JSON.

/// One word: right, allowed, mistake, one-of, numbers, unknown, other-scene.
[[nodiscard]] std::string_view nameOf(Marking verdict);
/// "right", "wrong: ..." without numbers: one line.
[[nodiscard]] std::string verdictOf(const Diagnosis& d);
/// "RV-abs", "n=10", "L-sign+Ia-twice": a row, a number or two rows in one word.
[[nodiscard]] std::string nameOf(const Fit& fit);
/// Where to look further.
struct PartedBy {
  /// What tells apart the mistakes of a class: a picture and its pixel, or that they are the same by algebra;
  /// "" if there is nothing to say.
  std::string sentence;
  std::vector<std::string_view> hidden;  ///< of a right picture: the keys that would not change it
  std::string shownBy;                   ///< which scene shows these
};
void printDiagnosis(const Diagnosis& d, const PartedBy& parted, std::ostream& out);
void printDiagnosisAsJson(const Diagnosis& d, const PartedBy& parted, std::ostream& out);

/// The picture that tells the mistakes a and b apart, in one sentence without a full stop.
[[nodiscard]] std::string partingSentence(std::string_view a, std::string_view b, const SceneFor& found);
void printSceneFor(std::string_view a, std::string_view b, const SceneFor& found, std::ostream& out);
void printSceneForAsJson(std::string_view a, std::string_view b, const SceneFor& found, std::ostream& out);

}  // namespace xnewell
