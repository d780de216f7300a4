#pragma once

#include <string>
#include <vector>

namespace xnewell {

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
