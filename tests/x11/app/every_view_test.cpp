#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "geometry/files/text_file.h"
#include "tests/support/seeds.h"
#include "tests/x11/support/find_text.h"
#include "tests/x11/support/ready_workbench.h"
#include "x11/app/key_lists.h"
#include "x11/stepper/sort_view.h"
#include "x11/window/layout.h"

namespace xnewell::THIS_FILE {

namespace {

/// What a key may change, as the user can tell.
auto seenIn(const Workbench& b) {
  return std::tuple{b.image(), b.palette(), b.setup(), b.view(), b.isAsking(), b.quitAsked(), b.moving()};
}

std::string nameOf(const ViewRow& row) { return std::string{row.name}; }

/// The keys that lead to each view, and more such.
std::vector<std::string> waysToViews(std::vector<std::string> ways) {
  for (const ViewRow& row : kWindowViews) ways.emplace_back(1, row.key);
  return ways;
}

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

/// The places of all controls that the view has drawn: all are in the window, and no two share a pixel unless
/// one of them lies above.
void expectPlaces(const ReadyWorkbench& b) {
  const auto& places = b.bench().list().places();
  for (std::size_t p = 0; p < places.size(); ++p) {
    const auto& [id, place] = places[p];
    SCOPED_TRACE(testing::Message() << "key '" << id.key << "' part " << id.part);
    EXPECT_FALSE(place.area.empty());
    EXPECT_EQ(intersection(place.area, {0, 0, b.layout().width, b.layout().height}), place.area);
    for (std::size_t q = 0; q < p; ++q) {
      const auto& [other, there] = places[q];
      if (place.above == there.above || (!place.passive && !there.passive && other.key != id.key)) {
        EXPECT_TRUE(intersection(place.area, there.area).empty()) << other.key << other.part;
      }
    }
  }
}

/// Visits these places with the pointer. Returns how many changed under it.
int visit(ReadyWorkbench& b, int unit) {
  const auto places = b.bench().list().places();
  b.pointAt(0, 0);
  const IndexImage before = b.image();
  int answered = 0;
  for (const auto& [id, place] : places) {
    if (place.passive || place.area.empty() || place.bare) continue;
    SCOPED_TRACE(testing::Message() << "key '" << id.key << "' part " << id.part);
    const int x = place.area.x + place.area.width / 2, y = place.area.y + place.area.height / 2;
    b.pointAt(x * unit + unit / 2, y * unit + unit / 2);
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

// Whatever a view says of its keys and controls is true of every view, at every scale: the pointer finds a
// control exactly where it is drawn.

// No view has a key twice, nor a control, by which the pointer would find another; and every key has words in
// the list of all keys. So has the page on which the student sorts, also after t.
TEST(EveryView, KeysAreUniqueAndExplained) {
  for (const char* scene : someOf({"cycle", "hues", "teapot"}, 1))
    for (const std::string& way : waysToViews({"2Y", "2Yt"})) {
      SCOPED_TRACE(scene + way);
      ReadyWorkbench b{{}, 1024, 768, scene};
      for (const char key : way) b.does(key);
      std::set<std::pair<NamedKey, char>> taken;
      for (const KeyRow& keys : b.keys()) {
        EXPECT_FALSE(keys.does.empty())
            << (keys.keys.empty() ? keys.gesture : xnewell::nameOf(keys.keys.front()));
        for (const Key& key : keys.keys)
          EXPECT_TRUE(taken.insert({key.name, key.name == NamedKey::Letter ? key.letter : '\0'}).second)
              << xnewell::nameOf(key);
      }
      EXPECT_GT(taken.size(), 15u);
      std::set<std::pair<char, int>> controls;
      for (const Control& control : b.bench().controls())
        EXPECT_TRUE(controls.insert({control.key, control.part}).second)
            << control.key << ' ' << control.part;
    }
}

// Every key that is listed does something that can be seen, or a sentence says why it does not. A key that is
// not listed says that it does nothing.
TEST(EveryView, EveryKeyAnswers) {
  for (const char* scene : someOf({"cycle", XNEWELL_DATA_DIR "/square.bpt"}, 1))
    for (const ViewRow& row : kWindowViews) {
      SCOPED_TRACE(scene + nameOf(row));
      std::vector<Key> keys;
      {
        ReadyWorkbench b{{}, 800, 540, scene};
        b.does(row.key);
        for (const KeyRow& one : b.keys()) keys.insert(keys.end(), one.keys.begin(), one.keys.end());
      }
      if (!kSanitized)
        for (char letter = '!'; letter <= '~'; ++letter) keys.push_back(letter);
      ReadyWorkbench b{{}, 800, 540, scene};
      std::set<std::string> silent;
      for (const Key& key : keys) {
        b.does(row.key);
        const auto before = seenIn(b);
        b.press(key);
        b.update();
        b.update();
        // A control that is selected already, a step beyond the end, the view that is shown.
        if (seenIn(b) == before) silent.insert(xnewell::nameOf(key));
        if (b.isAsking()) b.press(NamedKey::Escape);
      }
      EXPECT_LE(silent.size(), 8u) << testing::PrintToString(silent);
    }
}

// Every key cap is a button and every count a link, whatever view has drawn it: a press does something that
// can be seen, or a sentence says why it does not. What is selected already stays so.
TEST(EveryView, EveryCapAndCountAnswers) {
  for (const ViewRow& row : kWindowViews) {
    xnewell::Setup setup;
    setup.picture.order = Order::ZSort;
    setup.picture.light.Ip = 0.8, setup.picture.light.kd = setup.picture.light.ks = 1;
    ReadyWorkbench b{setup, 1024, 768};
    b.does(row.key);
    if (row.id == View::Trade) continue;  // it changes while it measures
    std::vector<Pointed> pressed;
    for (const Written& one : b.writing()) {
      const glm::ivec2 middle{one.place.x + one.place.width / 2, one.place.y + one.place.height / 2};
      if (one.pitch == 0) pressed.push_back(*pointedAt({one}, middle.x, middle.y));
      for (const Pointed& link : linksIn(one)) pressed.push_back(link);
    }
    EXPECT_GE(pressed.size(), 5u) << row.name;
    std::vector<std::string> silent;
    for (const Pointed& one : pressed) {
      const std::string what =
          one.key ? xnewell::nameOf(*one.key) : std::to_string(static_cast<int>(one.lead));
      SCOPED_TRACE(nameOf(row) + " " + what);
      if (one.key == Key{'q'}) continue;
      if (row.id == View::DepthSort) b.press(NamedKey::Home);
      b.finish();
      const auto before = seenIn(b);
      b.click(one.place.x + one.place.width / 2, one.place.y + one.place.height / 2);
      const bool answers = seenIn(b) != before;
      if (!answers) silent.push_back(what);
      if (one.lead != Lead::None && row.id != View::Lesson) {
        EXPECT_TRUE(answers);
      }
      if (b.isAsking()) b.press(NamedKey::Escape);
      if (b.moving()) b.press(NamedKey::Space);
      b.type("1r");
      b.does(row.key);
    }
    EXPECT_LE(silent.size(), 3u) << row.name << ' ' << testing::PrintToString(silent);
  }
}

// One framing: in every view the scene has the camera of view 1, so a vertex has one I; and where the picture
// has the size of view 1's, also its cuts and clamped values. A click in view 1 explains the very pixel.
TEST(EveryView, OnePictureOfTheScene) {
  for (const char* scene : someOf({"teapot", "cycle", "cubes", "penetrate", "spotlight", "hues", "highlight",
                                   "lamp", "saturated", "coarse-teapot"},
                                  3)) {
    xnewell::Setup setup;
    setup.picture.shading = Shading::Gouraud;
    ReadyWorkbench b{setup, 1024, 768, scene};
    const Picture first = b.picture();
    const Rect at = b.layout().picture;
    for (const ViewRow& row : kWindowViews) {
      if (row.id == View::Lesson) continue;
      SCOPED_TRACE(scene + nameOf(row));
      b.press(row.key);
      b.update();
      EXPECT_TRUE(b.picture().camera() == first.camera());
      if (row.id == View::MachBands) continue;
      EXPECT_EQ(b.picture().snapped().vertices, first.snapped().vertices);
      if (row.id == View::DepthSort) continue;  // the textbook's run, which view 1 need not take
      EXPECT_EQ(b.picture().sorted().statistics.splits, first.sorted().statistics.splits);
    }
    for (const glm::ivec2 pixel :
         {glm::ivec2{0, 0}, {at.width / 2, at.height - 1}, {at.width - 1, at.height / 3}}) {
      b.does('1');
      b.click(at.x + pixel.x, at.y + pixel.y);
      EXPECT_EQ(b.place().pixel, pixel) << scene;
    }
  }
}

// Every view draws every method, in ramps and in colours.
TEST(EveryView, DrawsEveryMethod) {
  for (const ShadingRow& method : kShadings)
    for (const ColorPlan plan : {ColorPlan::Needed, ColorPlan::Cube}) {
      xnewell::Setup setup;
      setup.picture.shading = method.id, setup.picture.colors = plan;
      ReadyWorkbench b{setup, 800, 540, "cycle"};
      for (const ViewRow& row : kWindowViews) {
        SCOPED_TRACE(nameOf(row) + ' ' + std::string{method.name});
        b.does(row.key);
        EXPECT_FALSE(b.bench().status().empty());
      }
    }
}

// The manual's tables of keys are those that the window acts by. To write them anew: xnewell keys
// >x11/KEYS.md
TEST(EveryView, TheManualListsTheKeys) {
  EXPECT_EQ(keyLists(), readTextFile(XNEWELL_DATA_DIR "/../x11/KEYS.md"));
}

// In every view, the list of keys fits into its frame, and no key runs into the words beside it.
TEST(EveryView, TheListOfKeysFits) {
  constexpr int kWidth = 560, kShadow = 4;
  for (const auto& [width, height] : someOf({std::pair{800, 540}, {800, 600}, {1024, 768}}, 1))
    for (const std::string& way : waysToViews({"2Y"})) {
      SCOPED_TRACE(way);
      ReadyWorkbench b{{}, width, height};
      for (const char key : way) b.does(key);
      const IndexImage before = b.image();
      b.does('?');
      ASSERT_NE(before.pixels, b.image().pixels);
      const int left = (width - kWidth) / 2, right = left + kWidth - 1;
      const int end = layoutOf(width, height).status.y;  // the status line tells the time, which may change
      for (int y = 0; y < end; ++y)
        for (int x = 0; x < width; ++x)
          if (before.row(y)[x] != b.image().row(y)[x]) {
            ASSERT_TRUE(x >= left && x <= right + kShadow) << x << ", " << y;
            ASSERT_TRUE(y > 0 && y + 1 < end) << y;
          }
      if (height < 768) continue;
      for (const HelpLine& line : helpOf(b.keys()))
        EXPECT_FALSE(findText(b.image(), line.keys + " ", b.plan()[Cell::Ink], 1, Voice::Bold).empty())
            << line.keys;
    }
}

TEST(EveryControl, IsHitWhereItIsDrawn) {
  for (const auto& [width, height, unit] : {Screen{800, 540, 1},
                                            {800, 600, 1},
                                            {1024, 768, 1},
                                            {1920, 1080, 1},
                                            {1920, 1080, 2},
                                            {2400, 1700, 3}}) {
    SCOPED_TRACE(testing::Message() << width << " x " << height << " at scale " << unit);
    ReadyWorkbench b{{}, width, height};
    b.scale(unit);
    int answered = 0;
    for (const ViewRow& row : kWindowViews) {
      SCOPED_TRACE(row.name);
      b.switchTo(row.id);
      b.update();
      expectPlaces(b);
      if (row.id == View::Trade) continue;  // it changes while it measures
      b.finish();
      ASSERT_EQ(b.layout().unit, unit);
      expectPlaces(b);
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
      b.does("D");
      const Rect larger = room();
      EXPECT_GT(larger.width * larger.height, picture.width * picture.height);
      EXPECT_TRUE(b.bench().list().find({kDrawerKey}));
      expectPlaces(b);
      visit(b, unit);
      const Rect handle = b.layout().handle;
      EXPECT_TRUE(intersection(handle, larger).empty());
      EXPECT_FALSE(b.grab((handle.x + 12) * unit, (handle.y + handle.height / 2) * unit));
      b.settle();
      b.pointAt(0, 0);
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
