#include "x11/kit/typed_line.h"

#include <algorithm>
#include <utility>

namespace xnewell {

void TypedLine::ask(Question question) {
  cancel();
  question_ = std::move(question);
  complaint_.clear();
}

void TypedLine::cancel() {
  const std::optional<Question> dropped = std::exchange(question_, std::nullopt);
  if (dropped && dropped->dropped) dropped->dropped();
}

bool TypedLine::pick(int cell) {
  if (!question_ || !question_->cells) return false;
  question_->text = "cell " + std::to_string(cell);
  press({NamedKey::Return});
  return true;
}

std::optional<Typed> TypedLine::typed() const {
  if (!question_) return std::nullopt;
  return Typed{question_->asks, question_->text, complaint_, !question_->offers.empty()};
}

/// Puts the next of the offered texts on the line, or the one before.
void TypedLine::offer(bool next) {
  const std::vector<std::string>& offers = question_->offers;
  if (offers.empty()) return;
  const auto at = std::ranges::find(offers, question_->text);
  if (next)
    question_->text = at == offers.end() || at + 1 == offers.end() ? offers.front() : *(at + 1);
  else
    question_->text = at == offers.begin() || at == offers.end() ? offers.back() : *(at - 1);
  question_->fresh = true;
}

void TypedLine::press(const Key& key) {
  complaint_.clear();
  std::string& text = question_->text;
  switch (key.name) {
    case NamedKey::Escape:
      return cancel();
    case NamedKey::Backspace:
      if (!text.empty()) text.pop_back();
      question_->fresh = false;  // the next letter is added to the text that is left
      return;
    case NamedKey::Return: {
      const Question asked = *std::exchange(question_, std::nullopt);
      complaint_ = asked.take(asked.text);
      if (!complaint_.empty()) question_ = asked, question_->fresh = true;  // a letter begins anew
      return;
    }
    case NamedKey::Space:
      text += ' ';
      return;
    case NamedKey::Up:
    case NamedKey::Down:
      return offer(key.name == NamedKey::Down);
    case NamedKey::Letter:
      if (question_->fresh) text.clear();
      text += key.letter;
      question_->fresh = false;
      return;
    default:
      return;
  }
}

}  // namespace xnewell
