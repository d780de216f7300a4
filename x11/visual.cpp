#include "x11/visual.h"

#include <algorithm>
#include <bit>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <iomanip>
#include <memory>
#include <sstream>
#include <stdexcept>

#include "x11/display.h"

#include <X11/Xutil.h>

namespace {

/// How much we want a visual; 0 is not at all. The order is chooseVisual()'s.
int preference(const VisualInfo& v) {
  if (v.kind == VisualClass::PseudoColorClass) return v.depth == 8 ? 1000 : 0;
  if (v.kind != VisualClass::TrueColorClass) return 0;
  return v.depth == 24 ? 500 : v.alphaMask() != 0 ? 1 : 1 + v.depth;
}

bool granted(const std::optional<VisualWish>& wish, const VisualInfo& v) {
  return !wish || (wish->kind == v.kind && wish->depth.value_or(v.depth) == v.depth);
}

std::string hex(unsigned long id) {
  std::ostringstream text;
  text << "0x" << std::hex << id;
  return text.str();
}

bool sameKind(const VisualInfo& a, const VisualInfo& b) {
  return a.kind == b.kind && a.depth == b.depth && a.masks == b.masks && a.bitsPerRgb == b.bitsPerRgb &&
         a.cells == b.cells;
}

struct Fold {
  VisualInfo visual;
  int count;
};

/// Equal visuals together, the deepest first, then in the order of kVisualClasses.
std::vector<Fold> fold(const ServerVisuals& server) {
  std::vector<Fold> rows;
  for (const VisualInfo& v : server.visuals) {
    const auto same =
        std::find_if(rows.begin(), rows.end(), [&](const Fold& row) { return sameKind(row.visual, v); });
    if (same != rows.end())
      ++same->count;
    else
      rows.push_back({v, 1});
  }
  std::stable_sort(rows.begin(), rows.end(), [](const Fold& a, const Fold& b) {
    return a.visual.depth != b.visual.depth ? a.visual.depth > b.visual.depth : a.visual.kind < b.visual.kind;
  });
  return rows;
}

/// "a, b, c", each once.
std::string list(const std::vector<std::string>& names) {
  std::string text;
  for (auto name = names.begin(); name != names.end(); ++name) {
    if (std::find(names.begin(), name, *name) != name) continue;
    if (!text.empty()) text.append(", ");
    text.append(*name);
  }
  return text;
}

std::string namesOf(const ServerVisuals& server) {
  std::vector<std::string> names;
  for (const Fold& row : fold(server)) names.push_back(row.visual.name());
  return list(names);
}

std::string_view deed(const VisualInfo& v) {
  if (preference(v) == 0) return "not used yet";
  return v.writable() ? "a real colormap of its own: colours change without drawing"
                      : "emulate the 256-entry table: draw again when colours change";
}

/// Takes the largest number of cells that the map gives, in falling powers of two, and gives all back.
int countFreeCells(::Display* display, ::Colormap map, int size) {
  ErrorTrap trap{display};
  std::vector<unsigned long> taken(size);
  int count = 0;
  for (int step = std::bit_floor(static_cast<unsigned>(std::max(size, 1))); step > 0; step /= 2)
    while (count + step <= size && XAllocColorCells(display, map, 0, nullptr, 0, &taken[count], step))
      count += step;
  XFreeColors(display, map, taken.data(), count, 0);
  return count;
}

/// A mask's lowest bit and number of bits.
struct Channel {
  int shift, width;
  explicit Channel(unsigned long mask)
      : shift{mask ? std::countr_zero(mask) : 0}, width{std::popcount(mask)} {}
  [[nodiscard]] unsigned long bits(std::uint16_t v) const {
    return static_cast<unsigned long>(v >> (16 - width)) << shift;
  }
  [[nodiscard]] std::uint16_t value(unsigned long pixel) const {
    const unsigned long top = (1ul << width) - 1;
    return static_cast<std::uint16_t>(top ? ((pixel >> shift) & top) * 65535 / top : 0);
  }
};

}  // namespace

std::string VisualInfo::name() const {
  return std::string{kVisualClasses[static_cast<int>(kind)].name} + " " + std::to_string(depth);
}

const VisualInfo& ServerVisuals::defaultVisual() const {
  return *std::find_if(visuals.begin(), visuals.end(),
                       [&](const VisualInfo& v) { return v.id == defaultId; });
}

ServerVisuals readVisuals(::_XDisplay* display) {
  const int screen = DefaultScreen(display);
  ServerVisuals server;
  server.display = DisplayString(display);
  server.vendor = std::string{ServerVendor(display)} + " " + std::to_string(VendorRelease(display));
  server.defaultId = XVisualIDFromVisual(DefaultVisual(display, screen));
  server.black = BlackPixel(display, screen);
  server.white = WhitePixel(display, screen);
  ::XVisualInfo wanted{};
  wanted.screen = screen;
  int count = 0;
  const std::unique_ptr<::XVisualInfo[], int (*)(void*)> found{
      XGetVisualInfo(display, VisualScreenMask, &wanted, &count), XFree};
  for (int i = 0; i < count; ++i) {
    const ::XVisualInfo& v = found[i];
    server.visuals.push_back({.kind = static_cast<VisualClass>(v.c_class),
                              .depth = v.depth,
                              .id = v.visualid,
                              .masks = {v.red_mask, v.green_mask, v.blue_mask},
                              .bitsPerRgb = v.bits_per_rgb,
                              .cells = v.colormap_size});
  }
  if (const VisualInfo& v = server.defaultVisual(); v.writable())
    server.freeCells = countFreeCells(display, DefaultColormap(display, screen), v.cells);
  return server;
}

VisualWish parseVisualWish(std::string_view text) {
  const auto sameLetter = [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
  };
  for (const VisualClassRow& row : kVisualClasses) {
    if (text.size() < row.name.size() ||
        !std::equal(row.name.begin(), row.name.end(), text.begin(), sameLetter))
      continue;
    const std::string_view digits = text.substr(row.name.size());
    if (digits.empty()) return {row.id, std::nullopt};
    int depth = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), depth);
    if (error == std::errc{} && end == digits.data() + digits.size() && depth >= 1 && depth <= 32)
      return {row.id, depth};
  }
  std::vector<std::string> classes;
  classes.reserve(kVisualClasses.size());
  for (const VisualClassRow& row : kVisualClasses) classes.emplace_back(row.name);
  throw std::invalid_argument(
      "'" + std::string{text} +
      "' is no visual: write a class and, if it matters, a depth, as in PseudoColor8 or "
      "TrueColor24; the classes are " +
      list(classes));
}

VisualChoice chooseVisual(const ServerVisuals& server, const std::optional<VisualWish>& wish) {
  const VisualInfo* best = nullptr;
  bool has = false;
  const auto rank = [&](const VisualInfo& v) {
    return 2 * preference(v) + (v.id == server.defaultId ? 1 : 0);
  };
  for (const VisualInfo& v : server.visuals) {
    if (!granted(wish, v)) continue;
    has = true;
    if (preference(v) > 0 && (best == nullptr || rank(v) > rank(*best))) best = &v;
  }
  if (best == nullptr) {
    const std::string here = "display '" + server.display + "' has ";
    const std::string all = "; it has " + namesOf(server);
    if (!wish) throw X11Error(here + "no visual that xnewell uses yet" + all);
    std::string wished{kVisualClasses[static_cast<int>(wish->kind)].name};
    if (wish->depth) wished.append(" ").append(std::to_string(*wish->depth));
    throw X11Error(has ? here + wished + ", but xnewell does not use it yet" + all
                       : here + "no " + wished + all);
  }
  std::string why = wish ? "as insisted on; " : "";
  if (best->kind == VisualClass::PseudoColorClass)
    why.append("its colormap is real: a new hue or gamma stores colours and draws nothing");
  else if (best->depth == 24 || wish)
    why.append("the 256-entry table is emulated: a change of colours draws the picture again");
  else
    why.append(
        "for want of PseudoColor 8 and TrueColor 24; the table is emulated, its colours may be coarser");
  return {*best, why};
}

std::string describeVisuals(const ServerVisuals& server, const std::optional<VisualWish>& wish) {
  std::ostringstream out;
  out << "display " << server.display << " (" << server.vendor << ")\n\n" << std::left;
  const auto line = [&](std::string_view name, std::string_view depth, std::string_view number,
                        std::string_view cells, std::string_view bits, std::string_view map,
                        std::string_view what) {
    out << std::setw(13) << name << std::right << std::setw(5) << depth << std::setw(8) << number
        << std::setw(7) << cells << std::setw(6) << bits << "  " << std::left << std::setw(10) << map << what
        << '\n';
  };
  line("class", "depth", "visuals", "cells", "bits", "colormap", "xnewell would");
  for (const auto& [v, count] : fold(server))
    line(kVisualClasses[static_cast<int>(v.kind)].name, std::to_string(v.depth), std::to_string(count),
         std::to_string(v.cells), std::to_string(v.bitsPerRgb), v.writable() ? "writable" : "fixed", deed(v));
  out << "\ncells: entries of its colormap (of each channel where red, green and blue have their own)\n"
      << "bits:  of a stored colour that reach the screen\n\n"
      << "default visual    " << server.defaultVisual().name() << " (" << hex(server.defaultId) << ")\n"
      << "black and white   pixels " << server.black << " and " << server.white << '\n'
      << "default colormap  ";
  if (server.freeCells)
    out << *server.freeCells << " of " << server.defaultVisual().cells
        << " cells free (counted by taking them and giving them back)\n";
  else
    out << "not writable\n";
  try {
    const VisualChoice choice = chooseVisual(server, wish);
    out << "chosen            " << choice.visual.name() << " (" << hex(choice.visual.id)
        << "): " << choice.why << '\n';
  } catch (const X11Error& error) {
    out << "chosen            none: " << error.what() << '\n';
  }
  return out.str();
}

unsigned long pixelOf(Rgb16 color, const ChannelMasks& masks) {
  return Channel{masks.red}.bits(color.r) | Channel{masks.green}.bits(color.g) |
         Channel{masks.blue}.bits(color.b);
}

Rgb16 colorOf(unsigned long pixel, const ChannelMasks& masks) {
  return {Channel{masks.red}.value(pixel), Channel{masks.green}.value(pixel),
          Channel{masks.blue}.value(pixel)};
}
