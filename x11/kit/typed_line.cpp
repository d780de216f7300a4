#include "x11/kit/typed_line.h"

#include <algorithm>
#include <exception>
#include <filesystem>
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

Question fileQuestion(std::string asks, std::string text,
                      std::function<std::string(const std::string& file)> complaint,
                      std::function<void(const std::string& file)> write) {
  return {.asks = std::move(asks),
          .text = std::move(text),
          .take = [complaint = std::move(complaint), write = std::move(write),
                   replaced = std::string{}](const std::string& file) mutable -> std::string {
            if (std::string wrong = complaint(file); !wrong.empty()) return wrong;
            if (std::filesystem::is_directory(file)) return "That is a folder.";
            if (file != replaced && std::filesystem::exists(file)) {
              replaced = file;
              return "The file exists. Press Return again to replace it.";
            }
            try {
              write(file);
            } catch (const std::exception& e) {
              return oneLine(e.what());
            }
            return {};
          }};
}

}  // namespace xnewell
