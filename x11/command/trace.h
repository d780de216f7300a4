#pragma once

#include <iosfwd>

#include "depthsort/depth_sort.h"
#include "shading/picture/picture.h"
#include "x11/options/options.h"

namespace xnewell {

/// `trace`: describes a run of the depth sort.

/// The run of a picture with planes (Picture::withPlanes()), with its events: the textbook's, or with --quick
/// the accelerated one.
/// @throws std::runtime_error if the run has too many steps to record
[[nodiscard]] SortedScene recordedRun(const Options& options, const Picture& picture);

/// Writes one JSON object per line. The first, "event": "run", describes the run; the last, "summary", gives
/// its counts. Between them stand, in the order of the run, the events take, test, move, cycle, impossible,
/// vain, contact, cut and paint. Before a test that settles a pair stand the tests that were made earlier and
/// failed; together they are one step. Lengths are in pixels, a larger z is nearer, and numbers have ten
/// digits.
/// @throws std::system_error if `out` accepts no more
void printTrace(const Options& options, const Picture& picture, const SortedScene& sorted, std::ostream& out);

}  // namespace xnewell
