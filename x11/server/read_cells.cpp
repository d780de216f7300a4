#include "x11/server/read_cells.h"

#include <X11/Xutil.h>

#include <cassert>
#include <unordered_map>

#include "shading/color/color_plan.h"
#include "shading/color/png.h"

namespace xnewell {

std::optional<ColoredImage> readCells(const Canvas& canvas, const ServerColormap& colormap,
                                      const IndexImage& sent) {
  assert(sent.width == canvas.width() && sent.height == canvas.height());
  const OwnedImage got = canvas.pixels({0, 0, sent.width, sent.height});
  const std::array<unsigned long, 256>& pixels = colormap.pixels();
  std::unordered_map<unsigned long, std::uint8_t> cellOf;
  for (int cell = 0; cell < 256; ++cell) cellOf.try_emplace(pixels[cell], static_cast<std::uint8_t>(cell));
  ColoredImage cells{sent, colormap.shown()};
  for (int j = 0; j < sent.height; ++j)
    for (int i = 0; i < sent.width; ++i) {
      const unsigned long pixel = XGetPixel(got.get(), i, j);
      std::uint8_t& cell = cells.image.row(j)[i];
      if (pixels[cell] == pixel) continue;
      const auto known = cellOf.find(pixel);
      if (known == cellOf.end()) return std::nullopt;
      cell = known->second;
    }
  return cells;
}

std::string pngOf(const Canvas& canvas, const ServerColormap& colormap, const IndexImage& sent,
                  const std::string& note) {
  if (const auto cells = readCells(canvas, colormap, sent))
    return encodePng(cells->image, cells->palette, note);
  const RgbImage seen = canvas.readBack({0, 0, sent.width, sent.height});
  if (const auto cells = inFewColors(seen)) return encodePng(cells->image, cells->palette, note);
  return encodePng(seen, note);
}

}  // namespace xnewell
