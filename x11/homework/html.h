#pragma once

#include <string>
#include <string_view>

#include "shading/color/rgb_image.h"

namespace xnewell {

/// Parts of HTML, XML and JSON files that the program writes.

/// The text with the characters that HTML means something by as entities, and others than UTF-8 as they are.
[[nodiscard]] std::string inHtml(std::string_view text);
/// <name>text</name> and a line break.
[[nodiscard]] std::string element(const std::string& name, std::string_view text);
/// The address of a PNG file that is in it: data:image/png...
[[nodiscard]] std::string imageUrl(std::string_view png);
/// An <img> that carries the bytes of a PNG file.
[[nodiscard]] std::string imageElement(std::string_view png);
/// The text in UTF-8, with characters alone that XML may have, as JSON may, too: \\xff stands for a byte of
/// others.
[[nodiscard]] std::string wellFormed(std::string_view text);
/// RFC 4648, section 4.
[[nodiscard]] std::string base64(std::string_view bytes);

}  // namespace xnewell
