#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "geometry/model/mesh.h"

namespace xnewell {

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
