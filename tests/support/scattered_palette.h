#pragma once

#include <cstdint>
#include <random>

#include "shading/color/palette.h"

namespace xnewell {

/// Scattered colours, so that no two cells can be mixed up.
inline Palette scattered(unsigned seed) {
  std::mt19937 rng{seed};
  const auto value = [&] { return static_cast<std::uint16_t>(rng()); };
  Palette palette;
  for (Rgb16& c : palette) c = {value(), value(), value()};
  return palette;
}

}  // namespace xnewell
