#include "x11/lessons/kept_answers.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "geometry/files/output_file.h"
#include "geometry/files/text_file.h"
#include "shading/scene/json_text.h"
#include "x11/kit/score.h"

namespace xnewell {

namespace {

std::string letterText(int answer) { return {static_cast<char>('a' + answer)}; }

int readLetter(const Node& node) {
  const std::string letter = node.text();
  if (letter.size() != 1 || letter[0] < 'a' || letter[0] >= 'a' + kMostAnswers)
    node.fail("a letter from a to d is needed");
  return letter[0] - 'a';
}

}  // namespace

void KeptAnswers::keepIn(const std::string& file) {
  file_ = file;
  if (!std::filesystem::exists(file)) return;
  const JsonText json{readTextFile(file), file};
  const Node root = json.root();
  root.expectKeys({"answers"});
  if (!root.has("answers")) root.fail("answers is needed");
  const Node answers = root.at("answers");
  for (int k = 0; k < answers.size(); ++k) {
    const Node node = answers.item(k);
    node.expectKeys({"lesson", "step", "tries", "right"});
    for (const char* const key : {"lesson", "step", "tries", "right"})
      if (!node.has(key)) node.fail(std::string{key} + " is needed");
    Question question{.tries = {}, .right = readLetter(node.at("right"))};
    const Node tries = node.at("tries");
    if (tries.size() == 0) tries.fail("an answer is needed");
    for (int i = 0; i < tries.size(); ++i) question.tries.push_back(readLetter(tries.item(i)));
    lessons_[node.at("lesson").text()][node.at("step").whole(1, kMostSteps) - 1] = std::move(question);
  }
}

void KeptAnswers::add(const Lesson& lesson, int step, int answer) {
  const auto& answers = lesson.steps[static_cast<std::size_t>(step)].question->answers;
  const auto right = std::ranges::find(answers, true, &LessonAnswer::holds) - answers.begin();
  Question& question = lessons_[lesson.name][step];
  question.tries.push_back(answer);
  question.right = static_cast<int>(right);
  if (file_.empty()) return;
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const auto& [name, steps] : lessons_)
    for (const auto& [number, kept] : steps) {
      nlohmann::ordered_json tries = nlohmann::ordered_json::array();
      for (const int k : kept.tries) tries.push_back(letterText(k));
      all.push_back(
          {{"lesson", name}, {"step", number + 1}, {"tries", tries}, {"right", letterText(kept.right)}});
    }
  writeFile(file_, nlohmann::ordered_json{{"answers", all}}.dump(2) + '\n');
}

std::string KeptAnswers::score(const std::string& lesson) const {
  const auto found = lessons_.find(lesson);
  if (found == lessons_.end()) return "";
  Score score;
  for (const auto& [step, question] : found->second) score.add(question.tries.front() == question.right);
  return score.inWords();
}

}  // namespace xnewell
