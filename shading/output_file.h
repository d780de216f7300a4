#pragma once

#include <string>
#include <string_view>

/// Writes a whole file: afterwards it is complete, or as it was before (absent, if it was absent).
/// The bytes go to a temporary file in the same folder, which takes the name when it is complete; a
/// symbolic link stays, and the file it leads to is replaced. Where that makes no sense (/dev/stdout,
/// /dev/fd/N, /dev/null, a pipe) they go straight in.
/// @throws std::system_error `FILE: No space left on device`
void writeFile(const std::string& file, std::string_view bytes);
