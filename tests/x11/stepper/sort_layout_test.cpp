#include "x11/stepper/sort_layout.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/x11/support/stepper.h"
#include "x11/drawing/painter.h"

namespace xnewell::THIS_FILE {

namespace {

/// Bodies of windows of 800 x 540 and more.
std::vector<Rect> bodies() {
  return {{16, 43, 768, 428},   {16, 43, 768, 449},  {16, 48, 992, 612}, {16, 48, 1248, 612},
          {16, 43, 1200, 449},  {8, 26, 744, 450},   {8, 26, 904, 432},  {16, 48, 768, 900},
          {16, 48, 1568, 1044}, {16, 48, 3000, 2000}};
}

std::vector<Rect> partsOf(const SortLayout& at) {
  std::vector<Rect> all{
      at.picture, at.table,    at.finding,
      at.step,    at.timeline, intersection(at.speed.area, at.body)};  // its thumb reaches into the margin
  if (at.shut)
    all.push_back(at.headline);
  else
    all.insert(all.end(), {at.side, at.list});
  for (const ControlPlace& toggle : at.toggles) all.push_back(toggle.area);
  all.insert(all.end(), at.transport.begin(), at.transport.end());
  all.insert(all.end(), at.kinds.options.begin(), at.kinds.options.end());
  return all;
}

}  // namespace

// All parts lie in the body and do not overlap, in every window with room for them.
TEST(SortLayout, PartsKeepApart) {
  for (const Rect& body : bodies()) {
    SCOPED_TRACE(std::to_string(body.width) + " x " + std::to_string(body.height));
    for (const auto& [shut, own] : {std::pair{false, false}, {true, false}, {false, true}, {true, true}}) {
      if (!shut && body.x < 16) continue;  // with the drawer shut, the margins are smaller
      const SortLayout at = layoutOfSort(body, shut, own);
      EXPECT_EQ(at.picture, layoutOfSort(body, shut).picture);
      if (own) {
        for (const Rect& act : at.acts) EXPECT_EQ(intersection(act, at.finding), act);
      }
      const std::vector<Rect> all = partsOf(at);
      for (std::size_t i = 0; i < all.size(); ++i) {
        ASSERT_FALSE(all[i].empty()) << i;
        ASSERT_EQ(intersection(all[i], body), all[i]) << i;
        for (std::size_t j = 0; j < i; ++j)
          ASSERT_TRUE(intersection(all[i], all[j]).empty()) << i << ' ' << j;
      }
      EXPECT_GE(at.picture.width, 400);
      EXPECT_GE(at.picture.height, 146);
      EXPECT_GE(at.rows(), shut ? 0 : 8);
      for (const Rect& answer : at.answers) EXPECT_EQ(intersection(answer, at.finding), answer);
      for (int k = 0; k < kToggleCount; ++k)
        EXPECT_GE(at.toggles[k].area.width, 17 + textWidth(kToggleNames[k])) << kToggleNames[k];
    }
  }
}

// No control that is drawn shares a pixel with another, and every control has a place. Where one can be
// clicked, the list finds it, up to its corners.
TEST(SortLayout, ControlsHavePlaces) {
  for (const auto& [width, height] : {std::pair{1024, 768}, {800, 540}, {800, 600}, {1600, 1200}}) {
    Stepper s{"nested-cycles", 3, width, height};
    s.press("y");
    for (int step = 0; step <= s.run().steps() && !s.bench.view().asking; ++step) s.press(NamedKey::Right);
    ASSERT_TRUE(s.bench.view().asking);
    s.draw();
    const Controls all = s.bench.controls();
    const auto& places = s.bench.list().places();
    ASSERT_EQ(all.size(), places.size());
    for (const auto& [id, place] : places) {
      const Rect& r = place.area;
      ASSERT_FALSE(r.empty()) << id.part;
      for (const auto& [other, there] : places)
        EXPECT_TRUE(other == id || intersection(r, there.area).empty()) << id.part << ' ' << other.part;
      for (const auto& [x, y] : {std::pair{r.x, r.y},
                                 {r.x + r.width / 2, r.y + r.height / 2},
                                 {r.x + r.width - 1, r.y + r.height - 1}}) {
        s.bench.hover(x, y);
        const Control* const found = s.bench.list().hovered(all);
        ASSERT_NE(found, nullptr) << id.part;
        EXPECT_EQ(found->id(), id);
      }
    }
    for (const auto& [x, y] : {std::pair{0, 0}, {s.places().body.x, s.places().rule}}) {
      s.bench.hover(x, y);
      EXPECT_EQ(s.bench.list().hovered(all), nullptr);
    }
  }
}

// Steps go along the timeline from end to end. If each step has its own column, the column leads back to the
// step. Otherwise it leads to one of the steps in that column.
TEST(SortLayout, ColumnsAndStepsAgree) {
  const Rect line{84, 591, 924, 60};
  for (const int steps : {0, 1, 2, 19, 300, 923, 924, 20339, 4000000}) {
    const TrackRange range{0, static_cast<double>(steps), 1, false, 0};
    const auto stepAt = [&](int x) {
      return static_cast<int>(valueAt(range, static_cast<double>(x - line.x) / (line.width - 1)));
    };
    EXPECT_EQ(columnOf(line, 0, steps), line.x);
    if (steps > 0) {
      EXPECT_EQ(columnOf(line, steps, steps), line.x + line.width - 1);
    }
    for (int step = 0; step <= steps; step += std::max(1, steps / 1000)) {
      const int column = columnOf(line, step, steps);
      ASSERT_EQ(columnOf(line, stepAt(column), steps), column);
      if (steps < line.width) {
        ASSERT_EQ(stepAt(column), step);
      }
    }
    EXPECT_EQ(stepAt(-1000), 0);
    EXPECT_EQ(stepAt(5000), steps);
  }
  for (int x = 0; x < 168; ++x)
    EXPECT_EQ(std::lround(167 * shareOf(kSpeeds, valueAt(kSpeeds, x / 167.0))), x);
  EXPECT_EQ(valueAt(kSpeeds, -0.1), kSpeeds.low);
  EXPECT_EQ(valueAt(kSpeeds, 1.1), kSpeeds.high);
}

}  // namespace xnewell::THIS_FILE
