#include "depthsort/pieces.h"

#include <algorithm>

namespace xnewell {

PixelArea rowsOf(const ScreenBox& box, const PixelArea& area, bool inPixels) {
  if (inPixels) return area;
  const int top = std::max(area.top, box.y0 >> kGridBits);
  return {area.left, top, area.right, std::max(top, std::min(area.bottom, (box.y1 >> kGridBits) + 1))};
}

void enterPiece(SortedScene& sorted, const PieceOf& of, const Region& region, const PixelArea& area) {
  Piece piece{of.face, static_cast<int>(sorted.cuts.size()), 0, area, of.parent};
  for (const Side& side : region)
    if (side.line.kind == Line::Kind::Cut) {
      sorted.cuts.push_back({side.line.p, side.line.q});
      ++piece.cuts;
    }
  sorted.pieces.push_back(piece);
}

}  // namespace xnewell
