#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include <unistd.h>

namespace xnewell {

/// The arguments of execvpe(), made before fork(): nothing may be allocated between the two.

/// This program's environment with DISPLAY as given, or without it where `display` is empty; without a home,
/// where a window would keep answers.
inline std::vector<std::string> environmentWith(const std::string& display) {
  std::vector<std::string> environment;
  for (char** e = environ; *e != nullptr; ++e)
    if (std::ranges::none_of(std::array<std::string_view, 3>{"DISPLAY=", "HOME=", "XDG_STATE_HOME="},
                             [e](std::string_view name) { return std::string_view{*e}.starts_with(name); }))
      environment.emplace_back(*e);
  if (!display.empty()) environment.push_back("DISPLAY=" + display);
  return environment;
}

/// Pointers to the strings, and a null at the end; valid as long as `strings` does not change.
inline std::vector<char*> pointers(std::vector<std::string>& strings) {
  std::vector<char*> result;
  result.reserve(strings.size() + 1);
  for (std::string& s : strings) result.push_back(s.data());
  result.push_back(nullptr);
  return result;
}

}  // namespace xnewell
