#include "shading/diagnose/handed_in.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <string_view>

#include "geometry/files/parse_error.h"
#include "geometry/files/text_file.h"
#include "shading/color/png.h"

namespace xnewell {

namespace {

constexpr int kLargestSide = 8192;
/// A window dump of that size with four bytes a pixel, and its head.
constexpr std::size_t kLargestFile = std::size_t{4} * kLargestSide * kLargestSide + (1 << 20);

struct Bytes {
  std::string_view all;
  std::string name;
  [[noreturn]] void fail(const std::string& what) const { throw ParseError{name, 0, what}; }
  [[nodiscard]] std::uint8_t at(std::size_t k) const {
    if (k >= all.size()) fail("the file ends early");
    return static_cast<std::uint8_t>(all[k]);
  }
  [[nodiscard]] std::uint32_t big32(std::size_t k) const {
    return static_cast<std::uint32_t>(at(k)) << 24 | static_cast<std::uint32_t>(at(k + 1)) << 16 |
           static_cast<std::uint32_t>(at(k + 2)) << 8 | at(k + 3);
  }
  void needs(std::size_t size) const {
    if (all.size() < size) fail("the file ends early");
  }
  void checkSize(std::uint64_t width, std::uint64_t height) const {
    if (width < 1 || height < 1) fail("the picture has no pixels");
    if (width > kLargestSide || height > kLargestSide) fail("the picture is larger than 8192 pixels");
  }
};

/// A number of a PPM file's head; comments run from # to the end of the line.
int headNumber(const Bytes& b, std::size_t& k) {
  for (;; ++k) {
    if (b.at(k) == '#')
      while (b.at(k) != '\n') ++k;
    if (b.at(k) > ' ') break;
  }
  const char* const from = b.all.data() + k;
  int value = 0;
  const auto [end, error] = std::from_chars(from, b.all.data() + b.all.size(), value);
  if (error != std::errc{} || value < 1)
    b.fail("the head of the PPM file has no whole number where one belongs");
  k += static_cast<std::size_t>(end - from);
  return value;
}

HandedIn fromPpm(const Bytes& b) {
  const bool gray = b.at(1) == '5';
  std::size_t k = 2;
  const int width = headNumber(b, k), height = headNumber(b, k), most = headNumber(b, k);
  b.checkSize(width, height);
  if (most > 65535) b.fail("the largest value of a PPM file is 65535");
  ++k;  // one blank
  const std::size_t bytes = most > 255 ? 2 : 1, channels = gray ? 1 : 3;
  b.needs(k + bytes * channels * static_cast<std::size_t>(width) * height);
  HandedIn in{.picture = RgbImage{width, height}, .cells = {}, .held = {}};
  for (std::size_t p = 0; p < static_cast<std::size_t>(width) * height; ++p)
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t at = k + bytes * (p * channels + (gray ? 0 : c));
      const int value = bytes == 2 ? b.at(at) << 8 | b.at(at + 1) : b.at(at);
      in.picture.rgb[3 * p + c] =
          static_cast<std::uint8_t>(most == 255 ? value : std::min(255, (value * 255 + most / 2) / most));
    }
  return in;
}

/// A part of a pixel value, as eight bits.
std::uint8_t masked(std::uint32_t pixel, std::uint32_t mask) {
  if (mask == 0) return 0;
  const std::uint32_t value = (pixel & mask) >> std::countr_zero(mask), most = mask >> std::countr_zero(mask);
  return static_cast<std::uint8_t>(std::uint64_t{value} * 255 / most);
}

/// The head of a window dump has 25 numbers of 32 bits. @see XWDFile.h of X11
HandedIn fromXwd(const Bytes& b) {
  const auto head = [&](int k) { return b.big32(4 * static_cast<std::size_t>(k)); };
  const std::uint32_t size = head(0), width = head(4), height = head(5), bits = head(11), line = head(12),
                      colors = head(19);
  b.checkSize(width, height);
  if (head(2) != 2) b.fail("the window dump is not in the Z format");
  if (bits != 8 && bits != 16 && bits != 24 && bits != 32)
    b.fail("the window dump has no 8, 16, 24 or 32 bits a pixel");
  if (colors > 65536) b.fail("the window dump has too many colours");
  const std::uint32_t bytes = bits / 8;
  if (line < std::uint64_t{width} * bytes || line > 8u * kLargestSide)
    b.fail("the rows of the window dump do not fit");
  const std::size_t pixels = size + std::size_t{12} * colors;
  b.needs(pixels + static_cast<std::size_t>(line) * height);
  const int w = static_cast<int>(width), h = static_cast<int>(height);
  HandedIn in{.picture = RgbImage{w, h}, .cells = {}, .held = {}};
  const bool indexed = bits == 8 && head(14) == 0;
  if (indexed) {
    in.cells.emplace(w, h, std::uint8_t{0});
    for (std::uint32_t c = 0; c < colors; ++c) {
      const std::size_t at = size + std::size_t{12} * c;
      if (const std::uint32_t cell = b.big32(at); cell < 256)
        in.held[cell] = {b.at(at + 4), b.at(at + 6), b.at(at + 8)};
    }
  }
  const bool lowFirst = head(7) == 0;
  for (int j = 0; j < h; ++j)
    for (int i = 0; i < w; ++i) {
      const std::size_t at =
          pixels + static_cast<std::size_t>(line) * j + static_cast<std::size_t>(bytes) * i;
      std::uint32_t pixel = 0;
      for (std::uint32_t k = 0; k < bytes; ++k)
        pixel |= std::uint32_t{b.at(at + k)} << 8 * (lowFirst ? k : bytes - 1 - k);
      std::uint8_t* const rgb = in.picture.pixel(i, j);
      if (indexed) {
        in.cells->row(j)[i] = static_cast<std::uint8_t>(pixel);
        std::ranges::copy(in.held[pixel & 255], rgb);
      } else {
        for (int c = 0; c < 3; ++c) rgb[c] = masked(pixel, head(14 + c));
      }
    }
  return in;
}

}  // namespace

HandedIn readHandedIn(const std::string& file) {
  const std::string text = readTextFile(file, kLargestFile);
  const Bytes bytes{text, file};
  if (text.starts_with("\x89PNG")) {
    HandedIn in{.picture = readPng(file), .cells = {}, .held = {}};
    if (auto indexed = readIndexedPng(file)) {
      in.cells = std::move(indexed->image);
      in.held = indexed->held;
    }
    return in;
  }
  if (text.starts_with("P6") || text.starts_with("P5")) return fromPpm(bytes);
  if (text.size() >= 100 && bytes.big32(0) >= 100 && bytes.big32(0) < 65536 && bytes.big32(4) == 7)
    return fromXwd(bytes);
  bytes.fail("not a PNG, PPM or XWD picture");
}

}  // namespace xnewell
