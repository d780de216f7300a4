#include "x11/server/read_visuals.h"

#include <X11/Xutil.h>

#include <algorithm>
#include <bit>
#include <memory>
#include <string>

namespace xnewell {

ServerVisuals readVisuals(Display* display, bool countsCells) {
  const int screen = DefaultScreen(display);
  ServerVisuals server;
  server.display = DisplayString(display);
  server.vendor = std::string{ServerVendor(display)} + " " + std::to_string(VendorRelease(display));
  server.defaultId = XVisualIDFromVisual(DefaultVisual(display, screen));
  server.black = BlackPixel(display, screen);
  server.white = WhitePixel(display, screen);
  XVisualInfo wanted{};
  wanted.screen = screen;
  int count = 0;
  const std::unique_ptr<XVisualInfo[], int (*)(void*)> found{
      XGetVisualInfo(display, VisualScreenMask, &wanted, &count), XFree};
  for (int i = 0; i < count; ++i) {
    const XVisualInfo& v = found[i];
    server.visuals.push_back({.kind = static_cast<VisualClass>(v.c_class),
                              .depth = v.depth,
                              .id = v.visualid,
                              .masks = {v.red_mask, v.green_mask, v.blue_mask},
                              .bitsPerRgb = v.bits_per_rgb,
                              .cells = v.colormap_size});
  }
  if (const VisualInfo& v = server.defaultVisual(); countsCells && v.writable()) {
    const Colormap map = DefaultColormap(display, screen);
    const ServerGrab grab{display};
    std::vector<unsigned long> taken = takeCells(display, map, v.cells);
    server.freeCells = static_cast<int>(taken.size());
    XFreeColors(display, map, taken.data(), static_cast<int>(taken.size()), 0);
  }
  return server;
}

std::vector<unsigned long> takeCells(Display* display, unsigned long map, int most) {
  ErrorTrap trap{display};
  std::vector<unsigned long> taken(std::max(most, 0));
  int count = 0;
  for (int step = std::bit_floor(static_cast<unsigned>(std::max(most, 1))); step > 0; step /= 2)
    while (count + step <= most && XAllocColorCells(display, map, 0, nullptr, 0, &taken[count], step))
      count += step;
  taken.resize(count);
  return taken;
}

}  // namespace xnewell
