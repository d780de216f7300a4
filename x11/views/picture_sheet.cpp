#include "x11/views/picture_sheet.h"

namespace xnewell {

PictureSheet::PictureSheet(Picture& picture, const ViewSettings& settings, int strip)
    : sheet{settings.picture.width, settings.picture.height, settings.cells},
      width_{settings.picture.width - 2 * Sheet::kMargin} {
  column = (width_ - Sheet::kGutter) / 2;
  right = left + width_ - column;
  at = {left, Sheet::kMargin, width_, settings.picture.height - strip - 2 * Sheet::kMargin - Sheet::kGutter};
  top_ = at.y + at.height + Sheet::kGutter;
  PictureSettings smaller = settings.picture;
  smaller.width = at.width, smaller.height = at.height;
  picture.make(smaller);
  IndexImage painted;  // a plan of colours chooses its colours when it is painted
  picture.paint(painted, settings.cells[Cell::Well]);
}

}  // namespace xnewell
