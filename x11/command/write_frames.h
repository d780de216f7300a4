#pragma once

#include <functional>

#include "depthsort/depth_sort.h"
#include "shading/picture/picture.h"
#include "x11/options/options.h"

namespace xnewell {

/// --frames: writes a numbered PNG for each step of the kind that --every names, and one of the whole picture
/// at the end. Makes the folder if it does not exist.
/// @throws UsageError if the run has no such step or more than 9,998 of them, or if the folder holds frames
/// already; std::system_error
void writeFrames(const Options& options, const Picture& picture, const SortedScene& sorted);

/// --frames with --whole-window: writes the window's stepper at each of these steps. It calls `tell` with the
/// number of the frame and the number of all frames before it draws each.
void writeStepperFrames(const Options& options, Scene scene, const std::function<void(int, int)>& tell);

}  // namespace xnewell
