#include "x11/kit/page.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>

#include "x11/drawing/wording.h"
#include "x11/kit/typed_line.h"

namespace xnewell::page {

/// The order of this file: words with marks in them, and what a question hides; tables as grids of letters
/// (Grid); text and JSON; the window, where parts take their room by weight (Flow); the answer to a question.

std::string asked(int rank, std::string_view value) {
  return std::string{'\1', static_cast<char>('0' + rank)} + std::string{value} + '\2';
}
std::string strong(std::string_view value) { return '\3' + std::string{value} + '\2'; }

namespace {

using Row = std::vector<Entry>;

struct Span {
  std::string text;
  bool bold = false, tick = false;
};

/// Words without their marks.
std::vector<Span> spansOf(std::string_view words, Hiding hiding) {
  std::vector<Span> all(1);
  bool hidden = false;
  for (std::size_t k = 0; k < words.size(); ++k) {
    const char c = words[k];
    if (c == '\1') {
      hidden = hiding.hides(words[++k] - '0');
      if (hidden) all.back().text += '?';
    } else if (c == '\2') {
      hidden = false;
      if (all.back().bold) all.emplace_back();
    } else if (c == '\3') {
      all.push_back({.text = {}, .bold = true});
    } else if (c == kTick[0]) {
      all.push_back({.text = {}, .tick = true});
    } else if (!hidden) {
      all.back().text += c;
    }
  }
  return all;
}
std::string plain(std::string_view words, Hiding hiding) {
  std::string text;
  for (const Span& span : spansOf(words, hiding)) text += span.text;
  return text;
}
int lettersOf(std::string_view text) { return textWidth(text) / 6; }
std::string padded(std::string text, int width, bool right = false) {
  const std::string pad(static_cast<std::size_t>(std::max(0, width - lettersOf(text))), ' ');
  return right ? pad + text : text + pad;
}

bool isHidden(const Part& part, Hiding hiding) {
  const int tells = std::visit([](const auto& p) { return p.tells; }, part);
  return tells > 0 && hiding.hides(tells);
}
int weightOf(const Part& part) {
  return std::visit([](const auto& p) { return p.weight; }, part);
}
int indentOf(const Part& part) {
  return std::visit([](const auto& p) { return p.indent; }, part);
}
bool hasWords(const Part& part) {
  const auto* f = std::get_if<Fact>(&part);
  const auto* t = std::get_if<Table>(&part);
  return f ? !f->words.empty() : !t || !t->rows.empty();
}
bool hasHeads(const Table& t) {
  return std::ranges::any_of(t.columns, [](const Column& c) { return !c.head.empty(); });
}

constexpr int kSwatch = 5;  ///< letters that a swatch takes

/// The columns of a table: letters of each, 0 where none is shown.
struct Grid {
  const Table& t;
  Hiding hiding;
  std::vector<int> widths = {};
  int gap = 2, fewer = 0;  ///< letters between them; decimals that numbers lack

  Grid(const Table& table, Hiding hides, bool swatches = false) : t{table}, hiding{hides} {
    measure(swatches);
  }
  /// Gives up what it can until all fits: columns that are light, space, decimals, and then the other
  /// columns.
  void fit(int letters) {
    constexpr int kLight = 4, kHeavy = 9;
    while (width() > letters) {
      const auto weight = [&](const Column& c) {
        return widths[static_cast<std::size_t>(&c - t.columns.data())] > 0 ? c.weight : kHeavy;
      };
      const auto lightest = std::ranges::min_element(t.columns, {}, weight);
      const int least = weight(*lightest);
      if (least > kLight && gap > 1) {
        --gap;
      } else if (least > kLight && fewer < 2) {
        const std::vector<int> had = widths;
        ++fewer;
        measure(true);
        for (std::size_t c = 0; c < had.size(); ++c) widths[c] = had[c] > 0 ? widths[c] : 0;
      } else if (least < kHeavy) {
        widths[static_cast<std::size_t>(lightest - t.columns.begin())] = 0;
      } else {
        return;
      }
    }
    if (std::ranges::none_of(t.columns, &Column::lane) && gaps() > 0)
      gap = std::clamp(gap + (letters - width()) / gaps(), gap, 4);
  }
  /// There is none within a bracket, nor beside an equals sign.
  [[nodiscard]] int gaps(std::size_t upTo = 99) const {
    int count = 0;
    bool before = false;
    for (std::size_t c = 0; c < std::min(upTo + 1, widths.size()); ++c) {
      if (widths[c] == 0) continue;
      const char bracket = t.columns[c].bracket;
      count += before && bracket != ']' && bracket != '=';
      before = bracket != '[' && bracket != '=';
    }
    return count;
  }
  [[nodiscard]] int width() const { return std::accumulate(widths.begin(), widths.end(), gap * gaps()); }
  /// Where a column begins.
  [[nodiscard]] int at(std::size_t column) const {
    return std::accumulate(widths.begin(), widths.begin() + static_cast<std::ptrdiff_t>(column),
                           gap * gaps(column));
  }
  [[nodiscard]] std::string wordsOf(const Entry& e) const {
    return e.number ? fitted(*e.number, std::max(0, e.decimals - fewer), e.most - 2 * fewer)
                    : plain(e.words, hiding);
  }
  /// `each` takes a column and its entry.
  template <class Do>
  static void forEach(const Row& row, const Do& each) {
    std::size_t c = 0;
    for (const Entry& e : row) each(c, e), c += static_cast<std::size_t>(e.span);
  }
  [[nodiscard]] std::vector<std::string> lines() const {
    std::vector<std::string> all;
    const auto put = [&](std::string& line, std::size_t c, const std::string& words, int span = 1) {
      if (words.empty() || widths[c] == 0) return;
      line = padded(std::move(line), at(c)) + padded(words, span > 1 ? 0 : widths[c], t.columns[c].right);
    };
    const auto add = [&](const Row& row) {
      std::string line;
      std::size_t next = 0;
      const auto brackets = [&](std::size_t upTo) {
        for (; next < upTo; ++next)
          if (const char b = t.columns[next].bracket) put(line, next, {b});
      };
      forEach(row, [&](std::size_t c, const Entry& e) {
        brackets(c);
        put(line, c, wordsOf(e), e.span);
      });
      brackets(widths.size());
      line.erase(line.find_last_not_of(' ') + 1);
      all.push_back(std::move(line));
    };
    if (hasHeads(t)) {
      Row heads;
      for (const Column& c : t.columns) heads.push_back({.words = c.head});
      add(heads);
    }
    for (const Row& row : t.rows) add(row);
    for (const Row& row : t.foot) add(row);
    return all;
  }

 private:
  void measure(bool swatches) {
    widths.assign(t.columns.size(), 0);
    for (const Row& row : t.rows)
      forEach(row, [&](std::size_t c, const Entry& e) {
        if (e.span == 1)
          widths[c] = std::max(widths[c], lettersOf(wordsOf(e)) + (swatches && e.swatch ? kSwatch : 0));
      });
    for (std::size_t c = 0; c < widths.size(); ++c)
      widths[c] = t.columns[c].bracket ? 1
                  : widths[c] == 0     ? 0
                                       : std::max(widths[c], lettersOf(t.columns[c].head));
  }
};

using Json = nlohmann::ordered_json;

/// A file name need not be UTF-8, but JSON can hold nothing else.
std::string dumped(const Json& json, int indent = -1) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace) + '\n';
}

Json jsonOf(const Data& data) {
  return std::visit(
      [](const auto& v) -> Json {
        using T = std::decay_t<decltype(v)>;
        if constexpr (std::is_same_v<T, List>) {
          Json all = Json::array();
          for (const Data& one : v) all.push_back(jsonOf(one));
          return all;
        } else if constexpr (std::is_same_v<T, Object>) {
          Json all = Json::object();
          for (const auto& [key, one] : v) all[std::string{key}] = jsonOf(one);
          return all;
        } else {
          return v;
        }
      },
      static_cast<const Data::variant&>(data));
}

}  // namespace

std::vector<std::string> asLines(const Page& page, Hiding hiding) {
  std::vector<std::string> lines;
  if (!page.title.empty()) lines.push_back(page.title);
  for (const std::string& line : page.under) lines.push_back(plain(line, hiding));
  for (const Section& s : page.sections) {
    std::vector<std::string> of;
    for (const Part& part : s.parts) {
      if (isHidden(part, hiding)) continue;
      const std::string margin(static_cast<std::size_t>((s.title.empty() ? 0 : 6) + indentOf(part)), ' ');
      if (const auto* f = std::get_if<Fact>(&part); f && !f->words.empty()) {
        std::string words = plain(f->words, hiding);
        if (const std::size_t tab = words.find('\t'); tab != std::string::npos) words.replace(tab, 1, "  ");
        of.push_back(margin + words);
      } else if (const auto* t = std::get_if<Table>(&part)) {
        for (const std::string& line : Grid{*t, hiding}.lines()) of.push_back(margin + line);
      } else if (const auto* found = std::get_if<Finding>(&part)) {
        of.push_back(margin + found->bold + ' ' + plain(found->why, hiding));
      }
    }
    if (of.empty()) continue;
    if (!s.title.empty()) lines.push_back(s.title + (s.aside.empty() ? "" : ": " + s.aside));
    lines.insert(lines.end(), of.begin(), of.end());
  }
  return lines;
}

std::string asText(const Page& page) {
  std::string text = page.of.empty() ? "" : page.of + (page.title.empty() ? "\n" : ": ");
  for (const std::string& line : asLines(page)) text += line + '\n';
  return text;
}

std::string asJson(const Page& page) {
  Json found = Json::object(), all = found;
  for (const Section& s : page.sections)
    for (const Part& part : s.parts) {
      if (const auto* f = std::get_if<Fact>(&part); f && !f->key.empty())
        found[std::string{f->key}] = jsonOf(f->data);
      const auto* t = std::get_if<Table>(&part);
      if (!t || t->key.empty()) continue;
      List rows;
      for (const Row& row : t->rows) {
        Object object;
        Grid::forEach(row, [&](std::size_t c, const Entry& e) {
          if (!t->columns[c].key.empty()) object.emplace_back(t->columns[c].key, e.data);
        });
        rows.emplace_back(std::move(object));
      }
      found[std::string{t->key}] = jsonOf(rows);
    }
  for (std::size_t from = 0, end = 0; from < page.order.size(); from = end + 1) {
    end = std::min(page.order.find(' ', from), page.order.size());
    const std::string key{page.order.substr(from, end - from)};
    if (const auto at = found.find(key); at != found.end()) all[key] = *at;
  }
  all.update(found);
  return dumped(all, page.indent);
}

std::string asJson(const Data& data) { return dumped(jsonOf(data)); }

int pitchOf(const Rect& body) {
  return body.height < 500 ? 14 : 16 + std::clamp((body.height - 600) / 60, 0, 4);
}

namespace {

/// The rows that have room: -1 for a line that stands for the others. The chosen one is among them.
std::vector<int> shownRows(int count, int chosen, int room) {
  std::vector<int> rows;
  if (count <= room || chosen < room - 1) {
    for (int k = 0; k < std::min(count, count <= room ? room : room - 1); ++k) rows.push_back(k);
    if (count > room) rows.push_back(-1);
    return rows;
  }
  const int last = std::min(chosen + (room > 3 ? 1 : 0), count - 1);
  rows = {0, -1};
  for (int k = last - (room - 3); k <= last; ++k) rows.push_back(k);
  return rows;
}

/// A part with its place. Heights are in units.
struct Laid {
  const Part* part;
  std::size_t section, order;
  std::vector<std::string> lines = {};  ///< of a fact or a finding that is broken
  int rows = 0, leastRows = 0;          ///< of a table or a finding
  int rowWeight = 0;
  int height = 0, extra = 0;  ///< of a sketch beside lines: not in the flow
  bool isBeside = false;

  [[nodiscard]] int weight() const { return rows > leastRows ? rowWeight : weightOf(*part); }
};

struct Flow {
  Pen& pen;
  const Page& page;
  Rect area;
  int pitch;
  Hiding hiding;
  std::vector<Laid> all = {}, gone = {};
  std::vector<Pressed> pressed = {};

  static constexpr int kBelowSketch = 3;  ///< from its lower edge to where the next line's letters may start
  static constexpr int kBox = 6;          ///< of a finding, around its lines
  /// Of heights: the last line needs only its letters.
  [[nodiscard]] int room() const { return area.height + pitch - (page.title.empty() ? 13 : 3); }
  [[nodiscard]] int titleHeight() const { return page.title.empty() ? 0 : 46; }
  [[nodiscard]] int headHeight(std::size_t s) const {
    return page.sections[s].title.empty() ? 0 : pitch / 2 + pitch + 2;
  }
  [[nodiscard]] Cell cellOf(Tone tone) const {
    return tone == Tone::Soft ? Cell::Soft : tone == Tone::Alarm ? Cell::Alarm : Cell::Ink;
  }
  /// The height of so many rows of a table, or lines of a finding.
  [[nodiscard]] int heightOf(const Part& part, int rows) const {
    if (const auto* t = std::get_if<Table>(&part))
      rows += (hasHeads(*t) ? 1 : 0) + static_cast<int>(t->foot.size());
    return rows * pitch + (std::holds_alternative<Finding>(part) ? kBox : 0);
  }

  void measure(Laid& laid) const {
    const int letters = area.width / 6 - indentOf(*laid.part);
    if (const auto* f = std::get_if<Fact>(laid.part)) {
      const std::string words = plain(f->words, hiding);
      if (lettersOf(words) > letters && words.find('\t') == std::string::npos)
        laid.lines = broken(words, letters);
      laid.height = pitch * std::max(1, static_cast<int>(laid.lines.size()));
    } else if (const auto* t = std::get_if<Table>(laid.part)) {
      laid.rows = std::min(static_cast<int>(t->rows.size()), t->most);
      laid.leastRows = t->least, laid.rowWeight = t->rowWeight;
      laid.height = heightOf(*t, laid.rows);
    } else if (const auto* found = std::get_if<Finding>(laid.part)) {
      laid.lines = broken(plain(found->why, hiding), letters - 3);
      laid.rows = 1 + static_cast<int>(laid.lines.size());
      laid.leastRows = 2, laid.rowWeight = 4;
      laid.height = heightOf(*found, laid.rows);
    } else {
      const auto& sketch = std::get<Sketch>(*laid.part);
      laid.isBeside = sketch.beside;
      laid.height = sketch.lines * pitch + (sketch.beside ? -4 : 2);
    }
  }
  /// The lines beside a sketch: those after it in its section, up to a strip.
  template <class Do>
  void group(std::size_t from, const Do& each) const {
    for (std::size_t k = from + 1; k < all.size() && all[k].section == all[from].section; ++k) {
      if (const auto* s = std::get_if<Sketch>(all[k].part); s && !s->beside) break;
      each(all[k]);
    }
  }
  [[nodiscard]] int widthBeside(std::size_t from) const {
    int widest = 0;
    group(from, [&](const Laid& laid) {
      if (const auto* f = std::get_if<Fact>(laid.part); f && f->words.find('\t') == std::string::npos)
        widest = std::max(widest, lettersOf(plain(f->words, hiding)) + f->indent);
      if (const auto* t = std::get_if<Table>(laid.part))
        for (const std::string& line : Grid{*t, hiding}.lines())
          widest = std::max(widest, lettersOf(line) + t->indent);
    });
    return area.width - 6 * widest - 12;
  }
  [[nodiscard]] int heightBeside(std::size_t from) const {
    int height = 0;
    group(from, [&](const Laid& laid) { height += laid.isBeside ? 0 : laid.height; });
    return height;
  }
  [[nodiscard]] int total() const {
    int sum = titleHeight();
    for (std::size_t k = 0; k < all.size(); ++k) {
      if (k == 0 || all[k].section != all[k - 1].section) sum += headHeight(all[k].section);
      sum += all[k].isBeside ? std::max(0, all[k].height + all[k].extra + kBelowSketch - heightBeside(k))
                             : all[k].height;
    }
    return sum;
  }

  void collect() {
    static const Part mark = Fact{.words = "?"};
    for (std::size_t s = 0; s < page.sections.size(); ++s) {
      const std::size_t before = all.size();
      bool hidden = false;
      const auto add = [&](const Part& part) {
        all.push_back({.part = &part, .section = s, .order = all.size()});
        measure(all.back());
      };
      for (const Part& part : page.sections[s].parts) {
        if (!hasWords(part) || weightOf(part) == 0) continue;
        hidden = hidden || isHidden(part, hiding);
        if (!isHidden(part, hiding)) add(part);
      }
      if (hidden && all.size() == before) add(mark);
    }
  }
  /// A sketch that lines leave too little room beside them goes; then rows, then what is lightest.
  void fit() {
    for (std::size_t k = 0; k < all.size(); ++k)
      if (all[k].isBeside && widthBeside(k) < 5 * pitch)
        all.erase(all.begin() + static_cast<std::ptrdiff_t>(k--));
    while (total() > room() && !all.empty()) {
      auto lightest = all.begin();
      for (auto at = all.begin(); at != all.end(); ++at)
        if (at->weight() <= lightest->weight()) lightest = at;
      if (lightest->rows > lightest->leastRows) {
        lightest->height = heightOf(*lightest->part, --lightest->rows);
        continue;
      }
      gone.push_back(*lightest);
      all.erase(lightest);
    }
    // One that went early may be lower than one that went late.
    for (auto one = gone.rbegin(); one != gone.rend(); ++one) {
      const auto at =
          all.insert(std::ranges::find_if(all, [&](const Laid& l) { return l.order > one->order; }), *one);
      if (total() > room())
        all.erase(at);
      else
        one->part = nullptr;
    }
    for (Laid& laid : all) {
      Laid whole{laid};
      if (laid.rows > 0) measure(whole);
      while (laid.rows < whole.rows && total() + pitch <= room())
        laid.height = heightOf(*laid.part, ++laid.rows);
    }
    // What is left goes to sketches.
    for (std::size_t k = 0; k < all.size(); ++k) {
      if (!all[k].isBeside) continue;
      const auto& sketch = std::get<Sketch>(*all[k].part);
      const int most =
          std::min(static_cast<int>(sketch.most * area.height),
                   sketch.left ? std::min(area.width * 11 / 20, widthBeside(k) - 4) : widthBeside(k) * 3 / 4);
      const auto height = [&] { return all[k].height + all[k].extra; };
      while (height() + 4 <= most && (total() + 4 <= room() || height() < heightBeside(k) - pitch))
        all[k].extra += 4;
    }
  }

  [[nodiscard]] std::vector<std::string> leftOut() const {
    std::vector<std::string> words;
    for (const Laid& laid : gone) {
      if (!laid.part) continue;
      const auto* f = std::get_if<Fact>(laid.part);
      words.push_back(f                                            ? plain(f->words, hiding)
                      : std::holds_alternative<Sketch>(*laid.part) ? "a sketch"
                                                                   : "a table");
    }
    return words;
  }

  int words(int x, int y, std::string_view marked, Tone tone) {
    for (const Span& span : spansOf(marked, hiding)) {
      if (span.tick) pen.paint.tick(x + 4, y - 8, pen(Cell::Good)), x += 16;
      x = pen.paint.text(x, y, span.text, pen(cellOf(tone)),
                         span.bold || tone == Tone::Bold ? Voice::Bold : Voice::Plain);
    }
    return x;
  }
  void title() {
    if (page.title.empty()) return;
    pen.paint.text(area.x, area.y + 22, page.title, pen(page.alarms ? Cell::Alarm : Cell::Ink), Voice::Title);
    int y = area.y + 12;
    for (const std::string& line : page.under)
      words(area.x + textWidth(page.title, Voice::Title) + 16, y, line, Tone::Ink), y += 16;
  }
  void head(const Section& s, int y) {
    if (s.title.empty()) return;
    pen.rule(area.x, y - pitch + 1, area.width);
    const int end = pen.caps(area.x, y + 1, s.title);
    pen.softRight(area.x + area.width, y + 1, beginningOf(s.aside, area.x + area.width - end - 12));
  }
  void fact(const Fact& f, const Laid& laid, int x, int right, int y) {
    if (const std::size_t tab = f.words.find('\t'); tab != std::string::npos) {
      words(x, y, std::string_view{f.words}.substr(0, tab), Tone::Soft);
      const int room = right - x - 6 * static_cast<int>(tab) - 6;
      const std::string value = beginningOf(plain(std::string_view{f.words}.substr(tab + 1), hiding), room);
      f.tone == Tone::Soft ? (void)pen.softRight(right, y, value) : pen.boldRight(right, y, value);
    } else if (laid.lines.empty()) {
      words(x, y, f.words, f.tone);
    } else {
      for (const std::string& line : laid.lines) words(x, y, line, f.tone), y += pitch;
    }
  }
  void finding(const Finding& f, const Laid& laid, int x, int y) {
    const Rect box{x, y - 11, area.x + area.width - x, laid.height - pitch + 13};
    pen.paint.fillRect(box, pen(Cell::White));
    pen.paint.fillRect({box.x, box.y, 4, box.height}, pen(f.alarm ? Cell::Alarm : Cell::Good));
    const int room = box.width - 18;
    x += 12, y += 2;
    pen.bold(x, y, beginningOf(f.bold, room));
    for (int k = 1; k < laid.rows; ++k) {
      const auto at = static_cast<std::size_t>(k - 1);
      const bool cut = k + 1 == laid.rows && at + 1 < laid.lines.size();
      pen.ink(x, y += pitch,
              cut ? beginningOf(laid.lines[at] + ' ' + laid.lines[at + 1], room) : laid.lines[at]);
    }
  }
  /// A lane takes what is left, and the columns behind it stand at the right.
  void table(const Table& t, const Laid& laid, int left, int y) {
    Grid grid{t, hiding, true};
    const int width = area.x + area.width - left;
    grid.fit(width / 6);
    const auto lane = std::ranges::find(t.columns, true, &Column::lane) - t.columns.begin();
    int laneWidth = 0, spare = 0;
    if (lane < std::ssize(t.columns)) {
      const int free = width - 6 * grid.width();
      laneWidth = std::clamp(free, 0, area.width / 5);
      if (laneWidth < 40) laneWidth = 0;
      spare = free - laneWidth;
    }
    const auto xOf = [&](std::size_t c) {
      const auto at = static_cast<std::ptrdiff_t>(c);
      return left + 6 * grid.at(c) + (at >= lane ? spare : 0) + (at > lane ? laneWidth : 0);
    };
    const auto put = [&](std::size_t c, const std::string& text, Cell cell, Voice voice, int span = 1) {
      if (t.columns[c].right && span == 1)
        pen.paint.textRight(xOf(c) + 6 * grid.widths[c], y, text, pen(cell), voice);
      else
        pen.paint.text(xOf(c), y, beginningOf(text, area.x + area.width - xOf(c)), pen(cell), voice);
    };
    const auto row = [&](const Row& of, bool chosen) {
      Grid::forEach(of, [&](std::size_t c, const Entry& e) {
        if (static_cast<std::ptrdiff_t>(c) == lane && laneWidth > 0) {
          pen.paint.hline(xOf(c), y - 4, laneWidth - 12, pen(Cell::Rule));
          pen.paint.fillRect({xOf(c) + static_cast<int>(e.share * (laneWidth - 18)), y - 7, 6, 7},
                             pen(Cell::Soft));
          return;
        }
        if (grid.widths[c] == 0 && e.span == 1) return;
        const bool bold = chosen || e.tone == Tone::Bold || e.tone == Tone::Alarm;
        put(c, grid.wordsOf(e), cellOf(e.tone), bold ? Voice::Bold : Voice::Plain, e.span);
        if (!e.swatch) return;
        const Rect swatch{xOf(c) + 6 * (grid.widths[c] - kSwatch) + 8, y - 9, 22, 10};
        pen.paint.fillRect(swatch, static_cast<std::uint8_t>(*e.swatch));
        pen.paint.frame(swatch, pen(Cell::Ink));
      });
      y += pitch;
    };
    if (hasHeads(t)) {
      for (std::size_t c = 0; c < grid.widths.size(); ++c)
        if (grid.widths[c] > 0) put(c, t.columns[c].head, Cell::Soft, Voice::Plain);
      y += pitch;
    }
    for (std::size_t c = 0; c < t.columns.size(); ++c)
      if (t.columns[c].bracket && grid.widths[c] > 0) {
        const int x = xOf(c) + 2, top = y - 11, height = laid.rows * pitch - 1;
        if (t.columns[c].bracket == '=') {
          pen.soft(xOf(c), top + height / 2 + 4, "=");
          continue;
        }
        pen.paint.vline(x, top, height, pen(Cell::Soft));
        for (const int end : {top, top + height - 1})
          pen.paint.hline(t.columns[c].bracket == '[' ? x : x - 3, end, 4, pen(Cell::Soft));
      }
    const auto count = static_cast<int>(t.rows.size());
    for (const int k : shownRows(count, std::max(0, t.chosen), laid.rows)) {
      if (k < 0) {
        pen.ink(left, y, "+ " + std::to_string(count - laid.rows + 1) + " more");
        y += pitch;
        continue;
      }
      const Rect place{area.x - 4, y - 11, area.width + 8, pitch - 1};
      if (t.id > 0) pressed.push_back({place, t.id, k});
      if (k == t.chosen) pen.paint.fillRect(place, pen(Cell::White));
      row(t.rows[static_cast<std::size_t>(k)], k == t.chosen);
    }
    for (const Row& one : t.foot) row(one, false);
  }

  void drawAll() {
    title();
    int y = area.y + titleHeight() + (page.title.empty() ? 10 : 0), below = 0, left = area.x,
        right = area.x + area.width;
    const auto pass = [&] { y = std::max(y, below), below = 0, left = area.x, right = area.x + area.width; };
    for (std::size_t k = 0; k < all.size(); ++k) {
      const Laid& laid = all[k];
      if (k == 0 || laid.section != all[k - 1].section) {
        pass();
        if (headHeight(laid.section) > 0) {
          head(page.sections[laid.section], y + pitch / 2);
          y += headHeight(laid.section);
        }
      }
      const int x = left + 6 * indentOf(*laid.part);
      if (const auto* s = std::get_if<Sketch>(laid.part)) {
        Rect at{area.x, y - 9, area.width, laid.height - pitch + 9};
        if (s->beside) {
          at.height = laid.height + laid.extra;
          at.width = s->left ? at.height : std::min(widthBeside(k), at.height * 4 / 3);
          at.x = s->left ? area.x : area.x + area.width - at.width;
          at.y = y - 11;
          below = at.y + at.height + 14;
          s->left ? left = at.x + at.width + 16 : right = at.x - 12;
        } else {
          pass();
          at.y = y - 9;
          y += laid.height;
        }
        s->draw(pen, at);
        if (s->id > 0) pressed.push_back({at, s->id, 0});
        continue;
      }
      if (const auto* f = std::get_if<Fact>(laid.part)) fact(*f, laid, x, right, y);
      if (const auto* t = std::get_if<Table>(laid.part)) table(*t, laid, x, y);
      if (const auto* f = std::get_if<Finding>(laid.part)) finding(*f, laid, x, y);
      y += laid.height;
    }
  }
};

}  // namespace

std::vector<Pressed> draw(Pen& pen, const Page& page, const Rect& area, int pitch, Hiding hiding,
                          std::vector<std::string>* leftOut) {
  Flow flow{pen, page, area, pitch, hiding};
  flow.collect();
  flow.fit();
  flow.drawAll();
  if (leftOut) *leftOut = flow.leftOut();
  return std::move(flow.pressed);
}

Question::Judged Question::judged(const std::string& text) const {
  constexpr std::string_view kCell = "cell ";
  if (lands && text.starts_with(kCell)) {
    const std::optional<int> cell = wholeNumber(text.substr(kCell.size()));
    if (!cell || *cell < 0 || *cell > 255) return {.complaint = "Type a cell: a whole number from 0 to 255."};
    return {.isRight = *cell == lands(value) || *cell == lands(written), .lands = cell};
  }
  const std::optional<double> typed = typedNumber(text);
  if (!typed || !std::isfinite(*typed)) return {.complaint = "Type a number."};
  const std::size_t point = std::min(text.find('.'), text.size() - 1),
                    end = std::min(text.find_first_not_of("0123456789", point + 1), text.size());
  const int typedDecimals = static_cast<int>(end - point - 1), shown = std::min(typedDecimals, decimals);
  if (shown < std::min(2, decimals)) return {.complaint = "Type at least two decimals."};
  // The numbers that a page shows are rounded, so a result from them may be off by a little more.
  const double allowed =
      std::max(0.5 * std::pow(10.0, -shown) * (1.0 + 1e-9), 0.75 * std::pow(10.0, -decimals));
  std::optional<int> cell = lands ? std::optional{lands(*typed)} : std::nullopt;
  if (cell && (*cell < 0 || *cell > 255)) cell.reset();
  return {.isRight = std::min(std::abs(*typed - value), std::abs(*typed - written)) <= allowed,
          .lands = cell};
}

}  // namespace xnewell::page
