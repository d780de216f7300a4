#pragma once

#include <string>

#include "shading/diagnose/diagnose.h"

namespace xnewell {

/// The bytes of a PNG: the picture, the right one, and the one with the mistake, side by side. A frame is
/// around the face where the mistake shows most.
[[nodiscard]] std::string diagnosisSheet(Diagnoser& diagnoser, const HandedIn& handed, const Diagnosis& d);

}  // namespace xnewell
