#include "x11/server/canvas.h"

#include <X11/Xatom.h>
#include <X11/Xutil.h>

#include <cassert>
#include <memory>

namespace xnewell {

namespace {

constexpr long kEvents = ExposureMask | KeyPressMask | KeyReleaseMask | ButtonPressMask | ButtonReleaseMask |
                         PointerMotionMask | StructureNotifyMask | EnterWindowMask | LeaveWindowMask |
                         FocusChangeMask | ColormapChangeMask;

/// Border pixel and colormap are always given: a window that inherits them causes BadMatch if its depth or
/// visual differs from the root's. The window has no background: the picture covers all of it, and a
/// background painted first by the server would flash.
Window createWindow(Display* display, const ServerColormap& colormap, const Canvas::Settings& settings) {
  XSetWindowAttributes attributes{};
  attributes.background_pixmap = 0;
  attributes.border_pixel = colormap.pixel(0);
  attributes.bit_gravity = NorthWestGravity;
  attributes.colormap = colormap.id();
  attributes.event_mask = kEvents;
  return XCreateWindow(display, DefaultRootWindow(display), 0, 0, settings.width, settings.height, 0,
                       colormap.visual().depth, InputOutput, colormap.xVisual(),
                       CWBackPixmap | CWBorderPixel | CWBitGravity | CWColormap | CWEventMask, &attributes);
}

void tellWindowManager(Display* display, Window window, const Canvas::Settings& settings) {
  XSizeHints sizes{};
  sizes.flags = PSize | PMinSize;
  sizes.width = settings.width;
  sizes.height = settings.height;
  sizes.min_width = settings.minWidth;
  sizes.min_height = settings.minHeight;
  XWMHints hints{};
  hints.flags = InputHint | StateHint;
  hints.input = 1;
  hints.initial_state = NormalState;
  std::string name = "xnewell", group = "Xnewell";
  XClassHint classHint{name.data(), group.data()};
  Xutf8SetWMProperties(display, window, nullptr, nullptr, nullptr, 0, &sizes, &hints, &classHint);
}

}  // namespace

Canvas::Canvas(Display* display, const ServerColormap& colormap, const Settings& settings)
    : display_{display}, colormap_{colormap}, wantShm_{settings.sharedMemory} {
  ErrorTrap trap{display};
  OwnedWindow made{display, createWindow(display, colormap, settings)};
  trap.check();
  window_ = std::move(made);
  tellsItsEnd(window());
  tellWindowManager(display, window(), settings);
  netName_ = XInternAtom(display, "_NET_WM_NAME", 0);
  utf8_ = XInternAtom(display, "UTF8_STRING", 0);
  entitle(settings.title);
  deleteWindow_ = XInternAtom(display, "WM_DELETE_WINDOW", 0);
  protocols_ = XInternAtom(display, "WM_PROTOCOLS", 0);
  XSetWMProtocols(display, window(), &deleteWindow_, 1);
  if (colormap.id() != DefaultColormap(display, DefaultScreen(display))) {
    Window self = window();
    XSetWMColormapWindows(display, self, &self, 1);
  }
  XGCValues values{};
  values.graphics_exposures = 0;  // without this, the server would answer each copy below with an event
  gc_ = {display, XCreateGC(display, window(), GCGraphicsExposures, &values)};
  trap.check();
  resize(settings.width, settings.height);
}

void Canvas::entitle(const std::string& title) const {
  Xutf8SetWMProperties(display_, window(), title.c_str(), title.c_str(), nullptr, 0, nullptr, nullptr,
                       nullptr);
  XChangeProperty(display_, window(), netName_, utf8_, 8, PropModeReplace,
                  reinterpret_cast<const unsigned char*>(title.data()), static_cast<int>(title.size()));
}

bool Canvas::isCloseRequest(const XEvent& event) const {
  return event.type == ClientMessage && event.xclient.window == window() && event.xclient.format == 32 &&
         event.xclient.message_type == protocols_ &&
         static_cast<Atom>(event.xclient.data.l[0]) == deleteWindow_;
}

void Canvas::upload(const IndexImage& image, const Rect& dirty) {
  const Rect part = intersection(intersection(dirty, size_), {0, 0, image.width, image.height});
  if (!part.empty()) transfer_->put(drawable(), gc(), image, part, colormap_.table());
}

void Canvas::present(const IndexImage& image, const Rect& dirty) {
  upload(image, dirty);
  expose(dirty);
}

void Canvas::expose(const Rect& rect) {
  const Rect part = intersection(rect, size_);
  if (part.empty()) return;
  XCopyArea(display_, drawable(), window(), gc(), part.x, part.y, part.width, part.height, part.x, part.y);
  XFlush(display_);
}

void Canvas::resize(int width, int height) {
  assert(width >= 1 && height >= 1);
  const Rect size{0, 0, width, height};
  if (size == size_) return;
  const VisualInfo& visual = colormap_.visual();
  ErrorTrap trap{display_};
  OwnedPixmap picture{display_, XCreatePixmap(display_, window(), width, height, visual.depth)};
  setFill(0);
  XFillRectangle(display_, picture.get(), gc(), 0, 0, width, height);
  if (const Rect kept = intersection(size, size_); !kept.empty())
    XCopyArea(display_, drawable(), picture.get(), gc(), 0, 0, kept.width, kept.height, 0, 0);
  trap.check();
  auto transfer =
      std::make_unique<TransferImage>(display_, colormap_.xVisual(), visual.depth, width, height, wantShm_);
  size_ = size;
  picture_ = std::move(picture);
  transfer_ = std::move(transfer);
}

void Canvas::setFill(std::uint8_t index) {
  if (colormap_.table().solid(index)) {
    XSetFillStyle(display_, gc(), FillSolid);
    XSetForeground(display_, gc(), colormap_.pixel(index));
    return;
  }
  const Tile pixels = colormap_.table().tile(index);
  ServerTile& tile = tiles_[index];
  if (tile.pixmap.get() == 0 || tile.pixels != pixels) {
    constexpr int kSide = 8;
    TransferImage transfer{display_,         colormap_.xVisual(), colormap_.visual().depth, kSide, kSide,
                           /*wantShm=*/false};
    tile = {pixels, {display_, XCreatePixmap(display_, window(), kSide, kSide, colormap_.visual().depth)}};
    const OwnedGC whole{display_,
                        XCreateGC(display_, tile.pixmap.get(), 0, nullptr)};  // a context of its own, because
                                                                              // gc() may be clipped
    transfer.put(tile.pixmap.get(), whole.get(), IndexImage{kSide, kSide, index}, {0, 0, kSide, kSide},
                 colormap_.table());
  }
  XSetTile(display_, gc(), tile.pixmap.get());
  XSetFillStyle(display_, gc(), FillTiled);
}

OwnedImage Canvas::pixels(const Rect& rect) const {
  assert(!rect.empty() && intersection(rect, size_) == rect);
  ErrorTrap trap{display_};
  OwnedImage got{
      XGetImage(display_, drawable(), rect.x, rect.y, rect.width, rect.height, AllPlanes, ZPixmap)};
  trap.check();
  if (!got) throw X11Error("the X server did not return the picture");
  return got;
}

RgbImage Canvas::readBack(const Rect& rect) const {
  const OwnedImage got = pixels(rect);
  const PixelColors colors{display_, colormap_.id(), colormap_.visual()};
  RgbImage image{rect.width, rect.height};
  std::uint8_t* out = image.rgb.data();
  for (int y = 0; y < rect.height; ++y)
    for (int x = 0; x < rect.width; ++x) {
      const Rgb16 c = colors(XGetPixel(got.get(), x, y));
      for (const std::uint16_t v : {c.r, c.g, c.b}) *out++ = static_cast<std::uint8_t>(v >> 8);
    }
  return image;
}

}  // namespace xnewell
