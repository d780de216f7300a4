#include "shading/color/font.h"

#include <algorithm>

#include "geometry/files/parse_error.h"

namespace xnewell {

DoubledGlyph scale2x(const Glyph& glyph) {
  const auto at = [&](int i, int j) {
    return i >= 0 && i < kGlyphWidth && j >= 0 && j < kGlyphHeight && (glyph[j] >> (kGlyphWidth - 1 - i) & 1);
  };
  DoubledGlyph doubled{};
  const auto set = [&](int i, int j, bool on) {
    if (on) doubled[j] = static_cast<std::uint16_t>(doubled[j] | 1 << (2 * kGlyphWidth - 1 - i));
  };
  for (int j = 0; j < kGlyphHeight; ++j)
    for (int i = 0; i < kGlyphWidth; ++i) {
      const bool self = at(i, j), up = at(i, j - 1), down = at(i, j + 1), left = at(i - 1, j),
                 right = at(i + 1, j);
      const bool corners = up != down && left != right;
      set(2 * i, 2 * j, corners && left == up ? up : self);
      set(2 * i + 1, 2 * j, corners && up == right ? right : self);
      set(2 * i, 2 * j + 1, corners && left == down ? left : self);
      set(2 * i + 1, 2 * j + 1, corners && down == right ? right : self);
    }
  return doubled;
}

const Glyph* glyphOf(char32_t code) {
  const auto at = std::ranges::lower_bound(kFont6x13, code, {}, &CodedGlyph::code);
  return at != kFont6x13.end() && at->code == code ? &at->glyph : nullptr;
}

std::u32string codesOf(std::string_view utf8) {
  constexpr std::array<char32_t, 4> kLeast{0, 0x80, 0x800, 0x10000};  // of so many bytes after the first
  std::u32string codes;
  const auto byte = [&](std::size_t k) { return k < utf8.size() ? static_cast<unsigned char>(utf8[k]) : 0u; };
  for (std::size_t k = 0; k < utf8.size();) {
    char32_t code = byte(k++);
    const unsigned more = code >= 0xF0 ? 3 : code >= 0xE0 ? 2 : code >= 0xC0 ? 1 : 0;
    bool valid = code < 0x80 || more > 0;
    if (more > 0) code &= 0x3F >> more;
    for (unsigned n = 0; n < more && valid; ++n) {
      valid = continues(static_cast<char>(byte(k)));
      if (valid) code = code << 6 | (byte(k++) & 0x3F);
    }
    codes += valid && code >= kLeast[more] && glyphOf(code) ? code : U'?';
  }
  return codes;
}

std::string latin1(std::string_view utf8) {
  std::string letters;
  for (const char32_t code : codesOf(utf8)) letters += code < 0x100 ? static_cast<char>(code) : '?';
  return letters;
}

}  // namespace xnewell
