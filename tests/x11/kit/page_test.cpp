#include "x11/kit/page.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace xnewell::THIS_FILE {

using namespace page;

namespace {

Table numbers(int rows, int chosen) {
  Table t{.key = "rows",
          .columns = {{"name", "name"},
                      {.head = "x", .key = "x", .right = true},
                      {.head = "remark", .weight = 1}},
          .chosen = chosen,
          .id = 1};
  for (int k = 0; k < rows; ++k)
    t.rows.push_back({{"row " + std::to_string(k), k},
                      {.data = k / 8.0, .number = k / 8.0},
                      {"a remark that takes some room"}});
  t.foot = {{{.words = "both columns", .span = 2}}};
  return t;
}

/// The lines that a page has in an area, and what had no room.
struct Drawn {
  Drawn(const Page& page, int width, int height) {
    const CellPlan plan{TableKind::Linear};
    Pen pen{Painter{image}, plan};
    pressed = draw(pen, page, {10, 10, width, height}, 16, {}, &leftOut);
  }
  IndexImage image{1000, 800, 0};
  std::vector<std::string> leftOut;
  std::vector<Pressed> pressed;
  /// Whether something is drawn beyond the area.
  [[nodiscard]] bool within(int width, int height) const {
    for (int j = 0; j < image.height; ++j)
      for (int i = 0; i < image.width; ++i)
        if (image.row(j)[i] != 0 && (i < 6 || i >= 14 + width || j < 6 || j >= 14 + height)) return false;
    return true;
  }
};

}  // namespace

// A page is told once: as text, with its marks taken out, and as JSON with all digits, in the order that it
// asks for.
TEST(Page, IsToldAsTextAndJson) {
  page::Section s{"1 numbers", "an aside"};
  s.add(numbers(2, 0));
  s.add(Fact{"sum", 0.125, "their sum is " + asked(2, "0.1250") + std::string{kTick}});
  s.fact("none", Data{});
  s.fact("list", List{1, 2.5, "a", true, Object{{"k", std::optional<double>{}}}});
  s.say("only words").indent = 2;
  const Page page{.of = "a page", .title = "fine", .sections = {s}, .order = "sum rows"};
  EXPECT_EQ(asText(page),
            "a page: fine\n1 numbers: an aside\n"
            "      name        x  remark\n"
            "      row 0  0.0000  a remark that takes some room\n"
            "      row 1  0.1250  a remark that takes some room\n"
            "      both columns\n"
            "      their sum is 0.1250\n"
            "        only words\n");
  EXPECT_EQ(asJson(page), R"({"sum":0.125,"rows":[{"name":0,"x":0.0},{"name":1,"x":0.125}],"none":null,)"
                          R"("list":[1,2.5,"a",true,{"k":null}]})"
                          "\n");
  EXPECT_EQ(asLines(page, {2})[6], "      their sum is ?");
  EXPECT_EQ(asLines(page, {3})[6], "      their sum is 0.1250");
}

// Of a table that has too little room, the chosen row is always there, with the first one; a line stands for
// the others. Nothing is drawn beyond the area.
TEST(Page, RowsOfALongTable) {
  for (const int rows : {1, 4, 9, 30})
    for (int chosen = 0; chosen < rows; ++chosen)
      for (const int height : {120, 170, 300}) {
        const Drawn drawn{{.sections = {{"t", "", {numbers(rows, chosen)}}}}, 300, height};
        std::set<int> shown;
        for (const Pressed& one : drawn.pressed) shown.insert(one.row);
        EXPECT_TRUE(shown.contains(chosen) && shown.contains(0)) << rows << ' ' << chosen << ' ' << height;
        EXPECT_TRUE(drawn.within(300, height)) << rows << ' ' << chosen << ' ' << height;
      }
}

// The lightest goes first, whatever stands above or below it; where there is room again, it stays.
TEST(Page, TheLightestGoesFirst) {
  page::Section s{"weights"};
  for (int weight = 1; weight <= 9; ++weight) s.say("weight " + std::to_string(weight), weight);
  s.say("never in a window", 0);
  for (int height = 60; height < 220; height += 10) {
    const Drawn drawn{{.sections = {s}}, 200, height};
    EXPECT_TRUE(drawn.within(200, height)) << height;
    EXPECT_FALSE(std::ranges::count(drawn.leftOut, "never in a window"));
    for (std::size_t k = 1; k <= 9; ++k)
      EXPECT_EQ(std::ranges::count(drawn.leftOut, "weight " + std::to_string(k)), k <= drawn.leftOut.size());
  }
}

// A narrow table gives up its remark, then decimals, and keeps its numbers; a finding gives up its last
// lines.
TEST(Page, ANarrowTableKeepsItsNumbers) {
  page::Section s{"t"};
  s.add(numbers(3, -1));
  s.add(
      page::Finding{.bold = "Found.", .why = "Why it is so, in a sentence that takes some lines of a box."});
  for (const int width : {60, 84, 120, 200, 400})
    EXPECT_TRUE(Drawn(Page{.sections = {s}}, width, 400).within(width, 400)) << width;
  EXPECT_EQ(Drawn(Page{.sections = {s}}, 200, 400).image == Drawn(Page{.sections = {s}}, 400, 400).image,
            false);
}

}  // namespace xnewell::THIS_FILE
