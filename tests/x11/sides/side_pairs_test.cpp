#include <gtest/gtest.h>

#include <algorithm>

#include "tests/x11/support/shown_sides.h"

namespace xnewell::THIS_FILE {

// The pairs that teach something come one after the other, and each pair differs in one setting.
TEST(SideBySideView, PairsDifferInOneThing) {
  ShownSides s{"teapot", ordered(Order::Newell, Shading::Phong)};
  for (const PairRow& row : kPairs) {
    SCOPED_TRACE(row.name);
    s.press("g");
    EXPECT_EQ(differencesOf(s.stage.now.picture, s.setupB().picture).size(), 1u);
    EXPECT_NE(s.A(), s.B());
    EXPECT_GT(std::ranges::count(s.difference().pixels, CellPlan{}[Cell::Q]) +
                  std::ranges::count(s.difference().pixels, CellPlan{}[Cell::Faint]),
              50);
  }
}

// A pair also sets what it rests on: faces in a right order, unless the pair is about the order, and light.
TEST(SideBySideView, PairsHaveARightOrderAndLight) {
  ShownSides s{"teapot", ordered(Order::Unsorted, Shading::Full)};
  for (const PairRow& row : kPairs) {
    SCOPED_TRACE(row.name);
    s.press("g");
    const PictureSettings &A = s.stage.now.picture, B = s.setupB().picture;
    EXPECT_TRUE(rowOf(B.order).exact);
    EXPECT_TRUE(rowOf(A.order).exact || A.order != B.order);
    EXPECT_TRUE(rowOf(A.shading).lit && rowOf(B.shading).lit);
  }
}

}  // namespace xnewell::THIS_FILE
