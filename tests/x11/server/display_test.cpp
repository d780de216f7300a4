#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <type_traits>

#include "tests/x11/support/x_server.h"

#include "x11/server/display.h"

namespace xnewell::THIS_FILE {

using testing::AllOf;
using testing::HasSubstr;

namespace {

/// The text of the X11Error that `f` throws; empty if it does not.
template <typename F>
std::string thrownBy(F f) {
  try {
    f();
  } catch (const X11Error& error) {
    return error.what();
  }
  return {};
}

bool exists(pid_t pid) { return kill(pid, 0) == 0 || errno != ESRCH; }

}  // namespace

// Servers started side by side choose different displays, and each ends with its object.
TEST(XServerFixture, DoNotCollideAndLeaveNothingBehind) {
  pid_t first = 0, second = 0;
  {
    const XServer a = XServer::xvfb(8), b = XServer::xvfb(24);
    first = a.pid();
    second = b.pid();
    EXPECT_NE(a.name(), b.name());
    EXPECT_TRUE(exists(first) && exists(second));
    EXPECT_EQ(DefaultDepth(openDisplay(a.name()).get(), 0), 8);
    EXPECT_EQ(DefaultDepth(openDisplay(b.name()).get(), 0), 24);
  }
  EXPECT_FALSE(exists(first));
  EXPECT_FALSE(exists(second));
}

// A test program that dies without running destructors takes its server with it.
TEST(XServerFixture, DiesWithACrashingTest) {
  std::array<int, 2> channel{};
  ASSERT_EQ(pipe(channel.data()), 0);
  const pid_t crashing = fork();
  if (crashing == 0) {
    const XServer server = XServer::xvfb(8);
    const pid_t pid = server.pid();
    if (write(channel[1], &pid, sizeof pid) != sizeof pid) _exit(2);
    kill(getpid(), SIGKILL);
  }
  pid_t server = 0;
  ASSERT_EQ(read(channel[0], &server, sizeof server), static_cast<ssize_t>(sizeof server));
  close(channel[0]);
  close(channel[1]);
  waitpid(crashing, nullptr, 0);
  const auto gone = [&] {  // nobody may be there to reap it: a zombie is gone too
    std::ifstream stat{"/proc/" + std::to_string(server) + "/stat"};
    std::string number, program, state;
    return !(stat >> number >> program >> state) || state == "Z";
  };
  for (int tries = 0; tries < 1000 && !gone(); ++tries) usleep(10'000);
  EXPECT_TRUE(gone());
}

// If a server program is missing or does not start, the failure says what is missing.
TEST(XServerFixture, SaysWhatIsMissing) {
  const auto start = [](const char* program, std::vector<std::string> arguments) {
    try {
      const XServer server{program, std::move(arguments)};
    } catch (const std::runtime_error& error) {
      return std::string{error.what()};
    }
    return std::string{};
  };
  EXPECT_EQ(start("Xnothing", {}), "the tests need the program Xnothing, which is not installed");
  EXPECT_THAT(start("Xvfb", {"-nonsense"}), AllOf(HasSubstr("Xvfb did not start"), HasSubstr("-nonsense")));
}

// If there is no server, one line says so.
TEST(OpenDisplay, SaysWhatItCouldNotOpen) {
  EXPECT_EQ(thrownBy([] { (void)openDisplay(":54321"); }), "cannot open display ':54321'");
  const char* set = std::getenv("DISPLAY");
  const std::string before = set != nullptr ? set : "";
  unsetenv("DISPLAY");
  EXPECT_THAT(thrownBy([] { (void)openDisplay(); }), HasSubstr("DISPLAY is not set: "));
  setenv("DISPLAY", ":54322", 1);
  EXPECT_EQ(thrownBy([] { (void)openDisplay(); }), "cannot open display ':54322'");
  set != nullptr ? setenv("DISPLAY", before.c_str(), 1) : unsetenv("DISPLAY");
}

// check() throws the first error under a trap with the name of the request that caused it. The error is not
// counted as a stray one, and a trap set later does not get errors of earlier requests.
TEST(ErrorTrap, NamesTheRequest) {
  const XServer server = XServer::xvfb(8);
  const OwnedDisplay display = openDisplay(server.name());
  Display* d = display.get();
  const Window root = DefaultRootWindow(d);
  const int before = strayErrors();
  EXPECT_THAT(thrownBy([&] {
                ErrorTrap trap{d};
                const OwnedPixmap wide{d, XCreatePixmap(d, root, 40000, 1, 8)};  // no pixmap above 32767
                trap.check();
              }),
              AllOf(HasSubstr("X_CreatePixmap"), HasSubstr("BadAlloc")));
  {
    ErrorTrap trap{d};
    const OwnedPixmap shallow{d, XCreatePixmap(d, root, 4, 4, 1)};
    const OwnedGC gc{d, XCreateGC(d, root, 0, nullptr)};
    EXPECT_EQ(thrownBy([&] { trap.check(); }), "");
    XFillRectangle(d, shallow.get(), gc.get(), 0, 0, 4, 4);  // a GC of depth 8 on a pixmap of depth 1
    XMapWindow(d, 0);                                        // a second error, not the first
    ErrorTrap inner{d};
    EXPECT_EQ(thrownBy([&] { inner.check(); }), "");
    EXPECT_THAT(thrownBy([&] { trap.check(); }),
                AllOf(HasSubstr("X_PolyFillRectangle"), HasSubstr("BadMatch")));
    EXPECT_EQ(thrownBy([&] { trap.check(); }), "");
  }
  {
    ErrorTrap dropped{d};
    XMapWindow(d, 0);
  }
  EXPECT_EQ(strayErrors(), before);
}

// An error outside every trap is told and counted, and the program goes on.
TEST(ErrorTrap, StrayErrorsAreToldAndCounted) {
  const XServer server = XServer::xvfb(8);
  const OwnedDisplay display = openDisplay(server.name());
  const int before = strayErrors();
  testing::internal::CaptureStderr();
  XMapWindow(display.get(), 0);
  XSync(display.get(), 0);
  EXPECT_THAT(testing::internal::GetCapturedStderr(),
              AllOf(HasSubstr("xnewell: X_MapWindow: BadWindow"), testing::EndsWith("\n")));
  EXPECT_EQ(strayErrors(), before + 1);
}

// Of many errors only the first are told, but all are counted. A window may get one in every frame.
TEST(ErrorTrap, TellsOnlyTheFirstStrayErrors) {
  const XServer server = XServer::xvfb(8);
  const OwnedDisplay display = openDisplay(server.name());
  const int before = strayErrors();
  ASSERT_LT(before, kToldErrors);
  testing::internal::CaptureStderr();
  for (int i = 0; i < 100; ++i) XMapWindow(display.get(), 0);
  XSync(display.get(), 0);
  const std::string told = testing::internal::GetCapturedStderr();
  EXPECT_EQ(std::ranges::count(told, '\n'), kToldErrors - before);
  EXPECT_EQ(strayErrors(), before + 100);
}

// A server that vanishes ends the program at once with status 1 and a message, with or without a trap. The
// message is another one if a test beside this one has started a server of the same number since.
TEST(OpenDisplayDeathTest, AVanishedServerEndsTheProgram) {
  EXPECT_EXIT(
      {
        alarm(60);  // a hang would end by signal, not by status 1
        XServer server = XServer::xvfb(8);
        const OwnedDisplay display = openDisplay(server.name());
        server.stop();
        ErrorTrap trap{display.get()};
        XMapWindow(display.get(), 0);
        trap.check();
      },
      testing::ExitedWithCode(1),
      "xnewell: (lost the connection to the X server of display ':[0-9]+'|the X server of .* still "
      "runs.*)\n$");
}

// A resource has one owner. Moving leaves nothing behind, and each id is freed exactly once.
TEST(XResource, IsFreedOnce) {
  static_assert(!std::is_copy_constructible_v<OwnedPixmap> && std::is_nothrow_move_assignable_v<OwnedPixmap>);
  const XServer server = XServer::xvfb(8);
  const OwnedDisplay display = openDisplay(server.name());
  Display* d = display.get();
  const auto alive = [&](Pixmap pixmap) {
    ErrorTrap trap{d};
    Window root = 0;
    int x = 0, y = 0;
    unsigned w = 0, h = 0, border = 0, depth = 0;
    return XGetGeometry(d, pixmap, &root, &x, &y, &w, &h, &border, &depth) != 0;
  };
  ErrorTrap trap{d};
  Pixmap first = 0, second = 0;
  {
    OwnedPixmap a{d, XCreatePixmap(d, DefaultRootWindow(d), 4, 4, 8)};
    OwnedPixmap b{d, XCreatePixmap(d, DefaultRootWindow(d), 4, 4, 8)};
    first = a.get();
    second = b.get();
    a = std::move(b);
    OwnedPixmap c{std::move(a)};
    EXPECT_EQ(c.get(), second);
    EXPECT_EQ(a.get(), 0u);
    EXPECT_TRUE(alive(second));
  }
  EXPECT_FALSE(alive(first));
  EXPECT_FALSE(alive(second));
  EXPECT_NO_THROW(trap.check());  // a second free would be BadPixmap
}

}  // namespace xnewell::THIS_FILE
