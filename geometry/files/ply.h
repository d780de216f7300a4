#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/model/mesh.h"

namespace xnewell {

/// The header of a PLY file (ply.h): what follows it, and in which form.

enum class PlyNumber { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };
struct PlyNumberRow {
  PlyNumber id;
  std::string_view name, other;  ///< both are in use
  int bytes;
  bool whole;
};
inline constexpr std::array kPlyNumbers{
    PlyNumberRow{PlyNumber::Int8, "char", "int8", 1, true},
    PlyNumberRow{PlyNumber::Uint8, "uchar", "uint8", 1, true},
    PlyNumberRow{PlyNumber::Int16, "short", "int16", 2, true},
    PlyNumberRow{PlyNumber::Uint16, "ushort", "uint16", 2, true},
    PlyNumberRow{PlyNumber::Int32, "int", "int32", 4, true},
    PlyNumberRow{PlyNumber::Uint32, "uint", "uint32", 4, true},
    PlyNumberRow{PlyNumber::Float32, "float", "float32", 4, false},
    PlyNumberRow{PlyNumber::Float64, "double", "float64", 8, false},
};
[[nodiscard]] constexpr const PlyNumberRow& rowOf(PlyNumber id) { return kPlyNumbers[static_cast<int>(id)]; }

struct PlyProperty {
  std::string name;
  PlyNumber number;  ///< of its value, or of those of a list
  bool list = false;
  PlyNumber length = {};  ///< of a list's length; a whole number
};
struct PlyElement {
  std::string name;
  int count;
  std::vector<PlyProperty> properties;  ///< at least one, no two with one name
  int line;                             ///< where it is declared
  /// The place of a property, or -1.
  [[nodiscard]] int find(std::string_view property) const;
};

enum class PlyForm { Text, LittleEndian, BigEndian };
struct PlyHeader {
  PlyForm form = PlyForm::Text;
  std::vector<PlyElement> elements;  ///< no two with one name
  std::size_t bytes = 0;             ///< up to and with the end of the line end_header
  int lines = 0;
};

/// Elements, and properties of an element, are compared by name, so the header may have so many of each.
inline constexpr std::size_t kMostPlyNames = 256;

/// Throws ParseError.
[[nodiscard]] PlyHeader parsePlyHeader(std::string_view text, const std::string& name);

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
