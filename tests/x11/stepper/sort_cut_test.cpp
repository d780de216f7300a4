#include <gtest/gtest.h>

#include "tests/x11/support/shown_sort_page.h"
#include "x11/stepper/sort_wording.h"

namespace xnewell::THIS_FILE {

// A cut keeps the names that its two polygons had in the tests before it, and the tests stay in the table.
// The words say which of the two is cut: the one that the record calls P.
TEST(SortPage, ACutKeepsTheNamesOfItsTests) {
  int cuts = 0, ofQ = 0;
  for (const char* const scene : {"penetrate", "teapot", "crossing-sheets"}) {
    SCOPED_TRACE(scene);
    ShownSortPage page{readScene(scene, 4)};
    for (int step = 2; step <= page.run->steps(); ++step) {
      const Event &cut = page.event(step), &tests = page.event(step - 1);
      if (cut.kind != Event::Kind::Split || tests.kind != Event::Kind::Compare) continue;
      page.show(step);
      const Event named = *page.run->asTested();
      EXPECT_EQ(named.P, tests.P);
      EXPECT_EQ(named.Q, tests.Q);
      const StepFinding finding = findingOf(*page.run, page.view);
      const bool P = cut.P == tests.P;
      EXPECT_EQ(finding.bold, P ? "P is cut in two." : "Q is cut in two.");
      EXPECT_NE(finding.why.find(P ? "P is split by the plane of Q" : "Q is split by the plane of P"),
                std::string::npos)
          << finding.why;
      const Rect& table = page.at.table;
      const auto rows = [&] {
        std::vector<std::uint8_t> cells;
        for (int y = table.y + page.at.line; y < table.y + table.height; ++y)
          cells.insert(cells.end(), page.image.row(y) + table.x, page.image.row(y) + table.x + table.width);
        return cells;
      };
      const std::vector<std::uint8_t> atCut = rows();
      page.show(step - 1);
      EXPECT_EQ(rows(), atCut);
      ++cuts, ofQ += !P;
    }
  }
  EXPECT_GT(cuts, 20);
  EXPECT_GT(ofQ, 5);
}

}  // namespace xnewell::THIS_FILE
