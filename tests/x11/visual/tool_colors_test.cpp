#include "x11/visual/tool_colors.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "shading/color/color_difference.h"
#include "tests/support/masks.h"

namespace xnewell::THIS_FILE {

namespace {

using enum Cell;

/// A legend of differences, on the well.
constexpr std::array kSteps{Well, WellLine, Soft, Faint, WellText, White};
constexpr std::array kWords{Faint, Soft, Ink, Good, Alarm, P};

std::array<glm::ivec3, kCells> wantedColors() {
  const CellPlan plan;
  const Palette colors = withInterface({}, plan);
  std::array<glm::ivec3, kCells> wanted;
  for (int role = 0; role < kCells; ++role) wanted[role] = eightBits(colors[plan[static_cast<Cell>(role)]]);
  return wanted;
}

glm::ivec3 colorOf(const ToolColors& chosen, Cell cell) { return chosen[static_cast<int>(cell)].color; }
int brightness(const glm::ivec3& c) { return 30 * c.r + 59 * c.g + 11 * c.b; }
/// As the eye sees it.
double difference(const glm::ivec3& p, const glm::ivec3& q) {
  const auto labOf = [](const glm::u8vec3& c) { return labFromSrgb(&c.r); };
  return ciede2000(labOf(p), labOf(q));
}

}  // namespace

// All colours look nearly as they should, also if channels have few levels, and grays are gray. Chosen by the
// nearest 8-bit values, the well would be navy there, and words on it green.
TEST(ToolColors, LookAsTheyShould) {
  constexpr double kNearly = 14;
  const std::array<glm::ivec3, kCells> wanted = wantedColors();
  int worse = 0;
  for (const ChannelMasks& masks : {k332, kBgr233, k555, k565}) {
    SCOPED_TRACE(masks.red);
    const OfferedColors offered = allOf(masks);
    const ToolColors chosen = chooseToolColors(offered, wanted);
    for (int role = 0; role < kCells; ++role) {
      SCOPED_TRACE(kCellNames[role]);
      EXPECT_LE(difference(chosen[role].color, wanted[role]), kNearly);
      worse += difference(offered.nearest(wanted[role]).color, wanted[role]) > kNearly;
    }
  }
  EXPECT_GE(worse, 8);
  for (const ChannelMasks& masks : {k332, kBgr233})
    EXPECT_EQ(colorOf(chooseToolColors(allOf(masks), wanted), Well), glm::ivec3(0));
}

// Colours drawn on each other are shown differently, and the steps of a legend grow brighter.
TEST(ToolColors, WhatMeetsDiffers) {
  for (const ChannelMasks& masks : {k332, kBgr233, k555, k565, k888}) {
    SCOPED_TRACE(masks.red);
    const ToolColors chosen = chooseToolColors(allOf(masks), wantedColors());
    for (std::size_t k = 1; k < kSteps.size(); ++k)
      EXPECT_LT(brightness(colorOf(chosen, kSteps[k - 1])), brightness(colorOf(chosen, kSteps[k]))) << k;
    for (const Cell ground : {Paper, Panel}) {
      for (const Cell word : kWords)
        EXPECT_GT(brightness(colorOf(chosen, ground)) - brightness(colorOf(chosen, word)), 100 * 0x20);
      EXPECT_NE(colorOf(chosen, ground), colorOf(chosen, Rule));
      EXPECT_NE(colorOf(chosen, ground), colorOf(chosen, Q));
    }
    EXPECT_NE(colorOf(chosen, Paper), colorOf(chosen, Panel));
    EXPECT_NE(colorOf(chosen, Paper), colorOf(chosen, Focus));
  }
}

// A wanted colour that is on offer is taken. A choice that is already made stays, whatever else is near.
TEST(ToolColors, ExactWhereTheyCanBe) {
  const std::array<glm::ivec3, kCells> wanted = wantedColors();
  std::vector<OfferedColor> list{{100, {7, 7, 7}}};
  for (int role = 0; role < kCells; ++role) list.push_back({static_cast<unsigned long>(role), wanted[role]});
  const ToolColors exact = chooseToolColors(OfferedColors{list}, wanted);
  for (int role = 0; role < kCells; ++role) EXPECT_EQ(exact[role].pixel, role);

  std::array<std::optional<OfferedColor>, kCells> has;
  has[static_cast<int>(Well)] = OfferedColor{77, {0, 99, 0}};
  const ToolColors settled = chooseToolColors(OfferedColors{list}, wanted, has);
  for (int role = 0; role < kCells; ++role)
    EXPECT_EQ(settled[role].pixel, role == static_cast<int>(Well) ? 77 : role);
}

// If blue has only the levels none and full, there are no grays. Words that would be orange are black.
TEST(ToolColors, WordsAreBlackWhereNothingIsNear) {
  std::array<std::vector<OfferedLevel>, 3> levels;
  for (int c = 0; c < 3; ++c)
    for (const int value : c == 2 ? std::vector{0, 255} : std::vector{0, 36, 73, 146, 218, 255})
      levels[c].push_back({static_cast<unsigned long>(value) << 8 * c, value});
  const ToolColors chosen = chooseToolColors(OfferedColors{levels, 0}, wantedColors());
  for (const Cell word : {Soft, Faint, Ink}) EXPECT_EQ(colorOf(chosen, word), glm::ivec3(0));
  for (const Cell word : {Alarm, Good, P}) EXPECT_NE(colorOf(chosen, word), glm::ivec3(0));
}

// If only black and white are left, words can still be read.
TEST(ToolColors, BlackAndWhiteAreEnoughToRead) {
  const OfferedColors offered{{{0, {0, 0, 0}}, {1, {255, 255, 255}}}};
  const ToolColors chosen = chooseToolColors(offered, wantedColors());
  for (const Cell ground : {Paper, Panel, White})
    for (const Cell word : kWords) EXPECT_NE(colorOf(chosen, ground), colorOf(chosen, word));
  EXPECT_NE(colorOf(chosen, Well), colorOf(chosen, WellText));
  EXPECT_NE(colorOf(chosen, Paper), colorOf(chosen, Rule));
}

}  // namespace xnewell::THIS_FILE
