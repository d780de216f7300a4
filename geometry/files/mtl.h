#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace xnewell {

/// What an MTL file says of a material, where the illumination equation has a place for it.
struct MtlMaterial {
  glm::dvec3 Kd{1.0};                  ///< RGB in [0, 1]
  std::string map = {};                ///< the file of map_Kd as it is written, "" for none
  int line = 0;                        ///< where map_Kd is
  glm::dvec2 scale{1.0}, offset{0.0};  ///< of map_Kd: the texture is taken at scale uv + offset
  std::optional<glm::dvec3> Ks = {};   ///< RGB in [0, 1]; black for `illum 0` and `illum 1`
  std::optional<int> Ns = {};          ///< rounded, 0..1,000,000
  bool operator==(const MtlMaterial&) const = default;
};

struct MtlLibrary {
  std::map<std::string, MtlMaterial, std::less<>> materials;  ///< by name
  std::vector<std::string> notes;                             ///< as Mesh::notes
};

/// Reads the materials of an MTL file (Alias|Wavefront, Advanced Visualizer manual, chapter 5). It uses
/// `newmtl`, `Kd`, `Ks`, `Ns`, `illum` and `map_Kd`. `illum` 0 and 1 have no highlight. A note names the
/// other statements once, but not those that leave the picture as it is: `d 1`, `Tr 0`, `Ke 0 0 0`, `illum
/// 2`. There is no place for Ka, because the ambient term has the colour of the diffuse term (Foley & van Dam
/// 2e §16.1.1).
///
/// A material without `Kd r g b` is white, and so are the rare `Kd spectral` and `Kd xyz`; Ks likewise.
/// Components are clamped to [0, 1]. `Kd r` alone is a gray.
///
/// The file of `map_Kd` is the rest of the line after the options: a name may have blanks. Of the options, -s
/// and -o move the texture. A note names the first other one that would change the picture: -t, -mm,
/// -imfchan, -cc and `-clamp on`. -blendu, -blendv, -bm, -boost and -texres are about filtering, which the
/// program does not do.
///
/// Throws ParseError if a component is not a number, or if map_Kd has no file.
[[nodiscard]] MtlLibrary parseMtl(std::string_view text, const std::string& name);

}  // namespace xnewell
