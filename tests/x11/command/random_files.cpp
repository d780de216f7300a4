#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <random>
#include <set>
#include <sstream>
#include <string>

#include <time.h>
#include <unistd.h>

#include "shading/color/png.h"
#include "tests/x11/support/changed_numbers.h"
#include "tests/x11/support/program.h"
#include "tests/x11/support/random_words.h"
#include "tests/x11/support/x_server.h"

namespace xnewell {

// random_files [SECONDS [SEED [CASE]]] changes a few numbers in valid scenes, models and lessons, and gives
// them to every command with random options, for SECONDS. With CASE it tries this case alone. It fails if the
// program ends by a signal, takes too long or too much memory, ends with a status other than 0, 1 and 2, says
// anything but `xnewell: ...` lines, complains in more than one line, or leaves a part of a file. The folder
// of a case that failed stays, with the command in it.

namespace {

namespace fs = std::filesystem;

#ifdef __SANITIZE_ADDRESS__
constexpr double kMostSeconds = 240, kMostMegabytes = 6'000;
#else
constexpr double kMostSeconds = 30, kMostMegabytes = 2'000;
#endif
constexpr double kMostWaiting = 20;  ///< how many times as long as that it may take on a busy machine

/// What each case gets a copy of.
const std::array kSources{
    fs::path{XNEWELL_DATA_DIR} / "scenes",     fs::path{XNEWELL_DATA_DIR} / "lessons",
    fs::path{XNEWELL_DATA_DIR} / "textures",   fs::path{XNEWELL_DATA_DIR} / "square.bpt",
    fs::path{XNEWELL_DATA_DIR} / "teapot.bpt", fs::path{XNEWELL_TESTS_DATA_DIR} / "changed",
    fs::path{XNEWELL_TESTS_DATA_DIR} / "near"};

std::string contents(const fs::path& file) {
  std::ifstream in{file, std::ios::binary};
  return {std::istreambuf_iterator<char>{in}, {}};
}

/// All files in a folder, sorted.
std::vector<fs::path> filesBelow(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator{folder})
    if (!entry.is_directory()) files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

std::string quoted(const std::string& word) {
  const bool plain = !word.empty() && word.find_first_not_of(
                                          "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRST"
                                          "UVWXYZ0123456789-_./,=+:") == std::string::npos;
  return plain ? word : "'" + word + "'";
}

/// The end of a run that may take only so much. `took` says what was too much.
struct Run {
  Finished end;
  std::string took;
};

Run runWithin(const std::vector<std::string>& words, const std::string& display) {
  RunningProgram program{words, display};
  const pid_t pid = program.pid();
  const auto start = std::chrono::steady_clock::now();
  Run run;
  for (useconds_t pause = 500; program.running(); pause = std::min<useconds_t>(2 * pause, 20'000)) {
    usleep(pause);
    timespec used{};
    clockid_t clock = 0;
    if (clock_getcpuclockid(pid, &clock) == 0) clock_gettime(clock, &used);
    long all = 0, resident = 0;
    std::ifstream{"/proc/" + std::to_string(pid) + "/statm"} >> all >> resident;
    const double megabytes =
        static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1 << 20);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    if (static_cast<double>(used.tv_sec) > kMostSeconds)
      run.took = "took more than " + std::to_string(int(kMostSeconds)) + " s of the processor's time";
    else if (elapsed.count() > kMostWaiting * kMostSeconds)
      run.took = "did not end";
    else if (megabytes > kMostMegabytes)
      run.took = "took more than " + std::to_string(int(kMostMegabytes)) + " MB";
    if (run.took.empty()) continue;
    program.signal(SIGKILL);
    break;
  }
  run.end = program.wait();
  return run;
}

/// What is wrong with the messages; "" if nothing.
std::string wrongMessages(const Finished& end) {
  std::istringstream in{end.err};
  int complaints = 0;
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with("xnewell: ") || line.size() > 900) return "says something else than `xnewell: ...`";
    complaints += !line.starts_with("xnewell: note: ");
  }
  if (!end.err.empty() && !end.err.ends_with('\n')) return "its last line has no end";
  if (end.status != 0 && complaints != 1)
    return "complains in " + std::to_string(complaints) + " lines where one is promised";
  return "";
}

/// What is wrong with standard output; "" if nothing.
std::string wrongOutput(const RandomWords& tried, const Finished& end) {
  if (end.status != 0) return end.out.empty() ? "" : "fails, and has written to standard output";
  using Json = nlohmann::json;
  if (tried.printsJson && !Json::accept(end.out)) return "prints what is no JSON";
  std::istringstream in{end.out};
  if (tried.printsLines)
    for (std::string line; std::getline(in, line);)
      if (!Json::accept(line)) return "prints a line that is no JSON: " + line;
  return "";
}

/// What is wrong with the files that it has left; "" if nothing.
std::string wrongFiles(const RandomWords& tried, const Finished& end, const fs::path& folder) {
  std::set<std::string> missing;
  // A slow build times nothing within a small budget. Then a trade has no chart to write, and says so.
  const bool noChart = end.err.find("no chart was written: nothing was timed") != std::string::npos;
  if (end.status == 0 && !noChart) missing.insert(tried.writes.begin(), tried.writes.end());
  for (const fs::path& file : filesBelow(folder)) {
    const bool frame = file.parent_path().filename() == kFrames && file.extension() == ".png";
    if (!frame && missing.erase(file.filename().string()) == 0)
      return "has left " + file.filename().string() + " behind";
    try {
      (void)readPng(file.string());
    } catch (const std::exception& e) {
      return std::string{"has left a part of a picture: "} + e.what();
    }
  }
  return missing.empty() ? "" : "has not written " + *missing.begin();
}

/// What is wrong with a run; "" if nothing.
std::string wrongIn(const RandomWords& tried, const Run& run, const fs::path& folder) {
  if (!run.took.empty()) return run.took;
  if (run.end.status > 128) return std::string{"ends by signal: "} + strsignal(run.end.status - 128);
  if (run.end.status < 0 || run.end.status > 2) return "ends with status " + std::to_string(run.end.status);
  for (const std::string& wrong :
       {wrongMessages(run.end), wrongOutput(tried, run.end), wrongFiles(tried, run.end, folder)})
    if (!wrong.empty()) return wrong;
  return "";
}

/// Makes and runs one case in a folder of its own. Returns false if it failed.
bool tryCase(unsigned seed, int number, const fs::path& folder, const std::string& display,
             std::array<int, 3>& ends) {
  std::seed_seq both{seed, static_cast<unsigned>(number)};
  std::mt19937 rng{both};
  fs::remove_all(folder);
  fs::create_directories(folder / "out");
  for (const fs::path& source : kSources)
    fs::copy(source, folder / source.filename(), fs::copy_options::recursive);

  std::vector<fs::path> scenes = filesBelow(folder);
  std::erase_if(scenes, [](const fs::path& f) { return f.extension() == ".png" || f.extension() == ".mtl"; });
  const fs::path scene = scenes[rng() % scenes.size()];
  const auto change = [&](const fs::path& file) {
    const std::string text = withChangedNumbers(contents(file), rng);
    std::ofstream{file, std::ios::binary} << text;
  };
  // Most often the file itself is changed, and sometimes those that it may name.
  const bool named = below(4, rng) == 0;
  if (!named || below(2, rng) == 0) change(scene);
  if (named)
    for (const fs::path& file :
         {folder / "square.bpt", folder / "teapot.bpt", folder / "changed" / "boxes.mtl"})
      if (file != scene) change(file);

  const RandomWords tried =
      scene.parent_path().filename() == "lessons"
          ? wordsForLesson(scene.string(), (folder / "out").string())
          : randomWords(scene.string(), (folder / "out").string(), !display.empty(), rng);
  const Run run = runWithin(tried.words, display);
  const std::string wrong = wrongIn(tried, run, folder / "out");
  if (wrong.empty()) {
    ++ends[run.end.status];
    fs::remove_all(folder);
    return true;
  }
  std::string command = builtProgram();
  for (const std::string& word : tried.words) command += " " + quoted(word);
  std::ofstream{folder / "command"} << command << '\n';
  std::ofstream{folder / "said"} << run.end.err;
  std::cerr << "random_files: seed " << seed << ", case " << number << ": it " << wrong << "\n  " << command
            << '\n';
  std::istringstream said{run.end.err.substr(0, 4'000)};
  int lines = 0;
  for (std::string line; std::getline(said, line) && lines < 25; ++lines) std::cerr << "    " << line << '\n';
  return false;
}

}  // namespace

/// Returns the exit status.
int giveRandomFiles(int argc, char** argv) {
  const int seconds = argc > 1 ? std::atoi(argv[1]) : 600;
  const unsigned seed = argc > 2 ? static_cast<unsigned>(std::atoi(argv[2])) : 1;
  const int alone = argc > 3 ? std::atoi(argv[3]) : -1;
  const fs::path kept = fs::absolute(argv[0]).string() + ".failed";
  const XServer server = XServer::xvfb(8, 1024, 768);

  const auto start = std::chrono::steady_clock::now();
  const auto elapsed = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  int cases = 0, failed = 0;
  std::array<int, 3> ends{};
  for (int number = std::max(alone, 0); cases == 0 || (alone < 0 && elapsed() < seconds); ++number, ++cases) {
    const fs::path folder = kept / (std::to_string(seed) + "-" + std::to_string(number));
    failed += !tryCase(seed, number, folder, server.name(), ends);
  }
  std::cout << cases << " cases of seed " << seed << " in " << static_cast<int>(elapsed()) << " s: " << failed
            << " failed, " << ends[0] << " ended with 0, " << ends[1] << " with 1, " << ends[2]
            << " with 2\n";
  std::error_code inUse;
  fs::remove(kept, inUse);  // if it is empty
  return failed > 0 ? 1 : 0;
}

}  // namespace xnewell

int main(int argc, char** argv) { return xnewell::giveRandomFiles(argc, argv); }
