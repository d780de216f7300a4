#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace xnewell {

/// The one font of the program: misc-fixed 6x13, the `fixed` of every X server, public domain. It is read
/// from its package when the program is built (make_font.cpp), so that words look the same with and without a
/// server.

inline constexpr int kGlyphWidth = 6, kGlyphHeight = 13;
inline constexpr int kGlyphAscent = 11;  ///< rows above the baseline; two are below

/// Rows from the top; bit 5 is the leftmost pixel.
using Glyph = std::array<std::uint8_t, kGlyphHeight>;
struct CodedGlyph {
  char32_t code;
  Glyph glyph;
};
/// The letters of Latin-1 and Greek, signs, indices, arrows and mathematical operators, as far as the font
/// has them, by ascending codes.
extern const std::span<const CodedGlyph> kFont6x13;

/// Null if the font lacks the character.
[[nodiscard]] const Glyph* glyphOf(char32_t code);

/// Twice the size; bit 11 is the leftmost pixel.
using DoubledGlyph = std::array<std::uint16_t, 2 * kGlyphHeight>;

/// Doubles a glyph by Scale2x (Mazzoleni 2001): a quarter of a pixel takes the colour of the two neighbours
/// at its corner if these agree and neither of the other two has the same colour. Pixels outside the glyph
/// are blank.
[[nodiscard]] DoubledGlyph scale2x(const Glyph& glyph);

/// The characters of a text in UTF-8. One that the font lacks becomes one '?', and so does anything that is
/// not valid UTF-8.
[[nodiscard]] std::u32string codesOf(std::string_view utf8);

/// The same in Latin-1, with '?' for what it lacks.
[[nodiscard]] std::string latin1(std::string_view utf8);

}  // namespace xnewell
