#pragma once

#include <filesystem>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/model/mesh.h"

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

/// Reads the polygons of a Wavefront OBJ file (Alias|Wavefront, Advanced Visualizer manual, appendix B1).
///
/// It reads `v` (x y z; it ignores a weight or a colour after them), `vt` (u, v; a missing v is 0, a depth is
/// ignored), `vn` (x, y, z; 0 and NaN count as none), and `f` with corners `v`, `v/vt`, `v//vn` or `v/vt/vn`.
/// Indices count from 1 or, if negative, back from the last one so far. It reads `g` and `o`, which both
/// begin a group, `usemtl`, and `mtllib` for colours, exponents and textures (mtl.h). It uses nothing else.
/// Mesh::notes names the other statements once. A face may refer to vertices that come later in the file.
///
/// Mesh::points      every `v` in file order, correctly rounded (number.h), used or not.
/// Mesh::uv          every `vt` in file order, if a face uses any; then those that -s and -o of map_Kd move.
/// Mesh::normals     those of the corners.
/// Mesh faces        every `f` in file order, unchanged: no triangulation.
/// Mesh::groupNames  the groups that own a face, in file order. Several names after `g` are one name, joined
///                   by blanks. A group that begins twice is one group. Faces before any group belong to
///                   `default`.
/// Mesh::materials   the materials that a face uses, in file order; white if no library has the name.
/// Mesh::textureFiles  the files of their textures (namedFile() in the folder of the library), not read and
///                   perhaps missing.
/// Mesh::rounding    for every group 0.5 * 10^-d. RoundingOfNumbers in number.h computes it from all x, y
///                   and z of the file. A writer that prints significant digits (%g) shows the decimals of
///                   its smallest coordinates. 0 for d >= 309.
///
/// Throws ParseError, `teapot.obj:41: face index 0; OBJ counts from 1`, also if the file has no face.
/// Messages call the text `name`. Libraries are searched for in `folder` (namedFile()). A missing library is
/// not an error, but Mesh::notes reports the first one, and the first material that no library has. It also
/// reports coordinates that are written with more decimals than they hold (RoundingOfNumbers::doubtful()). A
/// library that cannot be read is an error (std::system_error), and so is a malformed colour in it.
/// Mesh::notes also has those of the libraries.
[[nodiscard]] Mesh parseObj(std::string_view text, const std::string& name,
                            const std::filesystem::path& folder);

/// Reads the same from a file, with libraries from its folder. Also throws std::system_error if the file
/// cannot be read (text_file.h).
[[nodiscard]] Mesh readObj(const std::filesystem::path& file);

}  // namespace xnewell
