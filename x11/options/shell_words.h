#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace xnewell {

/// Commands as a POSIX shell reads them: words between spaces, '...', \c, and $'...' with \n, \t and \xHH.

/// A word of a command line, quoted where a shell would read it otherwise, and visible (visible.h).
[[nodiscard]] std::string quoted(const std::string& word);

/// The words of a command. Nothing if a quotation does not end, or has no such byte.
[[nodiscard]] std::optional<std::vector<std::string>> wordsOf(std::string_view command);

}  // namespace xnewell
