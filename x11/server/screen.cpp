#include "x11/server/screen.h"

#include <X11/Xatom.h>
#include <X11/Xresource.h>
#include <X11/Xutil.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace xnewell {

namespace {

struct PropertyFree {
  void operator()(unsigned char* data) const { XFree(data); }
};

/// A property of a window: its values, of 8 or 32 bits; nothing if it has none of this type.
template <class Value>
std::vector<Value> property(Display* display, Window window, Atom name, Atom type) {
  constexpr long kMost = 1L << 20;  // words of 32 bits
  const ErrorTrap gone{display};    // the window may be that of a window manager that has ended
  Atom got = 0;
  int bits = 0;
  unsigned long count = 0, rest = 0;
  unsigned char* data = nullptr;
  XGetWindowProperty(display, window, name, 0, kMost, 0, type, &got, &bits, &count, &rest, &data);
  const std::unique_ptr<unsigned char, PropertyFree> owned{data};
  if (!data || got != type || bits != (sizeof(Value) == 1 ? 8 : 32)) return {};
  const auto* const values = reinterpret_cast<const Value*>(data);  // Xlib stores 32 bits as longs
  return {values, values + count};
}

std::vector<Atom> atoms(Display* display, Window window, const char* name) {
  return property<Atom>(display, window, XInternAtom(display, name, 0), XA_ATOM);
}

bool has(const std::vector<Atom>& all, Atom one) { return std::ranges::find(all, one) != all.end(); }

}  // namespace

std::string readResources(Display* display) {
  const std::vector<char> text =
      property<char>(display, DefaultRootWindow(display), XA_RESOURCE_MANAGER, XA_STRING);
  return {text.begin(), text.end()};
}

int scaleFor(const std::string& resources, glm::ivec2 pixels, int most) {
  constexpr double kUsualDpi = 96;
  XrmInitialize();
  XrmDatabase database = XrmGetStringDatabase(resources.c_str());
  char* type = nullptr;
  XrmValue value{};
  double dpi = 0;
  if (database && XrmGetResource(database, "Xft.dpi", "Xft.Dpi", &type, &value) != 0 && value.addr)
    dpi = std::strtod(value.addr, nullptr);
  if (database) XrmDestroyDatabase(database);
  if (dpi > 0)
    return static_cast<int>(std::clamp(std::floor(dpi / kUsualDpi + 0.5), 1.0, static_cast<double>(most)));
  return std::clamp(std::min(pixels.x / 1920, pixels.y / 1080), 1, most);
}

glm::ivec2 screenSize(Display* display) {
  const int screen = DefaultScreen(display);
  return {DisplayWidth(display, screen), DisplayHeight(display, screen)};
}

void selectResources(Display* display) {
  XSelectInput(display, DefaultRootWindow(display), PropertyChangeMask);
}

bool isResourceChange(const XEvent& event) {
  return event.type == PropertyNotify && event.xproperty.atom == XA_RESOURCE_MANAGER &&
         event.xproperty.window == DefaultRootWindow(event.xproperty.display);
}

bool FullScreen::isFull() const {
  return before_ ||
         has(atoms(display_, window_, "_NET_WM_STATE"), XInternAtom(display_, "_NET_WM_STATE_FULLSCREEN", 0));
}

bool FullScreen::fill(std::optional<bool> wish) {
  const bool fill = wish.value_or(!isFull());
  if (fill == isFull()) return fill;
  const Window root = DefaultRootWindow(display_);
  const Atom full = XInternAtom(display_, "_NET_WM_STATE_FULLSCREEN", 0);
  if (!before_ && has(atoms(display_, root, "_NET_SUPPORTED"), full)) {
    XEvent event{};
    event.xclient.type = ClientMessage;
    event.xclient.window = window_;
    event.xclient.message_type = XInternAtom(display_, "_NET_WM_STATE", 0);
    event.xclient.format = 32;
    constexpr long kFromAnApplication = 1;
    event.xclient.data.l[0] = fill ? 1 : 0;
    event.xclient.data.l[1] = static_cast<long>(full);
    event.xclient.data.l[3] = kFromAnApplication;
    XSendEvent(display_, root, 0, SubstructureRedirectMask | SubstructureNotifyMask, &event);
    return fill;
  }
  if (fill) {
    XWindowAttributes now{};
    XGetWindowAttributes(display_, window_, &now);
    int x = 0, y = 0;
    Window child = 0;
    XTranslateCoordinates(display_, window_, root, 0, 0, &x, &y, &child);
    before_ = {x, y, now.width, now.height};
    const glm::ivec2 all = screenSize(display_);
    XMoveResizeWindow(display_, window_, 0, 0, all.x, all.y);
    XRaiseWindow(display_, window_);
  } else {
    XMoveResizeWindow(display_, window_, before_->x, before_->y, before_->width, before_->height);
    before_.reset();
  }
  return fill;
}

}  // namespace xnewell
