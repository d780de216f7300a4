#include "x11/homework/questions.h"

#include <algorithm>
#include <charconv>
#include <set>

#include "x11/drawing/wording.h"

namespace xnewell {

namespace {

/// The characters that mean something in a GIFT file.
std::string inGift(const std::string& text) {
  std::string gift;
  for (const char c : text) {
    if (std::string_view{"~=#{}:\\"}.find(c) != std::string_view::npos) gift += '\\';
    gift += c;
  }
  return gift;
}

/// A number with as many decimals as its tolerance asks for.
/// With the decimals that the question asks for.
std::string numberText(const ExamQuestion& q) {
  return fixed(q.number, q.tolerance >= 0.001 ? 3 : q.tolerance > 0 ? 4 : 0);
}

}  // namespace

int rolled(Dice& dice, int low, int high) {
  return low + static_cast<int>(dice() % static_cast<unsigned>(high - low + 1));
}

double rolled(Dice& dice, int low, int high, double per) { return rolled(dice, low, high) / per; }

const std::vector<QuestionKind>& questionKinds() {
  static const std::vector<QuestionKind> all = [] {
    // Those of the scene and those of numbers in turn.
    const std::vector<QuestionKind> numbers = numberQuestions(), scenes = sceneQuestions();
    std::vector<QuestionKind> kinds;
    for (std::size_t k = 0; k < std::max(numbers.size(), scenes.size()); ++k) {
      if (k < numbers.size()) kinds.push_back(numbers[k]);
      if (k < scenes.size()) kinds.push_back(scenes[k]);
    }
    return kinds;
  }();
  return all;
}

std::vector<ExamQuestion> makeQuestions(const QuestionScene& scene, int count, unsigned seed) {
  Dice dice{seed};
  std::vector<ExamQuestion> questions;
  std::set<std::string> texts;
  const std::vector<QuestionKind>& kinds = questionKinds();
  // A kind that the scene has no question of, or no new one, is left out.
  for (std::size_t k = 0, tries = 0;
       static_cast<int>(questions.size()) < count && tries < 50u * static_cast<unsigned>(count) + 500u;
       k = (k + 1) % kinds.size(), ++tries)
    if (auto one = kinds[k].make(dice, scene); one && texts.insert(one->text).second)
      questions.push_back(std::move(*one));
  return questions;
}

std::string questionsAsGift(const std::vector<ExamQuestion>& questions) {
  std::string gift = "// questions in Moodle's GIFT format\n";
  for (std::size_t k = 0; k < questions.size(); ++k) {
    const ExamQuestion& q = questions[k];
    gift += "\n::" + std::to_string(k + 1) + " " + inGift(q.kind) + ":: " + inGift(q.text) + " {";
    if (q.choices.empty()) {
      gift += "#" + numberText(q) + ":" + fixed(q.tolerance, q.tolerance > 0 ? 4 : 0);
    } else {
      for (std::size_t c = 0; c < q.choices.size(); ++c)
        gift += (c == q.right ? "\n  =" : "\n  ~") + inGift(q.choices[c]);
      gift += "\n";
    }
    gift += "####" + inGift(q.solution) + "}\n";
  }
  return gift;
}

std::string questionsAsText(const std::vector<ExamQuestion>& questions) {
  std::string asked, solved;
  const auto add = [](std::string& to, const std::string& number, const std::string& text) {
    std::string indent = number;
    for (const std::string& line : broken(text, 100)) {
      to += indent + line + '\n';
      indent.assign(number.size(), ' ');
    }
  };
  for (std::size_t k = 0; k < questions.size(); ++k) {
    const ExamQuestion& q = questions[k];
    const std::string number = std::to_string(k + 1) + ". ";
    add(asked, number, q.text);
    const auto letter = [](std::size_t choice) { return std::string{static_cast<char>('a' + choice)}; };
    for (std::size_t c = 0; c < q.choices.size(); ++c)
      asked += "   " + letter(c) + ") " + q.choices[c] + '\n';
    asked += '\n';
    add(solved, number, (q.choices.empty() ? numberText(q) : letter(q.right)) + ". " + q.solution);
  }
  return asked + "Solutions\n\n" + solved;
}

}  // namespace xnewell
