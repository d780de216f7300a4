#pragma once

#include <set>
#include <string>

#include "x11/options/options.h"

namespace xnewell {

/// The page of build.sh, which begins with this lesson or lecture. It also holds the files that were read for
/// it, at their places relative to each other, but those of the data folder, which every page has.
/// @throws std::runtime_error if the page is of another version
[[nodiscard]] std::string pageThatBeginsWith(const Options& options, const std::set<std::string>& read,
                                             std::string page);

/// Writes this page. @throws std::runtime_error if build.sh has made none; as writeFile() does
void writePage(const Options& options);

}  // namespace xnewell
