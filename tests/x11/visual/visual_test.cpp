#include "x11/visual/visual.h"

#ifdef None
#error "x11/visual/visual.h is for code that must not see Xlib's macros"
#endif

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/x11/support/x_server.h"

#include "x11/server/display.h"
#include "x11/server/read_visuals.h"

namespace xnewell::THIS_FILE {

using testing::AllOf;
using testing::HasSubstr;

namespace {

constexpr ChannelMasks k888{0xFF0000, 0xFF00, 0xFF};

VisualInfo pseudo(unsigned long id, int depth = 8) {
  return {VisualClass::PseudoColorClass, depth, id, {}, 8, 1 << depth};
}
VisualInfo trueColor(unsigned long id, int depth, ChannelMasks masks = k888) {
  return {VisualClass::TrueColorClass, depth, id, masks, 8, 256};
}
VisualInfo direct(unsigned long id) { return {VisualClass::DirectColorClass, 24, id, k888, 8, 256}; }

ServerVisuals server(std::vector<VisualInfo> visuals, unsigned long defaultId) {
  ServerVisuals s;
  s.display = ":7";
  s.visuals = std::move(visuals);
  s.defaultId = defaultId;
  return s;
}

}  // namespace

// Visuals that show every colour come first. Among them a real colormap comes first, then those that make no
// other program's colours flash. The default visual comes before its equals. The test checks each pair of
// neighbours in this order, with the server listing them either way round.
TEST(ChooseVisual, TakesTheFirstRowThatTheServerHas) {
  const auto other = [](VisualClass kind, unsigned long id, int depth, int cells) {
    return VisualInfo{kind, depth, id, {}, 8, cells};
  };
  const VisualInfo direct8{VisualClass::DirectColorClass, 8, 11, {0x7, 0x38, 0xC0}, 8, 8};
  const std::vector<VisualInfo> falling{
      pseudo(1),
      pseudo(2, 12),
      trueColor(3, 24),
      trueColor(4, 30, {0x3FF00000, 0xFFC00, 0x3FF}),
      direct(5),
      trueColor(6, 16, {0xF800, 0x7E0, 0x1F}),
      trueColor(7, 15, {0x7C00, 0x3E0, 0x1F}),
      trueColor(8, 32),
      other(VisualClass::GrayScaleClass, 9, 8, 256),
      other(VisualClass::StaticColorClass, 10, 8, 256),
      trueColor(12, 8, {0x7, 0x38, 0xC0}),
      direct8,
      other(VisualClass::StaticGrayClass, 13, 8, 256),
      other(VisualClass::StaticGrayClass, 14, 1, 2),
      pseudo(15, 4),
  };
  for (std::size_t k = 0; k + 1 < falling.size(); ++k) {
    const VisualInfo &better = falling[k], &worse = falling[k + 1];
    SCOPED_TRACE(better.name() + " before " + worse.name());
    EXPECT_EQ(chooseVisual(server({better, worse}, worse.id)).visual.id, better.id);
    EXPECT_EQ(chooseVisual(server({worse, better}, worse.id)).visual.id, better.id);
  }
  EXPECT_EQ(chooseVisual(server({trueColor(1, 24), pseudo(2), pseudo(3)}, 3)).visual.id, 3u);
  EXPECT_EQ(chooseVisual(server({trueColor(1, 24), pseudo(2), pseudo(3)}, 1)).visual.id, 2u);
}

// Visuals that differ only in the order of their channels have different rows.
TEST(DescribeVisuals, ChannelsInTheirOrder) {
  VisualInfo swapped = trueColor(2, 24);
  std::swap(swapped.masks.red, swapped.masks.blue);
  const std::string text = describeVisuals(server({trueColor(1, 24), swapped}, 1));
  EXPECT_THAT(text, HasSubstr("TrueColor       24    rgb        1"));
  EXPECT_THAT(text, HasSubstr("TrueColor       24    bgr        1"));
}

// With 256 fixed grays, every gray is one of them and none is mixed. With fewer, grays are mixed.
TEST(DescribeVisuals, FixedGraysAreMixedOnlyWhereSomeAreMissing) {
  const auto grays = [](int depth) {
    return VisualInfo{VisualClass::StaticGrayClass, depth, 1, {}, 8, 1 << depth};
  };
  EXPECT_THAT(describeVisuals(server({grays(8)}, 1)),
              AllOf(HasSubstr("look the grays up itself"), testing::Not(HasSubstr("mix"))));
  EXPECT_THAT(describeVisuals(server({grays(4)}, 1)), HasSubstr("mix its fixed grays"));
}

// A stored colour loses its low bits: in a map, those that the map does not keep; without one, those that the
// narrowest channel has no place for. Mixed colours and grays are not the stored colour.
TEST(VisualInfo, ShowsTheHighBits) {
  EXPECT_EQ(pseudo(1).shownBits(), 8);
  VisualInfo precise = pseudo(1);
  precise.bitsPerRgb = 11;
  EXPECT_EQ(precise.shownBits(), 11);
  EXPECT_EQ(trueColor(1, 24).shownBits(), 8);
  EXPECT_EQ(trueColor(1, 30, {0x3FF00000, 0xFFC00, 0x3FF}).shownBits(), 10);
  EXPECT_EQ(direct(1).shownBits(), 8);
  EXPECT_EQ(trueColor(1, 16, {0xF800, 0x7E0, 0x1F}).shownBits(), 0) << "its colours are mixed";
  EXPECT_EQ((VisualInfo{VisualClass::GrayScaleClass, 8, 1, {}, 8, 256}.shownBits()), 0);
}

// A wish is a class, in upper or lower case, and perhaps a depth.
TEST(ParseVisualWish, TakesClassAndDepth) {
  for (const VisualClassRow& row : kVisualClasses) {
    EXPECT_EQ(parseVisualWish(row.name).kind, row.id);
    EXPECT_FALSE(parseVisualWish(row.name).depth);
    EXPECT_EQ(parseVisualWish(std::string{row.name} + "12").depth, 12);
    EXPECT_EQ(parseVisualWish(std::string{row.name} + " 12").depth, 12);
  }
  EXPECT_EQ(parseVisualWish("pseudoCOLOR8").kind, VisualClass::PseudoColorClass);
}

// In every layout a channel keeps its high bits, and the pixel holds nothing else. Reading gives back what a
// server shows: exactly for 8 bits, and exactly for zero and full intensity in all layouts.
TEST(PixelOf, KeepsTheHighBitsOfEachChannel) {
  EXPECT_EQ(pixelOf({0x12FF, 0x34FF, 0x56FF}, k888), 0x123456u);
  EXPECT_EQ(pixelOf({0x12FF, 0x34FF, 0x56FF}, {0xFF, 0xFF00, 0xFF0000}), 0x563412u);
  EXPECT_EQ(pixelOf({0xFFFF, 0, 0x7FFF}, {0xF800, 0x7E0, 0x1F}), 0xF80Fu);
  EXPECT_EQ(pixelOf({0x7FFF, 0xFFFF, 0x8000}, {0x7, 0x38, 0xC0}), 0xBBu);
  EXPECT_EQ(pixelOf({0xFFC0, 0x003F, 0x0040}, {0x3FF00000, 0xFFC00, 0x3FF}), 0x3FF00001u);
  EXPECT_EQ(colorOf(0x123456, k888), (Rgb16{0x1212, 0x3434, 0x5656}));
  EXPECT_EQ(colorOf(0xFFFF, {0xF800, 0x7E0, 0x1F}), (Rgb16{0xFFFF, 0xFFFF, 0xFFFF}));
  EXPECT_EQ(colorOf(0, {0x7, 0x38, 0xC0}), (Rgb16{0, 0, 0}));
  for (int v = 0; v < 65536; ++v) {
    const auto v16 = static_cast<std::uint16_t>(v);
    ASSERT_EQ(colorOf(pixelOf({v16, v16, v16}, k888), k888).g >> 8, v >> 8);
  }
}

// Without RENDER, all cells but black and white are free. Each cell that another program takes is one less.
// Counting gives all cells back.
TEST(ReadVisuals, CountsTheFreeCells) {
  const XServer x = XServer::xvfb(8, 640, 480, {"-extension", "RENDER"});
  const OwnedDisplay display = openDisplay(x.name()), other = openDisplay(x.name());
  EXPECT_EQ(readVisuals(display.get(), true).freeCells, 254);
  EXPECT_EQ(readVisuals(display.get(), true).freeCells, 254);
  std::vector<unsigned long> cells(254);
  const Colormap map = DefaultColormap(other.get(), 0);
  ASSERT_NE(XAllocColorCells(other.get(), map, 0, nullptr, 0, cells.data(), 77), 0);
  EXPECT_EQ(readVisuals(display.get(), true).freeCells, 177);
  ASSERT_NE(XAllocColorCells(other.get(), map, 0, nullptr, 0, cells.data() + 77, 177), 0);
  EXPECT_EQ(readVisuals(display.get(), true).freeCells, 0);
}

}  // namespace xnewell::THIS_FILE
