#include <gtest/gtest.h>

#include <set>

#include "geometry/files/text_file.h"
#include "tests/support/seeds.h"
#include "tests/x11/support/ready_workbench.h"
#include "x11/app/key_lists.h"
#include "x11/stepper/sort_view.h"

namespace xnewell::THIS_FILE {

// Whatever a view says of its keys and controls is true of every view.

namespace {

/// What a key may change, as the user can tell.
struct Seen {
  explicit Seen(const Workbench& b)
      : image{b.image()},
        palette{b.palette()},
        setup{b.setup()},
        view{b.view()},
        asking{b.isAsking()},
        quitting{b.quitAsked()},
        moving{b.moving()} {}
  IndexImage image;
  Palette palette;
  xnewell::Setup setup;
  View view;
  bool asking, quitting, moving;
  bool operator==(const Seen&) const = default;
};

std::string nameOf(const ViewRow& row) { return std::string{row.name}; }

}  // namespace

// No view has a key twice, and every key has words in the list of all keys.
TEST(EveryView, KeysAreUniqueAndExplained) {
  for (const char* scene : someOf({"cycle", "hues", "teapot"}, 1))
    for (const ViewRow& row : kWindowViews) {
      SCOPED_TRACE(scene + nameOf(row));
      ReadyWorkbench b{{}, 1024, 768, scene};
      b.press(row.key);
      b.finish();
      std::set<std::pair<NamedKey, char>> taken;
      for (const KeyRow& keys : b.keys()) {
        EXPECT_FALSE(keys.does.empty())
            << (keys.keys.empty() ? keys.gesture : xnewell::nameOf(keys.keys.front()));
        for (const Key& key : keys.keys)
          EXPECT_TRUE(taken.insert({key.name, key.name == NamedKey::Letter ? key.letter : '\0'}).second)
              << xnewell::nameOf(key);
      }
      EXPECT_GT(taken.size(), 15u);
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
        b.press(row.key);
        b.finish();
        for (const KeyRow& one : b.keys()) keys.insert(keys.end(), one.keys.begin(), one.keys.end());
      }
      if (!kSanitized)
        for (char letter = '!'; letter <= '~'; ++letter) keys.push_back(letter);
      ReadyWorkbench b{{}, 800, 540, scene};
      std::set<std::string> silent;
      for (const Key& key : keys) {
        b.press(row.key);
        b.finish();
        const Seen before{b};
        b.press(key);
        b.update();
        b.update();
        // A control that is selected already, a step beyond the end, the view that is shown.
        if (Seen{b} == before) silent.insert(xnewell::nameOf(key));
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
      const Seen before{b};
      (void)b.grab(one.place.x + one.place.width / 2, one.place.y + one.place.height / 2);
      b.settle();
      b.finish();
      const bool answers = Seen{b} != before;
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

// A count leads to what it counts, and Esc goes back to the place from which one came.
TEST(EveryView, CountsLeadToWhatTheyCount) {
  xnewell::Setup setup;
  setup.picture.order = Order::ZSort;
  setup.picture.light.Ip = 0.8, setup.picture.light.kd = setup.picture.light.ks = 1;
  for (const auto& [lead, view] :
       {std::pair{Lead::Clamped, View::Pixel}, {Lead::Wrong, View::Pixel}, {Lead::Cut, View::DepthSort}}) {
    setup.picture.order = lead == Lead::Cut ? Order::Newell : Order::ZSort;
    ReadyWorkbench b{setup};
    std::optional<Pointed> link;
    for (const Written& one : b.writing())
      for (const Pointed& found : linksIn(one))
        if (found.lead == lead) link = found;
    ASSERT_TRUE(link) << static_cast<int>(lead);
    (void)b.grab(link->place.x + 3, link->place.y + 5);
    b.finish();
    ASSERT_EQ(b.view(), view) << b.panel().notice;
    if (view == View::DepthSort) {
      EXPECT_EQ(b.stepper().run()->landmarks().count(Landmark::Cut, b.stepper().view().step), 1);
    } else {
      const std::string line = b.panel().status;
      EXPECT_EQ(line.find("ground"), line.npos) << line;
    }
    b.does(NamedKey::Escape);
    EXPECT_EQ(b.view(), View::Picture);
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
      (void)b.grab(at.x + pixel.x, at.y + pixel.y);
      b.settle();
      b.finish();
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

// No two controls that are drawn share a pixel, unless one of them lies above; and all are in the window.
TEST(EveryView, ControlsHavePlaces) {
  for (const auto& [w, h] : someOf({std::pair{800, 540}, {800, 600}, {1920, 1080}}, 1))
    for (const ViewRow& row : kWindowViews) {
      SCOPED_TRACE(nameOf(row) + std::to_string(w));
      ReadyWorkbench b{{}, w, h};
      b.press(row.key);
      b.finish();
      const auto& places = b.bench().list().places();
      for (std::size_t p = 0; p < places.size(); ++p) {
        const Rect& area = places[p].second.area;
        EXPECT_FALSE(area.empty());
        EXPECT_TRUE(area.x >= 0 && area.y >= 0 && area.x + area.width <= w && area.y + area.height <= h);
        for (std::size_t q = 0; q < p; ++q)
          if (places[p].second.above == places[q].second.above) {
            EXPECT_TRUE(intersection(area, places[q].second.area).empty())
                << places[p].first.key << places[p].first.part << ' ' << places[q].first.key
                << places[q].first.part;
          }
      }
    }
}

// In every view, the list of keys fits into its frame.
TEST(EveryView, TheListOfKeysFits) {
  constexpr int kWidth = 560, kShadow = 4;
  std::vector<std::string> ways;
  for (const ViewRow& row : kWindowViews) ways.emplace_back(1, row.key);
  ways.emplace_back("2Y");  // the student sorts
  for (const auto& [width, height] : someOf({std::pair{800, 540}, {800, 600}, {1024, 768}}, 1))
    for (const std::string& way : ways) {
      SCOPED_TRACE(way);
      ReadyWorkbench b{{}, width, height};
      for (const char key : way) {
        b.press(key);
        b.finish();
      }
      const IndexImage before = b.image();
      b.type("?");
      b.finish();
      ASSERT_NE(before.pixels, b.image().pixels);
      const int left = (width - kWidth) / 2, right = left + kWidth - 1;
      const int end = layoutOf(width, height).status.y;  // the status line tells the time, which may change
      for (int y = 0; y < end; ++y)
        for (int x = 0; x < width; ++x)
          if (before.row(y)[x] != b.image().row(y)[x]) {
            ASSERT_TRUE(x >= left && x <= right + kShadow) << x << ", " << y;
            ASSERT_TRUE(y > 0 && y + 1 < end) << y;
          }
    }
}

}  // namespace xnewell::THIS_FILE
