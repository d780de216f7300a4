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

}  // namespace xnewell
