#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <random>
#include <string>
#include <thread>
#include <tuple>
#include <vector>

#include "tests/x11/support/x_session.h"

#include <X11/Xutil.h>

#include "x11/server/canvas.h"

namespace xnewell::THIS_FILE {

using testing::AllOf;
using testing::HasSubstr;

// Pictures on their way to a server, into its window and back, by shared memory or through the connection.

namespace {

/// What the image shows through the palette, by definition.
RgbImage colored(const IndexImage& image, const Palette& palette, const Rect& rect) {
  RgbImage rgb{rect.width, rect.height};
  std::uint8_t* out = rgb.rgb.data();
  for (int y = rect.y; y < rect.y + rect.height; ++y)
    for (int x = rect.x; x < rect.x + rect.width; ++x) {
      const Rgb16 c = palette[image.row(y)[x]];
      for (const std::uint16_t v : {c.r, c.g, c.b}) *out++ = static_cast<std::uint8_t>(v >> 8);
    }
  return rgb;
}

bool windowShows(const IndexImage& image, Display* d, const Canvas& canvas, const ServerColormap& map) {
  const OwnedImage got{XGetImage(d, canvas.window(), 0, 0, image.width, image.height, AllPlanes, ZPixmap)};
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      if (XGetPixel(got.get(), x, y) != map.pixel(image.row(y)[x])) return false;
  return true;
}

}  // namespace

/// A visual, and whether shared memory is used.
class CanvasOn : public testing::TestWithParam<std::tuple<std::string, bool>> {
 protected:
  CanvasOn() { s.colormap.store(palette); }
  [[nodiscard]] Canvas canvasOf(int width, int height) const {
    return {s.display.get(), s.colormap, {.width = width, .height = height, .sharedMemory = shared}};
  }
  std::string visual = std::get<0>(GetParam());
  bool shared = std::get<1>(GetParam());
  Palette palette = distinctPalette();
  Session s{XServer::xvfb(visual == "PseudoColor8" ? 8 : 24), visual};
};
INSTANTIATE_TEST_SUITE_P(
    Visuals, CanvasOn,
    testing::Combine(testing::Values<std::string>("PseudoColor8", "TrueColor24", "TrueColor32"),
                     testing::Values(false, true)),
    [](const auto& made) { return std::get<0>(made.param) + (std::get<1>(made.param) ? "Shared" : "Sent"); });

// A presented image reads back as its palette says: for every index, on every kind of visual, with and
// without shared memory, at odd sizes.
TEST_P(CanvasOn, RoundTripIsTheIdentity) {
  unsigned seed = 0;
  for (const auto& [w, h] : {std::pair{1, 1}, {3, 5}, {256, 1}, {17, 300}, {1023, 777}}) {
    SCOPED_TRACE(testing::Message() << w << " x " << h);
    Canvas canvas = canvasOf(w, h);
    EXPECT_EQ(canvas.sharedMemory(), shared);
    const Rect all{0, 0, w, h};
    IndexImage image = randomImage(w, h, ++seed);
    if (w == 256)
      for (int i = 0; i < 256; ++i) image.pixels[i] = static_cast<std::uint8_t>(i);
    canvas.present(image, all);
    EXPECT_EQ(canvas.readBack(all), colored(image, palette, all));
    // And again, without a round trip in between.
    for (int k = 0; k < 5; ++k) canvas.present(image = randomImage(w, h, ++seed), all);
    EXPECT_EQ(canvas.readBack(all), colored(image, palette, all));
    const Rect inner{w / 3, h / 4, w - w / 3, h - h / 4};
    EXPECT_EQ(canvas.readBack(inner), colored(image, palette, inner));
  }
}

// A dirty rectangle changes only what is inside it. It is cut to the image and the canvas.
TEST_P(CanvasOn, PresentsOnlyTheDirtyRectangle) {
  const int w = 101, h = 67;
  const Rect all{0, 0, w, h};
  Canvas canvas = canvasOf(w, h);
  IndexImage expected = randomImage(w, h, 1);
  canvas.present(expected, all);
  std::mt19937 rng{1972};
  for (unsigned k = 0; k < 200; ++k) {
    SCOPED_TRACE(k);
    const auto among = [&](int low, int high) { return low + static_cast<int>(rng() % (high - low + 1)); };
    const IndexImage next = randomImage(among(1, w + 20), among(1, h + 20), k);
    const Rect dirty{among(-20, w), among(-20, h), among(-5, w), among(-5, h)};
    canvas.present(next, dirty);
    for (int y = 0; y < std::min(h, next.height); ++y)
      for (int x = 0; x < std::min(w, next.width); ++x)
        if (x >= dirty.x && x < dirty.x + dirty.width && y >= dirty.y && y < dirty.y + dirty.height)
          expected.row(y)[x] = next.row(y)[x];
    ASSERT_EQ(canvas.readBack(all), colored(expected, palette, all));
  }
}

// The window shows the picture after present(), and shows it again when it is exposed after being wiped.
TEST_P(CanvasOn, TheWindowShowsThePicture) {
  Display* d = s.display.get();
  const Rect all{0, 0, 120, 90};
  Canvas canvas = canvasOf(120, 90);
  canvas.map();
  for (XEvent event{}; event.type != Expose;) XNextEvent(d, &event);
  const IndexImage image = randomImage(120, 90, 3);
  canvas.present(image, all);
  EXPECT_TRUE(windowShows(image, d, canvas, s.colormap));
  XSetForeground(d, canvas.gc(), s.colormap.pixel(9));
  XFillRectangle(d, canvas.window(), canvas.gc(), 10, 10, 50, 50);
  EXPECT_FALSE(windowShows(image, d, canvas, s.colormap));
  canvas.expose({10, 10, 50, 50});
  EXPECT_TRUE(windowShows(image, d, canvas, s.colormap));
  XEvent event{};
  EXPECT_FALSE(XCheckTypedEvent(d, NoExpose, &event)) << "every copy is answered by an event";
}

// A new size keeps what fits and fills the rest with index 0. The largest picture works. If the server
// refuses a larger one, the error names the request, and the picture stays as it was.
TEST_P(CanvasOn, Resizes) {
  Canvas canvas = canvasOf(50, 40);
  const IndexImage image = randomImage(50, 40, 4);
  canvas.present(image, {0, 0, 50, 40});
  canvas.resize(30, 60);
  IndexImage expected{30, 60, 0};
  for (int y = 0; y < 40; ++y) std::copy_n(image.row(y), 30, expected.row(y));
  EXPECT_EQ(canvas.readBack({0, 0, 30, 60}), colored(expected, palette, {0, 0, 30, 60}));
  try {
    canvas.resize(40'000, 1);
    ADD_FAILURE() << "a pixmap above 32767";
  } catch (const X11Error& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("X_CreatePixmap"), HasSubstr("BadAlloc")));
  }
  EXPECT_EQ(canvas.width(), 30);
  EXPECT_EQ(canvas.readBack({0, 0, 30, 60}), colored(expected, palette, {0, 0, 30, 60}));
}

// On a real colormap, a change of colours shows in the same pixels at once. On an emulated one, it shows only
// after present().
TEST_P(CanvasOn, ColoursChangeAsTheMapIs) {
  const Rect all{0, 0, 64, 64};
  const IndexImage image = randomImage(64, 64, 5);
  Canvas canvas = canvasOf(64, 64);
  canvas.present(image, all);
  const RgbImage before = canvas.readBack(all);
  std::reverse(palette.begin(), palette.end());
  const bool again = s.colormap.store(palette);
  EXPECT_EQ(again, !s.colormap.live());
  EXPECT_EQ(canvas.readBack(all), again ? before : colored(image, palette, all));
  canvas.present(image, all);
  EXPECT_EQ(canvas.readBack(all), colored(image, palette, all));
}

// What the server draws with the pixel of an index has the colour of that index.
TEST_P(CanvasOn, TheServerDrawsIntoThePicture) {
  Canvas canvas = canvasOf(20, 20);
  IndexImage expected{20, 20, 7};
  canvas.present(expected, {0, 0, 20, 20});
  std::array<XPoint, 4> square{{{4, 5}, {10, 5}, {10, 12}, {4, 12}}};
  XSetForeground(s.display.get(), canvas.gc(), s.colormap.pixel(200));
  XFillPolygon(s.display.get(), canvas.drawable(), canvas.gc(), square.data(), 4, Convex, CoordModeOrigin);
  for (int y = 5; y < 12; ++y)
    for (int x = 4; x < 10; ++x) expected.row(y)[x] = 200;
  EXPECT_EQ(canvas.readBack({0, 0, 20, 20}), colored(expected, palette, {0, 0, 20, 20}));
}

// A picture far larger than the screen and than one request arrives whole: its corners and its middle are
// right.
TEST(Canvas, TakesTheLargestSize) {
  const int side = 8192;
  IndexImage image{side, side, 0};
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      image.row(y)[x] = static_cast<std::uint8_t>(x * 31 + y * 17 + x * y / 4096);
  const Palette palette = distinctPalette();
  for (const int depth : {8, 24}) {
    Session s{XServer::xvfb(depth)};
    s.colormap.store(palette);
    for (const bool shared : {false, true}) {
      SCOPED_TRACE(testing::Message() << "depth " << depth << (shared ? " shared" : " sent"));
      Canvas canvas{s.display.get(), s.colormap, {.width = side, .height = side, .sharedMemory = shared}};
      canvas.present(image, {0, 0, side, side});
      for (const Rect part : {Rect{0, 0, 100, 100}, Rect{side - 100, side - 100, 100, 100},
                              Rect{0, 4000, side, 3}, Rect{4095, 0, 2, side}})
        EXPECT_EQ(canvas.readBack(part), colored(image, palette, part));
    }
  }
}

// Only the close button's message is a request to close.
TEST(Canvas, KnowsTheCloseButton) {
  Session s{XServer::xvfb(8)};
  Display* d = s.display.get();
  const Canvas canvas{d, s.colormap, {.width = 10, .height = 10}};
  for (const char* protocol : {"WM_DELETE_WINDOW", "WM_TAKE_FOCUS"}) {
    XEvent event{};
    event.xclient.type = ClientMessage;
    event.xclient.window = canvas.window();
    event.xclient.message_type = XInternAtom(d, "WM_PROTOCOLS", 0);
    event.xclient.format = 32;
    event.xclient.data.l[0] = static_cast<long>(XInternAtom(d, protocol, 0));
    EXPECT_EQ(canvas.isCloseRequest(event), std::string{protocol} == "WM_DELETE_WINDOW");
  }
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
