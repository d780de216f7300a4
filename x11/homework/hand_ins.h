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

/// The files that are passed over, by what they are: "hidden file".
using PassedOver = std::map<std::string_view, std::vector<std::string>>;

struct HandIns {
  std::vector<HandIn> files;  ///< sorted by student, then by path
  PassedOver passed;
};

/// Links to folders are passed over: a folder cannot lead round, nor to what somebody else has handed in.
/// @throws std::system_error
[[nodiscard]] HandIns handInsOf(const std::string& folder);

/// "passed over: 2 hidden files, 1 linked folder"; "" if there is nothing.
[[nodiscard]] std::string sentenceOf(const PassedOver& passed);

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

/// What a student answered in lessons, as `--answers FILE` keeps it: a JSON file
///
///     {"answers": [{"lesson": "cycles", "step": 3, "tries": ["b", "d"], "right": "d"}]}
///
/// Steps count from 1, and answers are named by their letters. `tries` are in their order in time.

inline constexpr int kMostSteps = 12;   ///< of a lesson: as many dots fit
inline constexpr int kMostAnswers = 4;  ///< to a question

struct AnsweredQuestion {
  std::string lesson;
  int step = 1;
  std::vector<int> tries;  ///< from 0, which is a
  int right = 0;           ///< as the file has it
};

/// @throws std::system_error; ParseError for what is no such file, and for one of more than 1 MB
[[nodiscard]] std::vector<AnsweredQuestion> readAnswers(const std::string& file);
/// The same as a file has it.
[[nodiscard]] std::string answersText(const std::vector<AnsweredQuestion>& answers);

}  // namespace xnewell
