#pragma once

#include <functional>
#include <utility>

namespace xnewell {

/// Work that takes long can be given up, for example because a budget is spent. Who calls the work says when:
/// while a MayGiveUp lives, the long loops that are called in its thread throw GivenUp as soon as its
/// condition holds. What they were making is lost, and nothing else has changed.

/// It is no std::exception, so nobody takes it for the reason why something cannot be made.
struct GivenUp {};

class MayGiveUp {
 public:
  explicit MayGiveUp(std::function<bool()> condition)
      : condition_{std::move(condition)}, outer_{std::exchange(innermost, this)} {}
  MayGiveUp(const MayGiveUp&) = delete;
  MayGiveUp& operator=(const MayGiveUp&) = delete;
  ~MayGiveUp() { innermost = outer_; }

  /// @throws GivenUp if the condition of a MayGiveUp holds that is alive in this thread
  static void check() {
    for (const MayGiveUp* one = innermost; one != nullptr; one = one->outer_)
      if (one->condition_()) throw GivenUp{};
  }

 private:
  inline static thread_local MayGiveUp* innermost = nullptr;
  std::function<bool()> condition_;
  MayGiveUp* outer_;
};

/// For loops whose rounds are short: looks at the condition once in 256 rounds.
class GiveUpNowAndThen {
 public:
  void operator()() {
    if (++rounds_ % 256 == 0) MayGiveUp::check();
  }

 private:
  unsigned rounds_ = 0;
};

}  // namespace xnewell
