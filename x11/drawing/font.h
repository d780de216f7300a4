#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace xnewell {

/// The one font of the program: misc-fixed 6x13, the `fixed` of every X server, public domain. It is
/// read from its package when the program is built (make_font.cpp), so that words look the same with
/// and without a server.

inline constexpr int kGlyphWidth = 6, kGlyphHeight = 13;
inline constexpr int kGlyphAscent = 11;  ///< rows above the baseline; two are below

/// Rows from the top; bit 5 is the leftmost pixel.
using Glyph = std::array<std::uint8_t, kGlyphHeight>;
/// By Latin-1 code.
extern const std::array<Glyph, 256> kFont6x13;

/// Twice the size; bit 11 is the leftmost pixel.
using DoubledGlyph = std::array<std::uint16_t, 2 * kGlyphHeight>;

/// Doubles a glyph by Scale2x (Mazzoleni 2001): a quarter of a pixel takes the colour of the two neighbours
/// at its corner if these agree and neither of the other two has the same colour. Pixels outside the glyph
/// are blank.
[[nodiscard]] DoubledGlyph scale2x(const Glyph& glyph);

/// Converts UTF-8 to Latin-1. A character that the font lacks becomes one '?', and so does anything that is
/// not valid UTF-8.
[[nodiscard]] std::string latin1(std::string_view utf8);

}  // namespace xnewell
