#include "x11/drawing/painter.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <string>

#include "geometry/files/parse_error.h"
#include "shading/color/font.h"
#include "x11/drawing/wording.h"

namespace xnewell {

int textWidth(std::string_view utf8, Voice voice) {
  return kVoices[static_cast<int>(voice)].pitch * static_cast<int>(codesOf(utf8).size());
}

std::string beginningOf(std::string text, int width, Voice voice) {
  constexpr std::size_t kDots = 3;
  const auto letters = static_cast<std::size_t>(std::max(0, width) / kVoices[static_cast<int>(voice)].pitch);
  if (codesOf(text).size() <= letters) return text;
  if (letters <= kDots) return "";
  std::size_t end = 0;
  for (std::size_t letter = 0; end < text.size(); ++end)
    if (!continues(text[end]) && ++letter > letters - kDots) break;
  text.resize(end);
  return text + "...";
}

bool stippled(Stipple stipple, int x, int y) {
  switch (stipple) {
    case Stipple::Quarter:
      return (x + 2 * y) % 4 == 0;
    case Stipple::Eighth:
      return y % 2 == 0 && (x + y) % 4 == 0;
    case Stipple::Diagonals:
      return (x + y) % 8 == 0;
  }
  return false;
}

Painter Painter::pixels() const {
  Painter fine = *this;
  fine.step_ = 1;
  return fine;
}

Painter Painter::within(const Rect& area) const {
  Painter inner = *this;
  inner.clip_ = intersection(clip_, area * step_);
  return inner;
}

void Painter::fillRect(const Rect& area, std::uint8_t cell) {
  const Rect r = intersection(area * step_, clip_);
  for (int j = r.y; j < r.y + r.height; ++j) std::fill_n(image_->row(j) + r.x, r.width, cell);
}

void Painter::frame(const Rect& area, std::uint8_t cell) {
  if (area.width <= 0 || area.height <= 0) return;
  hline(area.x, area.y, area.width, cell);
  hline(area.x, area.y + area.height - thick(), area.width, cell);
  vline(area.x, area.y, area.height, cell);
  vline(area.x + area.width - thick(), area.y, area.height, cell);
}

void Painter::stipple(const Rect& area, Stipple stipple, std::uint8_t cell) {
  const Rect r = intersection(area * step_, clip_);
  for (int j = r.y; j < r.y + r.height; ++j)
    for (int i = r.x; i < r.x + r.width; ++i)
      if (stippled(stipple, i / unit_, j / unit_)) image_->row(j)[i] = cell;
}

void Painter::place(const IndexImage& picture, const Rect& part, int x, int y) {
  const int dx = x * step_ - part.x, dy = y * step_ - part.y;
  const Rect from = intersection(part, {0, 0, picture.width, picture.height});
  const Rect to = intersection({from.x + dx, from.y + dy, from.width, from.height}, clip_);
  if (to.empty()) return;
  for (int j = to.y; j < to.y + to.height; ++j)
    std::copy_n(picture.row(j - dy) + to.x - dx, to.width, image_->row(j) + to.x);
}

void Painter::fit(const IndexImage& picture, const Rect& area) {
  const Rect to = area * step_;
  if (to.width == picture.width && to.height == picture.height) return place(picture, area.x, area.y);
  const Rect shown = intersection(to, clip_);
  for (int j = shown.y; j < shown.y + shown.height; ++j) {
    const std::uint8_t* const from = picture.row((2 * (j - to.y) + 1) * picture.height / (2 * to.height));
    for (int i = shown.x; i < shown.x + shown.width; ++i)
      image_->row(j)[i] = from[(2 * (i - to.x) + 1) * picture.width / (2 * to.width)];
  }
}

void Painter::note(const Writing& writing, int dx, int dy) {
  if (!writing_) return;
  for (const Written& one : writing) {
    const Rect& at = one.place;
    const Rect place{at.x + dx, at.y + dy, at.width, at.height};
    if (!intersection(place * step_, clip_).empty()) writing_->push_back({place, one.words, one.pitch});
  }
}

void Painter::line(int x0, int y0, int x1, int y1, std::uint8_t cell, const LineStyle& style) {
  assert(style.thickness >= 1 && style.on >= 1 && style.off >= 0);
  const bool steep = std::abs(y1 - y0) > std::abs(x1 - x0);
  const int across = style.thickness * thick(), before = (across - 1) / 2;
  const int x = clip_.x / step_, y = clip_.y / step_;
  const Rect area{x, y, (clip_.x + clip_.width + step_ - 1) / step_ - x,
                  (clip_.y + clip_.height + step_ - 1) / step_ - y};
  forEachPixelOfLine(area, x0, y0, x1, y1, [&](int k, int i, int j) {
    if (k / thick() % (style.on + style.off) >= style.on) return;
    fillRect(steep ? Rect{i - before, j, across, 1} : Rect{i, j - before, 1, across}, cell);
  });
}

namespace {

/// Distances in half coordinates, squared: (2i)^2 + (2j)^2 < (2r + 1)^2, where a radius has `thick` of them.
bool inDisc(int i, int j, int radius, int thick) {
  const int reach = (2 * radius + 1) * thick;
  return radius >= 0 && 4 * (i * i + j * j) < reach * reach;
}

constexpr std::array<std::string_view, 7> kTick{"      #", "     ##", "    ## ", "#   #",
                                                "## ## ",  " ###",    "  #"};
constexpr std::array<std::string_view, 7> kCross{"##    ##", " ##  ##", "  ####",  "   ##",
                                                 "  ####",   " ##  ##", "##    ##"};

void stamp(Painter& painter, int x, int y, const std::array<std::string_view, 7>& rows, std::uint8_t cell) {
  for (int j = 0; j < static_cast<int>(rows.size()); ++j)
    for (int i = 0; i < static_cast<int>(rows[j].size()); ++i)
      if (rows[j][i] == '#') painter.point(x + i, y + j, cell);
}

}  // namespace

void Painter::disc(int x, int y, int radius, std::uint8_t cell) {
  const int reach = (radius + 1) * thick() - 1;
  for (int j = -reach; j <= reach; ++j)
    for (int i = -reach; i <= reach; ++i)
      if (inDisc(i, j, radius, thick())) point(x + i, y + j, cell);
}

void Painter::ring(int x, int y, int radius, std::uint8_t cell) {
  const int reach = (radius + 1) * thick() - 1;
  for (int j = -reach; j <= reach; ++j)
    for (int i = -reach; i <= reach; ++i)
      if (inDisc(i, j, radius, thick()) && !inDisc(i, j, radius - 1, thick())) point(x + i, y + j, cell);
}

int Painter::text(int x, int baseline, std::string_view utf8, std::uint8_t cell, Voice voice) {
  const VoiceRow& how = kVoices[static_cast<int>(voice)];
  const int width = kGlyphWidth * how.scale, top = baseline - kGlyphAscent * how.scale;
  if (step_ == unit_)
    note({{{x, top, textWidth(utf8, voice), kGlyphHeight * how.scale}, std::string{utf8}, how.pitch}});
  for (char32_t letter : codesOf(utf8)) {
    if (how.capitals && letter >= 'a' && letter <= 'z') letter -= 'a' - 'A';
    const Glyph& glyph = *glyphOf(letter);
    DoubledGlyph rows{};
    if (how.scale == 2)
      rows = scale2x(glyph);
    else
      std::copy(glyph.begin(), glyph.end(), rows.begin());
    for (int j = 0; j < kGlyphHeight * how.scale; ++j)
      for (int i = 0; i < width; ++i)
        if (rows[j] >> (width - 1 - i) & 1) hline(x + i, top + j, how.bold ? 2 : 1, cell);
    x += how.pitch;
  }
  return x;
}

int Painter::textRight(int right, int baseline, std::string_view utf8, std::uint8_t cell, Voice voice) {
  const int x = right - textWidth(utf8, voice);
  text(x, baseline, utf8, cell, voice);
  return x;
}

void Painter::haloed(int x, int baseline, std::string_view utf8, std::uint8_t cell, std::uint8_t rim) {
  Painter below = *this;
  below.writing_ = nullptr;
  for (const int dx : {-1, 0, 1})
    for (const int dy : {-1, 0, 1}) below.text(x + dx, baseline + dy, utf8, rim);
  text(x, baseline, utf8, cell);
}

void Painter::tick(int x, int y, std::uint8_t cell) { stamp(*this, x, y, kTick, cell); }
void Painter::cross(int x, int y, std::uint8_t cell) { stamp(*this, x, y, kCross, cell); }

void Painter::triangle(int x, int y, int depth, Direction to, std::uint8_t cell) {
  for (int k = 0; k < depth; ++k) {  // k lines from the base, which is the longest
    const int length = 2 * (depth - k) - 1;
    switch (to) {
      case Direction::Left:
        vline(x + depth - 1 - k, y + k, length, cell);
        break;
      case Direction::Right:
        vline(x + k, y + k, length, cell);
        break;
      case Direction::Up:
        hline(x + k, y + depth - 1 - k, length, cell);
        break;
      case Direction::Down:
        hline(x + k, y + k, length, cell);
        break;
    }
  }
}

void Painter::keyBlank(const Rect& a, const KeyCapCells& cells) {
  fillRect({a.x + 1, a.y + 1, a.width - 2, a.height - 2}, cells.face);
  hline(a.x + 1, a.y, a.width - 2, cells.edge);
  vline(a.x, a.y + 1, a.height - 2, cells.edge);
  vline(a.x + a.width - 1, a.y + 1, a.height - 2, cells.edge);
  hline(a.x + 1, a.y + a.height - 1, a.width - 2, cells.shadow);
}

int Painter::keyCap(int x, int y, std::string_view name, const KeyCapCells& cells) {
  const int letters = textWidth(name), width = std::max(kKeyCap, letters + 8);
  keyBlank({x, y, width, kKeyCap}, cells);
  Painter letter = *this;
  letter.writing_ = nullptr;
  letter.text(x + (width - letters + 1) / 2, y + kKeyCapBaseline, name, cells.letter);
  note({{{x, y, width, kKeyCap}, std::string{name}}});
  return width;
}

int Painter::keyCap(int x, int y, Direction arrow, const KeyCapCells& cells) {
  constexpr int kDepth = 4, kBase = 2 * kDepth - 1;
  constexpr int kLeftOfLevel = (kKeyCap - kBase) / 2, kBefore = (kKeyCap - kDepth) / 2;
  // An odd number of pixels is left over. The extra one goes behind the arrow, so that opposite arrows are
  // mirror images.
  const bool level = arrow == Direction::Left || arrow == Direction::Right;
  const int ahead = kBefore + (arrow == Direction::Right || arrow == Direction::Down);
  constexpr std::array<std::string_view, 4> kNames{"left", "right", "up", "down"};
  keyBlank({x, y, kKeyCap, kKeyCap}, cells);
  note({{{x, y, kKeyCap, kKeyCap}, std::string{kNames[static_cast<std::size_t>(arrow)]}}});
  triangle(x + (level ? ahead : kLeftOfLevel), y + (level ? kLeftOfLevel : ahead), kDepth, arrow,
           cells.letter);
  return kKeyCap;
}

void drawFindingBox(Pen& pen, const Rect& at, int line, std::string_view bold, std::string_view why,
                    Cell bar) {
  pen.paint.fillRect(at, pen(Cell::White));
  pen.paint.fillRect({at.x, at.y, 3, at.height}, pen(bar));
  const int x = at.x + 13, room = at.width - 20;
  int y = at.y + line - 1;
  pen.bold(x, y, beginningOf(std::string{bold}, room));
  for (const std::string& words : broken(why, room / textWidth("m"))) {
    y += line;
    if (y + 2 > at.y + at.height) break;
    pen.ink(x, y, words);
  }
}

void drawFocus(Pen& pen, const Rect& row, int beyond) {
  pen.paint.fillRect({row.x - 2, row.y, row.width + 2 + beyond, row.height}, pen(Cell::Focus));
  pen.paint.fillRect({row.x - 6, row.y, 2, row.height}, pen(Cell::Ink));
}

}  // namespace xnewell
