#include "x11/homework/answer_file.h"

#include <nlohmann/json.hpp>

#include "geometry/files/parse_error.h"
#include "geometry/files/text_file.h"
#include "shading/scene/json_text.h"

namespace xnewell {

namespace {

constexpr std::size_t kMostAnswerBytes = 1 << 20;

std::string answerLetter(int answer) { return {static_cast<char>('a' + answer)}; }

int readAnswerLetter(const Node& node) {
  const std::string letter = node.text();
  if (letter.size() != 1 || letter[0] < 'a' || letter[0] >= 'a' + kMostAnswers)
    node.fail("a letter from a to d is needed");
  return letter[0] - 'a';
}

}  // namespace

std::vector<AnsweredQuestion> readAnswers(const std::string& file) {
  const JsonText json{readTextFile(file, kMostAnswerBytes), file};
  const Node root = json.root();
  root.expectKeys({"answers"});
  if (!root.has("answers")) root.fail("answers is needed");
  const Node answers = root.at("answers");
  std::vector<AnsweredQuestion> all;
  for (int k = 0; k < answers.size(); ++k) {
    const Node node = answers.item(k);
    node.expectKeys({"lesson", "step", "tries", "right"});
    for (const char* const key : {"lesson", "step", "tries", "right"})
      if (!node.has(key)) node.fail(std::string{key} + " is needed");
    AnsweredQuestion one{.lesson = {}, .tries = {}, .right = readAnswerLetter(node.at("right"))};
    const Node tries = node.at("tries");
    if (tries.size() == 0) tries.fail("an answer is needed");
    for (int i = 0; i < tries.size(); ++i) one.tries.push_back(readAnswerLetter(tries.item(i)));
    one.lesson = node.at("lesson").text();
    one.step = node.at("step").whole(1, kMostSteps);
    all.push_back(std::move(one));
  }
  return all;
}

std::string answersText(const std::vector<AnsweredQuestion>& answers) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const AnsweredQuestion& one : answers) {
    nlohmann::ordered_json tries = nlohmann::ordered_json::array();
    for (const int k : one.tries) tries.push_back(answerLetter(k));
    all.push_back(
        {{"lesson", one.lesson}, {"step", one.step}, {"tries", tries}, {"right", answerLetter(one.right)}});
  }
  return nlohmann::ordered_json{{"answers", all}}.dump(2) + '\n';
}

}  // namespace xnewell
