#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <random>
#include <set>

#include "depthsort/fragment_spans.h"
#include "depthsort/oracle.h"
#include "depthsort/order.h"
#include "geometry/files/parse_error.h"
#include "geometry/files/text_file.h"
#include "shading/diagnose/judge_order.h"
#include "shading/laboratory/errors.h"
#include "tests/support/seeds.h"
#include "tests/support/student_sort.h"
#include "tests/support/student_world.h"
#include "tests/support/temporary_folder.h"
#include "tests/x11/support/program.h"
#include "tests/x11/support/ready_workbench.h"
#include "tests/x11/support/stepper.h"
#include "x11/command/commands.h"
#include "x11/drawing/wording.h"
#include "x11/options/shell_words.h"
#include "x11/stepper/own_sort.h"
#include "x11/stepper/sort_picture.h"
#include "x11/stepper/sort_wording.h"

namespace xnewell::THIS_FILE {

namespace {

/// A stepper in which somebody sorts.
struct Sorting : Stepper {
  explicit Sorting(const char* scene, int divisions = 3, int width = 800, int height = 540)
      : Stepper{scene, divisions, width, height} {
    press("Y");
    draw();
  }
  [[nodiscard]] const OwnState& own() const { return *bench.view().own; }
  [[nodiscard]] std::vector<int> left() { return run().waiting(); }
  /// Chooses P with the keys.
  void chooseP(int id) {
    const std::vector<int> all = left();
    const auto placeOf = [&](int P) { return std::ranges::find(all, P) - all.begin(); };
    const auto way = placeOf(id) - placeOf(own().P);
    for (auto k = way; k != 0; k += k > 0 ? -1 : 1) press(k > 0 ? NamedKey::Down : NamedKey::Up);
    ASSERT_EQ(own().P, id);
  }
  /// Chooses Q by clicks on one of its samples.
  void chooseQ(int id) {
    if (!own().clicksQ) press("k");
    const Rect at = places().picture;
    const auto [i, j] = *samplesOf(id).begin();
    for (int tries = 0; tries < 400 && own().Q != id; ++tries) click(at.x + i, at.y + j);
    ASSERT_EQ(own().Q, id);
  }
  [[nodiscard]] std::set<std::pair<int, int>> samplesOf(int id) {
    std::set<std::pair<int, int>> all;
    const Rect at = places().picture;
    forEachSpan(run().scene(), run().sorted(), fragmentOf(run().scene(), run().sorted(), id), at.width,
                at.height, [&](int row, int from, int to) {
                  for (int i = from; i < to; ++i) all.insert({i, row});
                });
    return all;
  }
  /// True if P is nearer than R at one of their common samples.
  [[nodiscard]] bool hides(int P, int R) {
    const SnappedScene& scene = run().scene();
    const int p = run().fragments().faceIndex(P), r = run().fragments().faceIndex(R);
    const auto ofR = samplesOf(R);
    return std::ranges::any_of(samplesOf(P), [&](const auto& s) {
      return ofR.contains(s) &&
             nearer(scene.planes[scene.faces[p].plane], scene.planes[scene.faces[r].plane], s.first,
                    s.second) > 0 &&
             checkOf(scene, r, p, s.first, s.second) == SampleCheck::Wrong;
    });
  }
  /// True if the plane of Q has corners of P on both sides.
  [[nodiscard]] bool crosses(int P, int Q) {
    if (run().fragments().faceIndex(P) == run().fragments().faceIndex(Q)) return false;
    const CornerCounts counts = run().explainer().corners(P, Q);
    return counts.inFront > 0 && counts.behind > 0;
  }
  /// Chooses P and paints it.
  void paint(int id) {
    chooseP(id);
    press("p");
  }
  /// What the file that `o` writes holds.
  std::vector<PaintStep> written(const std::string& file) {
    press("o");
    EXPECT_EQ(type(file), "");
    const PaintOrder order = readPaintOrder(file, picture().scene().mesh.faceCount());
    EXPECT_EQ(order.size, (glm::ivec2{places().picture.width, places().picture.height}));
    EXPECT_EQ(order.steps.back().line, bench.own()->steps(run()).back().line);
    return order.steps;
  }
};

/// Paints everything in a random order in which nothing hides what is left; cuts where there is none.
void sortByTruth(Sorting& s, unsigned seed) {
  std::mt19937 dice{seed};
  for (int steps = 0; steps < 400; ++steps) {
    std::vector<int> all = s.left();
    if (all.empty()) return;
    std::ranges::shuffle(all, dice);
    const auto isFree = [&](int P) {
      return std::ranges::none_of(all, [&](int R) { return R != P && s.hides(P, R); });
    };
    if (const auto P = std::ranges::find_if(all, isFree); P != all.end()) {
      s.paint(*P);
      continue;
    }
    bool cut = false;
    for (const int P : all)
      for (const int Q : all)
        if (!cut && P != Q && s.hides(P, Q) && s.crosses(P, Q) && !s.samplesOf(Q).empty()) {
          s.chooseP(P);
          s.chooseQ(Q);
          s.press("c");
          cut = true;
        }
    ASSERT_TRUE(cut);
  }
  FAIL() << "too many steps";
}

struct Theirs : Stepper {
  explicit Theirs(const char* scene) : Stepper{scene} {}
  void open(const std::string& file) {
    bench.open(file, picture().scene());
    draw();
  }
  student::Sorted write(const std::string& file, std::string_view fault) {
    return student::writeRun(studentsWorld(picture()), 400, 300, file.c_str(), 1, fault);
  }
  [[nodiscard]] const RunReport& report() { return run().theirs()->report; }
  [[nodiscard]] std::string words() { return testing::PrintToString(stepAsLines(run(), bench.view())); }
};

}  // namespace

// The student sorts: what is valid, what a wrong step does, what is kept of it, and what the page says.

// Whoever paints only what hides nothing that is left, in any order, does only valid steps. The file that is
// written is right to `judge`, and so is the whole in the window.
TEST(OwnSort, EveryTrueOrderIsValid) {
  const TemporaryFolder folder;
  int cuts = 0;
  for (const char* scene : someOf({"two-cards", "three-cards", "cycle", "penetrate", "sticks", "five-tests",
                                   "turned-cards", "makie-4693", "threejs-6887", "cubes"},
                                  3)) {
    SCOPED_TRACE(scene);
    Sorting s{scene};
    sortByTruth(s, 44);
    EXPECT_GT(s.own().score.asked, 1);
    EXPECT_EQ(s.own().score.right, s.own().score.asked) << s.own().why;
    EXPECT_TRUE(s.own().bold.ends_with("is right.")) << s.own().bold;
    EXPECT_TRUE(s.own().spoilt.empty());
    cuts += static_cast<int>(s.run().landmarks().steps(Landmark::Cut).size());
    const std::string file = folder.file(std::string{scene} + ".jsonl");
    const std::vector<PaintStep> steps = s.written(file);
    EXPECT_EQ(steps.size(), s.run().sorted().fragments.size());
    EXPECT_TRUE(judgeOrder(s.picture().withPlanes(), steps).isRight());
    const std::string command = *s.bench.command();
    ASSERT_TRUE(command.starts_with("xnewell judge ")) << command;
    std::vector<std::string> words = *wordsOf(command);
    words.erase(words.begin());
    EXPECT_EQ(words.back(), file);
    const auto end = runProgram(words);
    EXPECT_EQ(end.status, 0) << command << end.out << end.err;
    EXPECT_TRUE(end.out.starts_with("right: ")) << end.out;
  }
  EXPECT_GT(cuts, kSanitized ? 0 : 2);
}

// A teapot painted by mean z: the first wrong pair in the window is that of `judge` on the file. What was
// painted too early is what the picture then lacks.
TEST(OwnSort, AWrongOrderIsJudgedAlike) {
  const TemporaryFolder folder;
  Sorting s{"teapot", 3};
  std::vector<int> order = paintingOrder(s.run().scene(), Order::ZMean);
  const std::vector<int> all = s.left();
  std::erase_if(order, [&](int f) { return std::ranges::find(all, f) == all.end(); });
  for (const int face : order) s.paint(face);
  const OrderReport window = s.bench.ownReport();
  ASSERT_TRUE(window.first);
  EXPECT_LT(s.own().score.right, s.own().score.asked);
  EXPECT_TRUE(s.own().bold.ends_with("is wrong."));
  const std::vector<PaintStep> steps = s.written(folder.file("mean.jsonl"));
  const OrderReport judged = judgeOrder(s.picture().withPlanes(), steps);
  ASSERT_TRUE(judged.first);
  EXPECT_EQ(judged.first->shown, window.first->shown);
  EXPECT_EQ(judged.first->hidden, window.first->hidden);
  EXPECT_EQ(judged.first->i, window.first->i);
  EXPECT_EQ(judged.first->told, window.first->told);
  EXPECT_EQ(judged.wrongSamples, window.wrongSamples);
  // Its sample was marked when what is hidden there was painted.
  const auto& marked = s.own().spoilt;
  EXPECT_TRUE(std::ranges::any_of(marked, [&](const SampleRow& row) {
    return row.row == judged.first->j && row.from <= judged.first->i && judged.first->i < row.to;
  }));
}

// The nearer of two cards painted first is taken, and spoils the picture: the samples are marked, and a test
// of 3 and 4 would have told. Painted to the end, just these samples show the wrong face.
TEST(OwnSort, PaintingTooEarlySpoilsThePicture) {
  Sorting s{"two-cards"};
  const std::vector<int> all = s.left();
  ASSERT_EQ(all.size(), 2u);
  const int P = s.hides(all[0], all[1]) ? all[0] : all[1];
  s.paint(P);
  s.draw();
  EXPECT_EQ(s.own().score, (Score{0, 1}));
  EXPECT_TRUE(s.own().alarm);
  EXPECT_TRUE(s.own().bold.ends_with(" is painted too early.")) << s.own().bold;
  EXPECT_TRUE(s.own().why.find(". Test 3 tells: ") != std::string::npos ||
              s.own().why.find(". Test 4 tells: ") != std::string::npos)
      << s.own().why;
  std::set<std::pair<int, int>> spoilt;
  for (const SampleRow& row : s.own().spoilt)
    for (int i = row.from; i < row.to; ++i) spoilt.insert({i, row.row});
  ASSERT_FALSE(spoilt.empty());
  const Rect at = s.places().picture;
  const CellPlan plan{TableKind::Linear};
  const auto marked = std::ranges::count_if(spoilt, [&](const auto& sample) {
    const int shown = s.image().row(at.y + sample.second)[at.x + sample.first];
    return shown == plan[Cell::Alarm] || shown == plan[Cell::White];
  });
  // The tint and the outline of what is chosen now, and the loupe, cover some of them.
  EXPECT_GT(2 * marked, std::ssize(spoilt));
  s.press("p");
  const std::vector<int> nearest = visibleFaces(s.run().scene(), at.width, at.height);
  std::set<std::pair<int, int>> wrong;
  for (const auto& sample : s.samplesOf(s.run().paintedId(1)))
    if (nearest[sample.second * at.width + sample.first] == P) wrong.insert(sample);
  EXPECT_EQ(wrong, spoilt);
  EXPECT_TRUE(s.own().bold.ends_with("is wrong."));
}

// Of tests 1 to 5 just those are steps that truly pass, by the numbers of the page.
TEST(OwnSort, NamedTestsMustPass) {
  int passed = 0, failed = 0;
  for (const char* scene : {"five-tests", "cycle", "crossing-sheets"}) {
    Sorting s{scene};
    const std::vector<int> all = s.left();
    for (const int P : all)
      for (const int Q : all) {
        if (P == Q) continue;
        s.chooseP(P);
        for (std::size_t k = 0; k < all.size() && s.own().Q != Q; ++k) s.press("n");
        if (s.own().Q != Q) continue;  // it does not overlap P in z
        const Explainer& e = s.run().explainer();
        const auto apart = [](const Range& a, const Range& b) { return a.high <= b.low || b.high <= a.low; };
        const CornerCounts p = e.corners(P, Q), q = e.corners(Q, P);
        const bool onePlane = p.inFront + p.behind == 0;
        const std::array<bool, 5> truth{apart(e.xExtent(P), e.xExtent(Q)), apart(e.yExtent(P), e.yExtent(Q)),
                                        !onePlane && p.inFront == 0, !onePlane && q.behind == 0,
                                        e.separatingEdge(P, Q).has_value()};
        for (int k = 0; k < 5; ++k) {
          const Score before = s.own().score;
          const int events = s.bench.own()->events();
          s.press("t" + std::to_string(k + 1));
          EXPECT_EQ(s.own().score, (Score{before.right + truth[k], before.asked + truth[k]}))
              << scene << ' ' << P << ' ' << Q << ' ' << k + 1;
          EXPECT_EQ(s.bench.own()->events() > events, truth[k]);
          EXPECT_EQ(s.own().passed[k], truth[k]);
          (truth[k] ? passed : failed)++;
        }
      }
  }
  EXPECT_GT(passed, 20);
  EXPECT_GT(failed, 20);
}

// A move is refused where Q is nearer somewhere, and a cut where the plane does not cross: nothing is done.
// Where they are true they are done.
TEST(OwnSort, RefusesWhatIsNotTrue) {
  int moved = 0, kept = 0, cut = 0, whole = 0;
  for (const char* scene : {"cycle", "crossing-sheets", "two-cards"}) {
    Sorting s{scene};
    const std::vector<int> all = s.left();
    for (const int P : all)
      for (int k = 0; k < 4; ++k) {
        s.chooseP(P);
        for (int n = 0; n < k; ++n) s.press("n");
        const int Q = s.own().Q;
        for (const char key : {'m', 'c', 's'}) {
          const bool isTrue = key == 'm' ? !s.hides(Q, P) : key == 'c' ? s.crosses(P, Q) : s.crosses(Q, P);
          const Score before = s.own().score;
          const int events = s.bench.own()->events();
          s.press({key});
          EXPECT_EQ(s.own().score, (Score{before.right + isTrue, before.asked + 1})) << s.own().why;
          EXPECT_EQ(s.own().alarm, !isTrue);
          EXPECT_EQ(s.bench.own()->events() > events, isTrue);
          (key == 'm' ? (isTrue ? moved : kept) : (isTrue ? cut : whole))++;
          if (isTrue) s.press(NamedKey::Backspace);
          EXPECT_EQ(s.bench.own()->events(), events);
          EXPECT_EQ(s.own().P, P);
          EXPECT_EQ(s.own().Q, Q);
        }
      }
  }
  EXPECT_GT(std::min({moved, kept, cut, whole}), 0) << moved << ' ' << kept << ' ' << cut << ' ' << whole;
}

// Each step taken back leaves the picture, the list and the side view bit by bit as they were, and done again
// it does the same.
TEST(OwnSort, TakingBackRestoresThePicture) {
  Sorting s{"cycle", 3, 1024, 768};
  const Rect picture = s.places().picture, list = s.places().list, side = s.places().side;
  const auto parts = [&] {
    s.draw();
    return std::array{partOf(s.image(), picture), partOf(s.image(), list), partOf(s.image(), side)};
  };
  std::vector<std::array<IndexImage, 3>> shown;
  std::mt19937 dice{7};
  int tries = 0;
  for (; shown.size() < 12 && tries < 400; ++tries) {
    const int events = s.bench.own()->events();
    if (tries % 3 == 0) s.press("n");
    const auto before = parts();
    const char key = "mcsmcst3p"[std::uniform_int_distribution{0, 6 + 2 * (tries % 20 == 19)}(dice)];
    s.press({key});
    if (s.bench.own()->events() == events) continue;
    shown.push_back(before);
    const auto after = parts();
    s.press(NamedKey::Backspace);
    s.press({key});
    EXPECT_TRUE(parts() == after) << "done again: " << key;
    if (s.left().empty()) break;
  }
  const int done = static_cast<int>(shown.size());
  EXPECT_GT(done, 8);
  EXPECT_NE(shown.front(), shown.back());
  for (int k = done; k-- > 0;) {
    s.press(NamedKey::Backspace);
    EXPECT_TRUE(parts() == shown[k]) << k;
  }
  EXPECT_EQ(s.bench.own()->events(), 0);
  s.press(NamedKey::Backspace);
  EXPECT_EQ(s.notices.back(), "There is no step to take back.");
}

// A click on a row of the tests names that test, as `t` and its digit do, also after other steps. Nothing
// else happens: the run is not left for another step.
TEST(OwnPage, AClickOnATestNamesIt) {
  for (const auto& [width, height] : {std::pair{1024, 768}, {800, 600}, {1280, 1024}, {2048, 1536}})
    for (const char* const before : {"", "cp"})
      for (int k = 0; k < kOwnTests; ++k) {
        SCOPED_TRACE(std::to_string(width) + ' ' + before + ' ' + std::to_string(k + 1));
        Sorting clicked{"cycle", 3, width, height}, typed{"cycle", 3, width, height};
        for (Sorting* const page : {&clicked, &typed}) page->press(before), page->draw();
        clicked.click(layoutOfSort(layoutOf(width, height).body, false, true).testRow(k));
        typed.press("t" + std::to_string(k + 1));
        clicked.draw(), typed.draw();
        EXPECT_TRUE(clicked.own().passed[k]);
        EXPECT_EQ(clicked.own(), typed.own());
        EXPECT_EQ(clicked.step(), clicked.run().steps());
      }
}

// The stepper with the run of another program.

// j goes from one false step to the next, each at its line and with the judge's words. At a wrong answer the
// table says what it should be.
TEST(TheirRun, JumpsFromOneFalseStepToTheNext) {
  const TemporaryFolder folder;
  int answers = 0;
  for (const char* const scene : {"cycle", "two-cards"}) {
    Theirs s{scene};
    for (const student::Fault& fault : student::kFaults) {
      const std::string file = folder.file("run.jsonl");
      if (!s.write(file, fault.name).done) continue;
      s.open(file);
      ASSERT_TRUE(s.run().theirs());
      for (const FalseStep& wrong : s.report().wrong) {
        s.press(NamedKey::Home);
        s.notices.clear();  // it may say that this is the start
        do s.press("j"), s.draw();
        while (s.words().find(wrong.says.substr(1)) == std::string::npos && s.notices.empty());
        ASSERT_TRUE(s.notices.empty()) << scene << ", " << fault.name << ": " << wrong.says;
        if (wrong.line > 0) {
          EXPECT_NEAR(s.run().line(), wrong.line, wrong.kind == Falsehood::Gone ? 1 : 0) << fault.name;
        } else {
          EXPECT_EQ(s.step(), s.run().steps());
        }
        if (wrong.kind != Falsehood::Answer) continue;
        ++answers;
        EXPECT_NE(s.words().find(wrong.says.find(" says no") != std::string::npos ? "no; it is yes"
                                                                                  : "yes; it is no"),
                  std::string::npos)
            << s.words();
      }
    }
  }
  EXPECT_GE(answers, 8);
}

// What trace writes is the program's own run: the same is painted in the end, and no step is false.
TEST(TheirRun, TheProgramsOwnRunIsTheSame) {
  const TemporaryFolder folder;
  for (const char* const scene : {"cycle", "bench", "nested-cycles"}) {
    Theirs s{scene};
    s.press(NamedKey::End);
    s.draw();
    const IndexImage ours = s.run().soFar();
    std::ofstream out{folder.file("run.jsonl")};
    Options options;
    options.scene = scene;
    const Picture picture = s.picture().withPlanes();
    printTrace(options, picture, recordedRun(options, picture), out);
    out.close();
    s.open(folder.file("run.jsonl"));
    s.press(NamedKey::End);
    s.draw();
    EXPECT_TRUE(s.stepsOf(Landmark::Failed).empty());
    EXPECT_EQ(s.run().soFar(), ours) << scene;
  }
}

// Lines in any order, left out and twice, are a run that can be stepped, or none. A program that ended early
// has its last step, too.
TEST(TheirRun, AnyLinesCanBeStepped) {
  const TemporaryFolder folder;
  Theirs s{"cycle"};
  const std::string file = folder.file("run.jsonl");
  static_cast<void>(s.write(file, ""));
  std::vector<std::string> lines;
  std::istringstream text{readTextFile(file, 1 << 20)};
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  const auto opens = [&](const std::vector<std::string>& some) {
    std::ofstream out{file};
    for (const std::string& line : some) out << line << '\n';
    out.close();
    s.open(file);
  };
  const auto isCut = [](const std::string& line) { return line.find("\"cut\"") != std::string::npos; };
  const std::size_t cut = std::ranges::find_if(lines.rbegin(), lines.rend(), isCut).base() -
                          lines.begin();  // its pieces have no names before
  std::mt19937 random{7};
  int stepped = 0;
  for (int round = 0; round < 60; ++round) {
    std::vector<std::string> some = lines;
    for (int k = 0; k < 1 + round / 3; ++k) {
      const std::size_t a = cut + random() % (some.size() - cut), b = cut + random() % (some.size() - cut);
      random() % 2 == 0 ? std::swap(some[a], some[b]) : static_cast<void>(some[a] = some[b]);
    }
    try {
      opens(some);
    } catch (const ParseError&) {
      continue;
    }
    ++stepped;
    for (int k = 0; k < 6; ++k) {
      s.goTo(static_cast<int>(random() % (s.run().steps() + 1)));
      for (const char* const jump : {"j", "J"}) s.press(jump), s.draw();
    }
  }
  EXPECT_GE(stepped, 40);
  for (std::size_t length = 2; length < lines.size(); ++length) {
    opens({lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(length)});
    s.goTo(s.run().steps());
    s.draw();
  }
}

// Their tests of a pair are one question, and the answer is the true one, whatever they say. From another
// camera their run is not shown.
TEST(TheirRun, PredictsAndHasItsOwnView) {
  const TemporaryFolder folder;
  Theirs s{"two-cards"};
  static_cast<void>(s.write(folder.file("run.jsonl"), "test 3 has the other sign"));
  s.open(folder.file("run.jsonl"));
  s.press("y");
  int asked = 0;
  for (int step = 1; step <= s.run().steps(); ++step) {
    s.goTo(step);
    s.draw();
    if (!s.bench.view().asking) continue;
    ++asked;
    s.press(std::string{
        kAnswerKeys[static_cast<std::size_t>(s.run().compared(s.event().P, s.event().Q).verdict)]});
  }
  EXPECT_EQ(s.bench.view().score, (Score{asked, asked}));
  EXPECT_GE(asked, 2);
  EXPECT_LT(asked, s.run().landmarks().pairs(s.run().steps()));
  s.wanted.picture.camera.eye = glm::dvec3{1, 2, 30};
  s.draw();
  EXPECT_FALSE(s.run().theirs());
}

}  // namespace xnewell::THIS_FILE
