#pragma once

#include <cstdlib>

namespace xnewell {

#ifdef __SANITIZE_ADDRESS__
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

/// The seeds of a test: 0..count-1 or, where the environment says XNEWELL_SEED=seed, that one alone. A scene
/// that failed is run again so; what a test asks of all scenes together, it then leaves out. So it does in a
/// sanitized build, which takes an eighth of the seeds: it looks for faults of the code on its way, several
/// times more slowly, and the answers are those of the other builds.
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
