#pragma once

#include <optional>
#include <string>

#include "x11/kit/key.h"
#include "x11/kit/prompt.h"

namespace xnewell {

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

}  // namespace xnewell
