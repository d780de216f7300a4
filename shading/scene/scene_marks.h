#pragma once

#include "shading/scene/json_node.h"
#include "shading/scene/scene.h"

namespace xnewell {

/// Reads "lines" and "labels" of a scene file. A file coordinate is a mesh coordinate times 2^exponent.
/// @throws ParseError
[[nodiscard]] SceneMarks readMarks(const Node& root, int exponent);

}  // namespace xnewell
