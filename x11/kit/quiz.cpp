#include "x11/kit/quiz.h"

#include <cctype>
#include <utility>

#include "x11/drawing/wording.h"

namespace xnewell {

void Quiz::ask(const char* none) {
  if (now_.empty()) return host_.notify(none);
  const page::Question asked = now_[next_ % now_.size()];
  hiding_.from = asked.rank, tried_ = false;
  changed_();
  host_.ask({.asks = "predict " + asked.name + (asked.decimals > 0 ? ", to two decimals at least" : ""),
             .take = [this, asked](const std::string& text) -> std::string {
               const auto answer = asked.judged(text);
               if (!answer.complaint.empty()) return answer.complaint;
               if (!std::exchange(tried_, true)) score_.add(answer.isRight);
               if (!answer.isRight) return text + " is not right. Try again, or press Esc to see it.";
               tell(asked, "Right: ");
               return {};
             },
             .dropped = [this, asked] { tell(asked, ""); },
             .ofPicture = true});
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
