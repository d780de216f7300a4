#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <random>

#include "geometry/files/parse_error.h"
#include "geometry/files/text_file.h"
#include "tests/support/student_sort.h"
#include "tests/support/student_world.h"
#include "tests/support/temporary_folder.h"
#include "tests/x11/support/stepper.h"
#include "x11/command/commands.h"
#include "x11/drawing/wording.h"
#include "x11/stepper/sort_wording.h"

namespace xnewell::THIS_FILE {

// The stepper with the run of another program.

namespace {

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
      s.press("j");
      s.draw();
      s.press("J");
      s.draw();
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
