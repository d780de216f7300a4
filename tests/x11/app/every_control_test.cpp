#include <gtest/gtest.h>

#include <algorithm>

#include "tests/x11/support/ready_workbench.h"
#include "x11/window/drawer.h"

namespace xnewell::THIS_FILE {

// Every control of every view, at every scale: the pointer finds it exactly where it is drawn.

namespace {

constexpr int kMark = 8;   // a selected row has its mark at the left of its area
constexpr int kFrame = 2;  // in a low window the frame of an option reaches into the space between rows

/// The smallest rectangle that has all pixels outside `but` that differ.
Rect changed(const IndexImage& a, const IndexImage& b, const Rect& but) {
  int x0 = a.width, y0 = a.height, x1 = -1, y1 = -1;
  for (int j = 0; j < a.height; ++j) {
    if (std::equal(a.row(j), a.row(j) + a.width, b.row(j))) continue;
    for (int i = 0; i < a.width; ++i)
      if (a.row(j)[i] != b.row(j)[i] && intersection(but, {i, j, 1, 1}).empty())
        x0 = std::min(x0, i), y0 = std::min(y0, j), x1 = std::max(x1, i), y1 = std::max(y1, j);
  }
  return x1 < 0 ? Rect{} : Rect{x0, y0, x1 - x0 + 1, y1 - y0 + 1};
}

struct Screen {
  int width, height, unit;
};

/// Visits the places of all controls that the view has drawn. Returns how many changed under the pointer.
int visit(ReadyWorkbench& b, int unit) {
  const auto places = b.bench().list().places();
  const Rect all{0, 0, b.layout().width, b.layout().height};
  b.hover(0, 0);
  b.finish();
  const IndexImage before = b.image();
  int answered = 0;
  for (std::size_t p = 0; p < places.size(); ++p) {
    const auto& [id, place] = places[p];
    if (place.passive || place.area.empty()) continue;
    SCOPED_TRACE(testing::Message() << "key '" << id.key << "' part " << id.part);
    EXPECT_EQ(intersection(place.area, all), place.area);
    for (std::size_t q = 0; q < p; ++q)
      if (!places[q].second.passive && places[q].first.key != id.key) {
        EXPECT_TRUE(intersection(place.area, places[q].second.area).empty()) << places[q].first.key;
      }
    if (place.bare) continue;
    const int x = place.area.x + place.area.width / 2, y = place.area.y + place.area.height / 2;
    b.hover(x * unit + unit / 2, y * unit + unit / 2);
    b.finish();
    const Controls controls = b.bench().controls();
    const Control* const hit = b.bench().list().hovered(controls);
    EXPECT_TRUE(hit != nullptr);
    if (hit == nullptr) continue;
    EXPECT_EQ(hit->id(), id);
    const Rect differs = changed(before, b.image(), b.layout().status * unit);
    const Rect mayDiffer =
        Rect{place.area.x - kMark, place.area.y, place.area.width + 2 * kMark, place.area.height + kFrame} *
        unit;
    if (differs.empty()) continue;
    ++answered;
    EXPECT_EQ(intersection(differs, mayDiffer), differs);
  }
  return answered;
}

}  // namespace

TEST(EveryControl, IsHitWhereItIsDrawn) {
  for (const auto& [width, height, unit] :
       {Screen{800, 600, 1}, {1024, 768, 1}, {1920, 1080, 2}, {2400, 1700, 3}}) {
    SCOPED_TRACE(testing::Message() << width << " x " << height << " at scale " << unit);
    ReadyWorkbench b{{}, width, height};
    b.scale(unit);
    int answered = 0;
    for (const ViewRow& row : kWindowViews) {
      SCOPED_TRACE(row.name);
      b.switchTo(row.id);
      b.update();
      if (row.id == View::Trade) continue;  // it changes while it measures
      b.finish();
      ASSERT_EQ(b.layout().unit, unit);
      answered += visit(b, unit);
    }
    EXPECT_GT(answered, 20);
  }
}

// D gives the room of the controls to the picture, and the handle at the edge gives it back: with every
// control where it was, and found there.
TEST(EveryControl, CanBePutAway) {
  for (const auto& [width, height, unit] :
       {Screen{800, 600, 1}, {1024, 768, 1}, {1920, 1080, 2}, {3840, 2160, 2}, {2400, 1700, 3}}) {
    SCOPED_TRACE(testing::Message() << width << " x " << height << " at scale " << unit);
    ReadyWorkbench b{{}, width, height};
    b.scale(unit);
    for (const View view : {View::Picture, View::DepthSort}) {
      b.switchTo(view);
      b.update();
      b.finish();
      const IndexImage before = b.image();
      const auto places = b.bench().list().places();
      const auto room = [&] {
        return view == View::Picture ? b.layout().well : b.bench().picture(b.layout());
      };
      const Rect picture = room();
      b.type("D");
      b.finish();
      const Rect larger = room();
      EXPECT_GT(larger.width * larger.height, picture.width * picture.height);
      EXPECT_TRUE(b.bench().list().find({kDrawerKey}));
      visit(b, unit);
      const Rect handle = b.layout().handle;
      EXPECT_TRUE(intersection(handle, larger).empty());
      EXPECT_FALSE(b.grab((handle.x + 12) * unit, (handle.y + handle.height / 2) * unit));
      b.settle();
      b.hover(0, 0);
      b.finish();
      EXPECT_EQ(b.bench().list().places().size(), places.size());
      // Below stands how long the picture took.
      EXPECT_TRUE(changed(before, b.image(), b.layout().status * unit).empty());
    }
  }
  ReadyWorkbench b;
  b.switchTo(View::Colors);
  b.finish();
  b.type("D");  // this view has no drawer
  EXPECT_EQ(b.layout().drawer, Drawer::Whole);
}

}  // namespace xnewell::THIS_FILE
