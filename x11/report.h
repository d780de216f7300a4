#pragma once

#include "shading/picture.h"
#include "x11/options.h"

/// What draw and snapshot tell beside the picture: `--ids` as a PNG, `--stats` as one JSON object on
/// standard output. @throws std::system_error
void report(const Options& options, const Picture& picture, const StageTimes& times);
