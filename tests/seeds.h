#pragma once

#include <cstdlib>

/// The seeds of a test: 0..count-1 or, where the environment says XNEWELL_SEED=seed, that one alone. A scene
/// that failed is run again so; what a test asks of all scenes together, it then leaves out.
struct Seeds {
  unsigned from = 0, end;
  explicit Seeds(unsigned count) : end{count} {
    if (const char* const one = std::getenv("XNEWELL_SEED")) {
      from = static_cast<unsigned>(std::strtoul(one, nullptr, 10));
      end = from + 1;
    }
  }
  [[nodiscard]] bool all() const { return end - from > 1; }
};
