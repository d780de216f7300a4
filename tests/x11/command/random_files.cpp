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
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <time.h>
#include <unistd.h>

#include "shading/scene/settings.h"
#include "tests/x11/support/command_fixture.h"
#include "tests/x11/support/program_picture.h"
#include "tests/x11/support/x_server.h"
#include "x11/options/shell_words.h"
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

template <std::size_t N>
std::string oneOf(const std::array<const char*, N>& all, std::mt19937& rng) {
  return all[rng() % N];
}

/// `v` and something that is little beside it, or beside 1.
std::string nearly(double v, std::mt19937& rng) {
  const std::array near{std::nextafter(v, below(2, rng) == 0 ? 1e300 : -1e300),
                        v * (1 + std::pow(10.0, -below(16, rng))), v + std::pow(10.0, -below(30, rng)), v};
  return number(near[rng() % near.size()]);
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
                    digits = below(2, rng) == 0 ? "1" : number(1 + below(9000, rng) / 1000.0);
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
    const auto valueOf = [&](std::size_t place) {
      return std::atof(changed.substr(places[place].first, places[place].count).c_str());
    };
    const int how = below(10, rng);
    if (how == 0) {  // the line twice
      const std::size_t at = places[which].first, first = changed.rfind('\n', at) + 1,
                        end = std::min(changed.find('\n', at), changed.size() - 1) + 1;
      changed.insert(first, changed.substr(first, end - first));
      continue;
    }
    const std::size_t sameAxis = which >= 3 ? which - 3 : 0;  // of the last point
    const std::string by = how == 1   ? nearly(valueOf(which), rng)
                           : how == 2 ? nearly(valueOf(rng() % places.size()), rng)
                           : how == 3 ? nearly(valueOf(sameAxis), rng)
                           : how == 4 ? number(-valueOf(which))
                                      : oddNumber(rng);
    changed.replace(places[which].first, places[which].count, by);
  }
  return changed;
}

/// ---- Random command lines.

/// Command lines, and how many of a hundred are such. [words] may be left out, <a|b> is one of these, and
/// braces hold so many numbers between two others, a whole number below another one, or a size of so many
/// pixels a side.
struct RandomLine {
  int share;
  const char* line;
};
constexpr std::array kLines{
    RandomLine{30,
               "draw SCENE -o OUT/a.png [--ids OUT/ids.png] {size:60} <--stats|--errors|> [SETTING] "
               "[SETTING] OPTIONS"},
    RandomLine{10,
               "draw SCENE -o OUT/a.png {size:60} [[--accuracy <0.05|{1:0:1}> --budget 1]] [SETTING] "
               "[SETTING] OPTIONS"},
    RandomLine{10,
               "snapshot SCENE -o OUT/a.png [--ids OUT/ids.png] {size:60} <--stats|--errors|> [SETTING] "
               "[SETTING] OPTIONS"},
    RandomLine{10, "<draw|draw|snapshot> SCENE -o OUT/view.png VIEW OPTIONS"},
    RandomLine{6, "explain SCENE {below:60},{below:60} --size 60x60 [--json] OPTIONS"},
    RandomLine{7, "trace SCENE {size:60} [--quick] OPTIONS"},
    RandomLine{2, "trace SCENE --frames OUT/frames <{size:60}|--whole-window --size 800x600> OPTIONS"},
    RandomLine{15, "extremes SCENE [-o OUT/chart.png] [--json] {size:16} OPTIONS"},
    RandomLine{10,
               "trade SCENE --budget 1 [-o OUT/chart.png] [--json] [--axes <shade,order|divisions>] "
               "{size:32} OPTIONS"},
};
constexpr const char* kLesson = "lesson SCENE --size 800x600 --frames OUT/frames";
constexpr const char* kOptions =
    "[SETTING] [SETTING] [[CAMERA]] [[--divisions {below:13}]] [[[--max-fragments {below:3000}]]]";
constexpr std::array kCameras{
    "--eye {3:-8:8}",
    "--eye {3:-3:3} --look-at {3:-2:2} --fov {1:0.001:179.999}",
    "--fov {1:1e-9:180}",
    "--parallel {1:0:12} <--up {3:-1:1}|--oblique cavalier:{1:0:360}>",
    "--vrp {3:-2:2} --vpn {3:-1:1} --vup {3:-1:1} --prp {3:-9:9}",
    "--view-window {4:-4:4}",
    "--front {1:-9:9} --back {1:-30:0}",
};

/// Makes the words of a command for a scene, with random options: most values are valid. It writes into the
/// folder only.
class Maker {
 public:
  Maker(std::string scene, std::string folder, std::mt19937& rng)
      : scene_{std::move(scene)}, folder_{std::move(folder)}, rng_{rng} {}

  Strings make() {
    int what = below(100, rng_);
    const RandomLine* line = kLines.data();
    for (; what >= line->share; ++line) what -= line->share;
    return wordsOf(line->line);
  }
  Strings wordsOf(const std::string& line) {
    add(line);
    return std::move(made_);
  }

 private:
  bool oneIn(int n) { return below(n, rng_) == 0; }
  void add(std::string line) {
    for (std::size_t end = 0; (end = line.find_first_of("]>")) != std::string::npos;) {
      const std::size_t begin = line.find_last_of("[<", end);
      const std::string all = line.substr(begin + 1, end - begin - 1) + (line[end] == ']' ? "|" : "");
      std::istringstream choices{all + '|'};
      std::string choice;
      for (int k = 1 + below(1 + static_cast<int>(std::ranges::count(all, '|')), rng_); k > 0; --k)
        std::getline(choices, choice, '|');
      line.replace(begin, end + 1 - begin, choice);
    }
    for (const std::string& word : words(line)) {
      if (word == "OPTIONS")
        add(kOptions);
      else if (word == "SETTING")
        setting();
      else if (word == "CAMERA")
        add(kCameras[rng_() % kCameras.size()]);
      else if (word == "VIEW")
        view();
      else
        made_.push_back(word == "SCENE" ? scene_ : filled(word));
    }
  }
  /// A word with values in the place of its braces.
  std::string filled(std::string word) {
    if (word.starts_with("OUT/")) return folder_ + word.substr(3);
    for (std::size_t begin = 0; (begin = word.find('{')) != std::string::npos;) {
      const std::size_t end = word.find('}', begin);
      std::istringstream parts{word.substr(begin + 1, end - begin - 1)};
      std::string kind, low, high, value;
      std::getline(std::getline(std::getline(parts, kind, ':'), low, ':'), high);
      if (kind == "below")
        value = std::to_string(below(std::stoi(low), rng_));
      else if (kind == "size")
        value = "--size=" + side(std::stoi(low)) + 'x' + side(std::stoi(low));
      else
        value = numbers(std::stoi(kind), std::stod(low), std::stod(high));
      word.replace(begin, end + 1 - begin, value);
    }
    return word;
  }
  std::string side(int most) { return std::to_string(1 + below(oneIn(4) ? 8 : most, rng_)); }
  std::string between(double low, double high) {
    if (oneIn(6)) return oddNumber(rng_);
    std::array<char, 40> text;
    std::snprintf(text.data(), text.size(), "%.6g", std::uniform_real_distribution{low, high}(rng_));
    return text.data();
  }
  std::string numbers(int count, double low, double high) {
    std::string all;
    for (int k = 0; k < count; ++k) all += (k > 0 ? "," : "") + between(low, high);
    return all;
  }

  void setting() {
    const std::vector<Setting>& rows = settingRows();
    const Setting& row = rows[rng_() % rows.size()];
    // One option twice is refused, and so is the server's filler in most commands.
    if (row.option.empty() || row.option == "--fill" || std::ranges::find(made_, row.option) != made_.end())
      return;
    made_.emplace_back(row.option);
    const double low = std::max(row.range.low, -10.0), high = std::min(row.range.high, 250.0);
    const double whole = std::round(low + (high - low) * below(1000, rng_) / 999);
    if (row.field.kind == ValueKind::Choice)
      made_.emplace_back(row.field.choices[rng_() % row.field.choices.size()].name);
    else if (row.field.kind == ValueKind::Number)
      made_.push_back(between(low, high));
    else if (row.field.kind == ValueKind::Whole)
      made_.push_back(oneIn(8) ? oddNumber(rng_) : number(whole));
    else if (row.field.kind == ValueKind::Triple)
      made_.push_back(numbers(3, std::max(low, -3.0), std::min(high, 3.0)));
  }
  void view() {
    std::size_t any = 0;
    while (any == 0 || !kViews[any].hasSheet()) any = rng_() % kViews.size();
    const ViewRow& row = kViews[any];
    const std::string more = row.id == View::MachBands ? "[--scanline {below:300}]"
                             : row.id == View::Colors  ? "[--cell {below:256}]"
                                                       : "";
    add("--view " + std::string{row.name} + " --size " + std::to_string(row.least.x) + "x" +
        std::to_string(row.least.y) + ' ' + more);
  }

  std::string scene_, folder_;
  std::mt19937& rng_;
  Strings made_;
};

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

/// All files in a folder, sorted.
std::vector<fs::path> filesBelow(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator{folder})
    if (!entry.is_directory()) files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

/// The end of a run that may take only so much. `took` says what was too much.
struct Run {
  Finished end;
  std::string took;
};

Run runWithin(const std::vector<std::string>& words, const std::string& display) {
  RunningProgram program{words, display};
  const auto start = std::chrono::steady_clock::now();
  Run run;
  for (useconds_t pause = 500; program.running(); pause = std::min<useconds_t>(2 * pause, 20'000)) {
    usleep(pause);
    timespec used{};
    clockid_t clock = 0;
    if (clock_getcpuclockid(program.pid(), &clock) == 0) clock_gettime(clock, &used);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    if (static_cast<double>(used.tv_sec) > kMostSeconds)
      run.took = "took more than " + std::to_string(int(kMostSeconds)) + " s of the processor's time";
    else if (elapsed.count() > kMostWaiting * kMostSeconds)
      run.took = "did not end";
    else if (program.megabytes() > kMostMegabytes)
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
std::string wrongOutput(const Strings& tried, const Finished& end) {
  if (end.status != 0) return end.out.empty() ? "" : "fails, and has written to standard output";
  const bool frames = std::ranges::count(tried, "--frames") > 0;
  const bool json = std::ranges::any_of(tried, [](const std::string& word) {
    return word == "--json" || word == "--stats" || word == "--errors";
  });
  if (json && !Json::accept(end.out)) return "prints what is no JSON";
  std::istringstream in{end.out};
  if (tried[0] == "trace" && !frames)
    for (std::string line; std::getline(in, line);)
      if (!Json::accept(line)) return "prints a line that is no JSON: " + line;
  return "";
}

/// What is wrong with the files that it has left; "" if nothing.
std::string wrongFiles(const Strings& tried, const Finished& end, const fs::path& folder) {
  std::set<std::string> missing;
  // A slow build times nothing within a small budget. Then a trade has no chart to write, and says so.
  const bool noChart = end.err.find("no chart was written: nothing was timed") != std::string::npos;
  for (std::size_t k = 1; k < tried.size() && end.status == 0 && !noChart; ++k)
    if (tried[k - 1] == "-o" || tried[k - 1] == "--ids") missing.insert(fs::path{tried[k]}.filename());
  for (const fs::path& file : filesBelow(folder)) {
    const bool frame = file.parent_path().filename() == "frames" && file.extension() == ".png";
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
std::string wrongIn(const Strings& tried, const Run& run, const fs::path& folder) {
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
    const std::string text = withChangedNumbers(contents(file.string()), rng);
    std::ofstream{file, std::ios::binary} << text;
  };
  // Most often the file itself is changed, and sometimes those that it may name.
  const bool named = below(4, rng) == 0;
  if (!named || below(2, rng) == 0) change(scene);
  if (named)
    for (const fs::path& file :
         {folder / "square.bpt", folder / "teapot.bpt", folder / "changed" / "boxes.mtl"})
      if (file != scene) change(file);

  Maker maker{scene.string(), (folder / "out").string(), rng};
  const Strings tried = scene.parent_path().filename() == "lessons" ? maker.wordsOf(kLesson) : maker.make();
  const Run run = runWithin(tried, display);
  const std::string wrong = wrongIn(tried, run, folder / "out");
  if (wrong.empty()) {
    ++ends[run.end.status];
    fs::remove_all(folder);
    return true;
  }
  std::string command = builtProgram();
  for (const std::string& word : tried) command += " " + quoted(word);
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
