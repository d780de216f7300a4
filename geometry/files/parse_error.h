#pragma once

#include <stdexcept>
#include <string>

namespace xnewell {

/// What is wrong in a file, where: `teapot.obj:41: face index 0; OBJ counts from 1`.
/// `line` counts from 1; 0 stands for the file as a whole and is not printed.
class ParseError : public std::runtime_error {
 public:
  ParseError(const std::string& file, int line, const std::string& what)
      : std::runtime_error{(line > 0 ? file + ":" + std::to_string(line) : file) + ": " + what} {}
};

}  // namespace xnewell
