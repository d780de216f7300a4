#pragma once

#include <string>
#include <string_view>

namespace xnewell {

/// Where --frames writes: numbered PNGs in a folder of their own.

/// Makes the folder if need be. @throws UsageError if it holds frames already; std::system_error
void makeFrameFolder(const std::string& folder);

/// FOLDER/0007-cut.png
[[nodiscard]] std::string frameFile(const std::string& folder, int number, std::string_view word);

}  // namespace xnewell
