#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace xnewell {

/// Commands as a POSIX shell reads them: words between spaces, '...' and \c.

/// A word of a command line, quoted where a shell would read it otherwise.
[[nodiscard]] std::string quoted(const std::string& word);

/// The words of a command. Nothing if a quotation does not end.
[[nodiscard]] std::optional<std::vector<std::string>> wordsOf(std::string_view command);

}  // namespace xnewell
