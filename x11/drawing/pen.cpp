#include "x11/drawing/pen.h"

#include <algorithm>
#include <cmath>

namespace xnewell {

void drawFocus(Pen& pen, const Rect& row, int beyond) {
  pen.paint.fillRect({row.x - 2, row.y, row.width + 2 + beyond, row.height}, pen(Cell::Focus));
  pen.paint.fillRect({row.x - 6, row.y, 2, row.height}, pen(Cell::Ink));
}

}  // namespace xnewell
