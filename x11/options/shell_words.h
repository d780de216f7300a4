#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "shading/scene/settings.h"

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

/// Reads the values of options.

/// Throws a UsageError such as "--n: 'many' is not a whole number from 0 to 1000000".
[[noreturn]] void refuse(const std::string& option, const std::string& text, const std::string& expected);

/// The numbers in `text`, which must be exactly `count` finite numbers separated by commas.
/// @throws UsageError
[[nodiscard]] std::vector<double> numbers(const std::string& option, const std::string& text,
                                          std::size_t count, const std::string& expected);

/// The value of a setting, read from the text of its option. @throws UsageError
[[nodiscard]] Value valueOf(const Setting& setting, const std::string& text);

/// A pixel X,Y: column and row, from the top left. @throws UsageError
[[nodiscard]] glm::ivec2 pixelOf(const std::string& option, const std::string& text);

/// The value of --oblique: "cabinet:45".
[[nodiscard]] std::string textOf(const Oblique& oblique);

/// The words between commas.
[[nodiscard]] std::vector<std::string> commaWords(const std::string& text);

}  // namespace xnewell
