#pragma once

#include <string>

#include "x11/options/options.h"

namespace xnewell {

/// The page of build.sh, which begins with this lesson or lecture. It also holds every file that the program
/// has read by now, at its place relative to the others.
/// @throws std::runtime_error if the page is of another version
[[nodiscard]] std::string pageThatBeginsWith(const Options& options, std::string page);

/// Writes this page. @throws std::runtime_error if build.sh has made none; as writeFile() does
void writePage(const Options& options);

}  // namespace xnewell
