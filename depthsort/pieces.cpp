#include "depthsort/pieces.h"

#include <algorithm>

namespace xnewell {

void enterPiece(SortedScene& sorted, const PieceOf& of, const Region& region, const ScreenBox& box,
                const PixelArea& area) {
  Piece piece{of.face, static_cast<int>(sorted.cuts.size()), 0, area, of.parent};
  for (const Side& side : region)
    if (side.line.kind == Line::Kind::Cut) {
      sorted.cuts.push_back({side.line.p, side.line.q});
      ++piece.cuts;
    }
  piece.area.top = std::max(area.top, box.y0 >> kGridBits);
  piece.area.bottom = std::max(piece.area.top, std::min(area.bottom, (box.y1 >> kGridBits) + 1));
  sorted.pieces.push_back(piece);
}

}  // namespace xnewell
