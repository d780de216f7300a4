#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/model/bezier.h"

namespace xnewell {

/// Reads bicubic patches in the classic text form of the teapot. The file starts with the number of patches,
/// 1 to kMaxPatches. Each patch follows: its degrees `3 3`, then its 16 control points `x y z`, each on its
/// own line. Blank lines and '#' comments may stand anywhere.
/// Space: the file's. number.h says how coordinates are read. Throws ParseError, `teapot.bpt:412: the file
/// ends inside patch 24 of 32`. Memory grows with the patches that are read, not with the number that the
/// file states.
[[nodiscard]] std::vector<BezierPatch> parseBpt(std::string_view text, const std::string& name);

/// Reads the same from a file. Also throws std::system_error if the file cannot be read (text_file.h).
[[nodiscard]] std::vector<BezierPatch> readBpt(const std::filesystem::path& file);

/// With 4 x 4 faces for each patch, face numbers still fit 24 bits.
inline constexpr int kMaxPatches = 1'000'000;

}  // namespace xnewell
