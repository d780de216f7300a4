#include <chrono>
#include <csignal>
#include <cstdlib>
#include <deque>
#include <iostream>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <unistd.h>

#include "tests/support/temporary_folder.h"
#include "tests/x11/support/program.h"
#include "tests/x11/support/watched_window.h"

#include <X11/extensions/XRes.h>
#include <X11/keysym.h>

namespace xnewell {

// random_input [SECONDS [SEED [DEPTH]]] sends random keys, clicks, drags, wheel turns and sizes to every view
// of the window, to a lesson and to a lecture, for SECONDS in all. A third of them comes in batches, which
// the program finds all at once. It fails if the program ends, says anything, or grows in memory or on the
// server. It finds most with sanitizers: build/asan/tests/random_input 600 1 8

namespace {

constexpr int kWidth = 1280, kHeight = 1024;
constexpr int kBatch = 200;

/// What is started, one after the other.
const std::vector<std::vector<std::string>> kStarts{
    {"view", "teapot", "--divisions", "4"},
    {"lesson", "cycles"},
    {"lecture", XNEWELL_DATA_DIR "/lectures/first-hour.json"},
    {"view", "hues", "--shade", "phong"},
};

struct Size {
  double megabytes = 0;
  int resources = 0;
};

Size sizeOf(const RunningProgram& program, Display* display, Window window) {
  Size size{.megabytes = program.megabytes()};
  int count = 0;
  XResType* types = nullptr;
  if (XResQueryClientResources(display, window, &count, &types) != 0)
    for (int i = 0; i < count; ++i) size.resources += static_cast<int>(types[i].count);
  XFree(types);
  return size;
}

class Hands {
 public:
  Hands(const WatchedWindow& window, unsigned seed) : window_{window}, rng_{seed} {}

  /// Does something at random, and keeps a record of it.
  void act() {
    static const std::string kLetters =
        "ipadsncl0tzLVSNOFPKTW[]HBJ+-=uUr?123456789012345789yjJKgbxfAhmk/ABCDwe.52999ovEYXZRG ";
    static constexpr std::array kNamed{XK_Left,   XK_Right,     XK_Up,    XK_Down, XK_Home,
                                       XK_End,    XK_Prior,     XK_Next,  XK_Tab,  XK_space,
                                       XK_Return, XK_BackSpace, XK_Escape};
    const unsigned what = below(100);
    if (what < 45) {
      const char letter = kLetters[below(static_cast<unsigned>(kLetters.size()))];
      tell(std::string{"key "} + letter);
      window_.type({&letter, 1});
    } else if (what < 75) {
      const KeySym key = kNamed[below(kNamed.size())];
      const bool shift = below(4) == 0;
      tell("key " + std::string{XKeysymToString(key)} + (shift ? " with Shift" : ""));
      window_.press(key, shift);
    } else if (what < 85) {
      move();
      click(1);
    } else if (what < 92) {
      move();
      tell("drag");
      window_.button(1, true);
      for (unsigned k = 2 + below(8); k > 0; --k) move();
      window_.button(1, false);
    } else if (what < 96) {
      click(4 + below(2));
    } else if (what < 99) {
      move();
    } else {
      const int w = 1 + static_cast<int>(below(kWidth)), h = 1 + static_cast<int>(below(kHeight));
      const bool roomy = below(4) != 0;
      tell("resize");
      window_.resize(roomy ? std::max(w, 800) : w, roomy ? std::max(h, 540) : h);
    }
  }
  [[nodiscard]] const std::deque<std::string>& last() const { return told_; }
  [[nodiscard]] unsigned below(unsigned n) { return static_cast<unsigned>(rng_()) % n; }

 private:
  void tell(std::string what) {
    told_.push_back(std::move(what));
    if (told_.size() > 40) told_.pop_front();
  }
  void move() {
    const int x = static_cast<int>(below(kWidth)), y = static_cast<int>(below(kHeight));
    tell("move to " + std::to_string(x) + ", " + std::to_string(y));
    window_.moveTo(x, y);
  }
  void click(unsigned button) {
    tell("button " + std::to_string(button));
    window_.button(button, true);
    window_.button(button, false);
  }

  const WatchedWindow& window_;
  std::mt19937 rng_;
  std::deque<std::string> told_;
};

/// Returns the exit status.
int giveRandomInput(const XServer& server, const std::vector<std::string>& start, double seconds,
                    unsigned seed) {
  RunningProgram program{start, server.name()};
  const WatchedWindow window{server};
  Hands hands{window, seed};
  const auto failed = [&](const std::string& what) {
    std::cerr << "random_input: " << start[0] << ' ' << start[1] << ", seed " << seed << ": " << what
              << ", after:\n";
    for (const std::string& act : hands.last()) std::cerr << "  " << act << '\n';
    if (!program.running()) {
      const Finished end = program.wait();
      std::cerr << "status " << end.status << '\n' << end.err.substr(0, 4000) << '\n';
    }
    return 1;
  };

  const auto begin = std::chrono::steady_clock::now();
  const auto elapsed = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  Size early, late;  // the largest sizes in the first half and in the last quarter
  long acts = 0;
  for (double told = 0; elapsed() < seconds;) {
    const bool batch = hands.below(40) == 0;
    const int count = batch ? kBatch : 10;
    if (batch) program.signal(SIGSTOP);
    for (int k = 0; k < count; ++k) hands.act();
    acts += count;
    if (batch) program.signal(SIGCONT);
    if (!program.running()) return failed("the program has ended");
    usleep(10'000 + hands.below(batch ? 2'000'000 : 40'000));  // sometimes the program can keep up
    const Size now = sizeOf(program, window.display(), window.id());
    const double share = elapsed() / seconds;
    Size& quarter = share < 0.5 ? early : late;
    if (share < 0.5 || share > 0.75) {
      quarter.megabytes = std::max(quarter.megabytes, now.megabytes);
      quarter.resources = std::max(quarter.resources, now.resources);
    }
    if (elapsed() - told > 30) {
      told = elapsed();
      std::cerr << static_cast<int>(told) << " s, " << acts << " acts, " << now.megabytes << " MB, "
                << now.resources << " resources\n";
    }
  }
  bool answers = false;
  for (int k = 0; k < 3 && !answers && program.running(); ++k) {
    window.resize(1024, 768);
    window.moveTo(700, 15);  // keys go where the pointer is, which may be outside the window now
    for (int escapes = 0; escapes < 4; ++escapes) window.press(XK_Escape);
    window.type("1");   // settles() needs the picture behind the overlay of keys
    usleep(1'000'000);  // whoever leaves the full screen has the old size again
    window.resize(1024, 768);
    try {
      answers = window.settles();
    } catch (const std::runtime_error&) {  // it has changed its size meanwhile, or is gone
    }
  }
  if (!answers) return failed("the window does not answer");
  window.type("qq");
  const Finished end = program.wait();
  if (!comesToShowNone(window.display())) return failed("its window stays");
  std::cout << start[0] << ' ' << start[1] << ": " << acts << " acts with seed " << seed << ": "
            << early.megabytes << " MB and " << early.resources << " resources early, " << late.megabytes
            << " MB and " << late.resources << " late; status " << end.status << '\n';
  if (end.status != 0 || !end.err.empty())
    return failed("it ended with " + std::to_string(end.status) + ": " + end.err);
  if (late.resources > early.resources + 4) return failed("more resources on the server");
  if (late.megabytes > 2 * early.megabytes + 64) return failed("more memory");
  return 0;
}

}  // namespace

/// Returns the exit status.
int giveRandomInput(int argc, char** argv) {
  const int seconds = argc > 1 ? std::atoi(argv[1]) : 600;
  const unsigned seed = argc > 2 ? static_cast<unsigned>(std::atoi(argv[2])) : 1;
  const int depth = argc > 3 ? std::atoi(argv[3]) : 8;
  const TemporaryFolder folder;  // for files that are saved
  if (::chdir(folder.path().c_str()) != 0) return 1;

  const XServer server = XServer::xvfb(depth, kWidth, kHeight);
  for (const std::vector<std::string>& start : kStarts) {
    const double share = static_cast<double>(seconds) / static_cast<double>(kStarts.size());
    if (const int status = giveRandomInput(server, start, share, seed); status != 0) return status;
  }
  return 0;
}

}  // namespace xnewell

int main(int argc, char** argv) { return xnewell::giveRandomInput(argc, argv); }
