#include "x11/server/canvas.h"

#include <X11/Xatom.h>
#include <X11/Xutil.h>
#include <sys/ipc.h>
#include <sys/shm.h>
#include <sys/socket.h>

#include <bit>
#include <cassert>
#include <cstdint>
#include <cstring>
#include <memory>
#include <new>

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

namespace {

/// True if the server runs on this machine. A forwarded connection may offer MIT-SHM but mean the memory of
/// another machine.
bool isLocal(Display* display) {
  sockaddr_storage address{};
  socklen_t length = sizeof address;
  return getsockname(ConnectionNumber(display), reinterpret_cast<sockaddr*>(&address), &length) == 0 &&
         address.ss_family == AF_UNIX;
}

/// Pictures consist of runs, so eight equal indices are looked up once.
void expandRow(const std::uint8_t* in, int count, const std::array<std::uint32_t, 256>& pixels,
               std::uint32_t* out) {
  int i = 0;
  for (; i + 8 <= count; i += 8) {
    std::uint64_t eight = 0;
    std::memcpy(&eight, in + i, 8);
    if (eight == std::uint64_t{in[i]} * 0x0101010101010101u) {
      const std::uint32_t pixel = pixels[in[i]];
      for (int k = 0; k < 8; ++k) out[i + k] = pixel;
    } else {
      for (int k = 0; k < 8; ++k) out[i + k] = pixels[in[i + k]];
    }
  }
  for (; i < count; ++i) out[i] = pixels[in[i]];
}

}  // namespace

void writePixels(XImage& out, const IndexImage& image, const Rect& rect, const PixelTable& table) {
  assert(intersection(rect, {0, 0, image.width, image.height}) == rect);
  assert(intersection(rect, {0, 0, out.width, out.height}) == rect);
  const auto rowOf = [&](int y, int bytesPerPixel) {
    return out.data + std::size_t(y) * out.bytes_per_line + std::size_t(rect.x) * bytesPerPixel;
  };
  const bool nativeOrder =
      out.byte_order == (std::endian::native == std::endian::little ? LSBFirst : MSBFirst);
  const bool bytes = out.bits_per_pixel == 8, words = out.bits_per_pixel == 32 && nativeOrder;
  if (table.dithers() || !(bytes || words)) {
    for (int y = rect.y; y < rect.y + rect.height; ++y) {
      std::array<const unsigned long*, 8> pixels;
      for (int x = 0; x < 8; ++x)
        pixels[x] = table.dithers() ? table.at(placeInTile(x, y)).data() : table.pixels().data();
      const std::uint8_t* in = image.row(y);
      const auto eachPixel = [&](auto&& write) {
        for (int x = rect.x; x < rect.x + rect.width; ++x) write(x, pixels[x & 7][in[x]]);
      };
      if (bytes)
        eachPixel([to = rowOf(y, 1) - rect.x](int x, unsigned long p) { to[x] = static_cast<char>(p); });
      else if (words)
        eachPixel([to = reinterpret_cast<std::uint32_t*>(rowOf(y, 4)) - rect.x](int x, unsigned long p) {
          to[x] = static_cast<std::uint32_t>(p);
        });
      else
        eachPixel([&](int x, unsigned long p) { XPutPixel(&out, x, y, p); });
    }
  } else if (bytes) {
    std::array<std::uint8_t, 256> pixels;
    bool identity = true;
    for (int i = 0; i < 256; ++i) identity &= (pixels[i] = static_cast<std::uint8_t>(table.pixels()[i])) == i;
    for (int y = rect.y; y < rect.y + rect.height; ++y) {
      const std::uint8_t* in = image.row(y) + rect.x;
      char* to = rowOf(y, 1);
      if (identity)
        std::memcpy(to, in, rect.width);
      else
        for (int x = 0; x < rect.width; ++x) to[x] = static_cast<char>(pixels[in[x]]);
    }
  } else {
    std::array<std::uint32_t, 256> pixels;
    for (int i = 0; i < 256; ++i) pixels[i] = static_cast<std::uint32_t>(table.pixels()[i]);
    for (int y = rect.y; y < rect.y + rect.height; ++y)
      expandRow(image.row(y) + rect.x, rect.width, pixels, reinterpret_cast<std::uint32_t*>(rowOf(y, 4)));
  }
}

void TransferImage::ImageDeleter::operator()(XImage* image) const {
  image->data = nullptr;  // the memory is ours and was not allocated by malloc
  XDestroyImage(image);
}

TransferImage::TransferImage(Display* display, Visual* visual, int depth, int width, int height, bool wantShm)
    : display_{display} {
  if (wantShm && isLocal(display) && XShmQueryExtension(display) && share(visual, depth, width, height))
    return;
  image_.reset(XCreateImage(display, visual, depth, ZPixmap, 0, nullptr, width, height, 32, 0));
  if (!image_)
    throw X11Error("no memory for a picture of " + std::to_string(width) + " x " + std::to_string(height));
  own_.reset(new (std::nothrow) std::byte[std::size_t(image_->bytes_per_line) * height]);
  if (!own_)
    throw X11Error("no memory for a picture of " + std::to_string(width) + " x " + std::to_string(height));
  image_->data = reinterpret_cast<char*>(own_.get());
}

TransferImage::~TransferImage() {
  if (!shared()) return;
  XShmDetach(display_, &segment_);
  shmdt(segment_.shmaddr);
}

bool TransferImage::share(Visual* visual, int depth, int width, int height) {
  XShmSegmentInfo segment{};
  std::unique_ptr<XImage, ImageDeleter> image{
      XShmCreateImage(display_, visual, depth, ZPixmap, nullptr, &segment, width, height)};
  if (!image) return false;
  segment.shmid = shmget(IPC_PRIVATE, std::size_t(image->bytes_per_line) * height, IPC_CREAT | 0600);
  if (segment.shmid < 0) return false;
  void* memory = shmat(segment.shmid, nullptr, 0);
  // The segment is marked for removal now. So it disappears with its last user, however we end, even while we
  // wait for the server. Linux still lets the server attach it. On a system that does not, pictures are sent
  // through the connection.
  shmctl(segment.shmid, IPC_RMID, nullptr);
  bool attached = reinterpret_cast<std::intptr_t>(memory) != -1;
  if (attached) {
    segment.shmaddr = image->data = static_cast<char*>(memory);
    ErrorTrap trap{display_};
    try {
      XShmAttach(display_, &segment);
      trap.check();
    } catch (const X11Error&) {
      attached = false;
      shmdt(memory);
    }
  }
  if (!attached) return false;
  segment_ = segment;
  image_ = std::move(image);
  image_->obdata = reinterpret_cast<XPointer>(&segment_);  // XShmPutImage looks for the segment there
  return true;
}

void TransferImage::put(Drawable target, GC gc, const IndexImage& image, const Rect& rect,
                        const PixelTable& table) {
  if (shared() && lastPut_ > LastKnownRequestProcessed(display_)) XSync(display_, 0);
  writePixels(*image_, image, rect, table);
  if (shared()) {
    lastPut_ = NextRequest(display_);
    XShmPutImage(display_, target, gc, image_.get(), rect.x, rect.y, rect.x, rect.y, rect.width, rect.height,
                 0);
  } else {  // Xlib divides this into requests of a size that the server accepts
    XPutImage(display_, target, gc, image_.get(), rect.x, rect.y, rect.x, rect.y, rect.width, rect.height);
  }
}

}  // namespace xnewell
