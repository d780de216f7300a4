#include "x11/stepper/sort_layout.h"

#include <gtest/gtest.h>

#include <cmath>

#include "x11/drawing/painter.h"

namespace xnewell {

namespace {

/// Bodies of windows of 800 x 600 and more.
std::vector<Rect> bodies() {
  return {{16, 43, 768, 428},  {16, 43, 768, 449}, {16, 48, 992, 612},   {16, 48, 1248, 612},
          {16, 43, 1200, 449}, {16, 48, 768, 900}, {16, 48, 1568, 1044}, {16, 48, 3000, 2000}};
}

std::vector<Rect> partsOf(const SortLayout& at) {
  std::vector<Rect> all{at.picture, at.table, at.finding, at.side, at.list, at.step, at.speed, at.timeline};
  all.insert(all.end(), at.toggles.begin(), at.toggles.end());
  all.insert(all.end(), at.transport.begin(), at.transport.end());
  all.insert(all.end(), at.kinds.begin(), at.kinds.end());
  return all;
}

}  // namespace

// All parts lie in the body and do not overlap, in every window with room for them.
TEST(SortLayout, PartsKeepApart) {
  for (const Rect& body : bodies()) {
    SCOPED_TRACE(std::to_string(body.width) + " x " + std::to_string(body.height));
    const SortLayout at = layoutOfSort(body);
    const std::vector<Rect> all = partsOf(at);
    for (std::size_t i = 0; i < all.size(); ++i) {
      ASSERT_FALSE(all[i].empty()) << i;
      ASSERT_EQ(intersection(all[i], body), all[i]) << i;
      for (std::size_t j = 0; j < i; ++j) ASSERT_TRUE(intersection(all[i], all[j]).empty()) << i << ' ' << j;
    }
    EXPECT_GE(at.picture.width, 400);
    EXPECT_GE(at.picture.height, 146);
    EXPECT_GE(at.rows(), 8);
    for (const Rect& answer : at.answers) EXPECT_EQ(intersection(answer, at.finding), answer);
    for (int k = 0; k < kToggleCount; ++k)
      EXPECT_GE(at.toggles[k].width, 17 + textWidth(kToggleNames[k])) << kToggleNames[k];
  }
}

// The middle of each part is found as that part, with its number.
TEST(SortLayout, AMiddleBelongsToItsPart) {
  for (const Rect& body : bodies()) {
    const SortLayout at = layoutOfSort(body);
    const auto expect = [&](const Rect& r, SortPart part, int index) {
      EXPECT_EQ(spotAt(at, r.x + r.width / 2, r.y + r.height / 2), (SortSpot{part, index}));
      EXPECT_EQ(spotAt(at, r.x, r.y), (SortSpot{part, index}));
      EXPECT_EQ(spotAt(at, r.x + r.width - 1, r.y + r.height - 1), (SortSpot{part, index}));
    };
    const auto each = [&](const auto& rects, SortPart part) {
      for (int k = 0; k < static_cast<int>(rects.size()); ++k) expect(rects[k], part, k);
    };
    each(at.toggles, SortPart::Toggle);
    each(at.transport, SortPart::Transport);
    each(at.kinds, SortPart::Kind);
    each(at.answers, SortPart::Answer);
    expect(at.picture, SortPart::Picture, 0);
    expect(at.timeline, SortPart::Timeline, 0);
    expect(at.speed, SortPart::Speed, 0);
    for (int row = 0; row < at.rows(); ++row)
      EXPECT_EQ(spotAt(at, at.list.x, at.list.y + row * at.line), (SortSpot{SortPart::Row, row}));
    EXPECT_EQ(spotAt(at, body.x - 1, body.y), SortSpot{});
    EXPECT_EQ(spotAt(at, body.x, at.rule), SortSpot{});
  }
}

// Steps go along the timeline from end to end. If each step has its own column, the column leads back to the
// step. Otherwise it leads to one of the steps in that column.
TEST(SortLayout, ColumnsAndStepsAgree) {
  const Rect line{84, 591, 924, 60};
  for (const int steps : {0, 1, 2, 19, 300, 923, 924, 20339, 4000000}) {
    EXPECT_EQ(columnOf(line, 0, steps), line.x);
    if (steps > 0) {
      EXPECT_EQ(columnOf(line, steps, steps), line.x + line.width - 1);
    }
    for (int step = 0; step <= steps; step += std::max(1, steps / 1000)) {
      const int column = columnOf(line, step, steps);
      ASSERT_EQ(columnOf(line, stepAt(line, column, steps), steps), column);
      if (steps < line.width) {
        ASSERT_EQ(stepAt(line, column, steps), step);
      }
    }
    EXPECT_EQ(stepAt(line, -1000, steps), 0);
    EXPECT_EQ(stepAt(line, 5000, steps), steps);
  }
  const Rect track{840, 566, 168, 15};
  for (int x = track.x; x < track.x + track.width; ++x) EXPECT_EQ(columnOfSpeed(track, speedAt(track, x)), x);
  EXPECT_NEAR(speedAt(track, -9), kSlowest, 1e-9);
  EXPECT_NEAR(speedAt(track, 5000), kFastest, 1e-6);
}

}  // namespace xnewell
