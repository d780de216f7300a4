#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>

#include "geometry/files/bpt.h"
#include "geometry/files/obj.h"
#include "geometry/files/off.h"
#include "geometry/files/ply.h"
#include "geometry/model/mesh.h"

namespace xnewell {

/// The folder of the scenes, lessons and models that come with the program. It is looked for beside the
/// program: bin/xnewell finds share/xnewell, wherever the folder above both has been moved to. In the build
/// folder a link stands in that place. If there is none, for example because another program uses these
/// libraries, it is the folder into which `cmake --install` put the data.
/// @throws std::runtime_error if neither exists; the message names both
[[nodiscard]] const std::filesystem::path& dataFolder();

/// The files that hold a model. The extension says which kind a file is, in lower or upper case.
struct ModelFileRow {
  std::string_view extension;
  Mesh (*polygons)(
      const std::filesystem::path& file);  ///< reads its polygons; null if it holds patches (bpt.h)
};
inline constexpr std::array kModelFiles{ModelFileRow{".obj", readObj}, ModelFileRow{".ply", readPly},
                                        ModelFileRow{".off", readOff}, ModelFileRow{".bpt", nullptr}};

/// The row of a file; null if its extension is none of them.
[[nodiscard]] const ModelFileRow* modelFile(const std::filesystem::path& file);

/// The extension of a file in lower case: ".obj".
[[nodiscard]] std::string extensionOf(const std::filesystem::path& file);

/// `.obj, .ply, .off, .bpt`, for a message.
[[nodiscard]] std::string modelExtensions();

}  // namespace xnewell
