#pragma once

#include <map>
#include <string>
#include <vector>

#include "x11/lessons/lesson.h"

namespace xnewell {

/// What a student answered in lessons, for himself and for his teacher, in a file (answer_file.h).
class KeptAnswers {
 public:
  /// From now on each answer is written to this file. What it holds already is kept.
  /// @throws ParseError, std::system_error
  void keepIn(const std::string& file);

  /// @throws std::system_error if the file cannot be written
  void add(const Lesson& lesson, int step, int answer);

  /// "2 of 3 right at the first try"; "" if no question of the lesson was answered.
  [[nodiscard]] std::string score(const std::string& lesson) const;

 private:
  struct Question {
    std::vector<int> tries;
    int right;
  };
  using Steps = std::map<int, Question>;  ///< from 0

  std::map<std::string, Steps> lessons_;
  std::string file_;
};

}  // namespace xnewell
