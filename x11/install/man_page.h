#pragma once

#include <string>
#include <string_view>

namespace xnewell {

/// The man page xnewell(1), for the macros of man(7). Commands, options, exit statuses, scenes and lessons
/// come from the rows that the program itself uses. `date` is the day of the release, "2026-11-25".
[[nodiscard]] std::string manPage(std::string_view version, std::string_view date);

}  // namespace xnewell
