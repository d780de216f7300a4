#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "x11/options/options.h"

namespace xnewell {

/// Command lines as options, or as complaints.

/// Over what a scene asks for.
inline Options parsed(const std::vector<std::string>& arguments, const PictureSettings& scene = {}) {
  std::vector<const char*> argv{"xnewell"};
  for (const std::string& a : arguments) argv.push_back(a.c_str());
  auto options = parseOptions(static_cast<int>(argv.size()), argv.data());
  if (!options) throw std::logic_error{"only --help returns nothing"};
  settle(*options, scene);
  return *options;
}

/// `draw teapot -o no.png` and these.
inline Options drawn(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"draw", "teapot", "-o", "no.png"});
  return parsed(arguments);
}

/// The complaint about these words; "" if there is none.
inline std::string complaintAll(const std::vector<std::string>& arguments) {
  try {
    static_cast<void>(parsed(arguments));
  } catch (const std::exception& e) {
    return e.what();
  }
  return "";
}

}  // namespace xnewell
