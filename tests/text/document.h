#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

namespace xnewell {

/// The project's documents, and what they say.

/// The text of a file, by its path in the project.
[[nodiscard]] std::string documentOf(const std::string& path);

/// The lines below a heading, up to the next one.
[[nodiscard]] std::vector<std::string> linesOf(const std::string& document, std::string_view heading);

/// The cells of a line of a table, without the blanks around them; none if it is no such line.
[[nodiscard]] std::vector<std::string> cellsOf(const std::string& line);

/// Checks that a document has these words, with the numbers in place of each {}. It may break its lines
/// anywhere. If its numbers are others, the message has the right words, ready to be copied.
[[nodiscard]] testing::AssertionResult says(const std::string& path, std::string_view words,
                                            const std::vector<std::string>& numbers);

/// "12,703", and "0.0567" with four decimals.
[[nodiscard]] std::string number(long long value);
[[nodiscard]] std::string number(double value, int decimals);

}  // namespace xnewell
