// make_font 6x13.pcf.gz font_6x13.cpp: writes the font as a C++ table. Runs when the program is built.

#include <ft2build.h>
#include FT_FREETYPE_H

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

#include "shading/color/font.h"

namespace xnewell {

namespace {

[[noreturn]] void fail(const std::string& what) {
  std::cerr << "make_font: " << what << '\n';
  std::exit(1);
}

/// The glyph's bitmap, placed by its origin and the font's ascent. Precondition: the glyph is loaded.
Glyph place(const FT_GlyphSlot slot) {
  Glyph glyph{};
  const FT_Bitmap& bitmap = slot->bitmap;
  for (unsigned j = 0; j < bitmap.rows; ++j)
    for (unsigned i = 0; i < bitmap.width; ++i) {
      if (!(bitmap.buffer[j * bitmap.pitch + i / 8] >> (7 - i % 8) & 1)) continue;
      const int x = slot->bitmap_left + static_cast<int>(i);
      const int y = kGlyphAscent - slot->bitmap_top + static_cast<int>(j);
      if (x < 0 || x >= kGlyphWidth || y < 0 || y >= kGlyphHeight) fail("a glyph is larger than 6 x 13");
      glyph[y] = static_cast<std::uint8_t>(glyph[y] | 1 << (kGlyphWidth - 1 - x));
    }
  return glyph;
}

void makeFont(int count, char** arguments) {
  if (count != 3) fail("usage: make_font FONT.pcf.gz TABLE.cpp");
  FT_Library library;
  FT_Face face;
  if (FT_Init_FreeType(&library)) fail("FreeType does not start");
  if (FT_New_Face(library, arguments[1], 0, &face))
    fail(std::string{arguments[1]} + ": FreeType cannot read it");
  if (face->num_fixed_sizes != 1 || FT_Select_Size(face, 0) || FT_Select_Charmap(face, FT_ENCODING_UNICODE))
    fail(std::string{arguments[1]} + ": not a bitmap font in Unicode");

  std::ofstream table{arguments[2]};
  table << "// Made from the misc-fixed font 6x13 by make_font.cpp.\n"
           "#include \"shading/color/font.h\"\n\n"
           "namespace xnewell {\n\n"
           "static constexpr CodedGlyph kGlyphs[]{\n";
  constexpr std::array<std::array<unsigned, 2>, 6> kRanges{
      {{0x20, 0x7E}, {0xA0, 0xFF}, {0x370, 0x3FF}, {0x2010, 0x205E}, {0x2070, 0x209F}, {0x2190, 0x22FF}}};
  for (const auto& [from, to] : kRanges)
    for (unsigned code = from; code <= to; ++code) {
      const unsigned index = FT_Get_Char_Index(face, code);
      if (!index && code <= 0xFF) fail("the font lacks a character of Latin-1");
      if (!index) continue;
      if (FT_Load_Glyph(face, index, FT_LOAD_RENDER | FT_LOAD_MONOCHROME | FT_LOAD_TARGET_MONO))
        fail("a glyph cannot be loaded");
      table << "    {" << code << ", {";
      for (const int row : place(face->glyph)) table << row << ',';
      table << "}},\n";
    }
  table << "};\nconst std::span<const CodedGlyph> kFont6x13{kGlyphs};\n\n}  // namespace xnewell\n";
  table.close();
  if (!table) fail(std::string{arguments[2]} + ": cannot be written");
  FT_Done_Face(face);
  FT_Done_FreeType(library);
}

}  // namespace

}  // namespace xnewell

int main(int count, char** arguments) { xnewell::makeFont(count, arguments); }
