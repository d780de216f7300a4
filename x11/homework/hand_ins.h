#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace xnewell {

/// What a class has handed in, as course systems give it: files; a folder a student, which may have folders
/// of its own; and names of Moodle, `Anna Alt_4711_assignsubmission_file_flat.png`, of a file or of a folder.

struct HandIn {
  std::string path;          ///< in the folder; of a student who handed in nothing, that of his folder
  std::string student = {};  ///< "Anna Alt"; "" if the folder does not say
  std::string name = {};     ///< of the file alone: "flat.png"; "" if the student handed in nothing
  std::string place = {};    ///< in a folder of answers, how the names of those to the student begin
};

/// How many files are passed over, by what they are: "hidden file".
using PassedOver = std::map<std::string_view, int>;

struct HandIns {
  std::vector<HandIn> files;  ///< sorted by student, then by path
  PassedOver passed;
};

/// Links to folders are passed over: a folder cannot lead round, nor to what somebody else has handed in.
/// @throws std::system_error
[[nodiscard]] HandIns handInsOf(const std::string& folder);

/// "passed over: 2 hidden files, 1 linked folder"; "" if there is nothing.
[[nodiscard]] std::string sentenceOf(const PassedOver& passed);

}  // namespace xnewell
