#pragma once

#include <array>
#include <string>
#include <string_view>

namespace xnewell {

/// Files with which a shell completes the words after `xnewell`. Commands, options and the words of options
/// come from the rows that the program itself uses. The names of scenes and lessons come from `xnewell
/// scenes` at the moment of use, so a new file is proposed at once.

[[nodiscard]] std::string bashCompletion();
[[nodiscard]] std::string zshCompletion();
[[nodiscard]] std::string fishCompletion();

}  // namespace xnewell
