#pragma once

#include <stdexcept>
#include <streambuf>
#include <string>
#include <string_view>

namespace xnewell {

/// An error in a file, with its place: `teapot.obj:41: face index 0; OBJ counts from 1`. `line` counts from
/// 1. A line of 0 stands for the whole file and is not printed.
class ParseError : public std::runtime_error {
 public:
  ParseError(const std::string& file, int line, const std::string& what)
      : std::runtime_error{(line > 0 ? file + ":" + std::to_string(line) : file) + ": " + what} {}
};

/// A text from elsewhere as it may be shown: no file and no name commands a terminal or begins a line. A
/// control character, of ASCII or of Latin-1, becomes \n, \t or, byte by byte, \x1b. All other bytes stay,
/// also those that are no UTF-8: a file's name is bytes.
[[nodiscard]] std::string visible(std::string_view text);
/// Writes it without memory of its own. Returns false if that failed.
bool putVisible(std::string_view text, std::streambuf& to);

/// True for a byte that begins no character of UTF-8.
[[nodiscard]] constexpr bool continues(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

/// The first `most` bytes of a text in UTF-8, without a part of a character at the end.
[[nodiscard]] std::string_view beginOf(std::string_view text, std::size_t most);

}  // namespace xnewell
