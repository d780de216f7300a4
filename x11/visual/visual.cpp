#include "x11/visual/visual.h"

#include <algorithm>
#include <bit>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <iomanip>
#include <sstream>
#include <stdexcept>
#include <tuple>

namespace xnewell {

namespace {

/// One row of chooseVisual()'s order of preference: what xnewell does with such a visual, and why it takes
/// it.
struct Preference {
  bool (*holds)(const VisualInfo&);
  std::string_view does;  ///< completes the sentence "xnewell would ..."
  std::string_view why;
};

bool isClass(const VisualInfo& v, VisualClass kind) { return v.kind == kind; }
bool trueColor(const VisualInfo& v) { return isClass(v, VisualClass::TrueColorClass); }

constexpr std::string_view kStores = "store colours in a private map; a change of colours draws nothing";
constexpr std::string_view kEmulates = "look the colours up itself; a change of colours draws again";
constexpr std::string_view kLive =
    "its colormap is real: a new hue or gamma stores colours and draws nothing";
constexpr std::string_view kExactly =
    "the 256-entry table is emulated: a change of colours draws the picture again";
constexpr std::string_view kCoarse =
    "it does not have every colour; the table is emulated by mixing those it has";

constexpr std::array kPreferences{
    Preference{[](const VisualInfo& v) {
                 return isClass(v, VisualClass::PseudoColorClass) && v.depth == 8 && v.holdsTable();
               },
               kStores, kLive},
    Preference{
        [](const VisualInfo& v) { return isClass(v, VisualClass::PseudoColorClass) && v.holdsTable(); },
        kStores, kLive},
    Preference{[](const VisualInfo& v) { return trueColor(v) && v.depth == 24 && v.exact(); }, kEmulates,
               kExactly},
    Preference{[](const VisualInfo& v) { return trueColor(v) && v.exact() && v.alphaMask() == 0; }, kEmulates,
               kExactly},
    Preference{
        [](const VisualInfo& v) { return isClass(v, VisualClass::DirectColorClass) && v.holdsTable(); },
        "store colours in a private map, through pixels (i, i, i); a change draws nothing", kLive},
    Preference{[](const VisualInfo& v) { return trueColor(v) && v.alphaMask() == 0 && v.depth >= 15; },
               "mix its colours", kCoarse},
    Preference{[](const VisualInfo& v) { return trueColor(v) && v.exact(); }, kEmulates,
               "the table is emulated; the alpha channel, which a compositor may use, is opaque"},
    Preference{[](const VisualInfo& v) { return isClass(v, VisualClass::GrayScaleClass) && v.holdsTable(); },
               "store grays in a private map; a change of colours draws nothing",
               "its colormap is real and holds the grays of the colours: storing draws nothing"},
    Preference{[](const VisualInfo& v) { return isClass(v, VisualClass::StaticColorClass) && v.depth >= 8; },
               "mix its fixed colours", kCoarse},
    Preference{trueColor, "mix its colours", kCoarse},
    Preference{[](const VisualInfo& v) { return isClass(v, VisualClass::DirectColorClass); },
               "fill a private map with even levels and mix these", kCoarse},
    Preference{[](const VisualInfo& v) { return v.gray() && v.holdsColors(); },
               "look the grays up itself; a change of colours draws again",
               "it shows no colours; the table is emulated with their grays"},
    Preference{[](const VisualInfo& v) { return v.gray() && !v.writable(); }, "mix its fixed grays",
               "it shows no colours; the table is emulated by mixing the grays it has"},
    Preference{[](const VisualInfo&) { return true; }, "mix the colours of its few cells", kCoarse},
};

int rowOf(const VisualInfo& v) {
  return static_cast<int>(
      std::ranges::find_if(kPreferences, [&](const Preference& row) { return row.holds(v); }) -
      kPreferences.begin());
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

/// Counts equal visuals together. The deepest come first, then the order is that of kVisualClasses.
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

/// "a, b, c". Repeated names are listed once.
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

/// The order of the channels in a pixel value, from the highest bits down, such as "rgb"; "-" if the visual
/// has no channels.
std::string orderOf(const VisualInfo& v) {
  if (!v.hasChannels()) return "-";
  std::array channels{std::pair{v.masks.red, 'r'}, std::pair{v.masks.green, 'g'},
                      std::pair{v.masks.blue, 'b'}};
  std::ranges::sort(channels, std::ranges::greater{});
  return {channels[0].second, channels[1].second, channels[2].second};
}

/// What xnewell would do with this visual.
std::string deed(const VisualInfo& v, const ServerVisuals& server, MapOwner owner) {
  const std::string does{kPreferences[rowOf(v)].does};
  if (owner == MapOwner::Private) return does;
  if (!sameKind(v, server.defaultVisual())) return "not take it: the default map belongs to another visual";
  if (!v.writable()) return does;
  return v.hasChannels() && !v.holdsTable()
             ? "take the levels that the default map offers, and mix them"
             : "take free cells of the default map as shades; if these are too few, mix its colours";
}

/// The position of a channel in a pixel value: its lowest bit, and its number of bits.
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

int VisualInfo::shownBits() const {
  if (gray()) return 0;
  if (holdsTable()) return bitsPerRgb;
  return exact() ? std::bit_width(static_cast<unsigned>(leastLevels())) - 1 : 0;
}

int VisualInfo::leastLevels() const {
  return hasChannels()
             ? static_cast<int>(std::min({levelsOf(masks.red), levelsOf(masks.green), levelsOf(masks.blue)}))
             : cells;
}

const VisualInfo& ServerVisuals::defaultVisual() const {
  return *std::find_if(visuals.begin(), visuals.end(),
                       [&](const VisualInfo& v) { return v.id == defaultId; });
}

VisualWish parseVisualWish(std::string_view text) {
  const auto sameLetter = [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
  };
  for (const VisualClassRow& row : kVisualClasses) {
    if (text.size() < row.name.size() ||
        !std::equal(row.name.begin(), row.name.end(), text.begin(), sameLetter))
      continue;
    std::string_view digits = text.substr(row.name.size());
    if (digits.empty()) return {row.id, std::nullopt};
    if (digits.front() == ' ') digits.remove_prefix(1);  // name() writes the space
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
      "' is not a visual: give a class and, if it matters, a depth, such as PseudoColor8 or "
      "TrueColor24; the classes are " +
      list(classes));
}

VisualChoice chooseVisual(const ServerVisuals& server, const std::optional<VisualWish>& wish,
                          MapOwner owner) {
  const auto has = [&](const VisualInfo& v) { return granted(wish, v); };
  const auto wished = [&] {
    std::string name{kVisualClasses[static_cast<int>(wish->kind)].name};
    return wish->depth ? name + " " + std::to_string(*wish->depth) : name;
  };
  if (wish && std::ranges::none_of(server.visuals, has))
    throw X11Error("display '" + server.display + "' has no " + wished() + "; it has " + namesOf(server));
  if (owner == MapOwner::Shared) {
    const VisualInfo& v = server.defaultVisual();
    if (!has(v))
      throw X11Error("--colormap shared uses the default map, which belongs to " + v.name() + ", not to " +
                     wished());
    return {v, v.writable()
                   ? "the default visual, whose map is shared: it gives as many shades as it has free cells, "
                     "or its colours are mixed"
                   : "the default visual; its map is not writable, so the table is emulated"};
  }
  const auto rank = [&](const VisualInfo& v) {
    return std::tuple{-rowOf(v), v.depth, v.id == server.defaultId};
  };
  const VisualInfo* best = nullptr;
  for (const VisualInfo& v : server.visuals)
    if (has(v) && (best == nullptr || rank(v) > rank(*best))) best = &v;
  if (best == nullptr) throw X11Error("display '" + server.display + "' has no visual");
  std::string why = (wish ? "as you asked; " : "") + std::string{kPreferences[rowOf(*best)].why};
  const auto flashing = std::ranges::find_if(server.visuals, [&](const VisualInfo& v) {
    return has(v) && isClass(v, VisualClass::DirectColorClass) && v.holdsTable();
  });
  if (best->exact() && flashing != server.visuals.end())
    why += "; the real colormap of " + flashing->name() + " would make all other windows flash";
  return {*best, why};
}

std::string describeVisuals(const ServerVisuals& server, const std::optional<VisualWish>& wish,
                            MapOwner owner) {
  std::ostringstream out;
  out << "display " << server.display << " (" << server.vendor << ")\n\n" << std::left;
  const auto line = [&](std::string_view name, std::string_view depth, std::string_view order,
                        std::string_view number, std::string_view cells, std::string_view free,
                        std::string_view bits, std::string_view map, std::string_view what) {
    out << std::setw(13) << name << std::right << std::setw(5) << depth << std::setw(7) << order
        << std::setw(9) << number << std::setw(7) << cells << std::setw(6) << free << std::setw(6) << bits
        << "  " << std::left << std::setw(10) << map << what << '\n';
  };
  line("class", "depth", "order", "visuals", "cells", "free", "bits", "colormap", "xnewell would");
  for (const auto& [v, count] : fold(server))
    line(kVisualClasses[static_cast<int>(v.kind)].name, std::to_string(v.depth), orderOf(v),
         std::to_string(count), std::to_string(v.cells),
         server.freeCells && sameKind(v, server.defaultVisual()) ? std::to_string(*server.freeCells) : "-",
         std::to_string(v.bitsPerRgb), v.writable() ? "writable" : "fixed", deed(v, server, owner));
  out << "\norder: of red, green and blue in a pixel value, highest bits first\n"
      << "cells: entries of the colormap (of each channel, if red, green and blue have their own)\n"
      << "free:  cells of the default colormap that are free (all programs share it)\n"
      << "bits:  bits of a stored colour that reach the screen\n\n"
      << "default visual    " << server.defaultVisual().name() << " (" << hex(server.defaultId) << ")\n"
      << "black and white   pixels " << server.black << " and " << server.white << '\n'
      << "default colormap  ";
  if (server.freeCells)
    out << *server.freeCells << " of " << server.defaultVisual().cells
        << " cells free (counted by taking them and giving them back)\n";
  else
    out << "not writable\n";
  try {
    const VisualChoice choice = chooseVisual(server, wish, owner);
    out << "chosen            " << choice.visual.name() << " (" << hex(choice.visual.id)
        << "): " << choice.why << '\n';
  } catch (const X11Error& error) {
    out << "chosen            none: " << error.what() << '\n';
  }
  return out.str();
}

unsigned long pixelOfCell(const VisualInfo& visual, int k) {
  const auto bits = [&](unsigned long mask) {
    return (static_cast<unsigned long>(k) << Channel{mask}.shift) & mask;
  };
  const ChannelMasks& m = visual.masks;
  return visual.hasChannels() ? bits(m.red) | bits(m.green) | bits(m.blue) | visual.alphaMask()
                              : static_cast<unsigned long>(k);
}

unsigned long levelsOf(unsigned long mask) { return 1ul << std::popcount(mask); }

unsigned long pixelOf(Rgb16 color, const ChannelMasks& masks) {
  return Channel{masks.red}.bits(color.r) | Channel{masks.green}.bits(color.g) |
         Channel{masks.blue}.bits(color.b);
}

Rgb16 colorOf(unsigned long pixel, const ChannelMasks& masks) {
  return {Channel{masks.red}.value(pixel), Channel{masks.green}.value(pixel),
          Channel{masks.blue}.value(pixel)};
}

}  // namespace xnewell
