#pragma once

#include <functional>

#include "x11/app/workbench.h"
#include "x11/lessons/lesson.h"
#include "x11/options/options.h"

namespace xnewell {

/// The lesson of `xnewell lesson NAME`: a built-in one, or a .json file. @throws UsageError for an unknown
/// name; ParseError, std::system_error
[[nodiscard]] Lesson lessonNamed(const std::string& nameOrFile);

/// Draws the whole window at each step of a lesson, before any question is answered, and visits it. It needs
/// no server. It calls `tell` with the number of each step, from 1, before it draws it. The visitor gets the
/// step's index, from 0, and may press keys.
void visitSteps(const Options& options, Lesson lesson, const std::function<void(int)>& tell,
                const std::function<void(Workbench& bench, int step)>& visit);

/// --frames: writes a picture for each step, as visitSteps() draws it.
/// @throws UsageError if the folder holds frames already; std::system_error
void writeLesson(const Options& options, Lesson lesson, const std::function<void(int)>& tell);

}  // namespace xnewell
