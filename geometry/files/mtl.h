#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <map>
#include <string>
#include <string_view>

namespace xnewell {

/// Diffuse colours by material name, RGB in [0, 1].
using MaterialColors = std::map<std::string, glm::dvec3, std::less<>>;

/// The materials of an MTL file: `newmtl` and `Kd`; everything else is ignored. A material without a
/// `Kd r g b` is white (so are the rare `Kd spectral` and `Kd xyz`); components are clamped to [0, 1]; `Kd r`
/// alone is a gray. Throws ParseError where a component is no number.
[[nodiscard]] MaterialColors parseMtl(std::string_view text, const std::string& name);

}  // namespace xnewell
