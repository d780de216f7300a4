#pragma once

#include "shading/scene/scene.h"
#include "x11/options/options.h"

namespace xnewell {

/// Reads the scene that the options name, and settles the options and the scene with each other: what the
/// scene asks for becomes part of `options.picture`, and what the command line replaces leaves the scene.
/// Prints what was strange in the file on standard error.
/// @throws UsageError, ParseError, std::system_error, ViewError
[[nodiscard]] Scene readyScene(Options& options);

}  // namespace xnewell
