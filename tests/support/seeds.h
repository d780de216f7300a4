#pragma once

#include <cstdlib>
#include <initializer_list>
#include <ranges>
#include <vector>

extern "C" [[gnu::weak]] void __asan_init();  // the sanitizer's library has it

namespace xnewell {

/// Whether the program runs with the address sanitizer. The object files of tests do not know: the same ones
/// are linked with sanitized floors and with others.
inline const bool kSanitized = &__asan_init != nullptr;

/// The cases of a test that has a list of them. A sanitized build takes only the first `few`: it runs several
/// times more slowly and looks for faults of the code on its way, and the results are those of the other
/// builds.
template <std::ranges::random_access_range Cases>
requires std::is_lvalue_reference_v<Cases&&>
auto someOf(Cases&& cases, long few) {
  return cases | std::views::take(kSanitized ? few : static_cast<long>(std::ranges::size(cases)));
}
template <typename Case>
std::vector<Case> someOf(std::initializer_list<Case> cases, long few) {
  return {cases.begin(), kSanitized ? cases.begin() + few : cases.end()};
}

/// The seeds of a test: 0..count-1. If the environment has XNEWELL_SEED=seed, only that one, so that a scene
/// that failed can be run again; the test then leaves out what it asks of all scenes together. A sanitized
/// build leaves that out too and takes an eighth of the seeds.
class Seeds {
 public:
  unsigned from = 0, end;

  explicit Seeds(unsigned count) : end{kSanitized ? (count + 7) / 8 : count}, all_{!kSanitized} {
    if (const char* const one = std::getenv("XNEWELL_SEED")) {
      from = static_cast<unsigned>(std::strtoul(one, nullptr, 10));
      end = from + 1;
      all_ = false;
    }
  }
  [[nodiscard]] bool all() const { return all_; }

 private:
  bool all_;
};

}  // namespace xnewell
