#pragma once

#include <array>
#include <string>
#include <vector>

namespace xnewell {

/// A model as people have them: a file, what it is made of, and what the program must find in it. The shape
/// is stated apart from the file, so nothing here shares code with the readers.
struct CorpusModel {
  std::string name;     ///< of the file
  std::string content;  ///< of the file
  struct Shape {
    std::vector<std::array<double, 3>> points;
    std::vector<std::vector<int>> faces;  ///< outlines, with holes bridged
  } shape;                                ///< its faces in the order of the file
  int open = 0, turned = 0, crowded = 0;  ///< edges, as EdgeCounts has them
  std::vector<std::string> notes = {};    ///< after the file's name; FOLDER stands for that of the file
};
[[nodiscard]] std::vector<CorpusModel> corpusModels();

/// An .obj file of n by n squares over a gentle hill.
[[nodiscard]] std::string hillObj(int n);

}  // namespace xnewell
