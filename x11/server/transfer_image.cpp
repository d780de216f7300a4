#include "x11/server/transfer_image.h"

#include <X11/Xutil.h>
#include <sys/ipc.h>
#include <sys/shm.h>
#include <sys/socket.h>

#include <bit>
#include <cassert>
#include <cstdint>
#include <cstring>
#include <new>

namespace xnewell {

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
