#pragma once

#include <functional>

#include "x11/lessons/lesson.h"
#include "x11/options/options.h"

namespace xnewell {

/// Writes a lesson to options.worksheet, to be printed: one HTML file with the picture and the words of each
/// step, its question with room to write, and all solutions on a page of their own at the end. `tell` gets
/// the number of each step, from 1. @throws std::system_error
void writeWorksheet(const Options& options, Lesson lesson, const std::function<void(int)>& tell);

}  // namespace xnewell
