#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <random>
#include <set>

#include "shading/color/font.h"
#include "shading/diagnose/judge_order.h"
#include "shading/picture/picture_cache.h"
#include "tests/support/scene_text.h"
#include "tests/support/seeds.h"
#include "tests/x11/support/ready_workbench.h"
#include "x11/drawing/painter.h"
#include "x11/drawing/wording.h"
#include "x11/stepper/sort_layout.h"
#include "x11/stepper/sort_page.h"
#include "x11/stepper/sort_picture.h"
#include "x11/stepper/sort_wording.h"

namespace xnewell::THIS_FILE {

namespace {

constexpr Rect kWide{16, 48, 992, 612}, kCompact{16, 43, 768, 428};

/// The page of a scene's run in a body, on a ground that nothing else uses.
struct Page {
  static constexpr std::uint8_t kGround = 77;

  std::optional<Picture> picture;
  CellPlan plan;
  SortLayout at;
  std::unique_ptr<SortRun> run;
  IndexImage image;
  SortState view;
  SortDrawn drawn;

  explicit Page(Scene scene, const Rect& body = kWide)
      : at{layoutOfSort(body)}, image{body.x + body.width + 16, body.y + body.height + 16, kGround} {
    PictureSettings settings;
    settings.width = at.picture.width, settings.height = at.picture.height;
    settings.camera = completed({}, scene.camera);
    picture = makePicture(std::move(scene), settings);
    run = std::make_unique<SortRun>(*picture, plan[Cell::Well]);
  }
  const IndexImage& show(int step) {
    view.step = step;
    drawn = drawSortPage(image, at, *run, view, plan);
    return image;
  }
  [[nodiscard]] const Event& event(int step) const { return run->sorted().events[step - 1]; }
  [[nodiscard]] std::uint8_t operator()(Cell c) const { return plan[c]; }
};

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

/// Bodies of windows of 800 x 540 and more.
std::vector<Rect> bodies() {
  return {{16, 43, 768, 428},   {16, 43, 768, 449},   {16, 48, 992, 612}, {16, 48, 1248, 612},
          {16, 43, 1200, 449},  {8, 26, 744, 450},    {8, 26, 904, 432},  {16, 48, 768, 900},
          {16, 48, 1568, 1044}, {16, 48, 3000, 2000}, {8, 26, 744, 428},  {8, 26, 784, 450},
          {8, 26, 8192, 8192}};
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

// What the stepper draws.

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
        const Rect gutter{left, body.y, 14, page.at.rule - body.y};
        for (int j = 0; j < page.image.height; ++j)
          for (int i = 0; i < page.image.width; ++i)
            if (!body.has(i, j) || gutter.has(i, j)) {
              ASSERT_EQ(page.image.row(j)[i], body.has(i, j) ? page(Cell::Paper) : Page::kGround)
                  << step << ": " << i << ' ' << j;
            }
      }
    }
  EXPECT_GT(steps, kSanitized ? 25 : 200);
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
    const Event& e = page.event(step);
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

// A cut keeps the names that its two polygons had in the tests before it, and the tests stay in the table.
// The words say which of the two is cut: the one that the record calls P.
TEST(SortPage, ACutKeepsTheNamesOfItsTests) {
  int cuts = 0, ofQ = 0;
  for (const char* const scene : {"penetrate", "teapot", "crossing-sheets"}) {
    SCOPED_TRACE(scene);
    Page page{readScene(scene, 4)};
    const Rect rows{page.at.table.x, page.at.table.y + page.at.line, page.at.table.width,
                    page.at.table.height - page.at.line};
    for (int step = 2; step <= page.run->steps(); ++step) {
      const Event &cut = page.event(step), &tests = page.event(step - 1);
      if (cut.kind != Event::Kind::Split || tests.kind != Event::Kind::Compare) continue;
      const IndexImage atCut = partOf(page.show(step), rows);
      const Event named = *page.run->asTested();
      EXPECT_EQ(named.P, tests.P);
      EXPECT_EQ(named.Q, tests.Q);
      const StepFinding finding = findingOf(*page.run, page.view);
      const bool P = cut.P == tests.P;
      EXPECT_EQ(finding.bold, P ? "P is cut in two." : "Q is cut in two.");
      EXPECT_NE(finding.why.find(P ? "P is split by the plane of Q" : "Q is split by the plane of P"),
                std::string::npos)
          << finding.why;
      EXPECT_EQ(partOf(page.show(step - 1), rows), atCut);
      ++cuts, ofQ += !P;
    }
  }
  EXPECT_GT(cuts, 20);
  EXPECT_GT(ofQ, 5);
}

// The loupe stands in the lower right corner, and elsewhere only if it would hide a part of P or Q there. So
// it seldom jumps.
TEST(SortPage, TheLoupeSeldomJumps) {
  Page page{readScene("teapot", 3)};
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
    Page page{readScene(scene, 3)};
    page.show(page.run->steps() / 2);
    std::vector<int> ids = page.run->waiting();
    for (int n = 0; n < page.run->replay().painted(); ++n) ids.push_back(page.run->paintedId(n));
    constexpr glm::ivec2 kSize{12, 10};
    std::vector<std::uint32_t> faces = page.picture->faceImage();
    int found = 0;
    for (const int id : ids)
      if (const auto corner = page.run->roomFor(id, kSize)) {
        ++found;
        for (int k = 0; k < kSize.x * kSize.y; ++k) {
          std::uint32_t& face =
              faces[std::size_t(corner->y + k / kSize.x) * page.at.picture.width + corner->x + k % kSize.x];
          ASSERT_EQ(face, static_cast<std::uint32_t>(page.run->fragments().face(id).number) + 1);
          face = 0;  // taken
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
  Page page{std::move(near)};
  page.view.loupe = false;
  const Rect& picture = page.at.picture;
  const auto wordsIn = [&](int y) {
    const Rect line{picture.x + 10, picture.y + y, 190, 14};
    return std::ranges::count(partOf(page.image, line).pixels, page(Cell::WellText)) > 50;
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
    const bool isAbove = wordsIn(7);
    EXPECT_NE(isAbove, wordsIn(picture.height - 20)) << step;
    EXPECT_TRUE(isAbove || high) << step;
    (isAbove ? above : below) += 1;
  }
  EXPECT_GT(above, 20);
  EXPECT_GT(below, 20);
}

// All parts lie in the body and do not overlap, in every window with room for them. While the student sorts,
// what is said fits its box, also with the longest names, and every size that the window writes can be read.
TEST(SortLayout, PartsKeepApart) {
  const std::string longest =
      "It is nearer than face 1234.2abab, which is left to paint, at 12,345 samples, such as 123,456. "
      "Test 3 tells: face 1234.2abab is wholly on the far side of the plane of face 5678.2abab.";
  for (const Rect& body : bodies()) {
    SCOPED_TRACE(std::to_string(body.width) + " x " + std::to_string(body.height));
    for (const auto& [shut, own] : {std::pair{false, false}, {true, false}, {false, true}, {true, true}}) {
      if (!shut && body.x < 16) continue;  // with the drawer shut, the margins are smaller
      const SortLayout at = layoutOfSort(body, shut, own);
      EXPECT_EQ(at.picture, layoutOfSort(body, shut).picture);
      EXPECT_GE(std::min(at.picture.width, at.picture.height), kLeastOrderSize);
      if (own) {
        for (const Rect& act : at.acts) EXPECT_EQ(intersection(act, at.finding), act);
        const Rect &last = at.acts.back(), &box = at.finding;
        const auto lines = static_cast<int>(broken(longest, (box.width - 20) / kGlyphWidth).size());
        EXPECT_LE(last.y + last.height + at.line - 2 + (lines - 1) * at.line, box.y + box.height);
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
