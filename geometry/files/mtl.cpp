#include "geometry/files/mtl.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

#include "geometry/files/left_out.h"
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

/// Reads the components after `Kd`. A missing green or blue equals the red.
glm::dvec3 readColor(Words& words) {
  glm::dvec3 color{1.0};
  for (int channel = 0; channel < 3; ++channel) {
    const std::string_view word = words.next();
    if (channel == 0 && (word == "spectral" || word == "xyz")) return color;
    if (channel == 0 && word.empty()) words.fail("Kd needs a colour");
    color[channel] = word.empty() ? color.r : std::clamp(toNumber(words, word), 0.0, 1.0);
  }
  return color;
}

/// The file after `map_Kd` and its options. Calls unsupported(name) for an option that would change the
/// picture.
template <class Unsupported>
std::string readMap(Words& words, const Unsupported& unsupported) {
  std::string_view word = words.next();
  for (;;) {
    const auto* const option = std::ranges::find(kMapOptions, word, &MapOption::name);
    if (option == kMapOptions.end()) break;
    bool is = option->shows;
    int read = 0;
    for (word = words.next(); read < option->least || (read < option->most && isNumber(word)); ++read) {
      if (word.empty()) words.fail("map_Kd: nothing follows " + std::string{option->name});
      is = is && word != option->unlessIs;
      word = words.next();
    }
    if (is) unsupported(option->name);
  }
  if (word.empty()) words.fail("map_Kd needs a file");
  const std::string first{word}, others = words.rest();
  return others.empty() ? first : first + ' ' + others;
}

}  // namespace

MtlLibrary parseMtl(std::string_view text, const std::string& name) {
  MtlLibrary library;
  MtlMaterial* current = nullptr;
  LeftOut leftOut;
  Words words{text, name};
  while (words.nextLine()) {
    const std::string_view key = words.next();
    if (key == "newmtl") {
      current = &library.materials.insert_or_assign(words.rest(), MtlMaterial{}).first->second;
    } else if (key == "Kd" && current) {
      current->Kd = readColor(words);
    } else if (key == "map_Kd" && current) {
      current->line = words.line();
      current->map = readMap(words, [&](std::string_view option) {
        if (library.notes.empty())
          library.notes.emplace_back(
              ParseError{name, words.line(), "map_Kd is read without " + std::string{option}}.what());
      });
    } else if (!key.empty() && current) {
      leftOut.add(key);
    }
  }
  if (const std::string what = leftOut.sentence(); !what.empty())
    library.notes.emplace_back(ParseError{name, 0, what}.what());
  return library;
}

}  // namespace xnewell
