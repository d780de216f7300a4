#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "tests/x11/support/x_session.h"

#include <X11/Xutil.h>

#include "x11/server/canvas.h"

namespace xnewell::THIS_FILE {

namespace {

/// Lines of the kernel's list of shared segments whose creator is this process.
int ourSegments() {
  std::ifstream list{"/proc/sysvipc/shm"};
  std::string line;
  std::getline(list, line);
  int count = 0;
  long key = 0, id = 0, perms = 0, size = 0, cpid = 0;
  while (list >> key >> id >> perms >> size >> cpid && std::getline(list, line)) count += cpid == getpid();
  return count;
}

}  // namespace

// No shared segment outlives its use: it is marked for removal while in use, and is gone afterwards.
TEST(TransferImage, LeavesNoSharedSegment) {
  Session s{XServer::xvfb(8)};
  const int before = ourSegments();
  {
    Canvas canvas{s.display.get(), s.colormap, {.width = 100, .height = 100}};
    ASSERT_TRUE(canvas.sharedMemory());
    EXPECT_EQ(ourSegments(), before + 1);
    canvas.resize(200, 200);
    canvas.resize(300, 300);
    XSync(s.display.get(), 0);
    EXPECT_EQ(ourSegments(), before + 1);
  }
  XSync(s.display.get(), 0);
  EXPECT_EQ(ourSegments(), before);
}

// Shared memory that the server has yet to read is not overwritten: a second picture waits for the first.
TEST(TransferImage, DoesNotOverwriteWhatTheServerHasYetToRead) {
  Session s{XServer::xvfb(8)};
  Display* d = s.display.get();
  Canvas canvas{d, s.colormap, {.width = 64, .height = 64}};
  ASSERT_TRUE(canvas.sharedMemory());
  XSync(d, 0);
  kill(s.server.pid(), SIGSTOP);
  const unsigned long put = NextRequest(d);
  canvas.present(randomImage(64, 64, 1), {0, 0, 64, 64});
  EXPECT_LT(LastKnownRequestProcessed(d), put);
  // No proof hangs on the pause: it gives a canvas that does not wait time to overwrite the first picture.
  std::thread wake{[&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    kill(s.server.pid(), SIGCONT);
  }};
  canvas.present(randomImage(64, 64, 2), {0, 0, 64, 64});
  EXPECT_GE(LastKnownRequestProcessed(d), put);
  wake.join();
}

// Every image format that a server may ask for holds the same pixels, in any byte order and width. Dithered
// images hold the tile's pixel at each place.
TEST(WritePixels, EveryFormatHoldsThePixels) {
  const IndexImage image = randomImage(37, 11, 8);
  const Rect rect{2, 3, 31, 7};
  for (const int bits : {1, 4, 8, 16, 24, 32})
    for (const int order : {LSBFirst, MSBFirst})
      for (const int run : {0, 1}) {
        SCOPED_TRACE(testing::Message() << bits << " bits, order " << order);
        std::array<unsigned long, 256> pixels{};
        for (unsigned long i = 0; i < 256; ++i)
          pixels[i] = (run ? i : 0x9E3779B1ul * (i + 1)) & ((1ul << bits) - 1);
        XImage out{};
        out.width = 37;
        out.height = 11;
        out.format = ZPixmap;
        out.byte_order = order;
        out.bitmap_bit_order = order;
        out.bitmap_unit = out.bitmap_pad = 32;
        out.depth = out.bits_per_pixel = bits;
        ASSERT_NE(XInitImage(&out), 0);
        std::vector<char> data(std::size_t(out.bytes_per_line) * out.height, 0);
        out.data = data.data();
        PixelTable table{pixels};
        for (const bool dithers : {false, true}) {
          for (int i = 0; dithers && i < 256; i += 3) {
            Tile tile;
            for (int place = 0; place < 64; ++place) tile[place] = pixels[(i + place) % 256];
            table.set(i, pixels[i], tile);
          }
          ASSERT_EQ(table.dithers(), dithers);
          writePixels(out, image, rect, table);
          for (int y = 0; y < 11; ++y)
            for (int x = 0; x < 37; ++x) {
              const bool inside = x >= 2 && x < 33 && y >= 3 && y < 10;
              const int i = image.row(y)[x], moved = dithers && i % 3 == 0 ? y % 8 * 8 + x % 8 : 0;
              ASSERT_EQ(XGetPixel(&out, x, y), inside ? pixels[(i + moved) % 256] : 0) << x << ',' << y;
            }
        }
      }
}

}  // namespace xnewell::THIS_FILE
