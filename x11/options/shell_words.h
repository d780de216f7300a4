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

/// What stands after the # of the page's address is a command line in other words, and the same table of
/// options reads it: "teapot&view=pixel&pixel=288,158" is `xnewell teapot --view=pixel --pixel=288,158`,
/// "lesson&cycles&step=3" is `xnewell lesson cycles --step=3`. Bytes may be written as %26.

/// The arguments of the command, without "xnewell".
[[nodiscard]] std::vector<std::string> argumentsOf(std::string_view address);

/// The address of the window that a command shows, or draws a picture of: without the picture's file, and
/// without its size, unless it names a pixel. "" if the command is no line of words.
[[nodiscard]] std::string addressOf(std::string_view command);

}  // namespace xnewell
