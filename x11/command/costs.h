#pragma once

#include <string>
#include <utility>
#include <vector>

#include "shading/picture/picture.h"

namespace xnewell {

/// What each item that the picture requires (required.h) costs, in milliseconds of the processor's time. All
/// ways to make the picture run in turn (timing.h): the picture as it is, and without one item each. The cost
/// is the median, over all rounds, of the share of the picture's time that is saved without the item, times
/// the picture's time. If chance explains the difference, the cost is 0. Steps that can be done alone are
/// timed alone. The costs do not add up to the picture's time: without light, for example, there are no
/// highlights either.
/// Makes at least three rounds, and as many as fit into two seconds.
[[nodiscard]] std::vector<std::pair<std::string, double>> costsOf(const Picture& picture);

}  // namespace xnewell
