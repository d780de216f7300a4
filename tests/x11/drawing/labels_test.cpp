#include "x11/drawing/labels.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace xnewell::THIS_FILE {

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

}  // namespace xnewell::THIS_FILE
