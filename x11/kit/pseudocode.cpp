#include "x11/kit/pseudocode.h"

namespace xnewell {

void drawPseudocode(Pen& pen, const Rect& at, int line, std::string_view source,
                    std::span<const CodeLine> lines) {
  pen.caps(at.x, at.y + 11, "the book's lines");
  const int heading = textWidth("the book's lines", Voice::Caps) + 12;
  if (heading + textWidth(source) <= at.width) pen.softRight(at.x + at.width, at.y + 11, source);
  pen.rule(at.x, at.y + 16, at.width);
  int y = at.y + 18 + line;
  for (const CodeLine& one : lines) {
    if (y > at.y + at.height) break;
    const bool now = one.ran == CodeLine::Ran::Now;
    if (now) drawFocus(pen, {at.x + 4, y - line + 4, at.width - 4, line});
    if (one.ran == CodeLine::Ran::Before) pen.paint.disc(at.x + 2, y - 4, 2, pen(Cell::Soft));
    const int left = at.x + 10, room = at.width - 10;
    const std::string_view beside = one.values.empty() && one.ours ? "ours" : std::string_view{one.values};
    const bool hasRoom = textWidth(one.text) + 8 + textWidth(beside) <= room;
    const Cell cell = one.ours ? Cell::Good : one.ran == CodeLine::Ran::Never ? Cell::Soft : Cell::Ink;
    pen.paint.text(left, y, beginningOf(one.text, room), pen(cell), now ? Voice::Bold : Voice::Plain);
    if (hasRoom)
      pen.paint.textRight(at.x + at.width, y, beside, pen(one.values.empty() ? Cell::Good : Cell::Ink),
                          one.values.empty() ? Voice::Plain : Voice::Bold);
    y += line;
  }
}

}  // namespace xnewell
