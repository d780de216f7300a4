#pragma once

#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "shading/scene/settings.h"

namespace xnewell {

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
