#include "x11/window/panel.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <utility>

#include "shading/color/font.h"
#include "x11/drawing/painter.h"
#include "x11/drawing/wording.h"
#include "x11/options/options.h"

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

namespace {

/// The last line of a window without room for the controls: the view, and the way out.
PanelState inSmallWindow(PanelState state, const Layout& at) {
  const glm::ivec2 least = kLeastWindow * at.unit;
  const ViewRow& view = rowOf(state.view);
  state.status = std::string{view.key} + ' ' + std::string{view.title} + ": the controls need " +
                 std::to_string(least.x) + " x " + std::to_string(least.y);
  state.selected.clear();
  std::erase_if(state.legend, [](const Legend& one) {
    return std::ranges::none_of(one.keys, [](const Key& key) { return key == Key{'?'} || key == Key{'q'}; });
  });
  return state;
}

struct Tab {
  ViewRow view;
  Rect place;
};
std::vector<Tab> tabsOf(const Layout& at) {
  std::vector<Tab> tabs;
  const int letter = at.compact ? 0 : 9;  // a narrow window has less space beside the names
  int x = 6;
  for (const ViewRow& row : kWindowViews) {
    tabs.push_back({row,
                    {x, at.low ? 2 : 5, 27 + (at.briefTabs ? 0 : letter + textWidth(row.title)),
                     at.views.height - (at.low ? 1 : 4)}});
    x += tabs.back().place.width + (at.compact ? 0 : 4);
  }
  return tabs;
}

/// The end of the text, as much as fits.
std::string endOf(const std::string& text, int width) {
  const auto letters = static_cast<std::size_t>(std::max(0, width) / kGlyphWidth);
  if (text.size() <= letters) return text;
  return letters > 3 ? "..." + text.substr(text.size() - letters + 3) : "";
}

void drawTabs(Pen& pen, const Layout& at, const PanelState& state) {
  pen.paint.fillRect(at.views, pen(Cell::Panel));
  pen.rule(0, at.views.height, at.width);
  const int baseline = at.low ? 16 : 23;
  int end = 0;
  for (const auto& [view, tab] : tabsOf(at)) {
    const bool shown = view.id == state.view;
    if (shown) {
      pen.paint.fillRect(tab, pen(Cell::Paper));
      pen.paint.fillRect({tab.x, tab.y, tab.width, 2}, pen(Cell::Ink));
      for (const int edge : {tab.x, tab.x + tab.width - 1})
        pen.paint.vline(edge, tab.y, at.views.height - tab.y, pen(Cell::Rule));
    }
    pen.soft(tab.x + 9, baseline, std::string_view{&view.key, 1});
    if (!at.briefTabs)
      pen.paint.text(tab.x + 24 - (at.compact ? 4 : 0), baseline, view.title,
                     pen(shown ? Cell::Ink : Cell::Soft), shown ? Voice::Bold : Voice::Plain);
    end = tab.x + tab.width + 4;
  }
  const int room = at.width - 2 * kMargin - end;
  if (room < 4 * kGlyphWidth) return;
  constexpr std::string_view kDot = " \u00B7 ";
  // A long path keeps its end, which distinguishes files; other names keep their first parts.
  const bool isPath = state.title.find('/') != std::string::npos;
  std::string title = (at.briefTabs ? std::string{rowOf(state.view).title} + ": " : "") + state.title;
  while (!isPath && textWidth(title) > room && title.find(kDot) != std::string::npos)
    title.erase(title.rfind(kDot));
  pen.softRight(at.width - kMargin, baseline, isPath ? endOf(title, room) : beginningOf(title, room));
}

std::optional<Direction> arrowOf(const Key& key) {
  constexpr std::array kArrows{
      std::pair{NamedKey::Left, Direction::Left}, std::pair{NamedKey::Right, Direction::Right},
      std::pair{NamedKey::Up, Direction::Up}, std::pair{NamedKey::Down, Direction::Down}};
  for (const auto& [name, direction] : kArrows)
    if (key.name == name) return direction;
  return std::nullopt;
}

int widthOf(const Legend& legend) {
  int width = textWidth(legend.does) + 12;
  const auto add = [&](int letters) { width += std::max(kKeyCap, letters) + 2; };
  for (const Key& key : legend.keys) add(arrowOf(key) ? 0 : textWidth(capOf(key)) + 9);
  if (!legend.gesture.empty()) add(textWidth(legend.gesture) + 9);
  return width;
}

/// From x to the right. Entries that do not fit are left out, but never the last one.
void drawLegend(Pen& pen, const Layout& at, int x, int y, const std::vector<Legend>& legends) {
  const int last = legends.empty() ? 0 : widthOf(legends.back());
  for (const Legend& legend : legends) {
    const bool isLast = &legend == &legends.back();
    if (!isLast && x + widthOf(legend) + last > at.width - kMargin) continue;
    const int left = x;
    for (const Key& key : legend.keys) {
      const std::optional<Direction> arrow = arrowOf(key);
      x += 2 + (arrow ? pen.arrow(x, y - 11, *arrow) : pen.key(x, y - 11, capOf(key)));
    }
    if (!legend.gesture.empty()) x += pen.key(x, y - 11, legend.gesture) + 2;
    x = pen.soft(x + 4, y, legend.does) + 12;
    // Words beside one cap are a part of the button.
    if (legend.keys.size() == 1)
      pen.paint.note({{{left, y - 11, x - 6 - left, kKeyCap}, nameOf(legend.keys.front())}});
  }
}

void drawTyped(Pen& pen, const Layout& at, const Typed& typed) {
  const int y = at.status.y + 15;
  int x = pen.ink(kMargin, y, typed.asks + ": ");
  // A long text shows its end, where it grows. A complaint also shows its end, which says what is wrong.
  const int all = at.width - kMargin - x - 40;
  const std::string complaint = endOf(typed.complaint, std::max(all / 2, all - textWidth(typed.text)));
  x = pen.bold(x, y, endOf(typed.text, std::max(60, all - textWidth(complaint))));
  pen.paint.fillRect({x + 1, y - 10, 7, 13}, pen(Cell::Ink));
  if (!complaint.empty()) pen.paint.text(x + 26, y, complaint, pen(Cell::Alarm));
  std::vector<Legend> legend{{{NamedKey::Return}, "accept"}, {{NamedKey::Escape}, "cancel"}};
  if (typed.offers)
    legend.insert(legend.begin() + 1, {{NamedKey::Up, NamedKey::Down}, "the built-in scenes"});
  at.low ? drawLegend(pen, at, x + textWidth(complaint) + 36, y, legend)
         : drawLegend(pen, at, kMargin, y + 18, legend);
}

void drawStatus(Pen& pen, const Layout& at, const PanelState& state) {
  pen.paint.fillRect(at.status, pen(Cell::Panel));
  pen.rule(0, at.status.y, at.width);
  if (state.typed) return drawTyped(pen, at, *state.typed);
  const int y = at.status.y + 15;
  const int begin = state.selected.empty() ? kMargin : pen.bold(kMargin, y, state.selected) + 18;
  int end = begin;
  if (!state.notice.empty()) {
    end = pen.paint.text(begin, y, state.notice, pen(Cell::Alarm));
  } else if (!state.told.empty()) {
    end = pen.paint.text(begin, y, state.told, pen(Cell::Good));
  } else if (at.low && !state.hint.empty()) {
    end = pen.ink(begin, y, state.hint);
  } else if (at.low) {  // the keys have some of this line
    end = pen.ink(begin, y, beginningOf(state.status, at.width * 2 / 3 - begin));
  } else {
    end = pen.ink(begin, y, state.status);
    if (!at.compact) end = pen.soft(end + 18, y, beginningOf(state.aside, at.width - kMargin - end - 18));
  }
  if (at.low) return drawLegend(pen, at, end + 18, y, state.legend);
  if (end + 18 + textWidth(state.visual) <= at.width - kMargin)
    pen.softRight(at.width - kMargin, y, state.visual);
  if (!state.hint.empty()) return (void)pen.ink(kMargin, y + 18, state.hint);
  return drawLegend(pen, at, kMargin, y + 18, state.legend);
}

constexpr int kShadow = 4;
constexpr int kHelpKeys = 16;  // from the box's left edge

struct HelpBox {
  Rect box;
  int words;  ///< from the box's left edge: right of all keys
  int line;   ///< from one line to the next: less where many must fit
  /// The words of a line of the list of all keys. Long words take several lines.
  [[nodiscard]] std::vector<std::string> wordsOf(const HelpLine& of) const {
    return broken(of.does, std::max(1, (box.width - words - kHelpKeys) / kVoices[0].pitch));
  }
};
HelpBox helpBox(const Layout& at, const std::vector<HelpLine>& lines) {
  constexpr int kLeastLine = 13, kLine = 18;
  const int width = std::min(at.width - 2 * kMargin, 560), head = at.low ? 32 : 52;
  HelpBox help{.box = {.width = width}, .words = 154, .line = kLine};
  for (const HelpLine& line : lines)
    help.words = std::max(help.words, kHelpKeys + textWidth(line.keys, Voice::Bold) + 12);
  int rows = 0;
  for (const HelpLine& line : lines) rows += static_cast<int>(help.wordsOf(line).size());
  help.line = std::clamp((at.status.y - head - kShadow - 2) / std::max(rows, 1), kLeastLine, kLine);
  const int height = head + help.line * rows;
  help.box = {(at.width - width) / 2, std::max(1, (at.status.y - height) / 2), width, height};
  return help;
}

void drawHelp(Pen& pen, const Layout& at, const std::vector<HelpLine>& lines) {
  const HelpBox help = helpBox(at, lines);
  const Rect& box = help.box;
  pen.paint.fillRect({box.x + kShadow, box.y + kShadow, box.width, box.height}, pen(Cell::Ink));
  pen.paint.fillRect(box, pen(Cell::Paper));
  pen.paint.frame(box, pen(Cell::Ink));
  const int lead = at.low ? 16 : 24;
  pen.caps(box.x + kHelpKeys, box.y + lead, "ALL KEYS");
  int y = box.y + 2 * lead;
  for (const HelpLine& line : lines) {
    pen.bold(box.x + kHelpKeys, y, line.keys);
    for (const std::string& words : help.wordsOf(line)) {
      pen.ink(box.x + help.words, y, words);
      y += help.line;
    }
  }
}

}  // namespace

bool hasRoomForTitle(const Layout& at, std::string_view title) {
  const Rect last = tabsOf(at).back().place;
  return textWidth(title) <= at.width - 2 * kMargin - (last.x + last.width + 4);
}

std::optional<View> tabAt(const Layout& at, int x, int y) {
  if (!at.roomy) return std::nullopt;
  for (const auto& [view, tab] : tabsOf(at))
    if (tab.has(x, y)) return view.id;
  return std::nullopt;
}

Rect busyBox(int width, int height, int unit) {
  constexpr int kWidth = 280, kHeight = 58;
  return Rect{(width / unit - kWidth) / 2, (height / unit - kHeight) / 2, kWidth, kHeight} * unit;
}

void drawBusyBox(IndexImage& image, int unit, const CellPlan& plan, int seconds, const BusyNote& note) {
  Pen pen{{image, unit}, plan};
  const Rect box = busyBox(image.width / unit, image.height / unit, 1);
  pen.paint.fillRect(box, pen(Cell::Paper));
  pen.paint.frame(box, pen(Cell::Ink));
  pen.bold(box.x + 16, box.y + 25, "drawing: " + std::to_string(seconds) + " s so far");
  pen.soft(box.x + 16, box.y + 43,
           note.givesUp                    ? "giving up; the last picture comes back"
           : note.mayGiveUp && note.mayEnd ? "Esc keeps the last picture; q quits now"
           : note.mayGiveUp                ? "Esc keeps the last picture"
           : note.mayEnd                   ? "press q or close the window to quit now"
                                           : "keys pressed now take effect later");
}

namespace {

Rect ribbonOf(const PanelState& state) {
  constexpr int kRibbon = 20;
  return state.mistake.empty() ? Rect{}
                               : Rect{state.picture.x, state.picture.y, state.picture.width, kRibbon};
}

/// A mistake is a guest: a ribbon over the picture names it, and says how it goes.
void drawRibbon(Pen& pen, const PanelState& state) {
  const Rect at = ribbonOf(state);
  const std::uint8_t white = pen(Cell::White);
  pen.paint.fillRect(at, pen(Cell::Alarm));
  int x = at.x + 8;
  const int y = at.y + 14, end = at.x + at.width - 8;
  x = pen.paint.text(x, y, beginningOf("Mistake: " + state.mistake, end - x), white, Voice::Bold) + 14;
  if (state.view == View::SideBySide) return;
  if (constexpr std::string_view right = "beside the right one"; x + textWidth(right) <= end)
    x = pen.paint.text(x, y, right, white) + 14;
  if (constexpr std::string_view next = "the next"; x + kKeyCap + 5 + textWidth(next) <= end)
    pen.paint.text(x + pen.key(x, y - 11, "E") + 5, y, next, white);
}

}  // namespace

std::vector<Rect> drawnOverPicture(const Layout& at, const PanelState& state) {
  std::vector<Rect> parts;
  if (!state.mistake.empty()) parts.push_back(ribbonOf(state));
  if (const Rect box = helpBox(at, state.help).box; !state.help.empty())
    parts.push_back({box.x, box.y, box.width + kShadow, box.height + kShadow});
  return parts;
}

void drawPanel(Painter paint, const Layout& at, const PanelState& state, const CellPlan& plan) {
  Pen pen{paint, plan};
  if (!state.mistake.empty()) drawRibbon(pen, state);
  if (at.roomy) {
    drawTabs(pen, at, state);
    pen.rule(0, at.strip.y, at.width);
    drawColorStrip(pen.paint, at.strip, plan, state.use, state.words, at.compact, state.inspected);
    drawStatus(pen, at, state);
  } else if (!at.status.empty()) {
    drawStatus(pen, at, inSmallWindow(state, at));
  }
  if (!state.help.empty()) drawHelp(pen, at, state.help);
}

void drawLinks(Painter paint, const Writing& writing, const std::optional<Pointed>& pointed,
               const CellPlan& plan) {
  for (const Written& one : writing)
    for (const Pointed& link : linksIn(one)) {
      const Rect& at = link.place;
      for (int x = at.x; x < at.x + at.width - 1; x += 2) paint.point(x, at.y + at.height, plan[Cell::Soft]);
    }
  if (!pointed || (!pointed->key && pointed->lead == Lead::None)) return;
  const Rect& at = pointed->place;
  paint.frame({at.x - 1, at.y - 1, at.width + 2, at.height + 2}, plan[Cell::Ink]);
}

}  // namespace xnewell
