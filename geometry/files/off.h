#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "geometry/model/mesh.h"

namespace xnewell {

/// Reads the polygons of an OFF file (Geomview manual, "OFF Files"), as text.
///
///   OFF                      or COFF, NOFF, STOFF, or these letters together in the order ST, C, N
///   8 6 12                   the numbers of points, faces and edges; that of the edges does not matter
///   0.5 -0.5 0               a line for each point: x y z, then what the first word promises: N a normal
///                            (3 numbers), C a colour (1, 3 or 4), ST texture coordinates (2)
///   4 0 1 2 3  255 0 0       a line for each face: its number of corners, their indices from 0, and a colour
///                            or none: r g b or r g b a, from 0 to 255, or from 0 to 1 if one has a point
///
/// Blank lines and '#' comments may stand anywhere. The counts may follow OFF on its line, even without a
/// blank. Colours of faces are used (IndexedFaces), and so are texture coordinates. Colours of points,
/// normals, opacities and single numbers for the colours of faces, which are indices into a colormap of the
/// reader, are not: Mesh::notes says so. Binary files and points of other than three coordinates are
/// refused.
/// Mesh::points has every point, Mesh::rounding is that of an OBJ file (obj.h).
///
/// Throws ParseError, `cube.off:12: index 8 is out of range; points: 8`. Memory grows with the lines that are
/// read, not with the numbers that the file states.
[[nodiscard]] Mesh parseOff(std::string_view text, const std::string& name);

/// Reads the same from a file. Also throws std::system_error if the file cannot be read (text_file.h).
[[nodiscard]] Mesh readOff(const std::filesystem::path& file);

}  // namespace xnewell
