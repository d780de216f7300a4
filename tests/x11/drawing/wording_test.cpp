#include "x11/drawing/wording.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace xnewell::THIS_FILE {

// Broken text loses no word, and no line is longer than asked. Letters are counted, not bytes.
TEST(Wording, BreaksAtSpaces) {
  EXPECT_THAT(broken("one two three", 7), testing::ElementsAre("one two", "three"));
  EXPECT_THAT(broken("abcdefgh ij", 4), testing::ElementsAre("abcd", "efgh", "ij"));
  EXPECT_THAT(broken("\xC3\xA4\xC3\xB6\xC3\xBC x", 3), testing::ElementsAre("\xC3\xA4\xC3\xB6\xC3\xBC", "x"));
  EXPECT_THAT(broken("", 5), testing::IsEmpty());
}

TEST(Wording, WritesNumbers) {
  EXPECT_EQ(fixed(0.00416, 4), "0.0042");
  EXPECT_EQ(fixed(-0.00001, 4), "0.0000");
  EXPECT_EQ(fixed(-0.5, 1), "-0.5");
  EXPECT_EQ(msText(12.345), "12.35");
  EXPECT_EQ(msText(1), "1.00");
  EXPECT_EQ(msText(0.5), "0.500");
  EXPECT_EQ(msText(0.1), "0.100");
  EXPECT_EQ(msText(0.012345), "0.0123");
  EXPECT_EQ(msText(0.00101), "0.00101");
  EXPECT_EQ(msText(1e-6), "0.000001");
  EXPECT_EQ(msText(0), "0.00");
  EXPECT_EQ(grouped(0), "0");
  EXPECT_EQ(grouped(999), "999");
  EXPECT_EQ(grouped(1000), "1,000");
  EXPECT_EQ(grouped(-123456), "-123,456");
  EXPECT_EQ(grouped(1234567), "1,234,567");
  EXPECT_EQ(counted(0, "cut"), "no cuts");
  EXPECT_EQ(counted(1, "cut"), "1 cut");
  EXPECT_EQ(counted(1200, "cut"), "1,200 cuts");
}

}  // namespace xnewell::THIS_FILE
