#pragma once

#include <algorithm>
#include <glm/vec2.hpp>
#include <string_view>
#include <vector>

#include "shading/color/font.h"
#include "shading/color/images.h"
#include "x11/drawing/painter.h"

namespace xnewell {

/// Where a text stands in an image, in a cell, in letters of so many pixels a unit: the upper left corners of
/// its letters' boxes. Inside the box of the text nothing else may have the cell.
inline std::vector<glm::ivec2> findText(const IndexImage& image, std::string_view text, std::uint8_t cell,
                                        int unit = 1, Voice voice = Voice::Plain) {
  IndexImage model{unit * textWidth(text), unit * kGlyphHeight, 0};
  Painter{model, unit}.text(0, kGlyphAscent, text, 1, voice);
  const auto first = std::ranges::find(model.pixels, 1) - model.pixels.begin();
  const int i0 = static_cast<int>(first) % model.width, j0 = static_cast<int>(first) / model.width;
  std::vector<glm::ivec2> found;
  for (int y = 0; y + model.height <= image.height; ++y)
    for (int x = 0; x + model.width <= image.width; ++x) {
      bool same = image.row(y + j0)[x + i0] == cell;
      for (int j = 0; j < model.height && same; ++j)
        for (int i = 0; i < model.width && same; ++i)
          same = (model.row(j)[i] == 1) == (image.row(y + j)[x + i] == cell);
      if (same) found.emplace_back(x, y);
    }
  return found;
}

}  // namespace xnewell
