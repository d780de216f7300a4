#pragma once

#include <iosfwd>

#include "depthsort/depth_sort.h"
#include "shading/picture/picture.h"
#include "x11/options/options.h"

namespace xnewell {

/// `trace`: a run of the depth sort, told.

/// The run of a picture with planes (Picture::withPlanes()), with its events: the textbook's, or with --quick
/// the accelerated one.
/// @throws std::runtime_error where it has too many steps to be recorded
[[nodiscard]] SortedScene recordedRun(const Options& options, const Picture& picture);

/// One JSON object a line. The first, "event": "run", describes the run and the last, "summary", counts.
/// Those between are, in the order of the run: take, test, move, cycle, impossible, contact, cut, paint. A
/// test that settles a pair is preceded by those that were made before it and failed; all of them are one
/// step. Lengths are pixels, z larger is nearer, numbers have ten digits.
/// @throws std::system_error if `out` takes no more
void printTrace(const Options& options, const Picture& picture, const SortedScene& sorted, std::ostream& out);

}  // namespace xnewell
