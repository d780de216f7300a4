#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace xnewell {

/// What is to be handed in, and what it earns: a text file with a line a stage.
///
///     # stage  points  what is right, if it is not what the command line says
///     flat     3
///     phong    2       bench-n3 --shade phong --normals sum
///     order    4       cycle
///
/// `flat` is handed in as flat.png, flat.ppm, Flat.jsonl ...: a file of that name, whatever its end.

struct Stage {
  std::string name;
  int points = 1;
  std::vector<std::string> words = {};  ///< a scene and options, or options alone; empty: the command line's
  int line = 1;
};

/// @throws ParseError, std::system_error
[[nodiscard]] std::vector<Stage> readRubric(const std::string& file);

/// Whether a file of this name is handed in for a stage; any is for one without a name.
[[nodiscard]] bool isOf(const Stage& stage, std::string_view file);

}  // namespace xnewell
