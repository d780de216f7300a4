#pragma once

#include <X11/Xlib.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "x11/visual/x11_error.h"

namespace xnewell {

/// The connection to the X server: who owns what on it, and how its errors become ours.
/// Includes Xlib and with it the macros None, Bool, Status ...: only for x11/*.cpp and their tests.

struct DisplayCloser {
  void operator()(Display* display) const { XCloseDisplay(display); }
};
using OwnedDisplay = std::unique_ptr<Display, DisplayCloser>;

/// Opens the display called `name`, or the one in $DISPLAY where `name` is empty.
/// Installs what this program does about errors that no ErrorTrap awaits:
///   - an X error is counted (strayErrors()), and the first ten are printed with their requests, for a window
///     may see one in every frame; the program goes on;
///   - a server that has gone is told on standard error and ends the program at once with status 1. Xlib
///     cannot go on from there, and nothing but Xlib may be called, so destructors do not run. For this
///     SIGPIPE is ignored: a pipe that nobody reads is an error like a full disk.
/// @throws X11Error "cannot open display ':7'" and the server's reason, if it gives one, or that no DISPLAY
/// is set.
[[nodiscard]] OwnedDisplay openDisplay(const std::string& name = {});

inline constexpr int kToldErrors = 10;
/// Errors so far that arrived outside every trap; not 0 at the end means that something shown may be wrong.
[[nodiscard]] int strayErrors();

/// A server resource released by Free(display, id). Move-only; id 0 owns nothing.
/// The Display is borrowed and must outlive every resource made on it.
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

/// An image in our memory.
struct ImageDestroyer {
  void operator()(XImage* image) const;
};
using OwnedImage = std::unique_ptr<XImage, ImageDestroyer>;

/// While it lives all other programs wait; for a few requests that belong together.
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

/// Collects the errors of the requests made on `display` while it lives; answers of earlier requests that
/// are still under way go to the trap around it, so no round trip is needed to begin. Traps nest.
/// The destructor waits for the server only if check() has not, and drops what it finds.
class ErrorTrap {
 public:
  explicit ErrorTrap(Display* display);
  ~ErrorTrap();
  ErrorTrap(const ErrorTrap&) = delete;
  ErrorTrap& operator=(const ErrorTrap&) = delete;

  /// Waits until the server has done everything (XSync).
  /// @throws X11Error the first error since the trap was set or last checked, with its request's name.
  void check();

 private:
  friend int onError(Display* display, XErrorEvent* error);
  void sync();

  Display* display_;
  ErrorTrap* outer_;
  unsigned long from_;    ///< serial of the first request that is ours
  unsigned long synced_;  ///< serial of the next request when we last waited
  std::optional<XErrorEvent> first_;
};

}  // namespace xnewell
