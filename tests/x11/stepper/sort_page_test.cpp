#include "x11/stepper/sort_page.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <set>

#include "shading/color/font.h"
#include "shading/picture/picture_cache.h"
#include "tests/support/scene_text.h"
#include "tests/support/seeds.h"
#include "tests/x11/support/shown_sort_page.h"
#include "x11/stepper/outline.h"
#include "x11/stepper/sort_code.h"
#include "x11/stepper/sort_wording.h"

namespace xnewell::THIS_FILE {

// What the stepper draws.

namespace {

using Page = ShownSortPage;

Scene polygons(const std::string& list, const std::string& name = "p") {
  return parsed(R"({"objects": [{"name": ")" + name + R"(", "polygons": [)" + list + "]}]}");
}

/// A regular polygon at some depth, leaning by `lean`.
std::string regular(int corners, double radius, double z, double lean) {
  std::string text = "[";
  for (int k = 0; k < corners; ++k) {
    const double a = 2 * std::numbers::pi * k / corners, x = radius * std::cos(a), y = radius * std::sin(a);
    text += (k ? ", [" : "[") + std::to_string(x) + ", " + std::to_string(y) + ", " +
            std::to_string(z + lean * x) + "]";
  }
  return text + "]";
}

/// Scenes at the limits of what the page has to show.
std::vector<Scene> extremes() {
  std::vector<Scene> all;
  all.push_back(polygons(regular(3, 1, 0, 0)));
  all.push_back(polygons(regular(12, 1, 0, 0.2) + ", " + regular(12, 0.9, 0.05, -0.3) + ", " +
                         regular(11, 0.8, 0.1, 0.1)));
  all.push_back(
      polygons(regular(4, 1, 0, 0.1) + ", " + regular(5, 0.8, 0, 0.1) + ", " + regular(6, 0.5, 0, 0.1)));
  all.push_back(polygons(regular(4, 1, 0, 0.4) + ", " + regular(4, 1, 0, -0.4), std::string(200, 'W')));
  all.push_back(polygons(regular(4, 1, 0, 0) + ", " + regular(4, 1e-4, 0.3, 0.2)));
  all.push_back(readScene("pinwheels"));
  all.push_back(readScene("slivers"));
  return all;
}

}  // namespace

// A step looks the same whether it is reached forward, backward or from anywhere else.
TEST(SortPage, DoesNotDependOnTheWayThere) {
  for (const char* scene : {"cycle", "penetrate", "nested-cycles", "teapot"}) {
    Page page{readScene(scene, 3)};
    const int steps = page.run->steps(), stride = std::max(1, steps / 300);
    std::vector<IndexImage> forward;
    for (int step = 0; step <= steps; step += stride) forward.push_back(page.show(step));
    const auto last = static_cast<int>(forward.size()) - 1;
    for (int k = last; k >= 0; --k) ASSERT_EQ(page.show(k * stride), forward[k]) << scene << ' ' << k;
    std::mt19937 rng{1972};
    for (int n = 0; n < 60; ++n) {
      const int k = static_cast<int>(rng() % forward.size());
      ASSERT_EQ(page.show(k * stride), forward[k]) << scene << ' ' << k;
    }
    for (int k = 1; k <= last; ++k) ASSERT_NE(forward[k], forward[k - 1]) << scene << ' ' << k;
  }
}

// At the end the picture so far is the finished picture. Without the loupe, the page shows just that picture
// with the polygon painted last in outline, except in the line of words above. The loupe lies in the picture.
TEST(SortPage, ShowsThePictureSoFar) {
  Page page{readScene("teapot", 3)};
  const int steps = page.run->steps();
  page.view.loupe = false;
  page.show(steps);
  EXPECT_TRUE(page.drawn.loupe.empty());
  ASSERT_EQ(page.event(steps).kind, Event::Kind::Paint);
  IndexImage expected = page.picture->paint(page(Cell::Well)).image;
  EXPECT_EQ(page.run->soFar(), expected);
  Painter paint{expected};
  const Outline last = outlineOf(page.run->fragments().region(page.event(steps).P));
  outline(paint, last, page(Cell::Black), {4});
  outline(paint, last, page(Cell::P), {2});
  const int above = 18 - kGlyphAscent - 1,
            below = above + kGlyphHeight + 2;  // the words' rows, with their halo
  const Rect& at = page.at.picture;
  for (int j = 0; j < expected.height; ++j) {
    if (j >= above && j < below) continue;
    ASSERT_TRUE(std::equal(expected.row(j), expected.row(j) + expected.width, page.image.row(at.y + j) + at.x,
                           [&](std::uint8_t is, std::uint8_t shown) {  // names have a rim
                             return shown == is || shown == page(Cell::WellText) || shown == page(Cell::Well);
                           }))
        << "row " << j;
  }

  page.view.loupe = true;
  page.show(steps);
  ASSERT_FALSE(page.drawn.loupe.empty());
  EXPECT_EQ(intersection(page.drawn.loupe, at), page.drawn.loupe);
}

// The polygon at a pixel is the one seen there. At the end it is that of the finished picture. Before
// anything is painted it is the first one that will be painted there.
TEST(SortPage, FindsThePolygonAtAPixel) {
  Page page{readScene("teapot", 3)};
  const std::vector<std::uint32_t> faces = page.picture->faceImage();
  const int width = page.at.picture.width, all = static_cast<int>(page.run->sorted().fragments.size());
  int hits = 0, later = 0;
  for (int k = 0; k < static_cast<int>(faces.size()); k += 997) {
    const int column = k % width, row = k / width;
    page.run->goTo(page.run->steps());
    const int top = page.run->fragmentAt(column, row);
    ASSERT_EQ(top < 0 ? 0 : page.run->fragments().face(top).number + 1, static_cast<int>(faces[k]));
    if (top < 0) continue;
    ++hits;
    page.run->goTo(0);
    const int first = page.run->fragmentAt(column, row);
    const auto place = [&](int id) {
      for (int n = 0; n < all; ++n)
        if (page.run->paintedId(n) == id) return n;
      return all;
    };
    ASSERT_LE(place(first), place(top));
    later += first != top;
  }
  EXPECT_GT(hits, 40);
  EXPECT_GT(later, 20);
}

// The numbers in the table are those of the Explainer. They count the same corners on each side, and their
// areas and extents agree with the tests.
TEST(SortPage, NumbersAreTheExplainers) {
  std::set<xnewell::Test> seen;
  for (const char* scene : {"teapot", "cycle", "penetrate", "decals", "room", "slivers"}) {
    Page page{readScene(scene, 3)};
    const Explainer& explainer = page.run->explainer();
    for (int step = 1; step <= page.run->steps(); ++step) {
      const Event& e = page.event(step);
      if (e.kind != Event::Kind::Compare) continue;
      for (const xnewell::Test test : explainer.testsMade(e)) {
        const std::vector<std::string> texts = numbersOf(explainer, e, test);
        const bool first = seen.insert(test).second;
        if (!first && step % 7) continue;
        ASSERT_FALSE(texts.empty());
        const auto starts = [&](int count, std::size_t of) {
          const std::string start = std::to_string(count) + " of " + std::to_string(of) + " ";
          EXPECT_TRUE(texts[0].starts_with(start)) << texts[0] << " for " << start;
        };
        const auto plane = [&](int of, int other, bool behind) {
          const std::vector<CornerDistance> distances = explainer.distances(of, other);
          const CornerCounts counts = explainer.corners(of, other);
          CornerCounts again;
          for (const CornerDistance& d : distances) {
            ++(d.sign > 0 ? again.inFront : d.sign < 0 ? again.behind : again.on);
            EXPECT_NE(texts[0].find(distanceText(d)), std::string::npos) << texts[0];
            if (std::abs(d.inFront) > 1e-3) {
              EXPECT_EQ(d.sign > 0, d.inFront > 0);
            }
          }
          EXPECT_EQ(again, counts);
          const auto kept = std::ranges::count_if(distances, [&](const CornerDistance& d) {
            return !d.mayBeOn && (behind ? d.sign < 0 : d.sign > 0);
          });
          starts(static_cast<int>(kept), distances.size());
          const bool holds = behind ? counts.inFront == 0 : counts.behind == 0;
          if (test == e.test) {
            EXPECT_TRUE(holds);
          }
        };
        switch (test) {
          case xnewell::Test::PBehindQ:
            plane(e.P, e.Q, true);
            break;
          case xnewell::Test::QInFrontOfP:
            plane(e.Q, e.P, false);
            break;
          case xnewell::Test::QBehindP:
            plane(e.Q, e.P, true);
            break;
          case xnewell::Test::PInFrontOfQ:
            plane(e.P, e.Q, false);
            break;
          case xnewell::Test::XExtents:
          case xnewell::Test::YExtents:
            EXPECT_EQ(texts[0].find("apart") != std::string::npos, test == e.test) << texts[0];
            EXPECT_EQ(texts.back().find('-'), std::string::npos) << texts.back();
            break;
          case xnewell::Test::Projections:
            EXPECT_EQ(texts[0].find("share") == std::string::npos, test == e.test) << texts[0];
            break;
          case xnewell::Test::SamePlane:
          case xnewell::Test::Overlap:
            break;
        }
        // The last test made settled the pair. All tests before it failed.
        EXPECT_EQ(answerOf(e, test).words == "no", test != e.test);
      }
    }
  }
  EXPECT_EQ(seen.size(), std::size_t{kTests});
}

// A distance other than 0 is never shown as 0, and 0 has no sign.
TEST(SortPage, SmallDistancesKeepTheirSign) {
  EXPECT_EQ(distanceText({{}, 3.14, 1, false}), "+3.1");
  EXPECT_EQ(distanceText({{}, -28.57, -1, false}), "-29");
  EXPECT_EQ(distanceText({{}, 0.004, 1, false}), "+0.004");
  EXPECT_EQ(distanceText({{}, -0.00002, -1, false}), "-0.00002");
  EXPECT_EQ(distanceText({{}, 0.0, 0, false}), "0.0");
  EXPECT_EQ(distanceText({{}, 1e-12, 0, false}), "0.0");
}

// A page that asks does not show the outcome. If the test changes the test and the verdict in the event, the
// page that asks stays the same, bit for bit, and the page that tells changes.
TEST(SortPage, AQuestionHidesItsOutcome) {
  int questions = 0;
  for (const char* scene : {"cycle", "penetrate", "nested-cycles", "teapot"}) {
    Page page{readScene(scene, 3)};
    for (int step = 1; step <= page.run->steps(); ++step) {
      // The run itself is not const, and the event is put back.
      Event& e = const_cast<Event&>(page.event(step));
      if (!isQuestion(e) || (questions > 60 && step % 50)) continue;
      ++questions;
      page.view.asking = true;
      const IndexImage asked = page.show(step);
      // The timeline does not show what is to come either.
      const Rect& line = page.at.timeline;
      const int head = columnOf(line, step, page.run->steps()) + 6;
      for (int j = line.y; j < line.y + line.height; ++j)
        for (int i = head; i < line.x + line.width; ++i) {
          ASSERT_TRUE(asked.row(j)[i] == page(Cell::Paper) || asked.row(j)[i] == page(Cell::Rule));
        }
      page.view.asking = false;
      const IndexImage told = page.show(step);
      ASSERT_NE(asked, told);
      const Event was = e;
      for (const Verdict verdict : {Verdict::PFirst, Verdict::QFirst, Verdict::Crossing}) {
        e.verdict = verdict;
        e.test = was.test == xnewell::Test::Overlap ? xnewell::Test::QBehindP : xnewell::Test::Overlap;
        page.view.asking = true;
        ASSERT_EQ(page.show(step), asked) << scene << ' ' << step;
        page.view.asking = false;
        ASSERT_NE(page.show(step), told);
      }
      e = was;
    }
  }
  EXPECT_GT(questions, 60);
}

// Nothing is drawn outside the body, for any scene and in small windows. Above the buttons the gutter between
// the columns stays free, so that no column cuts off a word of another.
TEST(SortPage, KeepsWithinItsColumns) {
  int steps = 0;
  for (const Rect& body : {kWide, kCompact})
    for (Scene& scene : extremes()) {
      SCOPED_TRACE(scene.name);
      Page page{std::move(scene), body};
      ASSERT_GT(page.run->steps(), 0);
      const int stride = std::max(1, page.run->steps() / (kSanitized ? 5 : 40));
      for (int step = 0; step <= page.run->steps(); step += stride, ++steps) {
        page.view.asking = step % 2 == 1 && isQuestion(page.event(step));
        page.show(step);
        const int left = page.at.picture.x + page.at.picture.width;
        for (int j = 0; j < page.image.height; ++j)
          for (int i = 0; i < page.image.width; ++i) {
            const bool in = body.has(i, j);
            if (!in) {
              ASSERT_EQ(page.image.row(j)[i], Page::kGround) << i << ' ' << j;
            }
            if (in && j < page.at.rule && i >= left && i < left + 14) {
              ASSERT_EQ(page.image.row(j)[i], page(Cell::Paper)) << step << ": " << i << ' ' << j;
            }
          }
      }
    }
  EXPECT_GT(steps, kSanitized ? 25 : 200);
}

// A scene of which nothing shows has a page too, and the page says so.
TEST(SortPage, NothingToSort) {
  const auto page = [](const char* corners) { return Page{polygons(corners), kWide, Cull::Back}; };
  Page one = page("[[0, 0, 0], [1, 0, 0], [0, 1, 0]]"), other = page("[[0, 0, 0], [0, 1, 0], [1, 0, 0]]");
  Page& empty = one.run->steps() == 0 ? one : other;
  Page& full = one.run->steps() == 0 ? other : one;
  ASSERT_EQ(empty.run->steps(), 0);
  EXPECT_EQ(full.run->steps(), 2);  // taken, painted
  empty.show(0);
  EXPECT_EQ(findingOf(*empty.run, empty.view).bold, "There is nothing to sort.");
  for (const int id : empty.drawn.rows) EXPECT_EQ(id, -1);
  EXPECT_EQ(empty.run->fragmentAt(10, 10), -1);
}

// The list contains P and Q at every step. The rows are those that were drawn.
TEST(SortPage, TheListHoldsThePair) {
  for (const char* scene : {"teapot", "nested-cycles"})
    for (const Rect& body : {kWide, kCompact}) {
      Page page{readScene(scene, 3), body};
      int far = 0;
      for (int step = 1; step <= page.run->steps(); step += page.run->steps() > 1000 ? 31 : 1) {
        page.show(step);
        const std::vector<int>& rows = page.drawn.rows;
        ASSERT_TRUE(static_cast<int>(rows.size()) == page.at.rows() || !page.drawn.ring.empty());
        const Event& e = page.event(step);
        ASSERT_NE(std::ranges::find(rows, e.P), rows.end()) << step;
        if (e.Q < 0) continue;
        const auto q = std::ranges::find(rows, e.Q);
        ASSERT_NE(q, rows.end()) << step;
        far += q == rows.end() - 1;
      }
      if (page.run->steps() > 1000) {
        EXPECT_GT(far, 10);
      }
    }
}

// A polygon that has its mark shows it in the list, also beside the badge of P or Q. One without has none.
TEST(SortPage, MarksShowBesideBadges) {
  Page page{readScene("cycle")};
  int ofP = 0, ofQ = 0, unmarkedQ = 0, others = 0;
  for (int step = 1; step <= page.run->steps(); ++step) {
    page.show(step);
    const std::vector<int> marked = page.run->replay().marked();
    const Event& e = page.event(step);
    for (std::size_t k = 0; k < page.drawn.rows.size(); ++k) {
      const int id = page.drawn.rows[k];
      const bool isP = id == e.P, isQ = id == e.Q, has = std::ranges::find(marked, id) != marked.end();
      if (id < 0 || (isP && e.kind == Event::Kind::Paint)) continue;
      // The column where the arrow is as high as it gets.
      const int x = page.at.list.x + (isP || isQ ? 17 : 7), high = isP || isQ ? 5 : 7,
                top = page.at.list.y + static_cast<int>(k + 1) * page.at.line - 12;
      int ink = 0;
      for (int y = top; y < top + high; ++y) ink += page.image.row(y)[x] == page(Cell::Ink);
      ASSERT_EQ(ink, has ? high : 0) << "step " << step << ", row " << k;
      ++(isP ? ofP : isQ && has ? ofQ : isQ ? unmarkedQ : others);
    }
  }
  EXPECT_GT(ofP, 3);
  EXPECT_GT(ofQ, 0);
  EXPECT_GT(unmarkedQ, 3);
  EXPECT_GT(others, 3);
}

// The finding of every kind of step is a sentence, and its bold line is a sentence too.
TEST(SortPage, EveryStepHasAFinding) {
  std::set<Event::Kind> kinds;
  for (const char* scene : {"teapot", "cycle", "nested-cycles", "room", "crossing-sheets", "slivers"}) {
    Page page{readScene(scene, 3)};
    for (int step = 1; step <= page.run->steps(); ++step) {
      if (page.run->steps() > 1000 && step % 7 && !kinds.insert(page.event(step).kind).second) continue;
      page.run->goTo(step);
      page.view.step = step;
      kinds.insert(page.event(step).kind);
      const StepFinding finding = findingOf(*page.run, page.view);
      for (const std::string& text : {finding.bold, finding.why}) {
        ASSERT_GE(text.size(), 7u);  // "P is b."
        ASSERT_TRUE(text.back() == '.') << text;
        ASSERT_EQ(text.find("{"), std::string::npos) << text;
      }
      ASSERT_LT(finding.why.size(), 190u) << finding.why;
    }
  }
  EXPECT_GE(kinds.size(), 6u);
}

// The lines that the book does not have are named, and P stands where it came from: at the first of the list
// or at the move.
TEST(SortPage, SaysWhichLinesAreOursAndWherePIsFrom) {
  Page page{readScene("cycle")};
  SortRun& run = *page.run;
  bool moved = false;
  for (int step = 1; step <= run.steps(); ++step) {
    run.goTo(step);
    const Event& e = run.sorted().events[static_cast<std::size_t>(step - 1)];
    moved = e.kind == Event::Kind::Move || (moved && e.kind != Event::Kind::Take);
    if (e.kind == Event::Kind::Split) break;
    const std::vector<CodeLine> lines = sortCode(run, {.step = step});
    const auto with =
        std::ranges::find_if(lines, [](const CodeLine& l) { return l.values.starts_with("P = "); });
    ASSERT_NE(with, lines.end());
    EXPECT_EQ(with->text.find("move") != std::string::npos, moved) << "step " << step;
    EXPECT_EQ(std::ranges::count(lines, true, &CodeLine::ours), 4);
  }
  EXPECT_TRUE(moved);
}

}  // namespace xnewell::THIS_FILE
