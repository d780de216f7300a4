#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <random>
#include <set>
#include <string_view>
#include <utility>

#include "x11/drawing/painter.h"
#include "x11/drawing/wording.h"

namespace xnewell::THIS_FILE {

namespace {

using Pixels = std::set<std::pair<int, int>>;

/// Where the image is not 0.
Pixels painted(const IndexImage& image, int dx = 0, int dy = 0) {
  Pixels pixels;
  for (int j = 0; j < image.height; ++j)
    for (int i = 0; i < image.width; ++i)
      if (image.row(j)[i]) pixels.emplace(i + dx, j + dy);
  return pixels;
}

/// What `draw` paints with its origin at (dx, dy), on a large image, in the drawing's own coordinates.
template <typename Draw>
Pixels drawn(Draw draw, int dx = 200, int dy = 200) {
  IndexImage image{400, 400, 0};
  Painter painter{image};
  draw(painter, dx, dy);
  return painted(image, -dx, -dy);
}

Pixels lineFrom(int x0, int y0, int x1, int y1, const LineStyle& style = {}) {
  return drawn([&](Painter& p, int x, int y) { p.line(x + x0, y + y0, x + x1, y + y1, 1, style); });
}

/// Everything the painter can draw, somewhere around (x, y).
void everything(Painter& p, int x, int y) {
  p.fillRect({x - 3, y - 2, 4, 5}, 1);
  p.frame({x, y, 9, 7}, 2);
  p.stipple({x + 4, y - 9, 13, 11}, Stipple::Quarter, 3);
  p.line(x - 40, y + 3, x + 30, y - 20, 4, {.thickness = 3, .on = 5, .off = 2});
  p.line(x, y + 50, x + 7, y - 50, 5);
  p.disc(x, y, 6, 6);
  p.ring(x + 9, y, 8, 7);
  for (const VoiceRow& voice : kVoices) p.text(x - 10, y + 4, "Wg\u00B7", 8, voice.id);
  p.textRight(x, y, "0.40", 9, Voice::Bold);
  p.tick(x - 2, y, 10);
  p.cross(x, y - 3, 11);
  for (const Direction to : {Direction::Left, Direction::Right, Direction::Up, Direction::Down}) {
    p.triangle(x, y, 5, to, 12);
    p.keyCap(x - 7, y, to, {13, 14, 15, 16});
  }
  p.keyCap(x, y - 7, "Space", {13, 14, 15, 16});
}

}  // namespace

// Clipping leaves out pixels and changes none. Drawn across the border of a small image, or of a smaller
// clip, the picture is the part of the whole picture that is inside.
TEST(Painter, ClipsExactly) {
  constexpr int kWidth = 31, kHeight = 23, kMargin = 120;
  const Rect clip{5, 4, 17, 13};
  for (int y = -60; y <= kHeight + 60; y += 7)
    for (int x = -60; x <= kWidth + 60; x += 5) {
      IndexImage whole{kWidth + 2 * kMargin, kHeight + 2 * kMargin, 0}, small{kWidth, kHeight, 0},
          inner = small;
      Painter large{whole}, direct{small};
      everything(large, x + kMargin, y + kMargin);
      everything(direct, x, y);
      Painter clipped = Painter{inner}.within(clip);
      everything(clipped, x, y);
      for (int j = 0; j < kHeight; ++j)
        for (int i = 0; i < kWidth; ++i) {
          const int expected = whole.row(j + kMargin)[i + kMargin];
          const bool inside =
              i >= clip.x && i < clip.x + clip.width && j >= clip.y && j < clip.y + clip.height;
          ASSERT_EQ(small.row(j)[i], expected) << x << ' ' << y << ' ' << i << ' ' << j;
          ASSERT_EQ(inner.row(j)[i], inside ? expected : 0) << x << ' ' << y << ' ' << i << ' ' << j;
        }
    }
}

// A line has one pixel for each step along its longer axis, each within half a pixel of the line. Both ends
// are among them, and the pixels are the same from either end.
TEST(Painter, LineIsTheNearestPixels) {
  std::mt19937 rng{1965};
  std::uniform_int_distribution<int> any{-90, 90};
  for (int k = 0; k < 2000; ++k) {
    const int x0 = any(rng), y0 = any(rng), x1 = any(rng), y1 = any(rng);
    const int dx = x1 - x0, dy = y1 - y0, n = std::max(std::abs(dx), std::abs(dy));
    const Pixels line = lineFrom(x0, y0, x1, y1);
    ASSERT_EQ(static_cast<int>(line.size()), n + 1);
    EXPECT_TRUE(line.contains({x0, y0}) && line.contains({x1, y1}));
    // The distance along the shorter axis, times n, is the cross product.
    for (const auto& [x, y] : line) ASSERT_LE(2 * std::abs((x - x0) * dy - (y - y0) * dx), n);
    ASSERT_EQ(line, lineFrom(x1, y1, x0, y0));
  }
  EXPECT_TRUE(lineFrom(0, 0, 2, 1).contains({1, 1}));  // half way: the larger coordinate
  EXPECT_TRUE(lineFrom(0, 1, 2, 0).contains({1, 1}));
  EXPECT_TRUE(lineFrom(0, -2, -1, 0).contains({0, -1}));
}

// Ends far outside the image cost nothing and shift nothing: the clipped part of a line 2^24 long is that of
// the same line begun near the image.
TEST(Painter, LongLinesKeepTheirPlace) {
  const int far = 1 << 24;
  IndexImage a{100, 80, 0}, b = a;
  Painter{a}.line(-far, -far / 2, far, far / 2, 1);
  Painter{b}.line(-2, -1, 200, 100, 1);
  EXPECT_EQ(a, b);
  EXPECT_EQ(painted(a).size(), 100u);
}

// Dashes repeat from the first point. With the gaps filled they are the whole line.
TEST(Painter, DashesFromTheFirstPoint) {
  const LineStyle dashed{.thickness = 1, .on = 4, .off = 3};
  for (const auto& [x, y] : lineFrom(0, 0, 69, 20, dashed)) EXPECT_LT(x % 7, 4);
  EXPECT_EQ(lineFrom(0, 0, 69, 20, dashed).size(), 40u);
  for (const auto& [x, y] : lineFrom(69, 20, 0, 0, dashed)) EXPECT_LT((69 - x) % 7, 4);
}

// A line of thickness t has t pixels across its longer axis.
TEST(Painter, ThicknessAcrossTheLongerAxis) {
  for (const int t : {1, 2, 3, 5}) {
    std::map<int, int> columns;
    for (const auto& [x, y] : lineFrom(0, 0, 50, 31, {.thickness = t})) ++columns[x];
    EXPECT_EQ(columns.size(), 51u);
    for (const auto& [x, count] : columns) EXPECT_EQ(count, t);
  }
}

// In every 8 x 8 block of the image, wherever it begins, exactly the promised number of pixels is painted.
TEST(Painter, StippleDensityIsExact) {
  for (const StippleRow& row : kStipples)
    for (int y = 0; y < 8; ++y)
      for (int x = 0; x < 8; ++x) {
        IndexImage image{20, 20, 0};
        Painter{image}.stipple({x, y, 8, 8}, row.id, 1);
        EXPECT_EQ(painted(image).size(), static_cast<std::size_t>(row.ofSixtyFour)) << row.looks;
      }
}

// Two tinted areas side by side look like one tinted area.
TEST(Painter, StipplesJoinWithoutASeam) {
  for (const StippleRow& row : kStipples) {
    IndexImage parts{50, 30, 0}, whole = parts;
    Painter{parts}.stipple({3, 2, 11, 20}, row.id, 1);
    Painter{parts}.stipple({14, 2, 9, 20}, row.id, 1);
    Painter{whole}.stipple({3, 2, 20, 20}, row.id, 1);
    EXPECT_EQ(parts, whole);
  }
}

// The lowest row of a letter without a descender is the row above the baseline. text() returns the pen's
// place.
TEST(Painter, TextStandsOnItsBaseline) {
  for (const VoiceRow& voice : kVoices) {
    int pen = 0;
    const Pixels A = drawn([&](Painter& p, int x, int y) { pen = p.text(x, y, "AA", 1, voice.id) - x; });
    const auto byRow = [](const auto& a, const auto& b) { return a.second < b.second; };
    EXPECT_EQ(std::max_element(A.begin(), A.end(), byRow)->second, -1) << voice.looks;
    EXPECT_EQ(std::min_element(A.begin(), A.end(), byRow)->second, -9 * voice.scale) << voice.looks;
    EXPECT_EQ(A.begin()->first, 0) << voice.looks;
    EXPECT_EQ(pen, 2 * voice.pitch);
  }
}

// Right-aligned text of any length ends at the same place, in every voice.
TEST(Painter, RightAligned) {
  for (const VoiceRow& voice : kVoices)
    for (const std::string_view s : {"0", "0.40", "4,032"}) {
      const auto right = drawn([&](Painter& p, int x, int y) {
        EXPECT_EQ(p.textRight(x, y, s, 1, voice.id), x - textWidth(s, voice.id));
      });
      const int width = textWidth(s, voice.id);
      EXPECT_EQ(right, drawn([&](Painter& p, int x, int y) { p.text(x - width, y, s, 1, voice.id); }));
    }
}

// A disc has the pixels whose centres are nearer than radius + 1/2. The rings inside it fill it, each pixel
// once.
TEST(Painter, DiscIsItsRings) {
  for (int r = 0; r < 12; ++r) {
    Pixels rings;
    std::size_t count = 0;
    for (int k = 0; k <= r; ++k) {
      const Pixels ring = drawn([&](Painter& p, int x, int y) { p.ring(x, y, k, 1); });
      count += ring.size();
      rings.insert(ring.begin(), ring.end());
    }
    const Pixels disc = drawn([&](Painter& p, int x, int y) { p.disc(x, y, r, 1); });
    EXPECT_EQ(disc, rings);
    EXPECT_EQ(disc.size(), count);
    for (const auto& [x, y] : disc) EXPECT_LT(std::hypot(x, y), r + 0.5);
    EXPECT_TRUE(disc.contains({r, 0}) && disc.contains({0, -r}) && !disc.contains({r + 1, 0}));
  }
}

// Labels beside each other stay apart by a gap, so that each can be read by itself.
TEST(Labels, KeepAGap) {
  IndexImage image{400, 40, 0};
  const CellPlan plan{TableKind::Linear};
  int placed = 0;
  for (int apart = 0; apart < 160; ++apart) {
    SCOPED_TRACE(apart);
    Labels labels{Painter{image}, plan, {0, 0, 400, 40}};
    const auto a = labels.place(150, 20, "flat 6x6, z far", false),
               b = labels.place(150 + apart, 20, "flat 6x6, z-buf 32", apart % 2 == 0);
    ASSERT_TRUE(a);
    if (!b) continue;
    ++placed;
    EXPECT_LE(b->x + b->width, 400);
    if (a->y + a->height <= b->y || b->y + b->height <= a->y) continue;
    EXPECT_GE(std::max(a->x, b->x) - std::min(a->x + a->width, b->x + b->width), Labels::kGap);
  }
  EXPECT_GT(placed, 80);
}

// What must stay visible is not covered, and a label without room is left out.
TEST(Labels, CoverNothing) {
  IndexImage image{100, 40, 0};
  const CellPlan plan{TableKind::Linear};
  Labels labels{Painter{image}, plan, {0, 0, 100, 40}};
  labels.avoid({0, 0, 100, 40});
  EXPECT_FALSE(labels.place(50, 20, "flat", false));
  EXPECT_EQ(std::ranges::count(image.pixels, 0), 100 * 40);
}

// Broken text loses no word, and no line is longer than asked. Letters are counted, not bytes.
TEST(Wording, BreaksAtSpaces) {
  EXPECT_THAT(broken("one two three", 7), testing::ElementsAre("one two", "three"));
  EXPECT_THAT(broken("abcdefgh ij", 4), testing::ElementsAre("abcd", "efgh", "ij"));
  EXPECT_THAT(broken("\xC3\xA4\xC3\xB6\xC3\xBC x", 3), testing::ElementsAre("\xC3\xA4\xC3\xB6\xC3\xBC", "x"));
  EXPECT_THAT(broken("", 5), testing::IsEmpty());
}

TEST(Wording, WritesNumbers) {
  EXPECT_THAT((std::array{fixed(0.00416, 4), fixed(-0.00001, 4), fixed(-0.5, 1)}),
              testing::ElementsAre("0.0042", "0.0000", "-0.5"));
  EXPECT_THAT(
      (std::array{msText(12.345), msText(1), msText(0.5), msText(0.1), msText(0.012345), msText(0.00101),
                  msText(1e-6), msText(0)}),
      testing::ElementsAre("12.35", "1.00", "0.500", "0.100", "0.0123", "0.00101", "0.000001", "0.00"));
  EXPECT_THAT((std::array{grouped(0), grouped(999), grouped(1000), grouped(-123456), grouped(1234567)}),
              testing::ElementsAre("0", "999", "1,000", "-123,456", "1,234,567"));
  EXPECT_THAT((std::array{counted(0, "cut"), counted(1, "cut"), counted(1200, "cut")}),
              testing::ElementsAre("no cuts", "1 cut", "1,200 cuts"));
}

}  // namespace xnewell::THIS_FILE
