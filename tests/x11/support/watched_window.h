#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "shading/color/images.h"
#include "tests/x11/support/x_server.h"
#include "x11/drawing/painter.h"

#include <X11/Xlib.h>

#include "x11/server/display.h"

namespace xnewell {

/// The program's window as its user has it. Keys and mouse go in through XTEST. Pixels come out through the
/// colormap that the window really has.

/// Waits until `holds` is true. It asks again and again for at most 90 s, because machines may be busy.
/// Returns whether it became true.
[[nodiscard]] bool comesTrue(const std::function<bool()>& holds);

class WatchedWindow {
 public:
  /// Waits, as long as `hoping` is true, until the server shows a window of ours that is not `other` and its
  /// picture is drawn. @throws std::runtime_error if none comes
  explicit WatchedWindow(
      const XServer& server, Window other = 0, const std::function<bool()>& hoping = [] { return true; });
  /// A window that need not have its picture yet.
  [[nodiscard]] static WatchedWindow early(const XServer& server);

  [[nodiscard]] Display* display() const { return display_.get(); }
  [[nodiscard]] Window id() const { return id_; }
  [[nodiscard]] Colormap colormap() const;
  [[nodiscard]] bool colormapInstalled() const;

  [[nodiscard]] std::string title() const;
  /// The title says so too.
  [[nodiscard]] bool isDrawing() const { return title().starts_with("(drawing) "); }

  /// Types keys by their Latin-1 letters, with Shift where the keyboard needs it.
  void type(std::string_view letters) const;
  void press(KeySym symbol, bool shift = false) const;
  /// Presses one key, or lets it go.
  void hold(KeySym symbol, bool down) const;
  /// The mouse, in pixels of the screen.
  void moveTo(int x, int y) const;
  void button(unsigned number, bool down) const;

  void resize(int width, int height) const;
  /// Asks as the window manager's close button does.
  void askToClose() const;
  /// Waits until the window is gone.
  [[nodiscard]] bool goes() const;
  /// What `rect` of the window shows. It must be on the screen and uncovered.
  [[nodiscard]] RgbImage shown(const Rect& rect) const;
  [[nodiscard]] bool comesToShow(const RgbImage& expected, const Rect& rect) const;
  [[nodiscard]] bool comesToDiffer(const RgbImage& from, const Rect& rect) const;
  /// Waits until the program has handled everything that was sent to it: opens and closes the overlay of
  /// keys, and waits for both. The window must be at least 600 wide. Returns false if the overlay does not
  /// come or go.
  [[nodiscard]] bool settles() const;

 private:
  explicit WatchedWindow(OwnedDisplay display) : display_{std::move(display)} {}

  OwnedDisplay display_;
  Window id_ = 0;
};

/// Waits until the server shows no window of ours. The window of a program that has ended stays until the
/// server notices, and could be taken for the next one's.
[[nodiscard]] bool comesToShowNone(Display* display);

/// A part of an image.
[[nodiscard]] RgbImage cropped(const RgbImage& image, const Rect& rect);

/// The requests of one client, as the server takes them up (RECORD extension).
class RequestRecord {
 public:
  /// Records the client that made `resource`.
  RequestRecord(const XServer& server, Window resource);
  ~RequestRecord();
  RequestRecord(const RequestRecord&) = delete;
  RequestRecord& operator=(const RequestRecord&) = delete;

  /// Major opcodes of all requests since the start or the last forget(), oldest first.
  [[nodiscard]] const std::vector<int>& opcodes();
  void forget();
  [[nodiscard]] std::ptrdiff_t count(int opcode);
  [[nodiscard]] std::ptrdiff_t drawing();
  /// True if a request with this opcode may change what a drawable holds. The core's ClearArea to ImageText16
  /// may. We count all requests of extensions too, except the keyboard's, which Xlib makes at the first key.
  [[nodiscard]] bool isDrawing(int opcode) const;

 private:
  OwnedDisplay control_, data_;
  unsigned long context_ = 0;
  int keyboard_ = 0;  ///< major opcode of XKEYBOARD
  std::vector<int> opcodes_;
};

}  // namespace xnewell
