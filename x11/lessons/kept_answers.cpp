#include "x11/lessons/kept_answers.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "geometry/files/output_file.h"
#include "x11/homework/answer_file.h"
#include "x11/kit/score.h"

namespace xnewell {

void KeptAnswers::keepIn(const std::string& file) {
  file_ = file;
  if (!std::filesystem::exists(file)) return;
  for (AnsweredQuestion& one : readAnswers(file))
    lessons_[one.lesson][one.step - 1] = {.tries = std::move(one.tries), .right = one.right};
}

void KeptAnswers::add(const Lesson& lesson, int step, int answer) {
  const auto& answers = lesson.steps[static_cast<std::size_t>(step)].question->answers;
  const auto right = std::ranges::find(answers, true, &LessonAnswer::holds) - answers.begin();
  Question& question = lessons_[lesson.name][step];
  question.tries.push_back(answer);
  question.right = static_cast<int>(right);
  if (file_.empty()) return;
  std::vector<AnsweredQuestion> all;
  for (const auto& [name, steps] : lessons_)
    for (const auto& [number, kept] : steps) all.push_back({name, number + 1, kept.tries, kept.right});
  rewriteFile(file_, answersText(all));
}

std::string KeptAnswers::score(const std::string& lesson) const {
  const auto found = lessons_.find(lesson);
  if (found == lessons_.end()) return "";
  Score score;
  for (const auto& [step, question] : found->second) score.add(question.tries.front() == question.right);
  return score.inWords();
}

}  // namespace xnewell
