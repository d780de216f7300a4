#include "x11/views/wireframe.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "depthsort/fragment_spans.h"
#include "depthsort/oracle.h"
#include "geometry/model/solids.h"
#include "shading/picture/picture_cache.h"

namespace xnewell::THIS_FILE {

namespace {

PictureSettings viewOf(const Scene& scene, Order order) {
  PictureSettings s;
  s.width = 300, s.height = 220;
  s.order = order;
  s.camera = completed({}, scene.camera);
  return s;
}

/// For each sample, the pieces of faces that cover it, as (face, piece).
std::vector<std::set<std::pair<int, int>>> piecesAt(const Picture& picture) {
  const PictureSettings& s = picture.settings();
  std::vector<std::set<std::pair<int, int>>> at(std::size_t(s.width) * s.height);
  for (const Fragment& fragment : picture.sorted().fragments) {
    if (fragment.piece < 0) continue;
    forEachSpan(picture.snapped(), picture.sorted(), fragment, s.width, s.height,
                [&](int row, int from, int to) {
                  for (int i = from; i < to; ++i)
                    at[std::size_t(row) * s.width + i].insert({fragment.face, fragment.piece});
                });
  }
  return at;
}

bool isDash(std::uint8_t cell) {
  const CellPlan plan;
  return cell == plan[Cell::White] || cell == plan[Cell::Soft];
}

}  // namespace

// A cube seen from a corner shows nine of its twelve edges, and three are hidden. Three of its six polygons
// are seen from behind.
TEST(Wireframe, OfACubeIsCounted) {
  PictureCache pictures{makeScene("cube", cube(), UpAxis::Z)};
  PictureSettings s = viewOf(pictures.scene(), Order::Newell);
  s.camera.eye = glm::dvec3{6, -5, 4};
  pictures.make(s);
  const Wireframe wires = wireframeOf(pictures.last(), CellPlan{});
  EXPECT_EQ(wires.polygons, 6);
  EXPECT_EQ(wires.back, 3);
  EXPECT_EQ(wires.edges, 12);
  EXPECT_EQ(wires.cuts, 0);
  const auto hidden = std::ranges::count(wires.image.pixels, CellPlan{}[Cell::WellLine]),
             showing = std::ranges::count(wires.image.pixels, CellPlan{}[Cell::WellText]);
  EXPECT_GT(hidden, 60);
  EXPECT_GT(showing, 2 * hidden);
  EXPECT_EQ(hidden + showing + std::ranges::count(wires.image.pixels, CellPlan{}[Cell::Well]), 300 * 220);
}

// Edges are dashed only along cuts: next to each dashed pixel two pieces of one face meet. Where pieces meet
// there are dashes, except for the gaps.
TEST(Wireframe, DashesWhereACutRuns) {
  for (const char* const name : {"penetrate", "cycle"}) {
    SCOPED_TRACE(name);
    PictureCache pictures{readScene(name)};
    pictures.make(viewOf(pictures.scene(), Order::Newell));
    const Wireframe wires = wireframeOf(pictures.last(), CellPlan{});
    EXPECT_EQ(wires.cuts, pictures.last().sorted().statistics.splits);
    ASSERT_GT(wires.cuts, 0);
    const auto pieces = piecesAt(pictures.last());
    const int W = wires.image.width, H = wires.image.height;
    int dashes = 0, borders = 0, near = 0;
    const auto around = [&](int x, int y, int reach, auto&& use) {
      for (int j = std::max(0, y - reach); j <= std::min(H - 1, y + reach); ++j)
        for (int i = std::max(0, x - reach); i <= std::min(W - 1, x + reach); ++i) use(j * W + i);
    };
    for (int y = 0; y < H; ++y)
      for (int x = 0; x < W; ++x) {
        std::set<std::pair<int, int>> beside;
        around(x, y, 1, [&](int k) { beside.insert(pieces[k].begin(), pieces[k].end()); });
        bool meet = false;
        for (auto p = beside.begin(); p != beside.end() && std::next(p) != beside.end(); ++p)
          meet |= p->first == std::next(p)->first;
        if (isDash(wires.image.row(y)[x])) {
          ++dashes;
          ASSERT_TRUE(meet) << x << ", " << y;
        }
        if (!meet) continue;
        ++borders;
        bool dash = false;  // or an edge drawn over it
        around(x, y, kDashPeriod, [&](int k) { dash |= isDash(wires.image.pixels[k]); });
        near += dash;
      }
    EXPECT_GT(dashes, 8);
    EXPECT_GT(near, borders * 9 / 10);
  }
}

// An order that cuts nothing has the same edges and no dashes.
TEST(Wireframe, WithoutCutsNothingIsDashed) {
  PictureCache pictures{readScene("penetrate")};
  pictures.make(viewOf(pictures.scene(), Order::Newell));
  const Wireframe cut = wireframeOf(pictures.last(), CellPlan{});
  EXPECT_GT(std::ranges::count_if(cut.image.pixels, isDash), 20);
  for (const Order order : {Order::Unsorted, Order::ZMean, Order::ZSort, Order::ZBuffer16, Order::Oracle}) {
    pictures.make(viewOf(pictures.scene(), order));
    const Wireframe wires = wireframeOf(pictures.last(), CellPlan{});
    EXPECT_EQ(wires.cuts, 0);
    EXPECT_EQ(std::ranges::count_if(wires.image.pixels, isDash), 0);
    EXPECT_EQ(wires.edges, cut.edges);
    EXPECT_EQ(wires.polygons, cut.polygons);
    EXPECT_EQ(findingOf(wires, pictures.last()).bold, "Nothing is cut.");
  }
  // A BSP tree of two plates that pass through each other makes one cut, too.
  pictures.make(viewOf(pictures.scene(), Order::Bsp));
  const Wireframe tree = wireframeOf(pictures.last(), CellPlan{});
  EXPECT_EQ(tree.cuts, 1);
  EXPECT_GT(std::ranges::count_if(tree.image.pixels, isDash), 20);
  EXPECT_EQ(findingOf(tree, pictures.last()).bold, "The BSP tree cut once.");
}

// Visible lines lie next to samples of their polygons: a pixel with only another face around it is never
// bright.
TEST(Wireframe, BrightLinesLieOnWhatShows) {
  PictureCache pictures{readScene("teapot", 3)};
  pictures.make(viewOf(pictures.scene(), Order::Newell));
  const Wireframe wires = wireframeOf(pictures.last(), CellPlan{});
  const SeenRows seen = pictures.last().seen(0, wires.image.height);
  int bright = 0, inside = 0;
  for (int y = 1; y + 1 < wires.image.height; ++y)
    for (int x = 1; x + 1 < wires.image.width; ++x) {
      if (wires.image.row(y)[x] != CellPlan{}[Cell::WellText]) continue;
      ++bright;
      std::set<int> faces;
      for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i) faces.insert(seen.faces[std::size_t(y + j) * seen.width + x + i]);
      ASSERT_FALSE(faces.size() == 1 && faces.contains(kNothing)) << x << ", " << y;
      inside += faces.size() > 1;
    }
  EXPECT_GT(bright, 1000);
  EXPECT_GT(inside, bright * 9 / 10);  // an edge lies where the visible face changes
}

}  // namespace xnewell::THIS_FILE
