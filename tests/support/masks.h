#pragma once

#include <array>
#include <cstdint>
#include <map>

#include "x11/visual/emulation.h"

namespace xnewell {

/// Layouts of pixel values, and what servers show for them.

inline constexpr ChannelMasks k332{0x07, 0x38, 0xC0}, k565{0xF800, 0x7E0, 0x1F}, k555{0x7C00, 0x3E0, 0x1F},
    kBgr233{0xE0, 0x1C, 0x03}, k888{0xFF0000, 0xFF00, 0xFF};
inline constexpr std::array kLayouts{k332, kBgr233, k565, k555, k888, ChannelMasks{0x1, 0x6, 0x8}};

/// What level l of n shows: servers fill their maps with 65535 l / (n - 1), of which 8 bits are seen.
inline int levelShown(unsigned long l, unsigned long n) { return static_cast<int>(l * 65535 / (n - 1)) >> 8; }

/// All levels of a channel, keyed by the bits of the pixel value that hold them.
inline std::map<unsigned long, int> levels(unsigned long mask) {
  std::map<unsigned long, int> found;
  const unsigned long step = mask & -mask, n = levelsOf(mask);
  for (unsigned long l = 0; l < n; ++l) found[l * step] = levelShown(l, n);
  return found;
}

inline OfferedColors allOf(const ChannelMasks& masks, unsigned long opaque = 0) {
  return OfferedColors{masks, opaque, [&](unsigned long pixel) {
                         const auto value = [&](unsigned long mask) {
                           return static_cast<std::uint16_t>(257 * levels(mask).at(pixel & mask));
                         };
                         return Rgb16{value(masks.red), value(masks.green), value(masks.blue)};
                       }};
}

}  // namespace xnewell
