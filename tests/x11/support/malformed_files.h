#pragma once

#include <string>
#include <vector>

namespace xnewell {

/// A file that the program refuses: its name says what kind it is. s.json is a scene, l.json a lesson, and an
/// .mtl file is read for an .obj file.
struct Malformed {
  std::string name, content;
  std::string message;  ///< exactly what follows the file's name
  int status = 2;
};
[[nodiscard]] std::vector<Malformed> malformedFiles();

}  // namespace xnewell
