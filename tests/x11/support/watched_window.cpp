#include "tests/x11/support/watched_window.h"

#include <X11/XKBlib.h>
#include <X11/Xproto.h>
#include <X11/Xutil.h>
#include <X11/keysym.h>

#include <X11/extensions/XTest.h>
#include <X11/extensions/record.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstring>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <thread>

#include "x11/visual/visual.h"

namespace xnewell {

bool comesTrue(const std::function<bool()>& holds) {
  using namespace std::chrono_literals;
  // The longer it takes, the more seldom we ask: asking costs time that the others may need.
  std::chrono::milliseconds waited{}, pause{3};
  for (const auto start = std::chrono::steady_clock::now(); !holds();) {
    if (waited > 90s) return false;
    std::this_thread::sleep_for(pause);
    waited = std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::steady_clock::now() - start);
    pause = std::clamp(waited / 10, 3ms, 50ms);
  }
  return true;
}

namespace {

/// A viewable window inside `within` that has our class and is not `other`; 0 if there is none. A window
/// manager puts windows into its own frames.
Window findWindow(Display* display, Window within, Window other) {
  const ErrorTrap trap{display};  // a window may go while we look
  Window root = 0, parent = 0, *children = nullptr;
  unsigned count = 0;
  if (!XQueryTree(display, within, &root, &parent, &children, &count)) return 0;
  const std::unique_ptr<Window[], int (*)(void*)> owned{children, XFree};
  for (unsigned i = 0; i < count; ++i) {
    XWindowAttributes attributes{};
    XClassHint hint{};
    if (children[i] == other || !XGetWindowAttributes(display, children[i], &attributes) ||
        attributes.map_state != IsViewable)
      continue;
    if (XGetClassHint(display, children[i], &hint)) {
      const bool ours = std::string_view{hint.res_class} == "Xnewell";
      XFree(hint.res_name);
      XFree(hint.res_class);
      if (ours) return children[i];
    }
    if (const Window inside = findWindow(display, children[i], other)) return inside;
  }
  return 0;
}

}  // namespace

WatchedWindow::WatchedWindow(const XServer& server, Window other, const std::function<bool()>& hoping)
    : display_{openDisplay(server.name())} {
  const Window root = DefaultRootWindow(display());
  if (!comesTrue([&] { return (id_ = findWindow(display(), root, other)) != 0 || !hoping(); }) || id_ == 0)
    throw std::runtime_error("the program shows no window");
  if (!comesTrue([&] { return !isDrawing(); })) throw std::runtime_error("the program draws no picture");
}

WatchedWindow WatchedWindow::early(const XServer& server) {
  WatchedWindow window{openDisplay(server.name())};
  Display* const display = window.display();
  if (!comesTrue([&] { return (window.id_ = findWindow(display, DefaultRootWindow(display), 0)) != 0; }))
    throw std::runtime_error("the program shows no window");
  return window;
}

std::string WatchedWindow::title() const {
  const ErrorTrap trap{display()};  // the window may go
  char* name = nullptr;
  if (!XFetchName(display(), id_, &name)) return {};
  const std::string title{name};
  XFree(name);
  return title;
}

Colormap WatchedWindow::colormap() const {
  XWindowAttributes attributes{};
  XGetWindowAttributes(display(), id_, &attributes);
  return attributes.colormap;
}

bool WatchedWindow::colormapInstalled() const {
  XWindowAttributes attributes{};
  XGetWindowAttributes(display(), id_, &attributes);
  return attributes.map_installed;
}

void WatchedWindow::type(std::string_view letters) const {
  for (const char letter : letters) {
    const auto symbol = static_cast<unsigned char>(letter);
    const KeyCode code = XKeysymToKeycode(display(), symbol);
    press(symbol, XkbKeycodeToKeysym(display(), code, 0, 0) != symbol);
  }
}

void WatchedWindow::press(KeySym symbol, bool shift) const {
  const KeyCode code = XKeysymToKeycode(display(), symbol),
                shiftCode = XKeysymToKeycode(display(), XK_Shift_L);
  if (shift) XTestFakeKeyEvent(display(), shiftCode, 1, CurrentTime);
  XTestFakeKeyEvent(display(), code, 1, CurrentTime);
  XTestFakeKeyEvent(display(), code, 0, CurrentTime);
  if (shift) XTestFakeKeyEvent(display(), shiftCode, 0, CurrentTime);
  XSync(display(), 0);
}

void WatchedWindow::hold(KeySym symbol, bool down) const {
  XTestFakeKeyEvent(display(), XKeysymToKeycode(display(), symbol), down, CurrentTime);
  XSync(display(), 0);
}

void WatchedWindow::moveTo(int x, int y) const {
  XTestFakeMotionEvent(display(), DefaultScreen(display()), x, y, CurrentTime);
  XSync(display(), 0);
}

void WatchedWindow::button(unsigned number, bool down) const {
  XTestFakeButtonEvent(display(), number, down, CurrentTime);
  XSync(display(), 0);
}

void WatchedWindow::resize(int width, int height) const {
  XResizeWindow(display(), id_, width, height);
  XSync(display(), 0);
}

void WatchedWindow::askToClose() const {
  XEvent event{};
  event.xclient = {.type = ClientMessage,
                   .serial = 0,
                   .send_event = 1,
                   .display = display(),
                   .window = id_,
                   .message_type = XInternAtom(display(), "WM_PROTOCOLS", 0),
                   .format = 32,
                   .data = {}};
  event.xclient.data.l[0] = static_cast<long>(XInternAtom(display(), "WM_DELETE_WINDOW", 0));
  XSendEvent(display(), id_, 0, 0, &event);
  XSync(display(), 0);
}

bool WatchedWindow::goes() const {
  const ErrorTrap trap{display()};
  XWindowAttributes attributes{};
  return comesTrue([&] { return XGetWindowAttributes(display(), id_, &attributes) == 0; });
}

RgbImage WatchedWindow::shown(const Rect& rect) const {
  XWindowAttributes attributes{};
  XGetWindowAttributes(display(), id_, &attributes);
  const OwnedImage got{
      XGetImage(display(), id_, rect.x, rect.y, rect.width, rect.height, AllPlanes, ZPixmap)};
  if (!got || got->bits_per_pixel != (attributes.depth == 8 ? 8 : 32))
    throw std::runtime_error("the window cannot be read");
  std::array<XColor, 256> cells{};
  const bool indexed = attributes.depth == 8;
  const bool direct = !indexed && attributes.visual->c_class == DirectColor;
  for (unsigned i = 0; i < cells.size(); ++i) cells[i].pixel = direct ? 0x010101 * i : i;
  if (indexed || direct)
    XQueryColors(display(), attributes.colormap, cells.data(), static_cast<int>(cells.size()));
  const ChannelMasks masks{attributes.visual->red_mask, attributes.visual->green_mask,
                           attributes.visual->blue_mask};
  RgbImage image{rect.width, rect.height};
  std::uint8_t* out = image.rgb.data();
  std::optional<std::uint32_t> last;
  std::array<std::uint8_t, 3> rgb{};
  for (int y = 0; y < rect.height; ++y) {
    const char* row = got->data + std::ptrdiff_t{y} * got->bytes_per_line;
    for (int x = 0; x < rect.width; ++x) {
      std::uint32_t pixel = static_cast<std::uint8_t>(row[x]);
      if (!indexed) std::memcpy(&pixel, row + 4 * x, 4);  // a local server has our byte order
      if (pixel != last) {
        const std::uint32_t r = indexed ? pixel : pixel >> 16 & 255, g = indexed ? pixel : pixel >> 8 & 255,
                            b = indexed ? pixel : pixel & 255;
        const Rgb16 c =
            indexed || direct ? Rgb16{cells[r].red, cells[g].green, cells[b].blue} : colorOf(pixel, masks);
        rgb = {static_cast<std::uint8_t>(c.r >> 8), static_cast<std::uint8_t>(c.g >> 8),
               static_cast<std::uint8_t>(c.b >> 8)};
        last = pixel;
      }
      out = std::ranges::copy(rgb, out).out;
    }
  }
  return image;
}

bool WatchedWindow::comesToShow(const RgbImage& expected, const Rect& rect) const {
  return comesTrue([&] { return shown(rect) == expected; });
}

bool WatchedWindow::comesToDiffer(const RgbImage& from, const Rect& rect) const {
  return comesTrue([&] { return shown(rect) != from; });
}

bool WatchedWindow::settles() const {
  XWindowAttributes attributes{};
  XGetWindowAttributes(display(), id_, &attributes);
  // The overlay is 560 wide and in the middle. Its leftmost column is ink, and empty paper lies to the right.
  const Rect edge{(attributes.width - 560) / 2, attributes.height / 2, 8, 8};
  const auto open = [&] {
    const RgbImage now = shown(edge);
    const auto isPaper = [&](int i, int j) {
      return std::ranges::equal(std::span{now.pixel(i, j), 3}, std::array<std::uint8_t, 3>{0xF5, 0xF2, 0xEB});
    };
    for (int j = 0; j < edge.height; ++j)
      for (int i = 0; i < edge.width; ++i)
        if (isPaper(i, j) != (i > 0)) return false;
    return true;
  };
  type("?");
  if (!comesTrue(open)) return false;
  type("?");
  return comesTrue([&] { return !open(); });
}

bool comesToShowNone(Display* display) {
  return comesTrue([&] { return findWindow(display, DefaultRootWindow(display), 0) == 0; });
}

RgbImage cropped(const RgbImage& image, const Rect& rect) {
  RgbImage part{rect.width, rect.height};
  for (int y = 0; y < rect.height; ++y)
    std::copy_n(image.pixel(rect.x, rect.y + y), 3 * rect.width, part.pixel(0, y));
  return part;
}

RequestRecord::RequestRecord(const XServer& server, Window resource)
    : control_{openDisplay(server.name())}, data_{openDisplay(server.name())} {
  int major = 0, minor = 0;
  if (!XRecordQueryVersion(control_.get(), &major, &minor))
    throw std::runtime_error("the tests need an X server with the RECORD extension");
  int event = 0, error = 0;
  XQueryExtension(control_.get(), "XKEYBOARD", &keyboard_, &event, &error);
  const std::unique_ptr<XRecordRange, int (*)(void*)> range{XRecordAllocRange(), XFree};
  range->core_requests = {X_CreateWindow, X_NoOperation};
  range->ext_requests = {{128, 255}, {0, 65535}};
  XRecordClientSpec client = resource;
  XRecordRange* ranges = range.get();
  context_ = XRecordCreateContext(control_.get(), 0, &client, 1, &ranges, 1);
  XSync(control_.get(), 0);
  const auto take = [](XPointer self, XRecordInterceptData* seen) {
    if (seen->category == XRecordFromClient && seen->data_len > 0)
      reinterpret_cast<RequestRecord*>(self)->opcodes_.push_back(seen->data[0]);
    XRecordFreeData(seen);
  };
  if (!XRecordEnableContextAsync(data_.get(), context_, take, reinterpret_cast<XPointer>(this)))
    throw std::runtime_error("the server does not record");
}

RequestRecord::~RequestRecord() {
  XRecordDisableContext(control_.get(), context_);
  static_cast<void>(opcodes());  // reads to the end of the data, so that Xlib no longer waits for it
  XRecordFreeContext(control_.get(), context_);
  XSync(control_.get(), 0);
}

const std::vector<int>& RequestRecord::opcodes() {
  XSync(control_.get(), 0);  // the server hands out what it has recorded
  XRecordProcessReplies(data_.get());
  return opcodes_;
}

void RequestRecord::forget() {
  static_cast<void>(opcodes());
  opcodes_.clear();
}

std::ptrdiff_t RequestRecord::count(int opcode) { return std::ranges::count(opcodes(), opcode); }

bool RequestRecord::isDrawing(int opcode) const {
  return (opcode >= X_ClearArea && opcode <= X_ImageText16) || (opcode >= 128 && opcode != keyboard_);
}

std::ptrdiff_t RequestRecord::drawing() {
  return std::ranges::count_if(opcodes(), [this](int opcode) { return isDrawing(opcode); });
}

}  // namespace xnewell
