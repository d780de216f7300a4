#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shading/color/images.h"
#include "shading/diagnose/diagnose.h"
#include "shading/diagnose/judge_order.h"
#include "shading/diagnose/scene_for.h"
#include "x11/kit/page.h"

namespace xnewell {

/// Parts of HTML, XML and JSON files that the program writes.

/// The text with the characters that HTML means something by as entities, and others than UTF-8 as they are.
[[nodiscard]] std::string inHtml(std::string_view text);
/// <name>text</name> and a line break.
[[nodiscard]] std::string element(const std::string& name, std::string_view text);
/// The address of a PNG file that is in it: data:image/png...
[[nodiscard]] std::string imageUrl(std::string_view png);
/// An <img> that carries the bytes of a PNG file.
[[nodiscard]] std::string imageElement(std::string_view png);
/// The text in UTF-8, with characters alone that XML may have, as JSON may, too: \\xff stands for a byte of
/// others.
[[nodiscard]] std::string wellFormed(std::string_view text);
/// RFC 4648, section 4.
[[nodiscard]] std::string base64(std::string_view bytes);

/// What is said of a picture and of a painting order that were handed in.

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
[[nodiscard]] page::Page pageOf(const Diagnosis& d, const PartedBy& parted);
/// The bytes of a PNG: the picture, the right one, and the one with the mistake, side by side. A frame is
/// around the face where the mistake shows most.
[[nodiscard]] std::string diagnosisSheet(Diagnoser& diagnoser, const HandedIn& handed, const Diagnosis& d);

/// The picture that tells the mistakes a and b apart, in one sentence without a full stop.
[[nodiscard]] std::string partingSentence(std::string_view a, std::string_view b, const SceneFor& found);
[[nodiscard]] page::Page pageOf(std::string_view a, std::string_view b, const SceneFor& found);

/// One line, without a line break.
[[nodiscard]] std::string verdictOf(const OrderReport& report, std::span<const PaintStep> steps);
/// What would have told which of a wrong pair comes first; no full stop.
[[nodiscard]] std::string lessonOf(const WrongPair& pair, std::span<const PaintStep> steps);
/// The kinds of fault in it: missing, repeated, covers, outside, order, needs-cut; with blanks between them.
[[nodiscard]] std::string kindOf(const OrderReport& report);
[[nodiscard]] page::Page pageOf(const OrderReport& report, std::span<const PaintStep> steps);

}  // namespace xnewell
