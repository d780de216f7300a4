#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <map>
#include <string>
#include <string_view>

namespace xnewell {

/// Diffuse colours by material name, RGB in [0, 1].
using MaterialColors = std::map<std::string, glm::dvec3, std::less<>>;

/// Reads the materials of an MTL file. It uses `newmtl` and `Kd` and ignores everything else. A material
/// without `Kd r g b` is white, and so are the rare `Kd spectral` and `Kd xyz`. Components are clamped to [0,
/// 1]. `Kd r` alone is a gray. Throws ParseError if a component is not a number.
[[nodiscard]] MaterialColors parseMtl(std::string_view text, const std::string& name);

}  // namespace xnewell
