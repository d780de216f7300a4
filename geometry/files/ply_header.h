#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

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

}  // namespace xnewell
