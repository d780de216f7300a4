#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "tests/x11/support/ready_workbench.h"
#include "x11/drawing/wording.h"
#include "x11/scanline/scanline_page.h"
#include "x11/scanline/scanline_view.h"

namespace xnewell::THIS_FILE {

namespace {

/// A window at view 0.
struct ScanlineWindow : ReadyWorkbench {
  explicit ScanlineWindow(Shading shading = Shading::Gouraud, const char* scene = "teapot")
      : ReadyWorkbench{shaded(shading), 1024, 768, scene} {
    does('0');
  }
  static xnewell::Setup shaded(Shading shading) {
    xnewell::Setup setup;
    setup.picture.shading = shading;
    return setup;
  }
  [[nodiscard]] const ScanlineView& view0() const { return dynamic_cast<const ScanlineView&>(bench()); }
  [[nodiscard]] const ScanlineRun& run() const { return *view0().run(); }
  [[nodiscard]] int step() const { return view0().view().step; }
  [[nodiscard]] ScanSample sample() const { return run().samples()[step() - 1]; }
  void answer(const std::string& text) {
    for (const char c : text) press(c);
    does(NamedKey::Return);
  }
};

}  // namespace

// It begins with a polygon that shows, of a size that fills the grid, partly filled. The arrows, Home, End
// and j go along its samples, and the strip marks the cell of each.
TEST(ScanlineView, StepsAlongThePolygon) {
  ScanlineWindow b;
  EXPECT_EQ(b.view(), View::Scanline);
  EXPECT_GT(b.run().steps(), 60);
  EXPECT_LT(b.run().steps(), 700);
  EXPECT_NEAR(b.step(), 0.6 * b.run().steps(), 1);
  b.does(NamedKey::Home);
  EXPECT_EQ(b.step(), 0);
  EXPECT_EQ(b.bench().inspected(), std::nullopt);
  EXPECT_TRUE(b.bench().status().starts_with("before the first sample")) << b.bench().status();
  b.does(NamedKey::Right);
  EXPECT_EQ(b.bench().inspected(), b.sample().steppedCell);
  b.does({NamedKey::Right, 0, true});
  EXPECT_EQ(b.step(), 11);
  b.does('j');  // the next row
  EXPECT_EQ(b.sample().column, b.run().spanOf(b.sample()).from);
  EXPECT_GT(b.sample().span, 0);
  b.does(NamedKey::End);
  EXPECT_EQ(b.step(), b.run().steps());
}

// A click in the grid goes to its sample; a click in the small picture fills the polygon there.
TEST(ScanlineView, TheMouseChooses) {
  ScanlineWindow b;
  const ScanlineLayout at = layoutOfScanline(b.layout().body);
  const ScanSample target = b.run().samples()[b.run().samples().size() / 3];
  const GridWindow window = gridWindow(at.grid, b.run(), b.step());
  const int row = b.run().spanOf(target).row;
  b.click(at.grid.x + (target.column - window.column) * window.side + 1,
          at.grid.y + (row - window.row) * window.side + 1);
  EXPECT_EQ(b.sample().column, target.column);
  EXPECT_EQ(b.run().spanOf(b.sample()).row, row);

  const std::string before = b.view0().polygon();
  const int scale = overviewScale(at.overview, b.picture().image(), 1);
  const PictureSettings& settings = b.picture().settings();
  const int i = settings.width / 2 / scale * scale, j = settings.height / 2 / scale * scale;
  const int face = b.picture().seen(j, j + 1).faces[i];
  b.click(at.overview.x + i / scale, at.overview.y + j / scale);
  EXPECT_NE(b.view0().polygon(), before);
  EXPECT_EQ(b.run().face(), face);
}

// Before the first sample, the page does not show what y may ask for: its value and its cell.
TEST(ScanlineView, TheFirstCellIsNotTold) {
  ScanlineWindow b;
  b.does(NamedKey::Home);
  const IndexImage before = b.image();
  b.does(NamedKey::Right);
  const ScanlineLayout at = layoutOfScanline(b.layout().body);
  const std::uint8_t ground = before.row(at.choices - at.line)[at.column.x];
  // The last two lines of the span, its first sample and the pixel, come with the step.
  const auto inkAt = [&](const IndexImage& image, int y) {
    int ink = 0;
    for (int j = y; j < y + at.line; ++j)
      for (int i = at.column.x; i < at.column.x + at.column.width; ++i) ink += image.row(j)[i] != ground;
    return ink;
  };
  int filled = 0;
  for (int y = at.column.y + at.column.height / 3; y + at.line < at.choices; y += at.line)
    filled += inkAt(before, y) == 0 && inkAt(b.image(), y) > 0;
  EXPECT_GE(filled, 4);  // the two lines, and those about the pixel
}

// A key that comes before the view is ready counts when it is.
TEST(ScanlineView, EarlyKeysCount) {
  ScanlineWindow b;
  b.does('1');
  b.press('0');
  b.does(NamedKey::Home);
  EXPECT_EQ(b.step(), 0);
}

// With fewer bits the drift is larger. Where no bits can be chosen, the control shows the 24 bits that count,
// and the last choice comes back.
TEST(ScanlineView, BitsThatDoNotCountAreNotShown) {
  ScanlineWindow b{Shading::Gouraud};
  const auto bits = [&] {
    const Controls all = b.bench().controls();
    const Control& control = *std::ranges::find(all, 'B', &Control::key);
    return control.options[static_cast<int>(control.value)] + (control.off.empty() ? "" : " off");
  };
  const double fine = b.run().mostDrift();
  while (bits() != "8") b.does('B');
  EXPECT_GT(b.run().mostDrift(), 1000 * fine);
  while (b.setup().picture.shading != Shading::Flat) b.does('S');
  EXPECT_EQ(bits(), "24 off");
  EXPECT_TRUE(b.run().isConstant());
  while (b.setup().picture.shading != Shading::Gouraud) b.does('S');
  EXPECT_EQ(bits(), "8");
}

// The finding's bound: half a step for each pixel and row between corner A and a sample, counted here over
// all samples. No sample drifts more; a cell more is due to the two ends, which are rounded once each.
TEST(ScanlineView, TheBoundOfTheDriftHolds) {
  ScanlineWindow b;
  for (int polygons = 0; polygons < 20; ++polygons, b.does('h')) {
    const std::string why = findingOf(b.run(), nullptr).why;
    const std::size_t end = why.find(" additions err by half a step");
    ASSERT_NE(end, std::string::npos) << why;
    const int told = std::stoi(why.substr(why.rfind(' ', end - 1)));
    double most = 0;
    for (const ScanSample& sample : b.run().samples()) {
      const glm::ivec3 A = b.run().parts()[sample.part].outline.front();
      const double away = std::abs(sample.column + 0.5 - A.x / 65536.0) +
                          std::abs(b.run().spanOf(sample).row + 0.5 - A.y / 65536.0);
      most = std::max(most, away);
      EXPECT_LE(std::ldexp(std::abs(sample.stepped - sample.direct), b.run().bits()), away / 2 + 1);
    }
    EXPECT_EQ(told, static_cast<int>(std::ceil(most)));
  }
}

// The corners of a flat surface have one N, so no sum of them is short: the finding does not say that one is.
// The words fit their box in a small window.
TEST(ScanlineView, AFlatSurfaceHasNoShortNormals) {
  int flat = 0;
  for (const char* scene : {"cycle", "teapot"}) {
    ScanlineWindow b{Shading::Phong, scene};
    const Finding finding = findingOf(b.run(), nullptr);
    const bool says = finding.bold.find("its length is not 1") != std::string::npos;
    double shortest = 1;
    for (const ScanSample& sample : b.run().samples())
      shortest = std::min(shortest, glm::length(b.run().explained(sample).sum));
    EXPECT_EQ(says, shortest < 0.99995) << finding.bold << finding.why;
    EXPECT_EQ(says, finding.why.find("as short as") != std::string::npos);
    flat += !says;
  }
  EXPECT_EQ(flat, 1);
  const Rect box = layoutOfScanline(layoutOf(800, 540).body).finding;
  for (const Shading shading : {Shading::Full, Shading::Flat, Shading::Phong, Shading::Environment}) {
    ScanlineWindow b{shading};
    const Finding finding = findingOf(b.run(), nullptr);
    EXPECT_LE(broken(finding.why, (box.width - 20) / 6).size(), 2u) << finding.why;
  }
}

// The book's lines have the numbers of the step: exactly one runs, those of the row only at its first sample.
TEST(ScanlineView, TheBooksLinesRun) {
  ScanlineWindow b;
  int rows = 0;
  for (int step = 1; step <= b.run().steps(); ++step) {
    const std::vector<CodeLine> lines = scanlineCode(b.run(), step);
    ASSERT_EQ(std::ranges::count(lines, CodeLine::Ran::Now, &CodeLine::ran), 1);
    const auto now = std::ranges::find(lines, CodeLine::Ran::Now, &CodeLine::ran);
    EXPECT_EQ(now->values, "cell " + std::to_string(b.run().samples()[step - 1].directCell));
    rows += lines.front().ran == CodeLine::Ran::Before;
  }
  EXPECT_EQ(rows, static_cast<int>(b.run().marks(ScanMark::Row).size()));
  // With 8 bits, too, the value that is painted is the one whose whole part is the cell.
  while (b.run().bits() != 8) b.does('B');
  int other = 0;
  for (int step = 1; step <= b.run().steps(); ++step) {
    const ScanSample& sample = b.run().samples()[step - 1];
    const std::vector<CodeLine> lines = scanlineCode(b.run(), step);
    const auto adds = std::ranges::find_if(
        lines, [](const CodeLine& line) { return line.text.find("V = V + d") != std::string::npos; });
    ASSERT_NE(adds, lines.end());
    EXPECT_EQ(static_cast<int>(std::stod(adds->values)), sample.steppedCell) << adds->values;
    other += sample.steppedCell != sample.directCell;
  }
  EXPECT_GT(other, 0);
}

}  // namespace xnewell::THIS_FILE
