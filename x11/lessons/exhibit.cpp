#include "x11/lessons/exhibit.h"

namespace xnewell {

std::optional<int> stepOf(const SortedScene& run, const EventChoice& choice) {
  int left = choice.number;
  for (std::size_t k = 0; k < run.events.size(); ++k) {
    const Event& e = run.events[k];
    const bool one = choice.test ? e.kind == Event::Kind::Compare && e.test == *choice.test
                                 : !choice.kind || e.kind == *choice.kind;
    if (one && --left == 0) return static_cast<int>(k) + 1;
  }
  return std::nullopt;
}

}  // namespace xnewell
