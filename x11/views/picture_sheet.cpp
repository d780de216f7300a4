#include "x11/views/picture_sheet.h"

namespace xnewell {

namespace {

Rect pictureAbove(const ViewSettings& settings, int strip) {
  return {Sheet::kMargin, Sheet::kMargin, settings.picture.width - 2 * Sheet::kMargin,
          settings.picture.height - strip - 2 * Sheet::kMargin - Sheet::kGutter};
}

}  // namespace

PictureSheet::PictureSheet(const ViewSettings& settings, int strip)
    : at{pictureAbove(settings, strip)},
      sheet{settings.picture.width, settings.picture.height, settings.cells},
      width_{at.width} {
  column = (width_ - Sheet::kGutter) / 2;
  right = left + width_ - column;
  top_ = at.y + at.height + Sheet::kGutter;
}

PictureSettings PictureSheet::picture(const ViewSettings& settings, int strip) {
  const Rect at = pictureAbove(settings, strip);
  PictureSettings smaller = settings.picture;
  smaller.width = at.width, smaller.height = at.height;
  return smaller;
}

}  // namespace xnewell
