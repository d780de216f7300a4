#include "x11/homework/html.h"

#include <cstdint>

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

std::string imageElement(std::string_view png) {
  return "<img alt=\"\" src=\"data:image/png;base64," + base64(png) + "\">\n";
}

}  // namespace xnewell
