#pragma once

#include <cstdint>

struct _XDisplay;  // Xlib's Display

namespace xnewell {

/// What a picture costs the connection to the X server.
struct Sent {
  std::int64_t requests = 0;
  std::int64_t bytes = 0;  ///< of these requests; pixels in shared memory are not among them
  /// The pixels of one whole image in the server's format: rows of bitsPerPixel, padded as the server asks.
  std::int64_t imageBytes = 0;
  int bitsPerPixel = 0;
  bool sharedMemory = false;  ///< whether images go through MIT-SHM
};

/// Counts what the program sends to a server from the meter's construction on.
class SentMeter {
 public:
  /// The display must outlive the meter. What waits in Xlib's buffer is sent first and does not count.
  explicit SentMeter(_XDisplay* display);
  /// Sends what waits in the buffer. `bytes` counts all connections of the program; it has only one.
  [[nodiscard]] Sent sent() const;

 private:
  _XDisplay* display_;
  std::int64_t bytesBefore_;
  unsigned long nextBefore_;
};

/// Fills in imageBytes and bitsPerPixel, for an image on a server's drawable of this depth.
void measureImage(Sent& sent, _XDisplay* display, int depth, int width, int height);

}  // namespace xnewell
