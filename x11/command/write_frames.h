#pragma once

#include <functional>

#include "depthsort/depth_sort.h"
#include "shading/picture/picture.h"
#include "x11/options/options.h"

namespace xnewell {

/// --frames: a numbered PNG for each step of the kind of --every, and one of the whole picture at the end.
/// Makes the folder if need be. @throws UsageError if the run has no such step, more than 9,999 of them, or
/// the folder holds frames already; std::system_error
void writeFrames(const Options& options, const Picture& picture, const SortedScene& sorted);

/// The same with --whole-window: the window's stepper at each of the steps. `tell` gets how many of how many
/// are drawn.
void writeStepperFrames(const Options& options, Scene scene, const std::function<void(int, int)>& tell);

}  // namespace xnewell
