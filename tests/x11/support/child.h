#pragma once

#include <cstring>
#include <string>
#include <vector>

#include <unistd.h>

namespace xnewell {

/// The arguments of execvpe(), made before fork(): nothing may be allocated between the two.

/// This program's environment with DISPLAY as given, or without it where `display` is empty.
inline std::vector<std::string> environmentWith(const std::string& display) {
  std::vector<std::string> environment;
  for (char** e = environ; *e != nullptr; ++e)
    if (std::strncmp(*e, "DISPLAY=", 8) != 0) environment.emplace_back(*e);
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
