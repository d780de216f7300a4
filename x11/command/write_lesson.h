#pragma once

#include <functional>

#include "x11/lessons/lesson.h"
#include "x11/options/options.h"

namespace xnewell {

/// The lesson of `xnewell lesson NAME`: a built-in one, or a .json file. @throws UsageError for an unknown
/// name; ParseError, std::system_error
[[nodiscard]] Lesson lessonNamed(const std::string& nameOrFile);

/// --frames: writes the whole window at each step, before any question is answered. It needs no server. It
/// calls `tell` with the number of each step, from 1, before it draws it.
/// @throws UsageError if the folder holds frames already; std::system_error
void writeLesson(const Options& options, Lesson lesson, const std::function<void(int)>& tell);

}  // namespace xnewell
