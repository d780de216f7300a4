#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "shading/color/images.h"

namespace xnewell {

/// A picture that somebody hands in: a PNG file of any kind, a PPM, PGM or BMP file, or a window dump of xwd.
/// Nobody promises that such a file is whole, or small.
struct HandedIn {
  RgbImage picture;
  /// The cells, where the file has a palette; then `held` is what each holds.
  std::optional<IndexImage> cells;
  std::array<std::array<std::uint8_t, 3>, 256> held{};
};

/// Reads the file by what is in it, not by its name.
/// @throws std::system_error if it cannot be opened; ParseError if it is none of these kinds, if it is not
/// complete, or if its width or height is more than 8192 pixels
[[nodiscard]] HandedIn readHandedIn(const std::string& file);

}  // namespace xnewell
