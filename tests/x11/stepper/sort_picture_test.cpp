#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "tests/x11/support/shown_sort_page.h"

namespace xnewell::THIS_FILE {

// What stands over the picture of the stepper: the loupe and the words.

// The loupe stands in the lower right corner, and elsewhere only if it would hide a part of P or Q there. So
// it seldom jumps.
TEST(SortPage, TheLoupeSeldomJumps) {
  ShownSortPage page{readScene("teapot", 3)};
  const Rect& picture = page.at.picture;
  int jumps = 0, steps = 0, elsewhere = 0;
  bool before = true;
  for (int step = 1; step <= 1000; ++step) {
    page.show(step);
    const Rect& now = page.drawn.loupe;
    const std::optional<Event> event = page.run->asTested();
    if (now.empty() || !event) continue;
    const bool usual = now.x > picture.x + picture.width / 4 && now.y > picture.y + picture.height / 4;
    jumps += usual != before;
    before = usual;
    ++steps;
    if (usual) continue;
    ++elsewhere;
    bool met = false;  // the loupe in the lower right would begin right of the middle, and below a third
    for (const int id : {event->P, event->Q}) {
      if (id < 0) continue;
      const Range x = page.run->explainer().xExtent(id), y = page.run->explainer().yExtent(id);
      met |= x.high >= picture.width / 2 && y.high >= picture.height / 3;
    }
    EXPECT_TRUE(met) << step;
  }
  EXPECT_GT(steps, 150);  // of large polygons there is none
  EXPECT_GT(elsewhere, 0);
  EXPECT_LT(jumps, steps / 5);
}

// A name stands on what the finished picture shows of its polygon, so no name is on another.
TEST(SortPage, NamesStandOnTheirPolygons) {
  for (const char* scene : {"cycle", "coarse-teapot"}) {
    ShownSortPage page{readScene(scene, 3)};
    page.show(page.run->steps() / 2);
    std::vector<int> ids = page.run->waiting();
    for (int n = 0; n < page.run->replay().painted(); ++n) ids.push_back(page.run->paintedId(n));
    const glm::ivec2 size{12, 10};
    const int width = page.run->picture().settings().width;
    const std::vector<std::uint32_t> faces = page.picture->faceImage();
    std::vector<bool> taken(faces.size());
    int found = 0;
    for (const int id : ids)
      if (const auto corner = page.run->roomFor(id, size)) {
        ++found;
        for (int k = 0; k < size.x * size.y; ++k) {
          const std::size_t at = std::size_t(corner->y + k / size.x) * width + corner->x + k % size.x;
          ASSERT_EQ(faces[at], static_cast<std::uint32_t>(page.run->fragments().face(id).number) + 1);
          ASSERT_FALSE(taken[at]);
          taken[at] = true;
        }
      }
    EXPECT_GT(found, 2) << scene;
  }
}

// The words about the picture so far stand at its top, unless a part of P or Q is there; then they stand at
// its foot, if the foot is free.
TEST(SortPage, WordsKeepClearOfPAndQ) {
  Scene near = readScene("teapot", 3);
  near.camera.fov = 12;  // polygons everywhere
  ShownSortPage page{std::move(near)};
  page.view.loupe = false;
  const Rect& picture = page.at.picture;
  const auto wordsIn = [&](int y, int height) {
    int count = 0;
    for (int j = picture.y + y; j < picture.y + y + height; ++j)
      count += static_cast<int>(std::count(page.image.row(j) + picture.x + 10,
                                           page.image.row(j) + picture.x + 200, page(Cell::WellText)));
    return count;
  };
  int above = 0, below = 0;
  for (int step = 1; step <= page.run->steps(); step += 7) {
    page.show(step);
    const Event event = page.event(step);
    bool high = false;
    for (const int id : {event.P, event.Q})
      if (id >= 0) {
        const Range x = page.run->explainer().xExtent(id), y = page.run->explainer().yExtent(id);
        high |= x.low < 400 && y.low < 21;
      }
    const bool isAbove = wordsIn(7, 14) > 50;
    EXPECT_NE(isAbove, wordsIn(picture.height - 20, 14) > 50) << step;
    EXPECT_TRUE(isAbove || high) << step;
    (isAbove ? above : below) += 1;
  }
  EXPECT_GT(above, 20);
  EXPECT_GT(below, 20);
}

}  // namespace xnewell::THIS_FILE
