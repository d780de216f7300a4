#include "depthsort/pieces.h"

#include <algorithm>

namespace xnewell {

void enterPiece(SortedScene& sorted, const PieceOf& of, const Region& region, const ScreenBox& box,
                int height) {
  Piece piece{of.face, static_cast<int>(sorted.cuts.size()), 0, 0, 0, of.parent};
  for (const Side& side : region)
    if (side.line.kind == Line::Kind::Cut) {
      sorted.cuts.push_back({side.line.p, side.line.q});
      ++piece.cuts;
    }
  piece.firstRow = std::max(0, box.y0 >> kGridBits);
  piece.rows = std::max(0, std::min(height, (box.y1 >> kGridBits) + 1) - piece.firstRow);
  sorted.pieces.push_back(piece);
}

}  // namespace xnewell
