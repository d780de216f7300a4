#include "x11/drawing/pen.h"

#include <algorithm>
#include <cmath>

#include "x11/drawing/wording.h"

namespace xnewell {

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
