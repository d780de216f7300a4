#include "x11/drawing/font.h"

#include "geometry/files/visible.h"

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

std::string latin1(std::string_view utf8) {
  std::string letters;
  const auto byte = [&](std::size_t k) { return k < utf8.size() ? static_cast<unsigned char>(utf8[k]) : 0u; };
  for (std::size_t k = 0; k < utf8.size();) {
    const unsigned lead = byte(k++);
    const auto follows = [&] { return continues(static_cast<char>(byte(k))); };
    unsigned code = lead;
    if ((lead == 0xC2 || lead == 0xC3) && follows()) {
      code = (lead & 3) << 6 | (byte(k++) & 0x3F);
    } else if (lead >= 0x80) {
      code = 0;
      for (unsigned rest = lead >= 0xF0   ? 3
                           : lead >= 0xE0 ? 2
                           : lead >= 0xC0 ? 1
                                          : 0;
           rest && follows(); --rest)
        ++k;
    }
    const bool drawn = (code >= 0x20 && code < 0x7F) || code >= 0xA0;
    letters += drawn ? static_cast<char>(code) : '?';
  }
  return letters;
}

}  // namespace xnewell
