#include "geometry/files/parse_error.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <sstream>
#include <utility>

namespace xnewell {

namespace {

unsigned byteAt(std::string_view text, std::size_t k) {
  return k < text.size() ? static_cast<unsigned char>(text[k]) : 0;
}

/// How many bytes the control character has with which the text begins; 0 if none.
std::size_t controlSize(std::string_view text) {
  const unsigned first = byteAt(text, 0), second = byteAt(text, 1);
  if (first < 0x20 || (first >= 0x7F && first < 0xA0)) return 1;
  return first == 0xC2 && second >= 0x80 && second < 0xA0 ? 2 : 0;
}

/// How many bytes the character in UTF-8 has with which the text begins; 1 for a byte that begins none.
std::size_t characterSize(std::string_view text) {
  const unsigned lead = byteAt(text, 0), second = byteAt(text, 1);
  const std::size_t size = lead < 0xC2 || lead > 0xF4 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
  const bool shorter = (lead == 0xE0 && second < 0xA0) || (lead == 0xF0 && second < 0x90);  // would do
  const bool whole = size <= text.size() && std::ranges::all_of(text.substr(1, size - 1), continues);
  return whole && !shorter ? size : 1;
}

}  // namespace

bool putVisible(std::string_view text, std::streambuf& to) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  const auto put = [&](std::string_view part) {
    return to.sputn(part.data(), std::ssize(part)) == std::ssize(part);
  };
  bool well = true;
  while (!text.empty() && well) {
    const std::size_t control = controlSize(text), size = control > 0 ? control : characterSize(text);
    if (control == 0)
      well = put(text.substr(0, size));
    else if (text[0] == '\n' || text[0] == '\t')
      well = put(text[0] == '\n' ? "\\n" : "\\t");
    else
      for (std::size_t k = 0; k < control; ++k)
        well =
            well &&
            put({std::array{'\\', 'x', kDigits[byteAt(text, k) >> 4], kDigits[byteAt(text, k) & 15]}.data(),
                 4});
    text.remove_prefix(size);
  }
  return well;
}

std::string visible(std::string_view text) {
  std::stringbuf shown;
  putVisible(text, shown);
  return std::move(shown).str();
}

std::string_view beginOf(std::string_view text, std::size_t most) {
  if (text.size() <= most) return text;
  while (most > 0 && continues(text[most])) --most;
  return text.substr(0, most);
}

}  // namespace xnewell
