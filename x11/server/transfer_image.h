#pragma once

#include <X11/Xlib.h>
#include <X11/extensions/XShm.h>

#include <cstddef>
#include <memory>

#include "shading/color/index_image.h"
#include "x11/drawing/rect.h"
#include "x11/server/display.h"
#include "x11/visual/emulation.h"

namespace xnewell {

/// How an index image gets to the server: written into an XImage in the server's own format, in memory that
/// the server can read directly (MIT-SHM) where it is on this machine, and sent through the connection
/// elsewhere.

/// Writes the cells of `rect` as pixel values at the same place of `out`, whatever its bits per pixel and
/// byte order. Precondition: rect is within both; pixel values < 2^depth.
void writePixels(XImage& out, const IndexImage& image, const Rect& rect, const PixelTable& table);

class TransferImage {
 public:
  /// Memory for one picture of the given size. `wantShm` asks for shared memory; without it, or where the
  /// server does not offer it, is not reached through a local socket, or cannot attach (as from another
  /// container), the memory is ours alone. A shared segment is marked for removal before the server attaches
  /// it: it goes with the last of us, however we end.
  /// @throws X11Error if there is no memory.
  TransferImage(Display* display, Visual* visual, int depth, int width, int height, bool wantShm);
  ~TransferImage();
  TransferImage(const TransferImage&) = delete;
  TransferImage& operator=(const TransferImage&) = delete;

  [[nodiscard]] bool shared() const { return segment_.shmaddr != nullptr; }
  /// Puts `rect` of `image` at the same place of `target`. Waits first until the server has read what
  /// the last call wrote into shared memory; usually it has.
  void put(Drawable target, GC gc, const IndexImage& image, const Rect& rect, const PixelTable& table);

 private:
  struct ImageDeleter {
    void operator()(XImage* image) const;
  };
  bool share(Visual* visual, int depth, int width, int height);

  Display* display_;
  XShmSegmentInfo segment_{};  ///< shmaddr null: not shared
  std::unique_ptr<std::byte[]> own_;
  std::unique_ptr<XImage, ImageDeleter> image_;
  unsigned long lastPut_ = 0;  ///< serial of the request that reads the shared memory
};

}  // namespace xnewell
