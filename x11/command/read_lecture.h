#pragma once

#include <string>
#include <vector>

#include "x11/app/lecture.h"

namespace xnewell {

/// Reads a lecture, a JSON file:
///
///     {"shows": "what `xnewell scenes` says of it",
///      "pages": [
///       {"title": "Why facets?", "show": "teapot --shade flat", "notes": "Ask: how many colours has a
///       face?"},
///       {"title": "The cycle", "show": "cycle --view depthsort --step 12"},
///       {"title": "Five tests", "lesson": "five-tests"}]}
///
/// `show` is what follows `xnewell` on the command line, or a whole command as the key `C` prints it:
/// `--step` begins at a step of the depth sort, `--controls Ssn` keeps these three controls in a drawer.
/// `lesson` is a built-in lesson or a file. Files are looked for beside the lecture first. `name` is a file,
/// or a lecture of data/lectures. All scenes and lessons are read at once, so a lecture that opens has no
/// mistake on its last page.
/// @throws ParseError, UsageError, std::system_error
[[nodiscard]] std::vector<Page> readLecture(const std::string& name);

}  // namespace xnewell
