#pragma once

#include <cstring>
#include <string>
#include <vector>

#include <unistd.h>

namespace xnewell {

/// What execvpe() takes, made before fork(): between the two nothing may be allocated.

/// This program's environment with DISPLAY as given, or without it where `display` is empty.
inline std::vector<std::string> environmentWith(const std::string& display) {
  std::vector<std::string> environment;
  for (char** e = environ; *e != nullptr; ++e)
    if (std::strncmp(*e, "DISPLAY=", 8) != 0) environment.emplace_back(*e);
  if (!display.empty()) environment.push_back("DISPLAY=" + display);
  return environment;
}

/// The strings' beginnings and a null at the end; good as long as `strings` is not touched.
inline std::vector<char*> pointers(std::vector<std::string>& strings) {
  std::vector<char*> result;
  result.reserve(strings.size() + 1);
  for (std::string& s : strings) result.push_back(s.data());
  result.push_back(nullptr);
  return result;
}

}  // namespace xnewell
