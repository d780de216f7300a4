#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
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
#include <string_view>
#include <vector>

#include <time.h>
#include <unistd.h>

#include "shading/color/png.h"
#include "shading/scene/settings.h"
#include "tests/x11/support/program.h"
#include "tests/x11/support/x_server.h"
#include "x11/views/views.h"

namespace xnewell {

// random_files [SECONDS [SEED [CASE]]] changes a few numbers in valid scenes, models and lessons, and gives
// them to every command with random options, for SECONDS. With CASE it tries this case alone. It fails if the
// program ends by a signal, takes too long or too much memory, ends with a status other than 0, 1 and 2, says
// anything but `xnewell: ...` lines, complains in more than one line, or leaves a part of a file. The folder
// of a case that failed stays, with the command in it.

namespace {

namespace fs = std::filesystem;

/// ---- Numbers that are changed.

/// A whole number from 0 to n - 1.
int below(int n, std::mt19937& rng) { return static_cast<int>(rng() % static_cast<unsigned>(n)); }

struct Place {
  std::size_t first, count;
};

/// Where the text has numbers. Digits in names, as in "box 1", count too.
std::vector<Place> numbersIn(const std::string& text) {
  const auto isIn = [&](std::size_t k, std::string_view set) {
    return k < text.size() && set.find(text[k]) != std::string_view::npos;
  };
  std::vector<Place> places;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (!isIn(k, "-.0123456789")) continue;
    std::size_t end = k;
    bool digits = false;
    while (isIn(end, "-+.0123456789") || (digits && isIn(end, "eE") && isIn(end + 1, "-+0123456789"))) {
      digits |= std::isdigit(static_cast<unsigned char>(text[end])) != 0;
      ++end;
    }
    if (digits) places.push_back({k, end - k});
    k = end;
  }
  return places;
}

std::string exactly(double v) {
  std::array<char, 40> text;
  std::snprintf(text.data(), text.size(), "%.17g", v);
  return text.data();
}

template <std::size_t N>
std::string oneOf(const std::array<const char*, N>& all, std::mt19937& rng) {
  return all[rng() % N];
}

/// `v` and something that is little beside it, or beside 1.
std::string nearly(double v, std::mt19937& rng) {
  switch (below(4, rng)) {
    case 0:
      return exactly(std::nextafter(v, below(2, rng) == 0 ? 1e300 : -1e300));
    case 1:
      return exactly(v * (1 + std::pow(10.0, -below(16, rng))));
    case 2:
      return exactly(v + std::pow(10.0, -below(30, rng)));
    default:
      return exactly(v);
  }
}

/// A number as withChangedNumbers() puts in, by itself.
std::string oddNumber(std::mt19937& rng) {
  static constexpr std::array kZeros{"0", "-0", "0.0", "1e-400"};
  static constexpr std::array kNone{"nan", "inf",  "-inf", "NaN", "1e999", "-1e999",
                                    "",    "0x10", "1e",   "--1", "1.2.3"};
  static constexpr std::array kWhole{
      "2147483647", "2147483648", "-2147483648",         "4294967295",           "4294967296",
      "16777217",   "65536",      "9223372036854775807", "-9223372036854775809", "18446744073709551616"};
  static constexpr std::array kSmall{"-1", "1", "2", "3", "0.5", "7", "90", "180", "360", "255", "256"};
  const int what = below(100, rng);
  if (what < 15) return oneOf(kZeros, rng);
  if (what < 25) return oneOf(kNone, rng);
  if (what < 33) return oneOf(kWhole, rng);
  if (what < 45) return oneOf(kSmall, rng);
  const int most = what < 70 ? 20 : what < 85 ? 40 : 323;
  const int power = below(2 * most + 1, rng) - most;
  const std::string sign = below(3, rng) == 0 ? "-" : "",
                    digits = below(2, rng) == 0 ? "1" : exactly(1 + below(9000, rng) / 1000.0);
  return sign + digits + "e" + std::to_string(std::min(power, 308));
}

/// The text with a few of its numbers changed: to very large and very small ones, zeros, the negative, what
/// is no number, integers at the end of their range, and almost the same as itself or as another number of
/// the text. Sometimes a line is there twice.
std::string withChangedNumbers(const std::string& text, std::mt19937& rng) {
  std::string changed = text;
  static constexpr std::array kCounts{1, 1, 1, 2, 2, 3, 5, 12};
  for (int k = kCounts[rng() % kCounts.size()]; k > 0; --k) {
    const std::vector<Place> places = numbersIn(changed);
    if (places.empty()) return changed;
    const std::size_t which = rng() % places.size();
    const auto textOf = [&](std::size_t place) {
      return changed.substr(places[place].first, places[place].count);
    };
    const auto valueOf = [&](std::size_t place) { return std::atof(textOf(place).c_str()); };
    std::string number;
    switch (below(10, rng)) {
      case 0:
        number = nearly(valueOf(which), rng);
        break;
      case 1:
        number = nearly(valueOf(rng() % places.size()), rng);
        break;
      case 2:
        number = nearly(valueOf(which >= 3 ? which - 3 : 0), rng);
        break;  // the same axis of the last point
      case 3:
        number = exactly(-valueOf(which));
        break;
      case 4: {  // the line twice
        const std::size_t at = places[which].first;
        const std::size_t first = changed.rfind('\n', at) + 1,
                          end = std::min(changed.find('\n', at), changed.size() - 1) + 1;
        changed.insert(first, changed.substr(first, end - first));
        continue;
      }
      default:
        number = oddNumber(rng);
    }
    changed.replace(places[which].first, places[which].count, number);
  }
  return changed;
}

/// ---- Random command lines.

/// A random command line, and what it promises.
struct RandomWords {
  std::vector<std::string> words;
  std::vector<std::string> writes = {};  ///< the files that it writes into its folder, besides frames
  bool printsJson = false;               ///< one JSON value
  bool printsLines = false;              ///< one JSON value a line
};

/// The name of the folder that frames go to, in the folder of all files that are written.
inline constexpr const char* kFrames = "frames";

class Maker {
 public:
  Maker(std::string folder, std::mt19937& rng) : folder_{std::move(folder)}, rng_{rng} {}

  RandomWords make(const std::string& scene, bool server) {
    const int what = below(100, rng_);
    if (what < 40)
      picture("draw", scene);
    else if (what < 50 && server)
      picture("snapshot", scene);
    else if (what < 60)
      view(server && oneIn(3) ? "snapshot" : "draw", scene);
    else if (what < 66)
      explain(scene);
    else if (what < 75)
      trace(scene);
    else if (what < 90)
      extremes(scene);
    else
      trade(scene);
    return std::move(made_);
  }

 private:
  bool oneIn(int n) { return below(n, rng_) == 0; }
  void add(const std::vector<std::string>& words) {
    made_.words.insert(made_.words.end(), words.begin(), words.end());
  }
  void writes(const std::string& option, const std::string& name) {
    add({option, folder_ + "/" + name});
    made_.writes.push_back(name);
  }

  /// A size of at most so many pixels a side.
  void size(int most) {
    const auto side = [&] { return std::to_string(1 + below(oneIn(4) ? 8 : most, rng_)); };
    const std::string width = side();
    add({"--size", width + "x" + side()});
  }
  std::string number(double low, double high) {
    if (oneIn(6)) return oddNumber(rng_);
    std::array<char, 40> text;
    std::snprintf(text.data(), text.size(), "%.6g", std::uniform_real_distribution{low, high}(rng_));
    return text.data();
  }
  std::string numbers(int count, double low, double high) {
    std::string all;
    for (int k = 0; k < count; ++k) all += (k > 0 ? "," : "") + number(low, high);
    return all;
  }

  void setting() {
    const std::vector<Setting>& rows = settingRows();
    const Setting& row = rows[rng_() % rows.size()];
    // One option twice is refused, and so is the server's filler in most commands.
    if (row.option.empty() || row.option == "--fill" ||
        std::ranges::find(made_.words, row.option) != made_.words.end())
      return;
    add({std::string{row.option}});
    const double low = std::max(row.range.low, -10.0), high = std::min(row.range.high, 250.0);
    switch (row.field.kind) {
      case ValueKind::Flag:
        break;
      case ValueKind::Choice:
        add({std::string{row.field.choices[rng_() % row.field.choices.size()].name}});
        break;
      case ValueKind::Number:
        add({number(low, high)});
        break;
      case ValueKind::Whole:
        add({oneIn(8) ? oddNumber(rng_)
                      : std::to_string(std::lround(low + (high - low) * below(1000, rng_) / 999))});
        break;
      case ValueKind::Triple:
        add({numbers(3, std::max(low, -3.0), std::min(high, 3.0))});
        break;
    }
  }
  void camera() {
    switch (below(8, rng_)) {
      case 0:
        return add({"--eye", numbers(3, -8, 8)});
      case 1:
        return add(
            {"--eye", numbers(3, -3, 3), "--look-at", numbers(3, -2, 2), "--fov", number(0.001, 179.999)});
      case 2:
        return add({"--fov", number(1e-9, 180)});
      case 3:
        return add({"--parallel", number(0, 12), "--up", numbers(3, -1, 1)});
      case 4:
        return add({"--parallel", number(0, 12), "--oblique", "cavalier:" + number(0, 360)});
      case 5:
        return add({"--vrp", numbers(3, -2, 2), "--vpn", numbers(3, -1, 1), "--vup", numbers(3, -1, 1),
                    "--prp", numbers(3, -9, 9)});
      case 6:
        return add({"--view-window", numbers(4, -4, 4)});
      default:
        return add({"--front", number(-9, 9), "--back", number(-30, 0)});
    }
  }
  void options(int most) {
    for (int k = below(most + 1, rng_); k > 0; --k) setting();
    if (oneIn(3)) camera();
    if (oneIn(4)) add({"--divisions", std::to_string(1 + below(12, rng_))});
    if (oneIn(12)) add({"--max-fragments", std::to_string(1 + below(3000, rng_))});
  }

  void picture(const std::string& command, const std::string& scene) {
    add({command, scene});
    writes("-o", "picture.png");
    if (oneIn(2)) writes("--ids", "ids.png");
    size(60);
    const int told = below(8, rng_);
    if (told < 3) add({"--stats"});
    if (told >= 3 && told < 7) add({"--errors"});
    made_.printsJson = told < 7;
    if (command == "draw" && oneIn(10))
      add({"--accuracy", oneIn(2) ? "0.05" : number(0, 1), "--budget", "1"});
    options(4);
  }
  void view(const std::string& command, const std::string& scene) {
    add({command, scene});
    writes("-o", "view.png");
    std::size_t any = 0;
    while (any == 0 || !kViews[any].hasSheet()) any = rng_() % kViews.size();
    const ViewRow& row = kViews[any];
    add({"--view", std::string{row.name}, "--size",
         std::to_string(row.least.x) + "x" + std::to_string(row.least.y)});
    if (row.id == View::MachBands && oneIn(2)) add({"--scanline", std::to_string(below(300, rng_))});
    if (row.id == View::Colors && oneIn(2)) add({"--cell", std::to_string(below(256, rng_))});
    options(2);
  }
  void trace(const std::string& scene) {
    add({"trace", scene});
    const bool frames = oneIn(5);
    if (frames) add({"--frames", folder_ + "/" + kFrames});
    if (frames && oneIn(4))
      add({"--whole-window", "--size", "800x600"});
    else
      size(60);
    if (!frames && oneIn(2)) add({"--quick"});
    made_.printsLines = !frames;
    options(2);
  }
  void explain(const std::string& scene) {
    add({"explain", scene, std::to_string(below(60, rng_)) + "," + std::to_string(below(60, rng_))});
    add({"--size", "60x60"});
    made_.printsJson = oneIn(2);
    if (made_.printsJson) add({"--json"});
    options(3);
  }
  void extremes(const std::string& scene) {
    add({"extremes", scene});
    if (oneIn(2)) writes("-o", "chart.png");
    made_.printsJson = oneIn(2);
    if (made_.printsJson) add({"--json"});
    size(16);
    options(2);
  }
  void trade(const std::string& scene) {
    add({"trade", scene, "--budget", "1"});
    if (oneIn(2)) writes("-o", "chart.png");
    made_.printsJson = oneIn(2);
    if (made_.printsJson) add({"--json"});
    if (oneIn(2)) add({"--axes", oneIn(2) ? "shade,order" : "divisions"});
    size(32);
    options(2);
  }

  std::string folder_;
  std::mt19937& rng_;
  RandomWords made_;
};

/// A command for a scene, at a small size, with random options: most values are valid. It writes into the
/// folder only. `server`: also commands that need an X server.
RandomWords randomWords(const std::string& scene, const std::string& folder, bool server, std::mt19937& rng) {
  return Maker{folder, rng}.make(scene, server);
}

RandomWords wordsForLesson(const std::string& lesson, const std::string& folder) {
  return {.words = {"lesson", lesson, "--size", "800x600", "--frames", folder + "/" + kFrames}};
}

/// ---- Runs.

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
