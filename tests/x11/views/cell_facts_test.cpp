#include "x11/views/cell_facts.h"
#include "shading/picture/picture_cache.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace xnewell::THIS_FILE {

namespace {

/// The numbers in a text like `0.1868 <= I < 0.1899`, if it has them, and how many decimals they have.
struct Interval {
  double from = -1, to = -1;
  int decimals = 0;
};
Interval parsed(const std::string& text) {
  Interval interval;
  const auto number = [&](std::size_t at) {
    double v = 0;
    const char* const end = std::from_chars(text.data() + at, text.data() + text.size(), v).ptr;
    interval.decimals = static_cast<int>(end - text.data() - at) - 2;
    return v;
  };
  if (text[0] != 'I') interval.from = number(0);
  if (const std::size_t less = text.find("I < "); less != std::string::npos) interval.to = number(less + 4);
  return interval;
}

std::string valueOf(const std::vector<CellFact>& facts, std::string_view label) {
  const auto fact = std::ranges::find(facts, label, &CellFact::label);
  return fact == facts.end() ? "" : fact->value;
}

struct Made {
  Picture picture;
  CellUse use;
  Palette palette;
  CellPlan plan;
};
Made made(const char* scene, ColorPlan colors, const TableSettings& table) {
  PictureSettings s;
  s.width = 320, s.height = 240;
  s.shading = Shading::Gouraud;
  s.colors = colors;
  s.table = table;
  const CellPlan plan{table.kind};
  const Picture picture = makePicture(readScene(scene, 8), s, plan[Cell::Well]);
  return {picture, cellUse(picture.image(), picture.faceImage()), picture.palette(plan), plan};
}

}  // namespace

// The printed ends of a cell's interval are right, for every shade of every table. Numbers with the printed
// decimals pick the cell if and only if they are at least the first end and below the second.
TEST(CellFacts, TheIntervalPicksExactlyThatShade) {
  int checked = 0;
  for (const TableRow& row : kTables)
    for (const int shades : {2, 3, 17, 64, 240})
      for (const double I0 : {1e-6, 0.02, 0.5})
        for (const PickRow& pick : kPicks) {
          const ColorTable table{{.kind = row.id, .shades = shades, .I0 = I0, .pick = pick.id}};
          for (int j = 0; j < shades; ++j) {
            const std::string text = pickedText(table, j);
            SCOPED_TRACE(std::string{row.name} + ' ' + std::to_string(shades) + ' ' + text);
            const auto [from, to, decimals] = parsed(text);
            ASSERT_GE(decimals, 4);
            const double unit = std::pow(10, -decimals);
            ASSERT_EQ(from < 0, j == 0);
            ASSERT_EQ(to < 0, j == shades - 1);
            if (j > 0) {
              ASSERT_EQ(table.shade(from), j);
              ASSERT_LT(table.shade(from - unit * (1 - 1e-9)), j);
            }
            if (j < shades - 1) {
              ASSERT_GT(table.shade(to), j);
              ASSERT_EQ(table.shade(to - unit * (1 - 1e-9)), j);
            }
            ++checked;
          }
        }
  EXPECT_GT(checked, 5'000);
}

// A worked example: the facts of cell 148 of the corrected table.
TEST(CellFacts, OfTheCorrectedTable) {
  const Made m = made("teapot", ColorPlan::OneHue, {.kind = TableKind::Corrected});
  const std::vector<CellFact> facts = factsOf(148, m.picture, m.palette, m.plan, m.use);
  EXPECT_EQ(valueOf(facts, "stored RGB"), "(12342, 0, 0) of 65535, 0x3036");
  EXPECT_EQ(valueOf(facts, "8 bits"), "(48, 0, 0) of 255");
  EXPECT_EQ(valueOf(facts, "intensity"), "I_137 = r^137 I0 = 0.1883");
  EXPECT_EQ(valueOf(facts, "shown when"), "0.1868 <= I < 0.1899");
  EXPECT_EQ(valueOf(facts, "step to next"), "1.65 % brighter");
}

// The facts name as many users of a cell as were counted.
TEST(CellFacts, TellTheUse) {
  const Made m = made("teapot", ColorPlan::OneHue, {.kind = TableKind::Linear});
  int used = 0;
  for (int cell = 11; cell <= 250; ++cell) {
    const std::string text = valueOf(factsOf(cell, m.picture, m.palette, m.plan, m.use), "used by");
    const int n = m.use.samples[cell], p = m.use.polygons[cell];
    if (n == 0) {
      EXPECT_EQ(text, "no sample");
    } else if (n > 1 && n < 1000 && p > 1) {
      EXPECT_EQ(text, std::to_string(n) + " samples, " + std::to_string(p) + " polygons");
      ++used;
    }
  }
  EXPECT_GT(used, 50);
}

// Every cell has facts in every plan. The tool's cells say what they are for, and free cells say that nothing
// needs them.
TEST(CellFacts, EveryCellHasSome) {
  for (const auto& [scene, plan] : {std::pair{"teapot", ColorPlan::OneHue},
                                    {"hues", ColorPlan::Hues},
                                    {"hues", ColorPlan::Cube},
                                    {"hues", ColorPlan::Chosen}}) {
    const Made m = made(scene, plan, {.shades = 100});
    int tools = 0, free = 0;
    for (int cell = 0; cell < 256; ++cell) {
      const std::vector<CellFact> facts = factsOf(cell, m.picture, m.palette, m.plan, m.use);
      EXPECT_GE(facts.size(), 3u);
      EXPECT_LE(facts.size(), 7u);
      const std::string holds = valueOf(facts, "holds");
      tools += holds.starts_with("the tool's own: ");
      free += holds == "nothing of ours: a free cell";
    }
    EXPECT_EQ(tools, kCells);
    EXPECT_EQ(free, 240 - sceneCells(m.picture).count);
  }
}

}  // namespace xnewell::THIS_FILE
