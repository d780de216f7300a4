#include "x11/kit/quiz.h"

#include <cctype>
#include <memory>
#include <utility>

#include "x11/drawing/wording.h"

namespace xnewell {

void askNumber(Prompt& host, const page::Question& asked, Score& score,
               std::function<void(std::optional<int>)> tried, std::function<void(bool)> tell) {
  const auto isFirst = std::make_shared<bool>(true);
  host.ask({.asks = "predict " + asked.name + (asked.decimals > 0 ? ", to two decimals at least" : "") +
                    (asked.lands ? ", or click the strip" : ""),
            .take =
                [asked, isFirst, &score, tried = std::move(tried), tell](const std::string& text) {
                  const auto answer = asked.judged(text);
                  if (!answer.complaint.empty()) return answer.complaint;
                  if (std::exchange(*isFirst, false)) score.add(answer.isRight);
                  tried(answer.lands);
                  if (answer.isRight) return tell(true), std::string{};
                  return std::string{answer.lands ? "Not so: the strip marks your cell" : "Not so"} +
                         ". Try again; Esc shows it.";
                },
            .dropped = [tell] { tell(false); },
            .cells = asked.lands != nullptr,
            .ofPicture = true});
}

void Quiz::ask(const char* none) {
  if (now_.empty()) return host_.notify(none);
  const page::Question asked = now_[next_ % now_.size()];
  hiding_.from = asked.rank, landed_.reset();
  changed_();
  askNumber(
      host_, asked, score_, [this](std::optional<int> cell) { landed_ = cell, changed_(); },
      [this, asked](bool isRight) { tell(asked, isRight ? "Right: " : ""); });
}

void Quiz::tell(const page::Question& asked, const std::string& before) {
  next_ = now_.empty() ? 0 : (next_ + 1) % now_.size();
  hiding_.from = next_ == 0 ? 0 : now_[next_].rank;
  changed_();
  std::string name = asked.name;
  if (before.empty()) name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
  host_.tell(before + name + " is " + fixed(asked.written, asked.decimals) + "." +
             (isHiding() ? " y asks the next number, Esc shows all." : "") +
             (score_.asked > 0 ? " " + score_.text() + "." : ""));
}

}  // namespace xnewell
