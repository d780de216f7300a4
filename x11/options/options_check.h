#pragma once

#include <vector>

#include "x11/options/option_rows.h"
#include "x11/options/options.h"

namespace xnewell {

/// All that the first word may be but a file.
[[nodiscard]] std::vector<std::string> commandsAndScenes();

/// Check what no option can check alone: which options need others, and which exclude each other.
/// @throws UsageError

/// What the command line says by itself. `rows` are those of all options.
void checkUsage(const Options& options, const std::vector<OptionRow>& rows);
/// The same as settle(), without the carrier's name in a complaint.
void settleOver(Options& options, const PictureSettings& scene);

/// Refuses a pixel of a picture that has this size. @throws UsageError
[[noreturn]] void refuseOutside(const glm::ivec2& pixel, const glm::ivec2& size);

}  // namespace xnewell
