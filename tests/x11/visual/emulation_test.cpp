#include "x11/visual/emulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <random>
#include <set>

#include "shading/color/color_difference.h"
#include "tests/support/masks.h"

namespace xnewell::THIS_FILE {

namespace {

std::array<unsigned long, 3> channels(const ChannelMasks& m) { return {m.red, m.green, m.blue}; }

std::vector<OfferedColor> randomColors(std::mt19937& rng, std::size_t count) {
  std::vector<OfferedColor> list;
  const auto value = [&] { return static_cast<int>(rng() >> 24); };
  for (unsigned long k = 0; k < count; ++k) list.push_back({1000 + k, {value(), value(), value()}});
  return list;
}

int square(const glm::ivec3& v) { return v.r * v.r + v.g * v.g + v.b * v.b; }

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

// The nearest colour of a list is the one that comparing with all finds, also outside 0..255. In a tie it is
// the later one.
TEST(OfferedColors, NearestOfAList) {
  std::mt19937 rng{8};
  int ties = 0;
  for (int round = 0; round < 200; ++round) {
    std::vector<OfferedColor> list = randomColors(rng, 1 + round);
    list.push_back({5, list[rng() % list.size()].color});  // of two equal colours the later one wins
    const OfferedColors offered{list};
    for (int k = 0; k < 50; ++k) {
      const auto value = [&] { return static_cast<int>(rng() % 1000) - 400; };
      const glm::ivec3 target{value(), value(), value()};
      std::vector<int> distances;
      for (const OfferedColor& c : list) distances.push_back(square(c.color - target));
      const int least = *std::ranges::min_element(distances);
      ties += std::ranges::count(distances, least) > 1;
      std::size_t last = 0;
      for (std::size_t c = 0; c < list.size(); ++c)
        if (distances[c] == least) last = c;
      ASSERT_EQ(offered.nearest(target).pixel, list[last].pixel);
    }
  }
  EXPECT_GT(ties, 100);
}

// With channels, the nearest colour has in each channel the nearest level that its bits can hold, in any
// layout. Bits of no channel are those of an opaque pixel. Around a colour are the nearest one and, in each
// channel, two levels on either side of it, as far as there are any. Each of them is a colour on offer.
TEST(OfferedColors, NearestAndNextOfAllLevels) {
  for (const ChannelMasks& masks : kLayouts) {
    SCOPED_TRACE(masks.red);
    constexpr unsigned long kOpaque = 0xFF000000;
    const OfferedColors offered = allOf(masks, kOpaque);
    std::size_t all = 1;
    for (const unsigned long mask : channels(masks)) all *= levels(mask).size();
    EXPECT_EQ(offered.size(), all);
    for (int v = -50; v < 300; ++v) {
      const glm::ivec3 target{v, 250 - v, (v * 7) % 256};
      const OfferedColor got = offered.nearest(target);
      const std::vector<OfferedColor> around = offered.around(target);
      EXPECT_EQ(got.pixel & ~(masks.red | masks.green | masks.blue), kOpaque);
      for (int c = 0; c < 3; ++c) {
        const std::map<unsigned long, int> bits = levels(channels(masks)[c]);
        std::vector<int> shown;
        for (const auto& [pixel, shows] : bits) shown.push_back(shows);
        const auto at = std::ranges::find(shown, got.color[c]);
        int least = 1000;
        for (const int level : shown) least = std::min(least, std::abs(level - target[c]));
        ASSERT_EQ(bits.at(got.pixel & channels(masks)[c]), got.color[c]);
        ASSERT_EQ(std::abs(got.color[c] - target[c]), least) << v << ' ' << c;
        std::set<int> seen;
        for (const OfferedColor& color : around) seen.insert(color.color[c]);
        const std::set<int> next(at - std::min<std::ptrdiff_t>(2, at - shown.begin()),
                                 at + std::min<std::ptrdiff_t>(3, shown.end() - at));
        ASSERT_EQ(seen, next) << v << ' ' << c;
      }
      for (const OfferedColor& color : around)
        ASSERT_EQ(offered.nearest(color.color).pixel, color.pixel) << v;
    }
  }
}

// In each channel, the mean of a tile is the wanted value within 1/128 of the widest step between levels: the
// 64 values sum to 64 times the wanted one within half a step. A colour on offer fills its whole tile.
TEST(OfferedColors, MixturesOfLevelsHaveTheWantedMean) {
  std::mt19937 rng{1973};
  int mixed = 0;
  for (const ChannelMasks& masks : kLayouts) {
    SCOPED_TRACE(masks.red);
    const OfferedColors offered = allOf(masks);
    for (int k = 0; k < 300; ++k) {
      const auto value = [&] { return static_cast<int>(rng() >> 24); };
      const glm::ivec3 wanted = k < 256 ? glm::ivec3{k, 255 - k, k} : glm::ivec3{value(), value(), value()};
      const Tile tile = offered.mixture(wanted);
      mixed += std::set<unsigned long>{tile.begin(), tile.end()}.size() > 1;
      for (int c = 0; c < 3; ++c) {
        const std::map<unsigned long, int> all = levels(channels(masks)[c]);
        int step = 0, sum = 0;
        for (auto next = std::next(all.begin()); next != all.end(); ++next)
          step = std::max(step, next->second - std::prev(next)->second);
        for (const unsigned long pixel : tile) sum += all.at(pixel & channels(masks)[c]);
        ASSERT_LE(2 * std::abs(sum - 64 * wanted[c]), step) << k << ' ' << c;
      }
    }
  }
  EXPECT_GT(mixed, 1000);
}

// Tiles of grays have the wanted mean too. If the grays are evenly spaced, the bright places of a darker tile
// are among those of a brighter one, as in ordered dithering.
TEST(OfferedColors, MixturesOfGraysAreOrdered) {
  std::mt19937 rng{64};
  int rising = 0;
  for (int round = 0; round < 60; ++round) {
    const bool even = round % 2 == 0;
    const int count = 2 + round / 4;
    std::set<int> grays{0, 255};
    for (int k = 1; even && k < count; ++k) grays.insert(k * 255 / (count - 1));
    while (std::ssize(grays) < count) grays.insert(static_cast<int>(rng() >> 24));
    std::vector<OfferedColor> list;
    int step = 0;
    for (const int g : grays) {
      if (!list.empty()) step = std::max(step, g - list.back().color.r);
      list.push_back({static_cast<unsigned long>(g), {g, g, g}});
    }
    std::ranges::shuffle(list, rng);
    const OfferedColors offered{list};
    Tile before{};
    for (int v = 0; v < 256; ++v) {
      const Tile tile = offered.mixture({v, v, v});
      long sum = 0;
      for (int place = 0; place < 64; ++place) {
        sum += static_cast<long>(tile[place]);
        if (even) {
          ASSERT_GE(tile[place], before[place]) << v;
        }
        rising += tile[place] > before[place];
      }
      ASSERT_LE(2 * std::labs(sum - 64 * v), step) << v;
      before = tile;
    }
  }
  EXPECT_GT(rising, 60 * 64);
  // A quarter: one place in each 2 x 2, and the place of rank 0 is among them.
  const Tile quarter = OfferedColors{{{0, glm::ivec3{0}}, {1, glm::ivec3{255}}}}.mixture({64, 64, 64});
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) EXPECT_EQ(quarter[placeInTile(x, y)], x % 2 == 0 && y % 2 == 0);
}

// If no mixture gives the colour, the mean is nearer to it than the nearest single colour, and near to the
// best mixture of two.
TEST(OfferedColors, MixturesApproachWhatCannotBeMixed) {
  std::mt19937 rng{2003};
  int better = 0;
  for (int round = 0; round < 300; ++round) {
    const auto value = [&] { return static_cast<int>(rng() >> 24); };
    const std::vector<OfferedColor> list = randomColors(rng, 2);
    const glm::ivec3 wanted{value(), value(), value()};
    const OfferedColors offered{list};
    glm::ivec3 sum{0};
    for (const unsigned long pixel : offered.mixture(wanted)) sum += list[pixel - 1000].color;
    int best = 1 << 30;  // over all 65 mixtures
    for (int share = 0; share <= 64; ++share)
      best = std::min(best, square((64 - share) * list[0].color + share * list[1].color - 64 * wanted));
    const int step = square(list[0].color - list[1].color);
    ASSERT_LE(square(sum - 64 * wanted), best + step) << round;
    better += square(sum - 64 * wanted) < 4096 * square(offered.nearest(wanted).color - wanted);
  }
  EXPECT_GT(better, 150);
}

// A table has one pixel value for each index until a tile is set. Then it has at each place what the tile has
// there.
TEST(PixelTable, KeepsTiles) {
  std::array<unsigned long, 256> pixels;
  for (unsigned long i = 0; i < 256; ++i) pixels[i] = 3 * i;
  PixelTable table{pixels};
  Tile tile;
  for (unsigned long k = 0; k < 64; ++k) tile[k] = 1000 + k;
  EXPECT_FALSE(table.dithers());
  table.set(7, 21, Tile{});
  EXPECT_FALSE(table.solid(7));
  table.set(7, 70, tile);
  EXPECT_TRUE(table.dithers());
  EXPECT_FALSE(table.solid(7));
  EXPECT_EQ(table.tile(7), tile);
  EXPECT_EQ(table.pixels()[7], 70u);
  for (int k = 0; k < 64; ++k) {
    EXPECT_EQ(table.at(k)[7], tile[k]);
    EXPECT_EQ(table.at(k)[8], 24u);
  }
  EXPECT_TRUE(table.solid(8));
  table.set(7, 5);
  EXPECT_TRUE(table.solid(7));
}

// The gray of a gray is that gray, the weights are those of X servers, and no value exceeds 16 bits.
TEST(GrayOf, HasTheWeightsOfXServers) {
  for (int v = 0; v < 65536; ++v) {
    const auto v16 = static_cast<std::uint16_t>(v);
    ASSERT_EQ(grayOf({v16, v16, v16}), (Rgb16{v16, v16, v16}));
  }
  EXPECT_EQ(grayOf({65535, 0, 0}).r, 19660);  // 0.30 * 65535 = 19660.5
  EXPECT_EQ(grayOf({0, 65535, 0}).g, 38665);  // 38665.65
  EXPECT_EQ(grayOf({0, 0, 65535}).b, 7208);   // 7208.85
}

// A colour on offer has no error. Half way between black and white, the nearest colour is off by half the
// diagonal of the cube of colours. The mixture counts as an eighth of that: its mean is right, but it is
// grainy.
TEST(OfferedColors, MissCountsMeanAndGrain) {
  const OfferedColors offered{{{0, glm::ivec3{0}}, {1, glm::ivec3{254}}}};
  const double half = 127 * std::sqrt(3.0);
  EXPECT_EQ(offered.miss(glm::ivec3{254}, false), 0.0);
  EXPECT_EQ(offered.miss(glm::ivec3{254}, true), 0.0);
  EXPECT_NEAR(offered.miss(glm::ivec3{127}, false), half, 1e-9);
  EXPECT_NEAR(offered.miss(glm::ivec3{127}, true), half / 8, 1e-9);
  // No mixture of grays has a hue: red is off by more than the grain of its gray.
  EXPECT_GT(offered.miss({254, 0, 0}, true), 254 * std::sqrt(2.0 / 3.0));
}

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
