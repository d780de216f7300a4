#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "shading/color/color_table.h"
#include "shading/color/images.h"

namespace xnewell {

/// Reads and writes PNG files. The bytes written depend on the pixels and the note alone: they hold no time
/// and no version. A file is written completely or not at all (see writeFile()).

/// Writes a palette PNG of 8 bits per pixel: the index image unchanged, and its 256 colours as a server shows
/// them (16-bit value >> 8). Width and height are 1..8192 pixels.
/// @throws std::system_error `FILE: No such file or directory`
void writePng(const std::string& file, const IndexImage& image, const Palette& palette);

/// Writes an RGB PNG of 8 bits per channel.
void writePng(const std::string& file, const RgbImage& image);

/// The same pictures as the bytes of a file. The file carries `note`, a text in UTF-8, unless it is "".
[[nodiscard]] std::string encodePng(const IndexImage& image, const Palette& palette,
                                    const std::string& note = "");
[[nodiscard]] std::string encodePng(const RgbImage& image, const std::string& note = "");

/// The note that encodePng() put into a file, byte for byte, before its pixels; nothing if there is none.
/// Nobody promises that it is a note of ours, or UTF-8. @throws as readPng(); the pixels are not looked at
[[nodiscard]] std::optional<std::string> noteInPng(const std::string& file);

/// Reads a PNG of any kind as RGB. Transparent pixels are shown on black.
/// @throws std::system_error if the file cannot be opened; ParseError if it is not a complete PNG, or if its
/// width or height is more than 8192 pixels
[[nodiscard]] RgbImage readPng(const std::string& file);

/// The indices of a PNG that has a palette, and what each holds; nothing if the PNG has none.
struct IndexedPng {
  IndexImage image;
  std::array<std::array<std::uint8_t, 3>, 256> held{};
};
/// @throws as readPng()
[[nodiscard]] std::optional<IndexedPng> readIndexedPng(const std::string& file);

}  // namespace xnewell
