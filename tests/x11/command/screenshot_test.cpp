#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <stdexcept>

#include "tests/x11/support/watched_viewer.h"

#include <X11/XWDFile.h>

namespace xnewell::THIS_FILE {

// What an independent client, xwd, sees of the window. No code of the program reads the pixels, and the
// colours come from xwd's file.

namespace {

/// A number in the file. All numbers but the pixels have their most significant byte first.
std::uint32_t numberAt(const std::string& file, std::size_t at, int bytes, bool lowFirst = false) {
  std::uint32_t n = 0;
  for (int i = 0; i < bytes; ++i)
    n = n << 8 | static_cast<unsigned char>(file.at(at + (lowFirst ? bytes - 1 - i : i)));
  return n;
}

/// A screenshot as xwd writes it: header, the window's name, the entries of the colormap, rows of pixels.
/// @see X11/XWDFile.h
RgbImage readXwd(const std::string& file) {
  const auto field = [&](std::size_t at) { return numberAt(file, at, 4); };
  if (field(offsetof(XWDFileHeader, file_version)) != XWD_FILE_VERSION)
    throw std::runtime_error("no screenshot");
  const auto kind = field(offsetof(XWDFileHeader, visual_class));
  const bool channels =
      kind == 4 || kind == 5;  // TrueColor, DirectColor: one entry for each value of a channel
  std::array<std::uint32_t, 3> masks{field(offsetof(XWDFileHeader, red_mask)),
                                     field(offsetof(XWDFileHeader, green_mask)),
                                     field(offsetof(XWDFileHeader, blue_mask))};
  if (!channels) masks.fill(~0u);

  const std::size_t entries = field(offsetof(XWDFileHeader, header_size));
  const std::uint32_t count = field(offsetof(XWDFileHeader, ncolors));
  std::array<std::map<std::uint32_t, std::uint8_t>, 3> shown;  // by the bits of the channel
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::size_t entry = entries + i * std::size_t{sz_XWDColor};
    const std::uint32_t pixel = numberAt(file, entry, 4);
    for (int c = 0; c < 3; ++c)
      shown[c][pixel & masks[c]] = static_cast<std::uint8_t>(numberAt(file, entry + 4 + 2 * c, 2) >> 8);
  }

  RgbImage image{static_cast<int>(field(offsetof(XWDFileHeader, pixmap_width))),
                 static_cast<int>(field(offsetof(XWDFileHeader, pixmap_height)))};
  const std::uint32_t rowBytes = field(offsetof(XWDFileHeader, bytes_per_line));
  const int bytes = static_cast<int>(field(offsetof(XWDFileHeader, bits_per_pixel))) / 8;
  const bool lowFirst = field(offsetof(XWDFileHeader, byte_order)) == 0;
  const std::size_t rows = entries + count * std::size_t{sz_XWDColor};
  std::uint8_t* out = image.rgb.data();
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const std::uint32_t pixel =
          numberAt(file, rows + y * std::size_t{rowBytes} + x * std::size_t(bytes), bytes, lowFirst);
      for (int c = 0; c < 3; ++c) *out++ = shown[c].at(pixel & masks[c]);
    }
  return image;
}

RgbImage screenshot(const XServer& server, const std::string& options) {
  const Finished done = RunningProgram{"xwd", words("-silent " + options), server.name()}.wait();
  EXPECT_EQ(done.status, 0) << "the tests need the program xwd. " << done.err;
  EXPECT_EQ(done.err, "");
  return readXwd(done.out);
}

}  // namespace

class Screenshot : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Depths, Screenshot, testing::Values(8, 24), testing::PrintToStringParamName());

// A screenshot of the window equals the snapshot of the whole window, and the picture in it equals the plain
// snapshot. So does a screenshot of the screen with each window in its own colours.
TEST_P(Screenshot, OfAnotherClientAgreesWithOurs) {
  const XServer server = XServer::xvfb(GetParam(), 1100, 800);
  for (const auto& [w, h] : {std::pair{1024, 768}, {800, 600}, {320, 240}}) {
    SCOPED_TRACE(testing::Message() << w << " x " << h);
    const std::string line = "teapot --divisions 4 --table corrected --hue 0.3,0.5,1 --shade gouraud";
    const std::string size = " --size " + std::to_string(w) + "x" + std::to_string(h);
    const Rect seen = aboveStatus(w, h);
    const RgbImage expected = freshWindow(server, line, w, h);
    const WatchedViewer viewer{server, line + size};
    const WatchedWindow& window = viewer.window;
    ASSERT_TRUE(window.comesToShow(expected, seen));

    const RgbImage taken = screenshot(server, "-id " + std::to_string(window.id()));
    EXPECT_EQ(std::pair(taken.width, taken.height), std::pair(w, h));
    EXPECT_EQ(cropped(taken, seen), expected);
    const RgbImage screen = screenshot(server, "-root");
    EXPECT_EQ(screen.width, 1100);
    EXPECT_EQ(cropped(screen, seen), expected);

    const Rect at = layoutOf(w, h).picture;
    if (!layoutOf(w, h).roomy) continue;  // words lie over the picture
    const std::string pictureSize = " --size " + std::to_string(at.width) + "x" + std::to_string(at.height);
    EXPECT_EQ(cropped(taken, at), pictureOf("snapshot " + line + pictureSize, server.name()));
  }
}

}  // namespace xnewell::THIS_FILE
