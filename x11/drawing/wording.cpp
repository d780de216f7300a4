#include "x11/drawing/wording.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "geometry/files/parse_error.h"

namespace xnewell {

namespace {

bool overlap(const Rect& a, const Rect& b) {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

}  // namespace

std::optional<Rect> Labels::take(std::span<const Rect> places) {
  for (const Rect& at : places) {
    const bool inside = at.x >= area_.x && at.y >= area_.y && at.x + at.width <= area_.x + area_.width &&
                        at.y + at.height <= area_.y + area_.height;
    if (!inside || std::ranges::any_of(taken_, [&](const Rect& r) { return overlap(at, r); })) continue;
    taken_.push_back({at.x - kGap, at.y, at.width + 2 * kGap, at.height});
    return at;
  }
  return std::nullopt;
}

std::optional<Rect> Labels::place(int x, int y, const std::string& text, bool boxed) {
  const int width = textWidth(text, boxed ? Voice::Bold : Voice::Plain) + (boxed ? 10 : 2),
            height = boxed ? 18 : 13;
  const std::array<Rect, 8> places{Rect{x + 7, y - height - 2, width, height},
                                   Rect{x + 9, y - height / 2, width, height},
                                   Rect{x + 7, y + 5, width, height},
                                   Rect{x - width - 9, y + 3, width, height},
                                   Rect{x - width - 9, y - height / 2, width, height},
                                   Rect{x - width - 7, y - height - 2, width, height},
                                   Rect{x - 4, y - height - 9, width, height},
                                   Rect{x - width + 4, y + 9, width, height}};
  const std::optional<Rect> at = take(places);
  if (!at) return std::nullopt;
  if (boxed) {
    paint_.fillRect(*at, plan_[Cell::White]);
    paint_.frame(*at, plan_[Cell::Ink]);
  }
  paint_.text(at->x + (boxed ? 5 : 1), at->y + (boxed ? 13 : 11), text, plan_[Cell::Ink],
              boxed ? Voice::Bold : Voice::Plain);
  return at;
}

std::vector<std::string> broken(std::string_view text, int most) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    std::size_t end = 0, space = 0;
    for (int letters = 0; end < text.size(); ++end) {
      if (continues(text[end])) continue;
      if (text[end] == ' ') space = end;
      if (++letters > most) break;
    }
    if (end < text.size() && space > 0) end = space;
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(end);
    while (text.starts_with(' ')) text.remove_prefix(1);
  }
  return lines;
}

std::string fixed(double value, int decimals) {
  std::array<char, 400> text;
  const auto [end, error] =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, decimals);
  std::string result{text.data(), static_cast<std::size_t>(end - text.data())};
  if (result.starts_with('-') && result.find_first_not_of("-0.") == std::string::npos) result.erase(0, 1);
  return result;
}

std::string fitted(double value, int decimals, int most) {
  if (!std::isfinite(value)) return "-";
  for (int d = decimals; d >= 0; --d)
    if (std::string text = fixed(value, d); static_cast<int>(text.size()) <= most) return text;
  int exponent = static_cast<int>(std::floor(std::log10(std::abs(value))));
  return fixed(value / std::pow(10.0, exponent), 0) + "e" + std::to_string(exponent);
}

std::string significant(double value, int digits) {
  std::array<char, 40> text;
  const auto [end, error] =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, digits);
  return {text.data(), end};
}

std::string msText(double ms) {
  const int decimals = ms > 0 && ms < 1 ? std::min(6, 2 - static_cast<int>(std::floor(std::log10(ms)))) : 2;
  return fixed(ms, decimals);
}

std::string grouped(std::int64_t value) {
  std::string digits = std::to_string(value);
  const int first = value < 0;
  for (int at = static_cast<int>(digits.size()) - 3; at > first; at -= 3) digits.insert(at, ",");
  return digits;
}

std::string sizeText(int width, int height) { return std::to_string(width) + " x " + std::to_string(height); }

std::string counted(std::int64_t n, std::string_view what) {
  return (n == 0 ? "no" : grouped(n)) + " " + std::string{what} + (n == 1 ? "" : "s");
}

}  // namespace xnewell
