#include "x11/colormap.h"

#include <X11/Xutil.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <vector>

namespace {

constexpr int kCellCount = 256;

::Visual* findVisual(::Display* display, unsigned long id) {
  ::XVisualInfo wanted{};
  wanted.visualid = id;
  int count = 0;
  const std::unique_ptr<::XVisualInfo, int (*)(void*)> found{
      XGetVisualInfo(display, VisualIDMask, &wanted, &count), XFree};
  if (count == 0) throw X11Error("the X server has no such visual any more");
  return found->visual;
}

Palette readCells(::Display* display, ::Colormap map) {
  std::array<XColor, kCellCount> cells{};
  for (int i = 0; i < kCellCount; ++i) cells[i].pixel = i;
  XQueryColors(display, map, cells.data(), kCellCount);
  // Xlib keeps a BadAlloc here to itself; but where it has an answer, it says which parts are in it.
  if (cells[0].flags == 0) throw X11Error("X_QueryColors: the X server does not tell its colours");
  Palette palette;
  std::transform(cells.begin(), cells.end(), palette.begin(), [](const XColor& c) {
    return Rgb16{c.red, c.green, c.blue};
  });
  return palette;
}

}  // namespace

ServerColormap::ServerColormap(::Display* display, const VisualChoice& choice)
    : display_{display},
      screen_{DefaultScreen(display)},
      visual_{choice.visual},
      xVisual_{findVisual(display, choice.visual.id)},
      opaque_{visual_.alphaMask()} {
  ErrorTrap trap{display};
  if (real() || xVisual_ != DefaultVisual(display, screen_)) {
    OwnedColormap made{display, XCreateColormap(display, RootWindow(display, screen_), xVisual_,
                                                real() ? AllocAll : AllocNone)};
    trap.check();
    own_ = std::move(made);
  }
  if (real()) {
    std::iota(pixels_.begin(), pixels_.end(), 0ul);
    if (DefaultDepth(display, screen_) == 8)
      unneeded_ = readCells(display, DefaultColormap(display, screen_));
  }
  store(unneeded_);
  trap.check();
}

CellPlan ServerColormap::plan(TableKind table) const {
  if (!real() || DefaultDepth(display_, screen_) != 8) return CellPlan{table};
  return CellPlan{table, static_cast<int>(BlackPixel(display_, screen_)),
                  static_cast<int>(WhitePixel(display_, screen_))};
}

bool ServerColormap::store(const Palette& palette) {
  if (stored_ == palette) return false;
  if (real()) {
    std::vector<XColor> changed;
    for (int i = 0; i < kCellCount; ++i) {
      const Rgb16 c = palette[i];
      if (stored_ && (*stored_)[i] == c) continue;
      changed.push_back({.pixel = static_cast<unsigned long>(i),
                         .red = c.r,
                         .green = c.g,
                         .blue = c.b,
                         .flags = DoRed | DoGreen | DoBlue,
                         .pad = 0});
    }
    XStoreColors(display_, id(), changed.data(), static_cast<int>(changed.size()));
  } else {
    std::transform(palette.begin(), palette.end(), pixels_.begin(),
                   [&](Rgb16 c) { return pixelOf(c, visual_.masks) | opaque_; });
  }
  stored_ = palette;
  return !real();
}

Palette ServerColormap::shown() const {
  if (real()) return readCells(display_, id());
  Palette palette;
  std::transform(pixels_.begin(), pixels_.end(), palette.begin(),
                 [&](unsigned long pixel) { return colorOf(pixel, visual_.masks); });
  return palette;
}

bool ServerColormap::installed() const {
  int count = 0;
  const std::unique_ptr<::Colormap[], int (*)(void*)> maps{
      XListInstalledColormaps(display_, RootWindow(display_, screen_), &count), XFree};
  return std::find(maps.get(), maps.get() + count, id()) != maps.get() + count;
}

void ServerColormap::installUnlessManaged() {
  if (own_.get() && !windowManagerRuns(display_)) XInstallColormap(display_, id());
}

bool windowManagerRuns(::Display* display) {
  XWindowAttributes root{};
  XGetWindowAttributes(display, DefaultRootWindow(display), &root);
  return (root.all_event_masks & SubstructureRedirectMask) != 0;
}
