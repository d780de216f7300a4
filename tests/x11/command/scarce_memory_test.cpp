#include <cstdlib>
#include <random>

#include "tests/support/seeds.h"
#include "tests/x11/support/command_fixture.h"

namespace xnewell::THIS_FILE {

namespace {

/// The program when the system refuses it memory. Every command writes `out.png`, or a figure of that name.
class ScarceMemory : public CommandTest {
 protected:
  ScarceMemory() {
    std::filesystem::copy(XNEWELL_TESTS_DATA_DIR "/changed", file("."));
    write(
        "t.ply",
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    write("t.off", "OFF\n3 1 3\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    write("cube.json",
          R"({"lights": [{"kind": "spot", "at": [2, 3, 4]}], "materials": {"m": {"texture": "checks.png"}},)"
          R"( "objects": [{"solid": "cube", "material": "m"}, {"file": "t.ply", "move": [0, 0, 2]}]})");
    EXPECT_EQ(runProgram({"draw", file("t.off"), "-o", file("carried.png"), "--size", "40x30"}).status, 0);
    inputs_ = everything();
  }

  /// Runs the program whose allocations fail as `scarcity` says (scarce_memory.cpp).
  static Finished runScarce(const std::string& scarcity, const Strings& words) {
    ::setenv("XNEWELL_SCARCE", scarcity.c_str(), 1);
    RunningProgram program{builtProgram("tests/xnewell_hindered"), words, ""};
    ::unsetenv("XNEWELL_SCARCE");
    return program.wait(std::chrono::seconds{60});
  }
  [[nodiscard]] long allocationsOf(const Strings& words) const {
    (void)runScarce(file("count"), words);
    const long count = std::strtol(contents(file("count")).c_str(), nullptr, 10);
    std::filesystem::remove(file("count"));
    EXPECT_GT(count, 800);
    return count;
  }
  /// What is in the folder beside the inputs. Removes it.
  [[nodiscard]] std::map<std::string, std::string> taken() const {
    std::map<std::string, std::string> now = everything();
    for (const auto& [name, bytes] : inputs_) {
      EXPECT_TRUE(now[name] == bytes) << name;
      now.erase(name);
    }
    for (const auto& [name, bytes] : now) std::filesystem::remove(file(name));
    return now;
  }
  /// Checks that the program, if the n-th allocation fails, or all from the n-th on do, says so in a line and
  /// writes either nothing or what it writes else. A failure that does not matter may go unnoticed: sorting
  /// and buffers can do without. Here n is one of each of `few` parts of from..end, or if the environment has
  /// XNEWELL_ALLOCATIONS=PARTS, of so many, of all if that is more. Returns how many runs there were.
  int failsInALine(const Strings& words, const Finished& well, const std::map<std::string, std::string>& made,
                   long from, long end, long few) const {
    if (const char* const parts = std::getenv("XNEWELL_ALLOCATIONS")) few = std::strtol(parts, nullptr, 10);
    few = std::min(few, end - from);
    std::mt19937 rng{1972};
    int runs = 0;
    for (long part = 0; part < few; ++part) {
      const long begin = from + (end - from) * part / few, next = from + (end - from) * (part + 1) / few;
      const long n = begin + static_cast<long>(rng() % static_cast<unsigned long>(next - begin));
      for (const std::string& scarcity : {std::to_string(n), std::to_string(n) + '+'}) {
        SCOPED_TRACE(words[0] + ' ' + words[1] + ", allocation " + scarcity);
        const Finished run = runScarce(scarcity, words);
        const auto files = taken();
        ++runs;
        if (run.status == 0) {
          EXPECT_EQ(run.err, well.err);
          EXPECT_TRUE(files == made);
          continue;
        }
        EXPECT_EQ(run.status, 1);
        EXPECT_TRUE(files.empty() || files == made);
        // Notes of what a file has and the picture has not may be told before.
        std::string last = run.err;
        if (const std::size_t note = last.rfind("xnewell: note: "); note != last.npos)
          last.erase(0, last.find('\n', note) + 1);
        EXPECT_TRUE(last.starts_with("xnewell: ")) << run.err;
        EXPECT_EQ(std::ranges::count(last, '\n'), 1) << run.err;
        EXPECT_TRUE(last.find("memory") != last.npos) << run.err;
      }
    }
    return runs;
  }

 private:
  std::map<std::string, std::string> inputs_;
};

}  // namespace

// Whatever allocation fails, the program ends with status 1 and a line, and no file is half written: for
// models of all kinds, textures, a picture that carries its set-up, and figures.
TEST_F(ScarceMemory, IsToldInALine) {
  struct Case {
    Strings words;
    std::string output;
  };
  int runs = 0;
  bool options = false;
  // nlohmann-json leaks or asserts if it is refused memory. The program ends then, so only sanitizers mind.
  const Strings stats = kSanitized ? Strings{} : Strings{"--stats"};
  for (const Case& c :
       someOf({Case{Strings{"draw", file("boxes.obj"), "--ids", file("ids.png")} + stats, "out.png"},
               Case{{"draw", file("carried.png")}, "out.png"}, Case{{"figure", file("boxes.obj")}, "out.svg"},
               Case{{"figure", file("cube.json")}, "out.pdf"},
               Case{{"draw", file("cube.json"), "--shade", "phong"}, "out.png"},
               Case{{"draw", file("t.off"), "--order", "oracle"}, "out.png"},
               Case{{"draw", XNEWELL_DATA_DIR "/square.bpt", "--divisions", "2"}, "out.png"},
               Case{{"figure", file("t.ply"), "--edges", "visible"}, "out.eps"}},
              3)) {
    const Strings rest{"--size", "40x30", "-o", file(c.output)};
    const Strings words = c.words + rest;
    const Finished well = runProgram(words);
    ASSERT_EQ(well.status, 0) << well.err;
    const auto made = taken();
    Strings none = words;
    none[1] = file("none.obj");
    const long all = allocationsOf(words), parsed = allocationsOf(none);
    EXPECT_TRUE(taken() == made);
    ASSERT_GT(all, parsed);
    // Most allocations read the options: once is enough.
    if (!std::exchange(options, true))
      runs += failsInALine(words, well, made, 1, parsed, kSanitized ? 15 : 30);
    runs += failsInALine(words, well, made, parsed, all + 1, kSanitized ? 20 : 25);
  }
  if (std::getenv("XNEWELL_ALLOCATIONS") == nullptr) {
    EXPECT_GT(runs, kSanitized ? 100 : 400);
  }
  RecordProperty("runs", runs);
}

}  // namespace xnewell::THIS_FILE
