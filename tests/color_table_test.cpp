#include "shading/color_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

// r = 50^(1/239) = 1.01650299..., and the brightest corrected shade is full intensity.
TEST(ColorTable, CorrectedRatioAsInTheBook) {
  EXPECT_NEAR(ratioOfShades(0.02, 239), 1.01650299, 5e-9);
  EXPECT_NEAR(ratioOfShades(0.02, 239), std::pow(50.0, 1.0 / 239), 1e-15);
  const ColorTable t{{.kind = TableKind::Corrected}};
  EXPECT_EQ(t.level(0), 0.02);
  EXPECT_EQ(t.level(239), 1.0);
}

// Stored at 8 bits only 144 of the 240 corrected levels are distinct, at 16 bits all are.
TEST(ColorTable, EightBitsKeep144CorrectedLevels) {
  for (const int bits : {8, 16}) {
    const ColorTable t{{.kind = TableKind::Corrected, .bits = bits}};
    std::set<int> red;
    for (int j = 0; j < 240; ++j) red.insert(t.color(j).r);
    EXPECT_EQ(red.size(), bits == 8 ? 144u : 240u);
  }
}
