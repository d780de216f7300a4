#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <random>
#include <string_view>

#include "tests/support/seeds.h"
#include "tests/x11/support/command_fixture.h"
#include "tests/x11/support/program_picture.h"
#include "tests/x11/support/x_server.h"
#include "x11/options/option_rows.h"

namespace xnewell::THIS_FILE {

namespace {

/// A command with an option that writes a file or a folder of files. In its words, @ is the target, behind
/// the option, and @NAME another file in the folder.
struct WritingRow {
  std::string line, target = "out.png";
  bool server = false;
  [[nodiscard]] std::string command() const { return line.substr(0, line.find(' ')); }
  [[nodiscard]] std::string option() const {
    const Strings all = words(line);
    return *(std::ranges::find(all, "@") - 1);
  }
};
const std::array kWriting{
    WritingRow{"draw cycle --output @ --size 40x30"},
    WritingRow{"draw cycle --ids @ -o @other.png --size 40x30"},
    WritingRow{"snapshot cycle --output @ --size 40x30", "out.png", true},
    WritingRow{"snapshot cycle --ids @ -o @other.png --size 40x30", "out.png", true},
    WritingRow{"figure cycle --output @ --size 40x30", "out.svg"},
    WritingRow{"figure cycle --ids @ -o @other.pdf --size 40x30", "out.svg"},
    WritingRow{"trace cycle --frames @ --size 40x30", "frames"},
    WritingRow{"trade cycle --output @ --size 8x6 --budget 1 --axes order"},
    WritingRow{"extremes cycle --output @ --size 8x6"},
    WritingRow{"diagnose bench --output @ @in/drawn.png"},
    WritingRow{"judge cycle --output @ @in/wrong.jsonl", "out.json"},
    WritingRow{"grade bench --output @ @in", "out.csv"},
    WritingRow{"grade bench --page @ @in -o @other.csv", "out.html"},
    WritingRow{"grade bench --feedback @ @in -o @other.csv", "pages"},
    WritingRow{"questions cycle --solutions @ --count 5", "out.txt"},
    WritingRow{"questions cycle --gift @ --count 5", "out.gift"},
    WritingRow{"lesson --solutions @ cycles --worksheet @other.html", "out.html"},
    WritingRow{"lesson --frames @ cycles", "frames"},
    WritingRow{"lesson --worksheet @ cycles", "out.html"},
};

/// These options read a file, or write it while a window is open.
constexpr std::array<std::string_view, 4> kOthers{"--texture", "--answers", "--run", "--rubric"};

class InFolder : public CommandTest {
 protected:
  /// The words of a line. @NAME is a file of the folder, and @ alone the target.
  [[nodiscard]] Strings wordsOf(const std::string& line, const std::string& target = "") const {
    Strings all = words(line);
    for (std::string& word : all)
      if (word.starts_with('@')) word = word == "@" ? target : file(word.substr(1));
    return all;
  }
};

class WrittenFiles : public InFolder {
 protected:
  WrittenFiles() {
    std::filesystem::remove(file("old.png"));
    std::filesystem::create_directory(file("in"));
    EXPECT_EQ(runProgram({"draw", "bench", "--size", "40x30", "-o", file("in/drawn.png")}).status, 0);
    write("in/wrong.jsonl", "{\"face\": 2}\n{\"face\": 1}\n{\"face\": 0}\n");
  }

  /// Runs a row. If `hindrance` is not empty, its writes meet that (hindered.cpp).
  [[nodiscard]] Finished runRow(const WritingRow& row, const std::string& target,
                                const std::string& hindrance = "") {
    if (row.server && !server_) server_.emplace(XServer::xvfb(24));
    ::setenv("XNEWELL_HINDER", hindrance.c_str(), 1);
    RunningProgram program{builtProgram(hindrance.empty() ? "x11/xnewell" : "tests/xnewell_hindered"),
                           wordsOf(row.line, target), row.server ? server_->name() : ""};
    ::unsetenv("XNEWELL_HINDER");
    return program.wait();
  }
  /// What the folder has beside the inputs, with the names of files in folders. An empty folder counts as
  /// none.
  [[nodiscard]] std::map<std::string, std::string> outputs() const {
    std::map<std::string, std::string> all;
    const std::filesystem::path top = file(".");
    for (const auto& entry : std::filesystem::recursive_directory_iterator{top})
      if (const std::string name = entry.path().lexically_relative(top).string();
          entry.is_regular_file() && !name.starts_with("in/"))
        all[name] = contents(entry.path().string());
    return all;
  }
  void removeOutputs() const {
    for (const auto& entry : std::filesystem::directory_iterator{file(".")})
      if (entry.path().filename() != "in") std::filesystem::remove_all(entry.path());
  }
  /// Checks the one line of a failed run, and that it left the folder as it was.
  void failed(const WritingRow& row, const std::string& target, const std::string& hindrance,
              const std::string& reason) {
    const auto before = outputs();
    const Finished end = runRow(row, target, hindrance);
    EXPECT_EQ(end.status, 1);
    EXPECT_TRUE(end.err.starts_with("xnewell: " + file(""))) << end.err;
    EXPECT_TRUE(end.err.ends_with(": " + reason + "\n")) << end.err;
    EXPECT_EQ(std::ranges::count(end.err, '\n'), 1) << end.err;
    EXPECT_TRUE(outputs() == before) << outputs().size() << " files";
    removeOutputs();
  }

 private:
  std::optional<XServer> server_;
};

bool isFolder(const WritingRow& row) { return row.option() == "--frames" || row.option() == "--feedback"; }

/// The program when the system refuses it memory. Every command writes `out.png`, or a figure of that name.
class ScarceMemory : public InFolder {
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

  /// Runs the program whose allocations fail as `scarcity` says (hindered.cpp).
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

// The table has every option that takes the name of a file or folder, with each command where it works.
TEST_F(WrittenFiles, AreAllInTheTable) {
  int found = 0;
  for (const OptionRow& option : optionRows()) {
    if (option.takes != Takes::File && option.takes != Takes::Folder) continue;
    if (std::ranges::count(kOthers, option.name) > 0) continue;
    EXPECT_FALSE(option.places.empty()) << option.name;
    for (const std::string_view place : option.places) {
      const std::string_view command = place.substr(0, place.find(' '));
      if (option.name == "--page" && command != "grade")
        continue;  // needs the page of a browser: options_test.cpp
      EXPECT_EQ(std::ranges::count_if(
                    kWriting,
                    [&](const WritingRow& r) { return r.option() == option.name && r.command() == command; }),
                1)
          << option.name << ' ' << command;
      ++found;
    }
  }
  EXPECT_EQ(found, kWriting.size());
}

// A disk that is full, early or late, a device that is full, a folder in the place of a file, or a file in
// the place of a folder: status 1 and one line. The old file stays, a new one is not there, and neither is
// any other.
TEST_F(WrittenFiles, AreWholeOrAsTheyWere) {
  for (const WritingRow& row : kWriting) {
    SCOPED_TRACE(row.line);
    const std::string target = file(row.target), full = std::strerror(ENOSPC);
    const Finished well = runRow(row, target);
    EXPECT_EQ(well.err, "");
    EXPECT_TRUE(std::filesystem::exists(target));
    const auto made = outputs();
    removeOutputs();
    for (const std::string& hindrance : someOf({std::string{"full"}, std::string{"late"}}, 1)) {
      failed(row, target, hindrance, full);
      if (isFolder(row)) continue;
      write(row.target, "before");
      failed(row, target, hindrance, full);
    }
    if (isFolder(row)) {
      write(row.target, "before");
      failed(row, target, "", std::strerror(ENOTDIR));
      continue;
    }
    std::filesystem::create_symlink("/dev/full", target);
    failed(row, target, "", full);
    std::filesystem::create_directory(target);
    failed(row, target, "", std::strerror(EISDIR));
    failed(row, file("none/" + row.target), "", std::strerror(ENOENT));
  }
}

// An interrupt while a file is half written, and again before it takes its name: the program ends as soon as
// the file is whole, with 128 and the signal's number, or as if there had been none. No temporary file stays,
// although another thread would take the signal.
TEST_F(WrittenFiles, SurviveInterrupts) {
  int interrupted = 0;
  for (const WritingRow& row : kWriting)
    for (const int signal : someOf({SIGINT, SIGTERM, SIGHUP, SIGPIPE}, 1)) {
      SCOPED_TRACE(row.line + ", signal " + std::to_string(signal));
      const std::string target = file(row.target);
      const Finished well = runRow(row, target);
      const auto made = outputs();
      removeOutputs();
      if (!isFolder(row)) write(row.target, "before");
      const Finished end = runRow(row, target, std::to_string(signal));
      EXPECT_TRUE(end.status == 128 + signal || end.status == well.status) << end.status;
      interrupted += end.status == 128 + signal;
      EXPECT_EQ(end.err, "");
      EXPECT_TRUE(std::filesystem::exists(target));
      const auto now = outputs();
      EXPECT_TRUE(isFolder(row) ? !now.empty() : now.size() == made.size());
      for (const auto& [name, bytes] : now) {
        EXPECT_TRUE(made.contains(name)) << name;
        // A chart of measured times differs from run to run.
        if (row.command() == "trade")
          EXPECT_GT(readPng(file(name)).width, 0);
        else
          EXPECT_TRUE(bytes == made.at(name)) << name;
      }
      removeOutputs();
    }
  EXPECT_GT(interrupted, kSanitized ? 8 : 20);
}

// Whatever allocation fails, the program ends with status 1 and a line, and no file is half written: for
// models of all kinds, textures, a picture that carries its set-up, and figures.
TEST_F(ScarceMemory, IsToldInALine) {
  int runs = 0;
  bool options = false;
  // nlohmann-json leaks or asserts if it is refused memory. The program ends then, so only sanitizers mind.
  const std::string stats = kSanitized ? "" : " --stats";
  for (const std::string& line : someOf<std::string>(
           {"draw @boxes.obj --ids @ids.png -o @out.png" + stats, "draw @carried.png -o @out.png",
            "figure @boxes.obj -o @out.svg", "figure @cube.json -o @out.pdf",
            "draw @cube.json --shade phong -o @out.png", "draw @t.off --order oracle -o @out.png",
            "draw " XNEWELL_DATA_DIR "/square.bpt --divisions 2 -o @out.png",
            "figure @t.ply --edges visible -o @out.eps"},
           3)) {
    const Strings words = wordsOf(line + " --size 40x30");
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
