#pragma once

#include <string>
#include <string_view>

namespace xnewell {

/// The place where --frames writes: numbered PNG files in a folder of their own.

/// Makes the folder if it does not exist. @throws UsageError if it holds frames already; std::system_error
void makeFrameFolder(const std::string& folder);

/// The name of a frame's file, such as FOLDER/0007-cut.png.
[[nodiscard]] std::string frameFile(const std::string& folder, int number, std::string_view word);

}  // namespace xnewell
