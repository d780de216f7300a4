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

/// The man page xnewell(1), for the macros of man(7). Commands, options, exit statuses, scenes and lessons
/// come from the rows that the program itself uses. `date` is the day of the release, "2026-11-25".
[[nodiscard]] std::string manPage(std::string_view version, std::string_view date);

}  // namespace xnewell
