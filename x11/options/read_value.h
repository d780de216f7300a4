#pragma once

#include <string>
#include <vector>

#include "shading/scene/settings.h"

namespace xnewell {

/// The texts of options as values.

/// @throws UsageError `--n: 'many' is not a whole number from 0 to 1000000`
[[noreturn]] void refuse(const std::string& option, const std::string& text, const std::string& expected);

/// All of `text` as comma-separated finite numbers, exactly `count` of them. @throws UsageError
[[nodiscard]] std::vector<double> numbers(const std::string& option, const std::string& text,
                                          std::size_t count, const std::string& expected);

/// The text of an option as its setting's value. @throws UsageError
[[nodiscard]] Value valueOf(const Setting& setting, const std::string& text);

}  // namespace xnewell
