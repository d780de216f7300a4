#pragma once

#include <X11/Xlib.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "x11/visual/x11_error.h"

namespace xnewell {

/// The connection to the X server: who owns what on it, and how its errors become ours.
/// This header includes Xlib, and with it the macros None, Bool, Status and others. So only
/// x11/server, x11/app and their tests may include it.

struct DisplayCloser {
  void operator()(Display* display) const { XCloseDisplay(display); }
};
using OwnedDisplay = std::unique_ptr<Display, DisplayCloser>;

/// Opens the display called `name`, or the one in $DISPLAY if `name` is empty.
/// It also installs what this program does about errors that no ErrorTrap awaits:
///   - An X error is counted (see strayErrors()), and the program goes on. The first ten are printed with
///     their requests; no more, because a window may cause one in every frame.
///     Requests to a window that is gone do not count: see tellsItsEnd().
///   - If the connection has ended, the program prints a message and ends at once with status 1. Xlib cannot
///     go on from there, so destructors do not run. The message says whether the server still runs: then
///     another program has ended the connection (XKillClient). SIGPIPE is ignored for this, so writing to a
///     pipe that nobody reads is an ordinary error, like a full disk.
/// @throws X11Error "cannot open display ':7'" with the server's reason, if it gives one; or "DISPLAY is not
/// set"
[[nodiscard]] OwnedDisplay openDisplay(const std::string& name = {});

inline constexpr int kToldErrors = 10;
/// The number of errors so far that no trap caught. If it is not 0 at the end, something shown may be wrong.
[[nodiscard]] int strayErrors();

/// This window has a DestroyNotify event, whose handler tells that it is gone.
void tellsItsEnd(Window window);

/// From now on a connection that ends is no failure: the program then ends with status 0 and says nothing.
void nothingMoreIsNeeded();

/// A server resource that Free(display, id) releases. It can be moved but not copied; id 0 owns nothing.
/// The Display is borrowed. It must outlive every resource made on it.
template <typename Id, auto Free>
class XResource {
 public:
  XResource() noexcept = default;
  XResource(Display* display, Id id) noexcept : display_{display}, id_{id} {}
  XResource(XResource&& o) noexcept : display_{o.display_}, id_{std::exchange(o.id_, Id{})} {}
  XResource& operator=(XResource&& o) noexcept {
    std::swap(display_, o.display_);
    std::swap(id_, o.id_);
    return *this;
  }
  ~XResource() {
    if (id_) Free(display_, id_);
  }
  [[nodiscard]] Id get() const noexcept { return id_; }

 private:
  Display* display_ = nullptr;
  Id id_{};
};
using OwnedPixmap = XResource<Pixmap, XFreePixmap>;
using OwnedWindow = XResource<Window, XDestroyWindow>;
using OwnedColormap = XResource<Colormap, XFreeColormap>;
using OwnedGC = XResource<GC, XFreeGC>;

/// An image in our own memory.
struct ImageDestroyer {
  void operator()(XImage* image) const;
};
using OwnedImage = std::unique_ptr<XImage, ImageDestroyer>;

/// While this object lives, all other programs wait. Use it for a few requests that belong together.
class ServerGrab {
 public:
  explicit ServerGrab(Display* display) : display_{display} { XGrabServer(display); }
  ~ServerGrab() {
    XUngrabServer(display_);
    XFlush(display_);
  }
  ServerGrab(const ServerGrab&) = delete;
  ServerGrab& operator=(const ServerGrab&) = delete;

 private:
  Display* display_;
};

/// Collects the errors of the requests made on `display` while it lives. Errors of earlier requests go to the
/// trap around it, even if they arrive now, so a trap begins without a round trip. Traps nest.
/// The destructor waits for the server only if check() has not done so; it drops the errors that it finds.
class ErrorTrap {
 public:
  explicit ErrorTrap(Display* display);
  ~ErrorTrap();
  ErrorTrap(const ErrorTrap&) = delete;
  ErrorTrap& operator=(const ErrorTrap&) = delete;

  /// Waits until the server has processed every request (XSync).
  /// @throws X11Error for the first error since the trap was set or last checked, with the name of its
  /// request.
  void check();

 private:
  friend int onError(Display* display, XErrorEvent* error);
  void sync();

  Display* display_;
  ErrorTrap* outer_;
  unsigned long from_;    ///< serial of the first request that belongs to this trap
  unsigned long synced_;  ///< serial that the next request had when we last waited
  std::optional<XErrorEvent> first_;
};

}  // namespace xnewell
