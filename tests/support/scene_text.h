#pragma once

#include <filesystem>
#include <string>

#include "shading/scene/scene_file.h"

namespace xnewell {

/// Scene files as text, and the reader's errors about them: what the tests of the scene reader share.

inline const std::filesystem::path kData{XNEWELL_DATA_DIR};

inline Scene parsed(const std::string& text) { return parseSceneFile(text, "s.json", kData); }

inline std::string complaint(const std::string& text) {
  try {
    (void)parsed(text);
  } catch (const std::exception& e) {
    return e.what();
  }
  return "no complaint";
}

inline std::string withObject(const std::string& object) { return R"({"objects": [)" + object + "]}"; }
inline const std::string kTriangle = R"({"polygons": [[[0, 0, 0], [1, 0, 0], [0, 1, 0]]]})";
/// The size of the scene is 1/2 to 1: its coordinates are the file's, halved.
inline std::string withTriangle(const std::string& more) {
  return "{" + more + R"(, "objects": [)" + kTriangle + "]}";
}

}  // namespace xnewell
