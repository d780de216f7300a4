#pragma once

#include <functional>
#include <string>
#include <vector>

namespace xnewell {

/// A question whose answer the user types on a line under the body. Return accepts the answer, Esc cancels.
struct Question {
  std::string asks;                      ///< "go to step"
  std::string text = {};                 ///< the text at first
  bool fresh = true;                     ///< true if the first letter typed replaces the text
  std::vector<std::string> offers = {};  ///< the texts that Up and Down put on the line
  /// Takes the text. Returns "", or a sentence that says what is wrong; then the user can correct the text.
  std::function<std::string(const std::string&)> take;
  std::function<void()> dropped = {};  ///< called if the line is closed without an answer
  bool cells = false;                  ///< a click on the strip answers `cell 178`
  bool ofPicture = false;              ///< the line closes when another picture is shown
};

/// Where a view talks to the user.
class Prompt {
 public:
  virtual ~Prompt() = default;
  virtual void ask(Question question) = 0;
  /// Shows a warning, one sentence, in the status line until the next key or click.
  virtual void notify(std::string notice) = 0;
  /// Shows plain news there until the next key.
  virtual void tell(std::string news) = 0;
};

}  // namespace xnewell
