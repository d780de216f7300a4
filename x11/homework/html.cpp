#include "x11/homework/html.h"

#include <array>
#include <cstdint>

#include "geometry/files/visible.h"

namespace xnewell {

std::string inHtml(std::string_view text) {
  std::string html;
  for (const char c : text)
    html += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '"' ? "&quot;" : std::string{c};
  return html;
}

std::string element(const std::string& name, std::string_view text) {
  return '<' + name + '>' + inHtml(text) + "</" + name + ">\n";
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    std::uint32_t three = 0;
    for (std::size_t i = k; i < k + 3; ++i)
      three = three << 8 | (i < bytes.size() ? static_cast<std::uint8_t>(bytes[i]) : 0U);
    for (std::size_t digit = 0; digit < 4; ++digit)
      text += k + digit <= bytes.size() ? kDigits[three >> (18 - 6 * digit) & 63] : '=';
  }
  return text;
}

std::string imageUrl(std::string_view png) { return "data:image/png;base64," + base64(png); }

std::string imageElement(std::string_view png) { return "<img alt=\"\" src=\"" + imageUrl(png) + "\">\n"; }

std::string wellFormed(std::string_view text) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  constexpr std::array<std::uint32_t, 5> kLeast{0, 0, 0x80, 0x800, 0x10000};
  std::string all;
  while (!text.empty()) {
    const std::uint32_t lead = static_cast<std::uint8_t>(text[0]);
    std::size_t size = lead < 0x80 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
    std::uint32_t code = size == 1 ? lead : lead & (0x7FU >> size);
    bool isWell = (lead < 0x80 || lead >= 0xC2) && lead < 0xF5 && size <= text.size();
    for (std::size_t k = 1; isWell && k < size; ++k)
      isWell = continues(text[k]), code = code << 6 | (static_cast<std::uint8_t>(text[k]) & 0x3FU);
    isWell = isWell && code >= kLeast[size] && code <= 0x10FFFF && (code & 0xFFFFF800) != 0xD800 &&
             code != 0xFFFE && code != 0xFFFF && (code >= 0x20 || code == '\n' || code == '\t');
    if (isWell)
      all += text.substr(0, size);
    else
      size = 1, all += std::string{"\\x"} + kDigits[lead >> 4] + kDigits[lead & 15];
    text.remove_prefix(size);
  }
  return all;
}

}  // namespace xnewell
