#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

#include "shading/diagnose/paint_steps.h"
#include "tests/support/temporary_folder.h"
#include "tests/x11/support/stepper.h"
#include "x11/app/workbench.h"
#include "x11/stepper/sort_wording.h"

namespace xnewell::THIS_FILE {

// The page while the student sorts: what a click does there, and what is said.

namespace {

/// A stepper in which somebody sorts, on a page of any size.
struct OwnPage : Stepper {
  explicit OwnPage(const char* scene, int width = 1024, int height = 768)
      : Stepper{scene, 3, width, height}, at{layoutOfSort(layoutOf(width, height).body, false, true)} {
    press("Y");
    draw();
  }
  [[nodiscard]] const OwnState& own() const { return *bench.view().own; }
  SortLayout at;
};

}  // namespace

// A click on a row of the tests names that test, as `t` and its digit do, also after other steps. Nothing
// else happens: the run is not left for another step.
TEST(OwnPage, AClickOnATestNamesIt) {
  for (const auto& [width, height] : {std::pair{1024, 768}, {800, 600}, {1280, 1024}, {2048, 1536}})
    for (const char* const before : {"", "cp"})
      for (int k = 0; k < kOwnTests; ++k) {
        OwnPage clicked{"cycle", width, height}, typed{"cycle", width, height};
        for (OwnPage* const page : {&clicked, &typed}) page->press(before), page->draw();
        clicked.click(clicked.at.testRow(k));
        typed.press("t" + std::to_string(k + 1));
        clicked.draw(), typed.draw();
        EXPECT_TRUE(clicked.own().passed[k]) << width << ' ' << before << ' ' << k + 1;
        EXPECT_EQ(clicked.own(), typed.own()) << width << ' ' << before << ' ' << k + 1;
        EXPECT_EQ(clicked.step(), clicked.run().steps()) << width << ' ' << before << ' ' << k + 1;
      }
}

// No two controls of the page have one name, with which the pointer would find the other.
TEST(OwnPage, ControlsHaveNamesOfTheirOwn) {
  OwnPage page{"teapot"};
  std::set<std::pair<char, int>> names;
  for (const Control& control : page.bench.controls())
    EXPECT_TRUE(names.insert({control.key, control.part}).second) << control.key << ' ' << control.part;
  EXPECT_GT(names.size(), 30u);
}

// All tests can be made in the book's order: those that fail say why, and only the one that tells counts.
TEST(OwnPage, TestsThatFailDoNotCount) {
  OwnPage page{"two-cards"};
  page.press(NamedKey::Down);
  for (int k = 0; k < 2; ++k) {
    page.press("t" + std::to_string(k + 1));
    EXPECT_EQ(page.own().score, Score{}) << page.own().why;
    EXPECT_EQ(page.own().passed[k], false);
    EXPECT_FALSE(page.own().alarm);
    EXPECT_EQ(page.own().bold, "Test " + std::to_string(k + 1) + " does not tell.");
    EXPECT_NE(page.own().why.find("share "), std::string::npos) << page.own().why;
  }
  page.press("t3");
  if (!*page.own().passed[2]) page.press("t4");
  EXPECT_EQ(page.own().score, (Score{1, 1})) << page.own().why;
  EXPECT_EQ(page.own().passed[0], false);
}

// A sentence calls a polygon or a piece what the page calls it, and P or Q only what is P or Q now. After a
// move they have changed places.
TEST(OwnPage, NamesAreThoseOfThePage) {
  OwnPage page{"cycle"};
  const auto named = [&](int id) { return "polygon " + page.run().name(id); };
  const auto says = [&](const std::string& words) {
    return (page.own().bold + ' ' + page.own().why).find(words) != std::string::npos;
  };
  const int P = page.own().P;
  page.press("c");
  EXPECT_EQ(page.own().bold, "Polygon " + page.run().name(P) + " is cut in two.");
  EXPECT_TRUE(says("Behind lies " + named(page.own().P) + ", in front " + named(page.own().P + 1) + "."))
      << page.own().why;
  const std::string first = named(page.own().P);
  page.press("p");
  EXPECT_TRUE(says("P" + first.substr(1) + " is painted")) << page.own().bold;
  while (page.own().P >= 0) {
    const std::vector<int> all = page.run().waiting();
    const std::string painted = named(page.own().P);
    page.press("p");
    if (page.own().P < 0) break;
    EXPECT_TRUE(says("P" + painted.substr(1) + " is painted")) << page.own().bold;
    const bool nearer =
        std::ranges::any_of(all, [&](int id) { return says("It is nearer than " + named(id)); });
    EXPECT_EQ(page.own().alarm, nearer) << page.own().why;
    EXPECT_FALSE(says("face")) << page.own().bold << page.own().why;
  }
  EXPECT_TRUE(says("The judge says wrong: polygon ")) << page.own().why;
  OwnPage cards{"two-cards"};
  for (const bool other : {false, true}) {
    if (other) cards.press(NamedKey::Down);
    const int before = cards.own().P, Q = cards.own().Q;
    cards.press("m");
    if (cards.own().alarm) continue;
    EXPECT_EQ(cards.own().P, Q);
    EXPECT_EQ(cards.own().Q, before);
    EXPECT_NE(cards.own().bold.find(cards.run().fragments().name(Q) + " goes first."), std::string::npos);
    EXPECT_NE(cards.own().why.find(cards.run().fragments().name(before) + " is Q"), std::string::npos);
  }
}

// The file says the size of its picture, also in the smallest window, and the command that judges it is what
// C copies: of the file that was written last, without a size and without a step of another sort. The camera
// may have moved since.
TEST(OwnPage, CopiesTheCommandOfTheFileWrittenLast) {
  const TemporaryFolder folder;
  std::vector<std::string> copied;
  Workbench window{
      readScene("cycle", 3), {}, {.copy = [&](const std::string& text) { copied.push_back(text); }}};
  const auto draw = [&] {
    for (int k = 0; k < 3 && window.stale() != Workbench::Stale::Nothing; ++k) window.update();
  };
  const auto type = [&](const std::string& letters) {
    for (const char c : letters) window.press({NamedKey::Letter, c});
    draw();
  };
  const auto last = [&] {
    type("C");
    return copied.back().substr(copied.back().rfind('\n') + 1);
  };
  window.resize(800, 600);
  draw();
  for (const char* const key : {"2", "Y", "p"}) type(key);
  const std::string begin =
      "xnewell judge cycle --crease 180 --light=-0.54,-0.64,0.55 ";  // without the scene's own
  EXPECT_EQ(last(), begin + "order.jsonl");
  const auto write = [&](const std::string& file) {
    type("o");
    for (int k = 0; k < 20; ++k) window.press({NamedKey::Backspace});
    type(file);
    window.press({NamedKey::Return});
    draw();
  };
  for (const char* const name : {"cyc1.jsonl", "cyc2.jsonl"}) {
    write(folder.file(name));
    EXPECT_EQ(last(), begin + folder.file(name));
  }
  const glm::ivec2 size{window.picture().settings().width, window.picture().settings().height};
  EXPECT_EQ(readPaintOrder(folder.file("cyc2.jsonl"), 3).size, size);
  type("Y");
  EXPECT_TRUE(last().starts_with("xnewell snapshot cycle ")) << last();
}

// Every size that the window writes can be read.
TEST(OwnPage, SizesCanBeRead) {
  for (const Rect& body : {Rect{8, 26, 744, 428}, Rect{8, 26, 8192, 8192}})
    for (const bool shut : {false, true}) {
      const Rect picture = layoutOfSort(body, shut, true).picture;
      EXPECT_GE(std::min(picture.width, picture.height), kLeastOrderSize);
    }
}

// After `t` a digit that names no test says so; it does not open another view.
TEST(OwnPage, OnlyTestsHaveDigits) {
  OwnPage page{"cycle"};
  page.press("cpt6");
  EXPECT_TRUE(page.taken);
  ASSERT_FALSE(page.notices.empty());
  EXPECT_EQ(page.notices.back(), "There are five tests, 1 to 5.");
}

}  // namespace xnewell::THIS_FILE
