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
  [[nodiscard]] std::uint32_t little(std::size_t k, int bytes = 4) const {
    return bytes == 0 ? 0 : at(k) | little(k + 1, bytes - 1) << 8;
  }
  void needs(std::size_t size) const {
    if (all.size() < size) fail("the file ends early");
  }
  void checkSize(std::uint64_t width, std::uint64_t height) const {
    if (width < 1 || height < 1) fail("the picture has no pixels");
    if (width > kLargestSide || height > kLargestSide) fail("the picture is larger than 8192 pixels");
  }
};

/// A number of a PPM file as text, at least `least`; comments run from # to the end of the line.
int textNumber(const Bytes& b, std::size_t& k, int least = 1) {
  for (;; ++k) {
    if (b.at(k) == '#')
      while (b.at(k) != '\n' && b.at(k) != '\r') ++k;
    if (b.at(k) > ' ') break;
  }
  const char* const from = b.all.data() + k;
  int value = 0;
  const auto [end, error] = std::from_chars(from, b.all.data() + b.all.size(), value);
  if (error != std::errc{} || value < least) b.fail("the PPM file has no whole number where one belongs");
  k += static_cast<std::size_t>(end - from);
  return value;
}

HandedIn fromPpm(const Bytes& b) {
  const bool gray = b.at(1) == '2' || b.at(1) == '5', text = b.at(1) < '4';
  std::size_t k = 2;
  const int width = textNumber(b, k), height = textNumber(b, k), most = textNumber(b, k);
  b.checkSize(width, height);
  if (most > 65535) b.fail("the largest value of a PPM file is 65535");
  ++k;  // one blank
  // A sample of text has a digit and a blank before it; so little memory is taken for a file that is not
  // whole.
  const std::size_t bytes = text || most > 255 ? 2 : 1, channels = gray ? 1 : 3;
  b.needs(k + bytes * channels * static_cast<std::size_t>(width) * height - text);
  HandedIn in{.picture = RgbImage{width, height}, .cells = {}, .held = {}};
  for (std::size_t p = 0; p < static_cast<std::size_t>(width) * height; ++p)
    for (std::size_t c = 0; c < 3; ++c) {
      if (c > 0 && gray) {
        in.picture.rgb[3 * p + c] = in.picture.rgb[3 * p];
        continue;
      }
      const int value = text ? textNumber(b, k, 0) : bytes == 2 ? b.at(k) << 8 | b.at(k + 1) : b.at(k);
      if (!text) k += bytes;
      in.picture.rgb[3 * p + c] = static_cast<std::uint8_t>(
          std::min<std::int64_t>(255, (value * std::int64_t{255} + most / 2) / most));
    }
  return in;
}

/// A part of a pixel value, as eight bits.
std::uint8_t masked(std::uint32_t pixel, std::uint32_t mask) {
  if (mask == 0) return 0;
  const std::uint32_t value = (pixel & mask) >> std::countr_zero(mask), most = mask >> std::countr_zero(mask);
  return static_cast<std::uint8_t>(std::uint64_t{value} * 255 / most);
}

/// Pixels of 8, 16, 24 or 32 bits, as BMP files and window dumps have them.
struct Packed {
  int width, height;
  std::size_t first;                   ///< where the upper row begins
  std::ptrdiff_t line;                 ///< bytes from a row to the one below
  int bytes;                           ///< of a pixel
  bool lowFirst;                       ///< the low byte of a pixel comes first
  std::array<std::uint32_t, 3> masks;  ///< of red, green and blue; not used for cells
};

/// `held` is empty unless the pixels are cells.
HandedIn unpacked(const Bytes& b, const Packed& p, const std::optional<decltype(HandedIn::held)>& held) {
  HandedIn in{.picture = RgbImage{p.width, p.height}, .cells = {}, .held = {}};
  if (held) in.cells.emplace(p.width, p.height, std::uint8_t{0}), in.held = *held;
  for (int j = 0; j < p.height; ++j)
    for (int i = 0; i < p.width; ++i) {
      const std::size_t at = p.first + static_cast<std::size_t>(p.line * j + std::ptrdiff_t{p.bytes} * i);
      std::uint32_t pixel = 0;
      for (int k = 0; k < p.bytes; ++k)
        pixel |= std::uint32_t{b.at(at + k)} << 8 * (p.lowFirst ? k : p.bytes - 1 - k);
      std::uint8_t* const rgb = in.picture.pixel(i, j);
      if (held) {
        in.cells->row(j)[i] = static_cast<std::uint8_t>(pixel);
        std::ranges::copy(in.held[pixel & 255], rgb);
      } else {
        for (int c = 0; c < 3; ++c) rgb[c] = masked(pixel, p.masks[c]);
      }
    }
  return in;
}

/// @see BITMAPINFOHEADER of Windows. Numbers have the low byte first, and so have pixels. Rows run upwards,
/// unless the height is negative.
HandedIn fromBmp(const Bytes& b) {
  const std::uint32_t pixels = b.little(10), head = b.little(14), packing = b.little(30), used = b.little(46);
  const auto signedHeight = static_cast<std::int32_t>(b.little(22));
  const std::int64_t height = std::abs(std::int64_t{signedHeight}), width = b.little(18);
  const int bits = static_cast<int>(b.little(28, 2));
  if (head < 40) b.fail("the head of the BMP file has less than 40 bytes");
  b.checkSize(width, height);
  if (packing != 0 && packing != 3) b.fail("the BMP file is compressed");
  if (bits != 8 && bits != 16 && bits != 24 && bits != 32)
    b.fail("the BMP file has no 8, 16, 24 or 32 bits a pixel");
  const std::ptrdiff_t line = (width * bits + 31) / 32 * 4;
  b.needs(pixels + static_cast<std::size_t>(line * height));
  Packed p{.width = static_cast<int>(width),
           .height = static_cast<int>(height),
           .first = pixels,
           .line = line,
           .bytes = bits / 8,
           .lowFirst = true,
           .masks = {0xFF0000, 0xFF00, 0xFF}};
  if (bits == 16) p.masks = {0x7C00, 0x3E0, 0x1F};
  if (packing == 3) p.masks = {b.little(54), b.little(58), b.little(62)};
  if (signedHeight > 0) p.first += static_cast<std::size_t>(line * (height - 1)), p.line = -line;
  if (bits != 8) return unpacked(b, p, {});
  decltype(HandedIn::held) held{};
  for (std::uint32_t c = 0; c < (used == 0 ? 256 : std::min(used, 256u)); ++c)
    for (int k = 0; k < 3; ++k) held[c][k] = b.at(std::size_t{14} + head + std::size_t{4} * c + 2 - k);
  return unpacked(b, p, held);
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
  const Packed p{.width = static_cast<int>(width),
                 .height = static_cast<int>(height),
                 .first = pixels,
                 .line = static_cast<std::ptrdiff_t>(line),
                 .bytes = static_cast<int>(bytes),
                 .lowFirst = head(7) == 0,
                 .masks = {head(14), head(15), head(16)}};
  if (bits != 8 || head(14) != 0) return unpacked(b, p, {});
  decltype(HandedIn::held) held{};
  for (std::uint32_t c = 0; c < colors; ++c) {
    const std::size_t at = size + std::size_t{12} * c;
    if (const std::uint32_t cell = b.big32(at); cell < 256)
      held[cell] = {b.at(at + 4), b.at(at + 6), b.at(at + 8)};
  }
  return unpacked(b, p, held);
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
  if (text.size() > 1 && text[0] == 'P' && std::string_view{"2356"}.find(text[1]) != std::string_view::npos)
    return fromPpm(bytes);
  if (text.starts_with("BM")) return fromBmp(bytes);
  if (text.starts_with("\xFF\xD8\xFF"))
    bytes.fail("a JPEG picture; its compression changes the colours, so hand in a PNG, PPM, BMP or XWD file");
  if (text.size() >= 100 && bytes.big32(0) >= 100 && bytes.big32(0) < 65536 && bytes.big32(4) == 7)
    return fromXwd(bytes);
  bytes.fail("not a PNG, PPM, BMP or XWD picture");
}

}  // namespace xnewell
