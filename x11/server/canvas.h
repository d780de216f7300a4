#pragma once

#include <X11/Xlib.h>
#include <X11/extensions/XShm.h>

#include <cstddef>
#include <map>
#include <memory>
#include <string>

#include "shading/color/images.h"
#include "x11/drawing/painter.h"
#include "x11/server/colormap.h"
#include "x11/server/display.h"
#include "x11/visual/emulation.h"

namespace xnewell {

/// Brings an index image to the server. The image is written into an XImage in the server's own format. If
/// the server runs on this machine, the XImage lies in memory that it can read directly (MIT-SHM); otherwise
/// the image is sent through the connection.

/// Writes the cells of `rect` as pixel values at the same place of `out`, for any number of bits per pixel
/// and any byte order. Precondition: rect lies within both images; pixel values < 2^depth.
void writePixels(XImage& out, const IndexImage& image, const Rect& rect, const PixelTable& table);

class TransferImage {
 public:
  /// Makes memory for one picture of the given size. `wantShm` asks for shared memory. The memory is private
  /// if `wantShm` is false, if the server does not offer MIT-SHM, if we do not reach it through a local
  /// socket, or if it cannot attach the segment (as from another container). A shared segment is marked for
  /// removal before the server attaches it: it disappears with its last user, however we end.
  /// @throws X11Error if there is no memory.
  TransferImage(Display* display, Visual* visual, int depth, int width, int height, bool wantShm);
  ~TransferImage();
  TransferImage(const TransferImage&) = delete;
  TransferImage& operator=(const TransferImage&) = delete;

  [[nodiscard]] bool shared() const { return segment_.shmaddr != nullptr; }
  /// Puts `rect` of `image` at the same place of `target`. It first waits until the server has read what the
  /// last call wrote into shared memory; usually the server has.
  void put(Drawable target, GC gc, const IndexImage& image, const Rect& rect, const PixelTable& table);

 private:
  struct ImageDeleter {
    void operator()(XImage* image) const;
  };
  bool share(Visual* visual, int depth, int width, int height);

  Display* display_;
  XShmSegmentInfo segment_{};  ///< shmaddr is null if the memory is not shared
  std::unique_ptr<std::byte[]> own_;
  std::unique_ptr<XImage, ImageDeleter> image_;
  unsigned long lastPut_ = 0;  ///< serial of the request that reads the shared memory
};

/// A top-level window and the picture behind it. The picture is a pixmap of the window's size that keeps what
/// was presented, so an uncovered window needs no new drawing. Sizes are 1 x 1 to 8192 x 8192 pixels; a
/// window may be larger than the screen.
class Canvas {
 public:
  struct Settings {
    std::string title = "xnewell";
    int width = 1024, height = 768;
    int minWidth = 1, minHeight = 1;  ///< the smallest size, as a hint to the window manager
    bool sharedMemory = true;         ///< use MIT-SHM if it works
  };

  /// Makes the window but does not map it. The picture is all index 0. The Display and the colormap must
  /// outlive the canvas.
  /// @throws X11Error if the server has no room for the picture.
  Canvas(Display* display, const ServerColormap& colormap, const Settings& settings);
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  /// Sets the title that window managers show.
  void entitle(const std::string& title) const;
  void map() { XMapWindow(display_, window()); }
  [[nodiscard]] Window window() const { return window_.get(); }
  [[nodiscard]] int width() const { return size_.width; }
  [[nodiscard]] int height() const { return size_.height; }
  [[nodiscard]] bool sharedMemory() const { return transfer_->shared(); }
  /// True if the event says that the user pressed the close button.
  [[nodiscard]] bool isCloseRequest(const XEvent& event) const;

  /// Puts the part of `image` within `dirty` into the picture, but not yet onto the window. Parts outside the
  /// image or the canvas are left out. The pixel values are those of the colormap's last lookUp().
  void upload(const IndexImage& image, const Rect& dirty);
  /// upload(), then expose().
  void present(const IndexImage& image, const Rect& dirty);
  /// Copies `rect` of the picture to the window: after an Expose event, or after drawing into the picture.
  void expose(const Rect& rect);
  /// Gives the picture a new size, after ConfigureNotify. What fits stays at the upper left; new parts are
  /// index 0. It changes the fill of gc(). The size of the window itself is left to the user and the window
  /// manager.
  /// @throws X11Error if the server has no room; the old picture is then kept.
  void resize(int width, int height);

  /// For drawing by the server: call setFill(), draw into drawable() with gc(), then expose().
  [[nodiscard]] Drawable drawable() const { return picture_.get(); }
  [[nodiscard]] GC gc() const { return gc_.get(); }
  /// Makes gc() fill with what upload() shows for this index: one pixel value, or for a dithered index the
  /// tile, aligned with the picture's upper left corner.
  void setFill(std::uint8_t index);

  /// The pixel values of `rect`, read from the server. Precondition: rect is not empty and lies within the
  /// picture.
  /// @throws X11Error if the server does not deliver them.
  [[nodiscard]] OwnedImage pixels(const Rect& rect) const;
  /// The colours that these pixel values show through the colormap, each value >> 8.
  [[nodiscard]] RgbImage readBack(const Rect& rect) const;

 private:
  Display* display_;
  const ServerColormap& colormap_;
  bool wantShm_;
  Rect size_;
  OwnedWindow window_;
  OwnedPixmap picture_;
  OwnedGC gc_;
  std::unique_ptr<TransferImage> transfer_;
  /// The tiles that the server holds, with their pixel values.
  struct ServerTile {
    Tile pixels;
    OwnedPixmap pixmap;
  };
  std::map<std::uint8_t, ServerTile> tiles_;
  Atom deleteWindow_ = 0, protocols_ = 0, netName_ = 0, utf8_ = 0;
};

}  // namespace xnewell
