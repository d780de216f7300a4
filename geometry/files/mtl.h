#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace xnewell {

/// What an MTL file says of a material's diffuse term.
struct MtlMaterial {
  glm::dvec3 Kd{1.0};  ///< RGB in [0, 1]
  std::string map;     ///< the file of map_Kd as it is written, "" for none
  int line = 0;        ///< where map_Kd is
  bool operator==(const MtlMaterial&) const = default;
};

struct MtlLibrary {
  std::map<std::string, MtlMaterial, std::less<>> materials;  ///< by name
  std::vector<std::string> notes;                             ///< as Mesh::notes
};

/// Reads the materials of an MTL file (Alias|Wavefront, Advanced Visualizer manual, chapter 5). It uses
/// `newmtl`, `Kd` and `map_Kd`. A note names the other statements once. A material without `Kd r g b` is
/// white, and so are the rare `Kd spectral` and `Kd xyz`. Components are clamped to [0, 1]. `Kd r` alone is a
/// gray.
///
/// The file of `map_Kd` is the rest of the line after the options: a name may have blanks. The options are
/// read and not applied. A note says so for the first that would change the picture: -o, -s and -t (they move
/// the texture), -mm, -imfchan, -cc and `-clamp on`. -blendu, -blendv, -bm, -boost and -texres are about
/// filtering, which the program does not do.
///
/// Throws ParseError if a component is not a number, or if map_Kd has no file.
[[nodiscard]] MtlLibrary parseMtl(std::string_view text, const std::string& name);

}  // namespace xnewell
