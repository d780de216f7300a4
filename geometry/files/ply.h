#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "geometry/model/mesh.h"

namespace xnewell {

/// Reads the polygons of a PLY file, version 1.0 (Turk, The PLY Polygon File Format, 1994): as text, or
/// binary with either byte order.
///
/// Of the element `vertex` it uses x, y and z, and as texture coordinates u and v, s and t, or texture_u and
/// texture_v, and as normals nx, ny and nz. Of the element `face` it uses the list vertex_indices or
/// vertex_index, of any length, and as the face's colour red, green and blue (IndexedFaces; whole numbers
/// count from 0 to 255, others from 0 to 1). The element `tristrips` has such lists, too, of strips of
/// triangles. Mesh::notes names all other properties and elements. Colours of vertices are among them: the
/// illumination equation has a colour for a surface, none for a vertex. As text, each element stands on a
/// line of its own.
///
/// Mesh::points      every vertex.
/// Mesh::rounding    of text as for an OBJ file (obj.h). Of binary coordinates half a unit: of the last place
///                   of single precision at the largest coordinate, of a whole number, and 0 for double.
///
/// Throws ParseError: `bunny.ply:7: unknown type 'real'` for the header and text, `bunny.ply: face 12 of 96:
/// a vertex index is 8; vertices: 8` for binary data, where elements count from 1. Memory grows with the
/// elements that are read, not with the numbers that the header states.
[[nodiscard]] Mesh parsePly(std::string_view text, const std::string& name);

/// Reads the same from a file. Also throws std::system_error if the file cannot be read (text_file.h).
[[nodiscard]] Mesh readPly(const std::filesystem::path& file);

}  // namespace xnewell
