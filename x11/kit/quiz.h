#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "x11/kit/key_table.h"
#include "x11/kit/page.h"

namespace xnewell {

/// How many questions the student has answered, and how many of them right at the first try.
struct Score {
  int right = 0, asked = 0;

  void add(bool isRight) { ++asked, right += isRight; }
  [[nodiscard]] std::string text() const {
    return std::to_string(right) + " of " + std::to_string(asked) + " right at the first try";
  }
  bool operator==(const Score&) const = default;
};

/// Asks for a value until it is right or given up; the first try counts. `tried` gets the cell that an answer
/// picks, and `tell` whether the last one was right. `score` outlives the question.
void askNumber(Prompt& host, const page::Question& asked, Score& score,
               std::function<void(std::optional<int>)> tried, std::function<void(bool)> tell);

/// Asks for the values of a page, one after the other. The one that is asked is hidden, with all that follow
/// from it, until the student has typed it or given up; those after it stay hidden, so that they can be
/// asked. What may be asked is always that of the page as it is now: the page may change while a line is
/// open.
class Quiz {
 public:
  /// `changed` is called when something is hidden or shown.
  Quiz(Prompt& host, std::function<void()> changed) : host_{host}, changed_{std::move(changed)} {}

  void setQuestions(std::vector<page::Question> now) { now_ = std::move(now); }
  /// Asks the next one. `none` is the notice if there is none.
  void ask(const char* none);
  /// Hides nothing; the next one to ask stays, or is the first again.
  void showAll() { hiding_ = {}, landed_.reset(), changed_(); }
  void startAgain() { next_ = 0, showAll(); }
  [[nodiscard]] page::Hiding hiding() const { return hiding_; }
  [[nodiscard]] bool isHiding() const { return hiding_.from > 0; }
  /// The cell that the last answer picks.
  [[nodiscard]] std::optional<int> landed() const { return landed_; }

 private:
  /// Shows the value, and says what it is.
  void tell(const page::Question& asked, const std::string& before);

  Prompt& host_;
  std::function<void()> changed_;
  std::vector<page::Question> now_;
  page::Hiding hiding_;
  std::size_t next_ = 0;
  std::optional<int> landed_;
  Score score_;
};

}  // namespace xnewell
