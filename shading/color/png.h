#pragma once

#include <string>

#include "shading/color/index_image.h"
#include "shading/color/palette.h"
#include "shading/color/rgb_image.h"

namespace xnewell {

/// PNG files. What is written depends on the pixels alone: no time, no name of a program.
/// A file is complete or absent, as writeFile() has it.

/// A palette PNG of 8 bits a pixel: the index image as it is, with the 256 colours as a server shows
/// them, 16-bit value >> 8. 1..8192 pixels each way.
/// @throws std::system_error `FILE: No such file or directory`
void writePng(const std::string& file, const IndexImage& image, const Palette& palette);

/// An RGB PNG of 8 bits a channel.
void writePng(const std::string& file, const RgbImage& image);

/// The same as the bytes of a file.
[[nodiscard]] std::string encodePng(const IndexImage& image, const Palette& palette);
[[nodiscard]] std::string encodePng(const RgbImage& image);

/// A PNG of any kind as RGB; what is transparent shows black behind it.
/// @throws std::system_error when the file cannot be opened, ParseError when it is no whole PNG or
/// larger than 8192 pixels either way
[[nodiscard]] RgbImage readPng(const std::string& file);

}  // namespace xnewell
