#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/model/bezier.h"

namespace xnewell {

/// Bicubic patches in the classic text form of the teapot. First the number of patches, 1 to
/// kMaxPatches; then for each its degrees `3 3` and its 16 control points, `x y z`, each on a line of its
/// own. Blank lines and '#' comments may stand anywhere. Space: the file's; coordinates are read as in
/// number.h. Throws ParseError, `teapot.bpt:412: the file ends inside patch 24 of 32`, and takes no memory on
/// the word of the count.
[[nodiscard]] std::vector<BezierPatch> parseBpt(std::string_view text, const std::string& name);

/// The same from a file. Throws std::system_error too if it cannot be read (text_file.h).
[[nodiscard]] std::vector<BezierPatch> readBpt(const std::filesystem::path& file);

/// Cut into 4 x 4 faces each, these still have face numbers of 24 bits.
inline constexpr int kMaxPatches = 1'000'000;

}  // namespace xnewell
