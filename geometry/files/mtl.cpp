#include "geometry/files/mtl.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <set>

#include "geometry/files/number.h"
#include "geometry/files/parse_error.h"
#include "geometry/files/text_file.h"

namespace xnewell {

namespace {

/// An option of map_Kd. The manual gives -o, -s and -t one to three numbers, and every other option one
/// count of words.
struct MapOption {
  std::string_view name;
  int least, most;                 ///< words that follow it; those beyond `least` only if they are numbers
  bool shows = true;               ///< whether it would change the picture
  std::string_view unlessIs = {};  ///< unless it is this
};
constexpr std::array kMapOptions{
    MapOption{"-blendu", 1, 1, false},
    MapOption{"-blendv", 1, 1, false},
    MapOption{"-bm", 1, 1, false},
    MapOption{"-boost", 1, 1, false},
    MapOption{"-texres", 1, 1, false},
    MapOption{"-cc", 1, 1, true, "off"},
    MapOption{"-clamp", 1, 1, true, "off"},
    MapOption{"-imfchan", 1, 1},
    MapOption{"-mm", 2, 2},
    MapOption{"-o", 1, 3},
    MapOption{"-s", 1, 3},
    MapOption{"-t", 1, 3},
};

bool isNumber(std::string_view word) {
  double value = 0;
  const char* const end = word.data() + word.size();
  return std::from_chars(word.data(), end, value).ptr == end;
}

/// Reads the components after `Kd` or `Ks`. A missing green or blue equals the red. The first that is outside
/// of 0 to 1 is noted.
glm::dvec3 readColor(Words& words, std::string_view key, const std::string& name, std::string& outside) {
  glm::dvec3 color{1.0};
  for (int channel = 0; channel < 3; ++channel) {
    const std::string_view word = words.next();
    if (channel == 0 && (word == "spectral" || word == "xyz")) return color;
    if (channel == 0 && word.empty()) words.fail(std::string{key} + " needs a colour");
    const double value = word.empty() ? color.r : toNumber(words, word);
    color[channel] = std::clamp(value, 0.0, 1.0);
    if (outside.empty() && value != color[channel])
      outside = ParseError{name, words.line(),
                           std::string{key} + ' ' + std::string{word} + " is read as " +
                               (value > 1.0 ? "1" : "0") + ": a colour has numbers from 0 to 1"}
                    .what();
  }
  return color;
}

/// Reads the exponent after `Ns`.
int readExponent(Words& words) {
  const std::string_view word = words.next();
  if (word.empty()) words.fail("Ns needs a number");
  return static_cast<int>(std::lround(std::clamp(toNumber(words, word), 0.0, 1e6)));
}

/// True if a statement that has no place leaves the picture as it is: an opaque surface that does not shine.
bool hasNoEffect(std::string_view key, Words& words) {
  const double none = key == "d" ? 1.0 : 0.0;
  if (key != "d" && key != "Tr" && key != "Ke") return false;
  for (std::string_view word = words.next(); !word.empty(); word = words.next())
    if (!isNumber(word) || toNumber(words, word) != none) return false;
  return true;
}

/// The file after `map_Kd` and its options -s and -o go into the material. Calls unsupported(name) for an
/// option that would change the picture.
template <class Unsupported>
void readMap(Words& words, MtlMaterial& material, const Unsupported& unsupported) {
  material.scale = glm::dvec2{1.0}, material.offset = glm::dvec2{0.0};
  std::string_view word = words.next();
  for (;;) {
    const auto* const option = std::ranges::find(kMapOptions, word, &MapOption::name);
    if (option == kMapOptions.end()) break;
    bool is = option->shows;
    int read = 0;
    glm::dvec2* const pair = option->name == "-s"   ? &material.scale
                             : option->name == "-o" ? &material.offset
                                                    : nullptr;
    for (word = words.next(); read < option->least || (read < option->most && isNumber(word)); ++read) {
      if (word.empty()) words.fail("map_Kd: nothing follows " + std::string{option->name});
      is = is && word != option->unlessIs;
      if (pair != nullptr && read < 2) (*pair)[read] = toNumber(words, word);
      word = words.next();
    }
    if (is && pair == nullptr) unsupported(option->name);
  }
  if (word.empty()) words.fail("map_Kd needs a file");
  const std::string first{word}, others = words.rest();
  material.map = others.empty() ? first : first + ' ' + others;
}

}  // namespace

MtlLibrary parseMtl(std::string_view text, const std::string& name) {
  MtlLibrary library;
  MtlMaterial* current = nullptr;
  std::set<MtlMaterial*> matte;  // without a highlight
  std::string outside;
  LeftOut leftOut;
  Words words{text, name};
  while (words.nextLine()) {
    const std::string_view key = words.next();
    if (key == "newmtl") {
      current = &library.materials.insert_or_assign(words.rest(), MtlMaterial{}).first->second;
      matte.erase(current);
    } else if (key == "Kd" && current) {
      current->Kd = readColor(words, key, name, outside);
    } else if (key == "Ks" && current) {
      current->Ks = readColor(words, key, name, outside);
    } else if (key == "Ns" && current) {
      current->Ns = readExponent(words);
    } else if (key == "illum" && current) {
      const std::string_view model = words.next();
      matte.erase(current);
      if (model == "0" || model == "1")
        matte.insert(current);
      else if (model != "2")
        leftOut.add(key);
    } else if (key == "map_Kd" && current) {
      current->line = words.line();
      readMap(words, *current, [&](std::string_view option) {
        if (library.notes.empty())
          library.notes.emplace_back(
              ParseError{name, words.line(), "map_Kd is read without " + std::string{option}}.what());
      });
    } else if (!key.empty() && current && !hasNoEffect(key, words)) {
      leftOut.add(key);
    }
  }
  if (!outside.empty()) library.notes.push_back(outside);
  for (MtlMaterial* const m : matte) m->Ks = glm::dvec3{0.0};
  if (const std::string what = leftOut.sentence(); !what.empty())
    library.notes.emplace_back(ParseError{name, 0, what}.what());
  return library;
}

}  // namespace xnewell
