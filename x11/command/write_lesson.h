#pragma once

#include <functional>

#include "x11/lessons/lesson.h"
#include "x11/options/options.h"

namespace xnewell {

/// What `xnewell lesson NAME` shows: a built-in lesson, or a file. @throws UsageError for an unknown name,
/// ParseError, std::system_error
[[nodiscard]] Lesson lessonNamed(const std::string& nameOrFile);

/// --frames: the whole window at each step, as it is before any question is answered, drawn without a server.
/// `tell` is called before each step, from 1. @throws UsageError if the folder holds frames already;
/// std::system_error
void writeLesson(const Options& options, Lesson lesson, const std::function<void(int)>& tell);

}  // namespace xnewell
