#pragma once

#include "shading/picture/picture.h"

namespace xnewell {

/// The settings of a picture that is quickly made.
inline PictureSettings small() {
  PictureSettings s;
  s.width = 240;
  s.height = 180;
  return s;
}

}  // namespace xnewell
