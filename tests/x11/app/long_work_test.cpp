#include "x11/app/long_work.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <future>
#include <optional>
#include <stdexcept>
#include <thread>
#include <vector>

#include "geometry/exact/give_up.h"
#include "tests/support/seeds.h"
#include "tests/support/temporary_folder.h"
#include "tests/x11/support/watched_viewer.h"

#include <X11/keysym.h>

namespace xnewell::THIS_FILE {

namespace {

using std::chrono::steady_clock;

constexpr std::chrono::seconds kLongest{90};  ///< that a test waits for what must happen
constexpr Rect kSeen{0, 0, 1024, 724};        ///< the window of 1024 x 768 but for its status line
constexpr Rect kPicture{40, 100, 500, 500};   ///< a part of its picture

/// A gate before the program's work: while it is shut, a thread that the program xnewell_held
/// (held_threads.cpp) starts does nothing. Work takes as long as the test wants, on every machine.
class WorkGate {
 public:
  /// The gate is shut.
  WorkGate() : lock_{::open(folder_.write("gate", "").c_str(), O_RDONLY | O_CLOEXEC)} {
    if (lock_ < 0) throw std::runtime_error{"the gate's file cannot be opened"};
    setenv("XNEWELL_GATE", folder_.file("gate").c_str(), 1);
    shut();
  }
  WorkGate(const WorkGate&) = delete;
  WorkGate& operator=(const WorkGate&) = delete;
  ~WorkGate() {
    close(lock_);
    unsetenv("XNEWELL_GATE");
  }

  void open() const { flock(lock_, LOCK_UN); }
  /// Threads that start from now on wait.
  void shut() const { flock(lock_, LOCK_EX); }

 private:
  TemporaryFolder folder_;
  int lock_;
};

/// Reads the box that tells how long the work takes, and what a key does meanwhile.
class BoxWatch {
 public:
  explicit BoxWatch(const BusyNote& note) : boxes_{boxes(note)} {}

  /// The seconds in the window's box; nothing if no box is there.
  [[nodiscard]] std::optional<int> seconds(const WatchedWindow& window) const {
    const auto box = std::ranges::find(boxes_, window.shown(at_));
    return box == boxes_.end() ? std::nullopt : std::optional{static_cast<int>(box - boxes_.begin()) + 1};
  }
  /// Waits for a box that tells at least `least` seconds.
  [[nodiscard]] bool comesToTell(const WatchedWindow& window, int least) const {
    return comesTrue([&] { return seconds(window).value_or(0) >= least; });
  }

 private:
  static constexpr int kSeconds = 120;

  static std::vector<RgbImage> boxes(const BusyNote& note) {
    const CellPlan plan;
    const Palette palette = withInterface({}, plan);
    std::vector<RgbImage> all;
    IndexImage window{1024, 768, plan[Cell::Paper]};
    for (int seconds = 1; seconds <= kSeconds; ++seconds) {
      drawBusyBox(window, 1, plan, seconds, note);
      all.push_back(onScreen(window, palette, at_));
    }
    return all;
  }

  static inline const Rect at_ = busyBox(1024, 768, 1);
  std::vector<RgbImage> boxes_;
};

}  // namespace

// Nothing is said of work that is done within kPatience. It has a thread of its own.
TEST(DoPatiently, SaysNothingOfWorkThatIsSoonDone) {
  // A busy machine may take long to start a thread. Then nothing is soon done, and the test tries again.
  EXPECT_TRUE(comesTrue([] {
    std::thread::id where;
    int said = 0;
    const auto start = steady_clock::now();
    doPatiently([&] { where = std::this_thread::get_id(); },
                [&](int) {
                  ++said;
                  return false;
                });
    if (steady_clock::now() - start >= kPatience) return false;
    EXPECT_EQ(said, 0);
    EXPECT_NE(where, std::thread::id{});
    EXPECT_NE(where, std::this_thread::get_id());
    return true;
  }));
}

// What the work throws is thrown on. What the telling throws is thrown on too, but only when the work is
// done.
TEST(DoPatiently, PassesOnWhatIsThrown) {
  EXPECT_THROW(doPatiently([] { throw std::runtime_error{"work"}; }, [](int) { return false; }),
               std::runtime_error);
  std::promise<void> isThrown;
  /// Ends when an exception is on its way out.
  struct Thrower {
    std::promise<void>& told;
    ~Thrower() { told.set_value(); }
  };
  bool inTime = false, done = false;
  EXPECT_THROW(doPatiently(
                   [&] {
                     inTime = isThrown.get_future().wait_for(kLongest) == std::future_status::ready;
                     // No proof hangs on this: it gives a doPatiently() that does not wait time to be seen.
                     std::this_thread::sleep_for(std::chrono::milliseconds{50});
                     done = true;
                   },
                   [&](int) -> bool {
                     const Thrower thrower{isThrown};
                     throw std::logic_error{"meanwhile"};
                   }),
               std::logic_error);
  EXPECT_TRUE(inTime);
  EXPECT_TRUE(done);
}

// Work that may be given up ends at its next look after the telling has asked for that, and it is asked once.
TEST(DoPatiently, GivesUpOnce) {
  bool givenUp = false, again = false;
  const auto start = steady_clock::now();
  const auto looks = [&] {
    while (steady_clock::now() - start < kLongest) MayGiveUp::check();
  };
  doPatiently(
      [&] {
        try {
          looks();
        } catch (const GivenUp&) {
          givenUp = true;
        }
        try {
          for (int k = 0; k < 1'000; ++k) MayGiveUp::check();
        } catch (const GivenUp&) {
          again = true;
        }
      },
      [said = 0](int) mutable { return said++ == 0; });
  EXPECT_TRUE(givenUp);
  EXPECT_FALSE(again);
  EXPECT_LT(steady_clock::now() - start, kLongest);
}

/// The program's work waits at a gate, so that it lasts as long as the test wants.
class LongWorkAt : public testing::TestWithParam<int> {
 protected:
  /// Starts the window's program. Its first picture waits until the gate is open.
  [[nodiscard]] RunningProgram start() const {
    return RunningProgram{builtProgram("tests/xnewell_held"), words("view cycle"), server.name()};
  }

  XServer server = XServer::xvfb(GetParam(), 1280, 1024);
  TemporaryFolder folder;
  WorkGate gate;
  BoxWatch first{{.mayEnd = true}}, later{{.mayEnd = true, .mayGiveUp = true}};
};
INSTANTIATE_TEST_SUITE_P(Depths, LongWorkAt, testing::ValuesIn(someOf({8, 24}, 1)),
                         testing::PrintToStringParamName());

// The window is there before its picture, and says so. Then the picture comes, and nothing of the box stays.
// A later picture that takes long is told over the one that is there. The window closes meanwhile without
// waiting.
TEST_P(LongWorkAt, IsTold) {
  const RgbImage picture = freshWindow(server, "cycle");
  RunningProgram program = start();
  {
    const WatchedWindow early = WatchedWindow::early(server);
    EXPECT_TRUE(early.isDrawing()) << early.title();
    EXPECT_TRUE(first.comesToTell(early, 2));
    EXPECT_TRUE(early.isDrawing()) << early.title();
  }
  gate.open();
  const WatchedWindow window{server};
  EXPECT_EQ(window.title(), "xnewell: cycle");
  EXPECT_TRUE(window.comesToShow(picture, kSeen));

  window.type("t");
  ASSERT_TRUE(window.settles());
  const RgbImage before = window.shown(kSeen);
  gate.shut();
  window.press(XK_Right);
  EXPECT_TRUE(comesTrue([&] { return window.isDrawing(); }));
  EXPECT_TRUE(later.comesToTell(window, 1));
  gate.open();
  EXPECT_TRUE(comesTrue([&] { return !window.isDrawing(); }));
  EXPECT_EQ(later.seconds(window), std::nullopt);
  EXPECT_NE(window.shown(kSeen), before);

  gate.shut();
  window.press(XK_Right);
  EXPECT_TRUE(comesTrue([&] { return window.isDrawing(); }));
  window.askToClose();
  EXPECT_TRUE(window.goes());
  EXPECT_EQ(program.wait().status, 0);
}

// Esc gives up a picture that takes long, and the one before stays. The window goes on from there.
TEST_P(LongWorkAt, EscKeepsTheLastPicture) {
  const BoxWatch givesUp{{.mayEnd = true, .givesUp = true}};
  RunningProgram program = start();
  (void)WatchedWindow::early(server);  // this picture takes long: from now on the program expects that
  gate.open();
  const WatchedWindow window{server};
  window.type("t");
  ASSERT_TRUE(window.settles());
  const RgbImage before = window.shown(kPicture);
  gate.shut();
  window.press(XK_Right);
  EXPECT_TRUE(later.comesToTell(window, 1));
  window.press(XK_Escape);
  EXPECT_TRUE(givesUp.comesToTell(window, 1));
  gate.open();
  EXPECT_TRUE(comesTrue([&] { return !window.isDrawing(); }));
  EXPECT_TRUE(window.comesToShow(before, kPicture));

  window.press(XK_Right);
  ASSERT_TRUE(window.settles());
  EXPECT_NE(window.shown(kPicture), before);
}

// While the program works, q ends it. So does whoever destroys the window, and the program says so.
TEST_P(LongWorkAt, EndsAtOnce) {
  {
    RunningProgram program = start();
    const WatchedWindow window = WatchedWindow::early(server);
    window.type("q");
    EXPECT_TRUE(window.goes());
    EXPECT_EQ(program.wait().status, 0);
  }
  RunningProgram program = start();
  const WatchedWindow window = WatchedWindow::early(server);
  XDestroyWindow(window.display(), window.id());
  XSync(window.display(), 0);
  const Finished end = program.wait();
  EXPECT_EQ(end.status, 1);
  EXPECT_NE(end.err.find("xnewell: the window was destroyed by another program"), std::string::npos)
      << end.err;
}

// A window with unsaved changes does not close while the program works. Afterwards it warns, as ever, and
// closes when it is asked again.
TEST_P(LongWorkAt, LosesNothing) {
  RunningProgram program = start();
  (void)WatchedWindow::early(server);  // this picture takes long: from now on the program expects that
  gate.open();
  const WatchedWindow window{server};
  window.type("w");
  window.type(folder.file("kept.json"));
  window.press(XK_Return);
  ASSERT_TRUE(comesTrue([&] { return std::filesystem::exists(folder.file("kept.json")); }));
  window.type("t");
  ASSERT_TRUE(window.settles());
  gate.shut();
  window.press(XK_Right);
  const BoxWatch waits{{.mayGiveUp = true}};
  ASSERT_TRUE(waits.comesToTell(window, 1));
  window.askToClose();
  // The next box may be on its way already. The program looks for requests before it draws the one after.
  EXPECT_TRUE(waits.comesToTell(window, waits.seconds(window).value_or(1) + 2));
  EXPECT_TRUE(window.isDrawing());
  EXPECT_TRUE(program.running());
  gate.open();
  EXPECT_TRUE(comesTrue([&] { return !window.isDrawing(); }));
  // Now the request is answered with a warning, which the keys of settles() take back.
  ASSERT_TRUE(window.settles());
  EXPECT_TRUE(program.running());
  window.askToClose();
  window.askToClose();
  EXPECT_TRUE(window.goes());
  EXPECT_EQ(program.wait().status, 0);
}

}  // namespace xnewell::THIS_FILE
