#pragma once

#include <iosfwd>
#include <span>
#include <string>

#include "shading/diagnose/judge_order.h"

namespace xnewell {

/// A painting order that was judged, in words and as JSON.

/// One line, without a line break.
[[nodiscard]] std::string verdictOf(const OrderReport& report, std::span<const PaintStep> steps);
/// What would have told which of a wrong pair comes first; no full stop.
[[nodiscard]] std::string lessonOf(const WrongPair& pair, std::span<const PaintStep> steps);
/// The kinds of fault in it: missing, repeated, covers, outside, order, needs-cut; with blanks between them.
[[nodiscard]] std::string kindOf(const OrderReport& report);
void printJudgement(const OrderReport& report, std::span<const PaintStep> steps, std::ostream& out);
void printJudgementAsJson(const OrderReport& report, std::span<const PaintStep> steps, std::ostream& out);

}  // namespace xnewell
