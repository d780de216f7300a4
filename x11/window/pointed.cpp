#include "x11/window/pointed.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace xnewell {

namespace {

/// A word in the window, what it means, and where it leads with its number. A longer word comes before its
/// parts.
struct WordRow {
  std::string_view word, means;
  Lead lead = Lead::None;
  enum class Number { None, Before, BeforeOrAlone, After } number = Number::None;
  bool alone = false;  ///< it counts only if nothing stands beside it
};
using Number = WordRow::Number;
constexpr std::array kWords{
    WordRow{"clamped", "an intensity above 1, which no cell has, is shown as 1", Lead::Clamped,
            Number::Before},
    WordRow{"cuts", "polygons that were split because no order of them was right", Lead::Cut,
            Number::BeforeOrAlone},
    WordRow{"cut", "polygons that were split because no order of them was right", Lead::Cut, Number::Before},
    WordRow{"wrong face", "a face shows although another one is nearer", Lead::Wrong},
    WordRow{"wrong", "a face shows although another one is nearer", Lead::Wrong, Number::Before},
    WordRow{"beside the right one", "the same picture without the mistake, in view 5", Lead::Right},
    WordRow{"cell", "a place in the colormap: it holds one colour, and the picture stores its number",
            Lead::Cell, Number::After},
    WordRow{"cells", "places in the colormap: each holds one colour, and the picture stores their numbers"},
    WordRow{"shade", "an entry of the ramp from dark to bright; each has a cell"},
    WordRow{"shades", "entries of the ramp from dark to bright; each has a cell"},
    WordRow{"sample", "the middle of a pixel: the face there gives the pixel its colour"},
    WordRow{"samples", "the middles of pixels: the face there gives a pixel its colour"},
    WordRow{"I0", "the lowest intensity of the corrected table, which begins there and grows in ratio"},
    WordRow{"oracle", "compares all faces at each sample: slow, and always right"},
    WordRow{"f", "how much of the light arrives: 1, or less far away, outside a spot's cone"},
    WordRow{"exact", "normals of the curved surface itself, not guessed from faces", Lead::None, Number::None,
            true},
    WordRow{"exact normals", "normals of the curved surface itself, not guessed from faces"},
    WordRow{"back faces", "faces that look away from the eye"},
    WordRow{"BSP", "a tree of planes that sorts the polygons from any eye, and cuts more of them"},
    WordRow{"Newell", "the depth sort of this program: it tests pairs, and cuts where no order is right"},
    WordRow{"z far", "sorts by the farthest point alone: fast, and sometimes wrong"},
    WordRow{"z mean", "sorts by the mean depth alone: fast, and sometimes wrong"},
    WordRow{"N.L", "the cosine between the normal and the light"},
    WordRow{"R.V", "the cosine between the reflected light and the eye"},
};

bool isLetter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }
bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// Letters of a text: a word with its number, if it has one there.
struct Found {
  std::size_t from, end;
  const WordRow* row;
  std::optional<int> number = {};
};

std::optional<Found> foundAt(std::string_view text, std::size_t at, const WordRow& row) {
  std::size_t end = at + row.word.size();
  if ((at > 0 && isLetter(text[at - 1])) || (end < text.size() && isLetter(text[end]))) return {};
  if (row.alone && text != row.word) return {};
  Found found{at, end, &row};
  if ((row.number == Number::Before || row.number == Number::BeforeOrAlone) && at > 1 &&
      text[at - 1] == ' ' && isDigit(text[at - 2])) {
    std::size_t from = at - 1;
    while (from > 0 && (isDigit(text[from - 1]) || text[from - 1] == ',')) --from;
    found.from = from, found.number = 0;
  }
  if (row.number == Number::After && end + 1 < text.size() && text[end] == ' ' && isDigit(text[end + 1])) {
    int number = 0;
    for (++end; end < text.size() && isDigit(text[end]) && number < 1000; ++end)
      number = 10 * number + (text[end] - '0');
    if (!text.substr(end).starts_with(" +")) found.end = end, found.number = number;  // a sum's first term
  }
  return found;
}

std::vector<Found> wordsIn(std::string_view text) {
  std::vector<Found> all;
  for (const WordRow& row : kWords)
    for (std::size_t at = 0; (at = text.find(row.word, at)) != text.npos; ++at)
      if (const auto found = foundAt(text, at, row); found && std::ranges::none_of(all, [&](const Found& f) {
                                                       return found->from < f.end && f.from < found->end;
                                                     }))
        all.push_back(*found);
  return all;
}

/// Letters before this byte of a text in UTF-8.
int lettersTo(std::string_view text, std::size_t end) {
  return static_cast<int>(
      std::ranges::count_if(text.substr(0, end), [](char c) { return (c & 0xC0) != 0x80; }));
}

Pointed pointedIn(const Written& written, const Found& found) {
  const int from = lettersTo(written.words, found.from), end = lettersTo(written.words, found.end);
  Pointed pointed{{written.place.x + from * written.pitch, written.place.y, (end - from) * written.pitch,
                   written.place.height}};
  const Number number = found.row->number;
  const bool leads = found.number || number == Number::None ||
                     (number == Number::BeforeOrAlone && written.words == found.row->word);
  if (leads) pointed.lead = found.row->lead;
  pointed.number = found.number.value_or(0);
  pointed.says = std::string{found.row->word} + ": " + std::string{found.row->means} + ".";
  return pointed;
}

}  // namespace

std::vector<Pointed> linksIn(const Written& written) {
  std::vector<Pointed> links;
  if (written.pitch == 0) return links;
  for (const Found& found : wordsIn(written.words))
    if (Pointed one = pointedIn(written, found); one.lead != Lead::None) links.push_back(std::move(one));
  return links;
}

std::optional<Pointed> pointedAt(const Writing& writing, int x, int y) {
  constexpr int kReach = 4;  // a finger is less exact than a cap is high
  for (auto one = writing.rbegin(); one != writing.rend(); ++one) {
    Rect place = one->place;
    if (one->pitch == 0) {
      place.y -= kReach, place.height += 2 * kReach;
      if (!place.has(x, y)) continue;
      const std::optional<Key> key = keyOfCap(one->words);
      return Pointed{.place = one->place, .key = key, .gesture = !key};
    }
    if (!place.has(x, y)) continue;
    for (const Found& found : wordsIn(one->words))
      if (Pointed pointed = pointedIn(*one, found); pointed.place.has(x, y)) return pointed;
  }
  return {};
}

}  // namespace xnewell
