#pragma once

#include <stdexcept>
#include <string>

namespace xnewell {

/// An error in a file, with its place: `teapot.obj:41: face index 0; OBJ counts from 1`. `line` counts from
/// 1. A line of 0 stands for the whole file and is not printed.
class ParseError : public std::runtime_error {
 public:
  ParseError(const std::string& file, int line, const std::string& what)
      : std::runtime_error{(line > 0 ? file + ":" + std::to_string(line) : file) + ": " + what} {}
};

}  // namespace xnewell
