#pragma once

#include <filesystem>

namespace xnewell {

/// The folder of the scenes, lessons and models that come with the program. It is looked for beside the
/// program: bin/xnewell finds share/xnewell, wherever the folder above both has been moved to. In the build
/// folder a link stands in that place. If there is none, for example because another program uses these
/// libraries, it is the folder into which `cmake --install` put the data.
/// @throws std::runtime_error if neither exists; the message names both
[[nodiscard]] const std::filesystem::path& dataFolder();

}  // namespace xnewell
