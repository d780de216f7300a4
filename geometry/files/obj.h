#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "geometry/model/mesh.h"

namespace xnewell {

/// Reads the polygons of a Wavefront OBJ file (Alias|Wavefront, Advanced Visualizer manual, appendix B1).
///
/// Read: `v` (x y z; a weight or a colour after them is ignored), `vt` (u, v; a missing v is 0, a depth
/// ignored), `f` with corners `v`, `v/vt`, `v//vn`, `v/vt/vn`, counted from 1 or, negative, back from the
/// last one so far; `g` and `o`, which both begin a group; `usemtl`, and `mtllib` for diffuse colours.
/// Everything else is ignored, and so is `vn`: vertex normals are computed. A face may name what comes after
/// it.
///
/// Mesh::points      every `v` in file order, correctly rounded (number.h), used or not.
/// Mesh::uv          every `vt` in file order, if a face uses any.
/// Mesh faces        every `f` in file order, unchanged: no triangulation.
/// Mesh::groupNames  the groups that own a face, in file order. Several names after `g` are one, joined by
///                   blanks; a group begun twice is one; faces before any belong to `default`.
/// Mesh::materials   the materials that a face uses, in file order; white where no library knows the name.
/// Mesh::rounding    of every group 0.5 * 10^-d, d the most decimals that any x, y or z carries in its text
///                   (decimals() in number.h: `-1.250` has 3, `1.5e-3` 4, `7` and `1e3` none). A writer that
///                   prints significant digits (%g) shows the decimals of its smallest coordinate. 0 from
///                   d = 309 on.
///
/// Throws ParseError, `teapot.obj:41: face index 0; OBJ counts from 1`, and for a file without a face.
/// `name` is how errors call the text. Libraries are looked for in `folder`; a missing one is no error, but
/// the first is noted (Mesh::notes), as is the first material that none of those found has; one that cannot
/// be read is (std::system_error), and so is a malformed colour in it.
[[nodiscard]] Mesh parseObj(std::string_view text, const std::string& name,
                            const std::filesystem::path& folder);

/// The same from a file, libraries beside it. Throws std::system_error too if it cannot be read
/// (text_file.h).
[[nodiscard]] Mesh readObj(const std::filesystem::path& file);

}  // namespace xnewell
