#pragma once

#include <string>
#include <vector>

namespace xnewell {

/// What a shell may put in place of the last of the words after `xnewell`, each with a tab and what it does.
/// Commands, options and their words come from the rows of --help, and scenes and lessons from the data
/// folder, so a new file is proposed at once. The files in x11/install ask with `xnewell complete -- WORDS`.
[[nodiscard]] std::string proposalsFor(std::vector<std::string> words);

}  // namespace xnewell
