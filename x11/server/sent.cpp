#include "x11/server/sent.h"

#include <X11/Xlib.h>
#include <X11/Xlibint.h>  // XESetBeforeFlush; its macros min and max are undefined below
#undef min
#undef max

#include <memory>

namespace xnewell {

namespace {

std::int64_t flushed = 0;  // Xlib calls count() with no place for data of ours

void count(Display*, XExtCodes*, const char*, long bytes) { flushed += bytes; }

}  // namespace

SentMeter::SentMeter(Display* display) : display_{display} {
  // Xlib calls it for all that it writes to the connection. It cannot be taken away, so it stays, once.
  static Display* counted = nullptr;
  if (counted != display) {
    if (const XExtCodes* codes = XAddExtension(display)) XESetBeforeFlush(display, codes->extension, count);
    counted = display;
  }
  XFlush(display);
  bytesBefore_ = flushed;
  nextBefore_ = NextRequest(display);
}

Sent SentMeter::sent() const {
  XFlush(display_);
  return {.requests = static_cast<std::int64_t>(NextRequest(display_) - nextBefore_),
          .bytes = flushed - bytesBefore_};
}

void measureImage(Sent& sent, Display* display, int depth, int width, int height) {
  int formats = 0;
  const std::unique_ptr<XPixmapFormatValues, int (*)(void*)> all{XListPixmapFormats(display, &formats),
                                                                 XFree};
  for (int k = 0; all && k < formats; ++k) {
    const XPixmapFormatValues& format = all.get()[k];
    if (format.depth != depth) continue;
    const std::int64_t pad = format.scanline_pad, bits = std::int64_t{width} * format.bits_per_pixel;
    sent.bitsPerPixel = format.bits_per_pixel;
    sent.imageBytes = (bits + pad - 1) / pad * pad / 8 * height;
  }
}

}  // namespace xnewell
