#include "geometry/files/mtl.h"

#include <algorithm>

#include "geometry/files/number.h"
#include "geometry/files/text_file.h"

namespace xnewell {

namespace {

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

}  // namespace

MaterialColors parseMtl(std::string_view text, const std::string& name) {
  MaterialColors colors;
  glm::dvec3* current = nullptr;
  Words words{text, name};
  while (words.nextLine()) {
    const std::string_view key = words.next();
    if (key == "newmtl") current = &colors.insert_or_assign(words.rest(), glm::dvec3{1.0}).first->second;
    if (key == "Kd" && current) *current = readColor(words);
  }
  return colors;
}

}  // namespace xnewell
