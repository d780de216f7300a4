#pragma once

#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "x11/lessons/lesson.h"

namespace xnewell {

/// The claims of a lesson's steps and answers that do not hold in a window of so many units, one sentence
/// each: "step 2, answer b: cuts is 2, which is not what the lesson claims". A sentence of the lesson rests
/// on each.
[[nodiscard]] std::vector<std::string> brokenClaims(const Lesson& lesson, glm::ivec2 window);

}  // namespace xnewell
