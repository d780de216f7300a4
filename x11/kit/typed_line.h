#pragma once

#include <charconv>
#include <functional>
#include <optional>
#include <string>

#include "geometry/files/parse_error.h"
#include "x11/kit/key_table.h"

namespace xnewell {

/// The whole number that `text` spells; nothing if it has any other character.
inline std::optional<int> wholeNumber(const std::string& text) {
  int value = 0;
  const char* const end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, value);
  return error == std::errc{} && at == end && !text.empty() ? std::optional{value} : std::nullopt;
}

/// The number that `text` spells, perhaps with a plus and with blanks around it; nothing if it has any other
/// character.
inline std::optional<double> typedNumber(std::string text) {
  text.erase(text.find_last_not_of(' ') + 1);
  text.erase(0, text.find_first_not_of(' '));
  if (text.starts_with('+') && !text.starts_with("+-")) text.erase(0, 1);
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, value);
  return error == std::errc{} && at == end && !text.empty() ? std::optional{value} : std::nullopt;
}

/// What a line shows while the user types on it.
struct Typed {
  std::string asks, text, complaint;  ///< `complaint` is about the text that was tried last
  bool offers = false;                ///< Up and Down put another text on the line
  bool operator==(const Typed&) const = default;
};

/// The line on which the user answers a question.
class TypedLine {
 public:
  void ask(Question question);
  void cancel();
  /// The user picks a cell. Returns false if no question wants one.
  [[nodiscard]] bool pick(int cell);
  /// Another picture is shown.
  void leavePicture() {
    if (question_ && question_->ofPicture) cancel();
  }
  [[nodiscard]] bool isOpen() const { return question_.has_value(); }
  /// Edits the text of an open line. Return gives it to the question, which may complain and stay; Esc
  /// cancels.
  void press(const Key& key);
  [[nodiscard]] std::optional<Typed> typed() const;

 private:
  void offer(bool next);

  std::optional<Question> question_;
  std::string complaint_;
};

/// Asks for the name of a file to write, and a second time before it replaces a file.
/// @param complaint  says what is wrong with a name; "" if nothing
/// @param write      writes the file. If it throws std::system_error, that is told, and the user may correct
///                   the name
[[nodiscard]] Question fileQuestion(std::string asks, std::string text,
                                    std::function<std::string(const std::string& file)> complaint,
                                    std::function<void(const std::string& file)> write);

/// Turns a text into one line of bounded length, whatever names and words it quotes: a text of more than 800
/// bytes keeps its first 600 and its last 200, and all is visible.
[[nodiscard]] inline std::string oneLine(std::string text) {
  constexpr std::size_t kBegin = 600, kEnd = 200;
  if (text.size() > kBegin + kEnd) text.replace(kBegin, text.size() - kBegin - kEnd, "...");
  return visible(text);
}

}  // namespace xnewell
