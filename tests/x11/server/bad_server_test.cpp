#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <functional>
#include <optional>
#include <set>
#include <sstream>

#include "tests/support/seeds.h"
#include "tests/x11/support/command_fixture.h"
#include "tests/x11/support/watched_viewer.h"
#include "tests/x11/support/x_proxy.h"

#include <X11/Xproto.h>
#include <X11/keysym.h>

namespace xnewell::THIS_FILE {

// What the user sees of servers that refuse, die or hang: the right picture, or a message and status 1. There
// is never a wrong picture, half a file or a program that does not end. And how often the program waits for a
// server, which is what a slow connection costs.

namespace {

using testing::HasSubstr;

const std::string kTeapot = "teapot --divisions 2", kSmall = " --size 120x90";
constexpr std::chrono::seconds kEnough{90};

/// What the program says when its connection ends and the server answers another one.
std::string cutAt(const std::string& display) {
  return "xnewell: the X server of display '" + display +
         "' still runs, but has ended our connection, as xkill makes it do\n";
}

XServer serverFor(int depth) { return XServer::xvfb(depth, 320, 240); }

/// A way to use the program, from its start to its end.
struct Use {
  std::string name;
  std::vector<std::string> arguments;
  std::string file = "";  ///< what it writes
  /// What the user does meanwhile, as long as `hoping` is true.
  std::function<void(const XServer&, const std::function<bool()>& hoping)> act = [](auto&&...) {};
};

Use visuals() { return {"visuals", {"visuals"}}; }

/// The server fills, which makes more kinds of request and sends the picture first.
Use snapshot(const TemporaryFolder& folder, const std::string& more = "--divisions 2 --fill x11" + kSmall) {
  std::vector<std::string> arguments = words("snapshot teapot " + more);
  arguments.insert(arguments.end(), {"-o", folder.file("picture.png")});
  return {"snapshot", arguments, folder.file("picture.png")};
}

/// As soon as there is a window: a new table, a new size, a new hue, and the close button.
Use view() {
  return {"view", words("view " + kTeapot + kSmall), "", [](const XServer& server, const auto& hoping) {
            try {
              const WatchedWindow window{server, 0, hoping};
              const ErrorTrap trap{window.display()};  // the window may be gone
              window.moveTo(60, 45);
              window.type("T");
              window.resize(140, 100);
              window.type("H");
              window.askToClose();
            } catch (const std::runtime_error&) {
              EXPECT_FALSE(hoping());
            }
          }};
}

/// The number of segments of System V shared memory that a process made and that still exist.
std::ptrdiff_t segmentsOf(pid_t maker) {
  std::ifstream table{"/proc/sysvipc/shm"};
  std::string line;
  std::getline(table, line);
  std::ptrdiff_t count = 0;
  for (long key, id, size, made; std::getline(table, line);) {
    std::string permissions;
    if (std::istringstream{line} >> key >> id >> permissions >> size >> made) count += made == maker;
  }
  return count;
}

/// How a use of the program went on the proxy's server.
struct Course {
  Finished end{};
  bool carriedOut = false;
  std::vector<XRequest> requests{}, answered{};
  std::chrono::milliseconds toEnd{};  ///< from the interrupt to the end
};

/// Runs the program to its end. If it is stalled, it is interrupted.
Course runThrough(const Use& use, const XServer& server, XProxy& proxy,
                  const std::optional<XFaultPlan>& plan = {}) {
  std::filesystem::remove(use.file);
  proxy.begin(plan);
  RunningProgram program{use.arguments, proxy.name()};
  const pid_t pid = program.pid();
  const bool stalls = plan && plan->fault == XFault::Stalled;
  const auto hoping = [&] { return program.running() && !(stalls && proxy.carriedOut()); };
  use.act(server, hoping);
  if (stalls && comesTrue([&] { return !hoping(); })) program.signal(SIGINT);
  const auto asked = std::chrono::steady_clock::now();
  Course course{.end = program.wait(kEnough)};
  course.toEnd =
      std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::steady_clock::now() - asked);
  course.carriedOut = proxy.carriedOut();
  course.requests = proxy.requests();
  course.answered = proxy.answered();
  // The shared memory and the window go only when the server has let them go too.
  EXPECT_TRUE(comesTrue([&] { return segmentsOf(pid) == 0; }));
  EXPECT_TRUE(comesToShowNone(openDisplay(server.name()).get()));
  return course;
}

/// The different requests, in the order of their first occurrence.
std::vector<XRequest> kinds(const std::vector<XRequest>& requests) {
  std::vector<XRequest> different;
  for (const XRequest& r : requests)
    if (std::ranges::find(different, r) == different.end()) different.push_back(r);
  return different;
}

/// True if every line is a message of the program.
bool linesAreOurs(const std::string& text) {
  std::istringstream in{text};
  for (std::string line; std::getline(in, line);)
    if (!line.starts_with("xnewell: ")) return false;
  return text.empty() || text.back() == '\n';
}

/// A good server, and a proxy that makes it a bad one.
class BadServer : public testing::TestWithParam<int> {
 protected:
  /// Runs `use` once for each plan.
  void sweep(const Use& use, const std::function<std::vector<XFaultPlan>(const Course&)>& plans,
             const std::function<void(const XFaultPlan&, const Course&)>& judge) {
    const Course good = runThrough(use, server, proxy);
    ASSERT_EQ(good.end.status, 0) << good.end.err;
    ASSERT_EQ(good.end.err, "");
    const std::string file = contents(use.file);
    const std::vector<XFaultPlan> all = plans(good);
    for (const XFaultPlan& plan : someOf(all, 6)) {
      SCOPED_TRACE(proxy.nameOf(plan.request) + ", occurrence " + std::to_string(plan.occurrence));
      const Course course = runThrough(use, server, proxy, plan);
      // The window's later requests depend on which events arrive together.
      EXPECT_TRUE(course.carriedOut || plan.occurrence > 1);
      EXPECT_TRUE(linesAreOurs(course.end.err)) << course.end.err;
      const bool written = std::filesystem::exists(use.file);
      // Without its own colormap, the picture has the colours of the default one.
      EXPECT_TRUE(!written || contents(use.file) == file || plan.request.major == X_CreateColormap);
      EXPECT_TRUE(use.file.empty() || folder.entries() == written);
      if (course.end.status == 0) {
        // A refused cell does no harm: it only means that fewer are free.
        EXPECT_TRUE(course.end.out == good.end.out || plan.request.major == X_AllocColorCells);
        EXPECT_EQ(written, !use.file.empty());
      }
      if (course.carriedOut) judge(plan, course);
    }
  }

  XServer server = serverFor(GetParam());
  XProxy proxy{server};
  TemporaryFolder folder;
};
INSTANTIATE_TEST_SUITE_P(Depths, BadServer, testing::ValuesIn(someOf({8, 24}, 1)),
                         testing::PrintToStringParamName());

/// Plans for a fault at the first and at the last request of each kind.
std::vector<XFaultPlan> at(XFault fault, const std::vector<XRequest>& which, const Course& good) {
  std::vector<XFaultPlan> plans;
  for (const XRequest& r : kinds(which))
    for (const int occurrence : std::set<int>{1, static_cast<int>(std::ranges::count(good.requests, r))})
      plans.push_back({fault, r, occurrence, occurrence == 1 ? BadAlloc : BadMatch});
  return plans;
}

/// How a message may name the refused request.
testing::Matcher<const std::string&> names(const XProxy& proxy, const XRequest& request) {
  if (request == kConnectionSetup) return HasSubstr("cannot open display '" + proxy.name() + "': no more");
  // A missing atom is noticed when it is used, and missing pixels when they do not come. Xlib says no more.
  if (request.major == X_InternAtom)
    return testing::AnyOf(HasSubstr("X_ChangeProperty: BadAtom"), HasSubstr("X_InternAtom: "));
  if (request.major == X_GetImage) return HasSubstr("the X server did not return the picture");
  return testing::AnyOf(
      HasSubstr(proxy.nameOf(request) + ": "),
      HasSubstr("request " + std::to_string(request.major) + "." + std::to_string(request.minor) + ": "));
}

const std::string kDivided = "teapot --divisions 4";
constexpr Rect kSeen{0, 0, 1024, 724};  ///< the window of 1024 x 768 but for its status line

}  // namespace

// A refused request ends in the right output, or in status 1 and a message that names the request.
TEST_P(BadServer, RefusedRequestsAreNamed) {
  // There is no error for UngrabServer. libXext 1.3.4 makes the other request by itself. If it is refused,
  // libXext frees the same memory twice when the connection is closed.
  const auto plans = [&](const Course& good) {
    std::vector<XFaultPlan> refusals = at(XFault::Refused, good.requests, good);
    std::erase_if(refusals, [&](const XFaultPlan& plan) {
      return plan.request.major == X_UngrabServer ||
             proxy.nameOf(plan.request) == "Generic Event Extension.0";
    });
    return refusals;
  };
  std::set<std::string> fatal;
  for (const Use& use : {visuals(), snapshot(folder), view()}) {
    SCOPED_TRACE(use.name);
    sweep(use, plans, [&](const XFaultPlan& plan, const Course& course) {
      EXPECT_THAT(course.end.status, testing::AnyOf(0, 1));
      if (course.end.status == 0) {
        EXPECT_TRUE(
            plan.request.major != X_CreateColormap ||
            course.end.err.find("the X server has no room for another colormap (X_CreateColormap: ") !=
                std::string::npos);
        return;
      }
      fatal.insert(proxy.nameOf(plan.request));
      EXPECT_THAT(course.end.err, names(proxy, plan.request));
      EXPECT_TRUE(use.file.empty() || folder.entries() == 0);
    });
  }
  if (kSanitized) return;  // not all were refused
  EXPECT_THAT(fatal, testing::IsSupersetOf({"setup", "X_CreateWindow", "X_CreatePixmap", "X_CreateGC",
                                            "X_ChangeProperty", "X_InternAtom", "MIT-SHM.3", "X_CopyArea",
                                            "X_GetImage", "X_FillPoly", "X_MapWindow"}));
}

// A connection that ends within a request or within a reply ends the program with status 1 and one line. It
// is no failure after a snapshot has its picture.
TEST_P(BadServer, CutConnectionsAreTold) {
  for (const Use& use : {visuals(), snapshot(folder), view()}) {
    SCOPED_TRACE(use.name);
    const auto judge = [&](const XFaultPlan& plan, const Course& course) {
      if (course.end.status == 0 && !use.file.empty()) {
        EXPECT_EQ(course.end.err, "");
        EXPECT_EQ(readPng(use.file).width, 120);
        return;
      }
      EXPECT_EQ(course.end.status, 1);
      EXPECT_THAT(course.end.err, testing::AnyOf(cutAt(proxy.name()),
                                                 "xnewell: lost the connection to the X server of display '" +
                                                     proxy.name() + "'\n",
                                                 "xnewell: cannot open display '" + proxy.name() + "'\n"));
      EXPECT_TRUE(plan.request != kConnectionSetup ||
                  course.end.err.find("cannot open") != std::string::npos);
    };
    sweep(
        use, [](const Course& good) { return at(XFault::CutRequest, good.requests, good); }, judge);
    sweep(
        use,
        [](const Course& good) {
          std::vector<XRequest> answered = good.answered;
          answered.push_back(kConnectionSetup);
          return at(XFault::CutReply, answered, good);
        },
        judge);
  }
}

// SIGINT ends the program even while it waits for a server that hangs.
TEST_P(BadServer, StalledConnectionsCanBeInterrupted) {
  for (const Use& use : {visuals(), snapshot(folder), view()}) {
    SCOPED_TRACE(use.name);
    sweep(
        use,
        [](const Course& good) {
          std::vector<XRequest> answered = good.answered;
          answered.push_back(kConnectionSetup);
          return at(XFault::Stalled, answered, good);
        },
        [&](const XFaultPlan&, const Course& course) {
          EXPECT_EQ(course.end.status, 130);
          EXPECT_EQ(course.end.err, "");
          EXPECT_LT(course.toEnd, std::chrono::seconds{20});
        });
  }
}

// A window that hangs in the middle of a frame, with the server grabbed, lets the server go when it is
// interrupted.
TEST_P(BadServer, AStalledFrameLetsGoOfTheServer) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    proxy.begin(XFaultPlan{XFault::Stalled, {X_CopyArea}});
    RunningProgram program{words("view " + kTeapot + kSmall), proxy.name()};
    ASSERT_TRUE(comesTrue([&] { return proxy.carriedOut(); }));
    ASSERT_THAT(proxy.requests(), testing::Contains(XRequest{X_GrabServer}));
    ASSERT_THAT(proxy.requests(), testing::Not(testing::Contains(XRequest{X_UngrabServer})));
    program.signal(signal);
    const Finished end = program.wait(kEnough);
    EXPECT_EQ(end.status, 128 + signal);
    EXPECT_EQ(end.err, "");
    EXPECT_EQ(runProgram({"visuals"}, server.name()).status, 0);
  }
}

// If the server does not attach the shared memory, the picture is sent instead, and is the same.
TEST_P(BadServer, SharedMemoryThatIsRefusedIsDoneWithout) {
  const Use use = snapshot(folder, "--divisions 2" + kSmall);
  const Course shared = runThrough(use, server, proxy);
  const RgbImage expected = readPng(use.file);
  const auto attach = std::ranges::find_if(shared.requests,
                                           [&](const XRequest& r) { return proxy.nameOf(r) == "MIT-SHM.1"; });
  ASSERT_NE(attach, shared.requests.end());
  EXPECT_EQ(std::ranges::count(shared.requests, XRequest{X_PutImage}), 0);
  const Course refused = runThrough(use, server, proxy, XFaultPlan{XFault::Refused, *attach, 1, BadAccess});
  EXPECT_TRUE(refused.carriedOut);
  EXPECT_EQ(refused.end.status, 0);
  EXPECT_EQ(refused.end.err, "");
  EXPECT_EQ(std::ranges::count(refused.requests, XRequest{X_PutImage}), 1);
  EXPECT_EQ(readPng(use.file), expected);
}

// A later refusal is told in the window, and again when the program ends, even if it was in the last frame. A
// refused size is no error: the next size may be granted.
TEST_P(BadServer, RefusalsAreToldInTheWindow) {
  struct Refusal {
    XRequest request;
    Rect status;  ///< where the window tells it
    bool last, error;
  };
  const Rect before = layoutOf(1024, 768).status, after = layoutOf(1100, 800).status;
  const XServer wide = XServer::xvfb(GetParam(), 1280, 1024);
  XProxy between{wide};
  const RgbImage first = freshWindow(wide, kTeapot), next = freshWindow(wide, kTeapot, 1020, 760);
  const CellPlan plan;
  const Rgb16 alarm = withInterface({}, plan)[plan[Cell::Alarm]];
  for (const Refusal& refusal :
       {Refusal{{X_GrabServer}, after, false, true}, Refusal{{X_GrabServer}, after, true, true},
        Refusal{{X_CreatePixmap}, before, false, false}}) {
    SCOPED_TRACE(between.nameOf(refusal.request) + (refusal.last ? ", last" : ""));
    RunningProgram program{words("view " + kTeapot), between.name()};
    const WatchedWindow window{wide};
    const auto alarmed = [&] {
      const RgbImage image = window.shown(refusal.status);
      for (std::size_t i = 0; i < image.rgb.size(); i += 3)
        if (image.rgb[i] == alarm.r >> 8 && image.rgb[i + 1] == alarm.g >> 8 &&
            image.rgb[i + 2] == alarm.b >> 8)
          return true;
      return false;
    };
    ASSERT_TRUE(window.comesToShow(first, aboveStatus(1024, 768)));
    between.begin(XFaultPlan{XFault::Refused, refusal.request});
    if (refusal.last) program.signal(SIGSTOP);  // so that the frame and the close request arrive together
    window.resize(1100, 800);
    if (!refusal.last) {
      EXPECT_TRUE(comesTrue(alarmed));
      window.resize(1020, 760);
      EXPECT_TRUE(window.comesToShow(next, aboveStatus(1020, 760)));
    }
    window.askToClose();
    program.signal(SIGCONT);
    const Finished end = program.wait(kEnough);
    EXPECT_TRUE(between.carriedOut());
    EXPECT_EQ(end.status, refusal.error ? 1 : 0);
    EXPECT_EQ(end.err,
              refusal.error
                  ? "xnewell: X_GrabServer: BadAlloc (insufficient resources for operation)\n"
                    "xnewell: the X server refused requests (1 in all): what was shown may be wrong\n"
                  : "");
    EXPECT_TRUE(window.goes());
  }
}

// A connection that ends during a snapshot ends the program with one line, and no file is left. It may end
// while a picture is sent that is larger than the system takes at once, or just as the program writes, which
// raises SIGPIPE. A snapshot needs nothing more of the server once it has the pixels: then the end is no
// failure.
TEST(DyingServer, EndsDuringASnapshot) {
  struct Case {
    std::string more;
    XFaultPlan plan;
    bool fails, carriedOut = true;
  };
  const std::string large = "--divisions 2 --size 1600x1200",
                    filled = "--fill x11" + kSmall + " --divisions ";
  const XServer server = XServer::xvfb(24, 320, 240, {"-extension", "MIT-SHM"});
  XProxy proxy{server};
  // 30 divisions: about a megabyte of requests, several times what fits between the two. When the first
  // polygon arrives, the program has not yet written the last one.
  for (const Case& c : {Case{large, {XFault::CutRequest, {X_PutImage}}, true},
                        Case{large, {XFault::CutRequest, {X_PutImage}, 100}, false, false},
                        Case{filled + "30", {XFault::Deaf, {X_FillPoly}}, true},
                        Case{filled + "2", {XFault::CutRequest, {X_DestroyWindow}}, false}}) {
    SCOPED_TRACE(c.more + ", " + proxy.nameOf(c.plan.request));
    const TemporaryFolder folder;
    const Course course = runThrough(snapshot(folder, c.more), server, proxy, c.plan);
    EXPECT_EQ(course.carriedOut, c.carriedOut);
    EXPECT_EQ(course.end.status, c.fails ? 1 : 0);
    EXPECT_EQ(course.end.err.empty(), !c.fails);
    EXPECT_EQ(folder.entries(), c.fails ? 0 : 1);
    if (c.plan.fault == XFault::Deaf) {
      EXPECT_EQ(course.end.err, cutAt(proxy.name()));  // the proxy still answers
    }
  }
}

// A server that ends in the middle of a frame, between two frames, or while the user drags, ends the program
// with one line and status 1.
TEST(DyingServer, EndsTheWindowAtAnyTime) {
  enum class When { Presenting, Between, Dragging };
  for (const When when : {When::Presenting, When::Between, When::Dragging}) {
    SCOPED_TRACE(static_cast<int>(when));
    XServer server = serverFor(8);
    XProxy proxy{server};
    if (when == When::Presenting) proxy.begin(XFaultPlan{XFault::Stalled, {X_CopyArea}});
    RunningProgram program{words("view " + kTeapot + kSmall), proxy.name()};
    if (when == When::Presenting) {
      ASSERT_TRUE(comesTrue([&] { return proxy.carriedOut(); }));
    } else {
      const WatchedWindow window{server};
      window.moveTo(60, 45);
      window.button(1, when == When::Dragging);
      for (int i = 0; when == When::Dragging && i < 300; ++i) window.moveTo(20 + i % 80, 45);
    }
    proxy.serverStops();
    server.stop();
    const Finished end = program.wait(kEnough);
    EXPECT_EQ(end.status, 1);
    EXPECT_EQ(end.err, "xnewell: lost the connection to the X server of display '" + proxy.name() + "'\n");
  }
}

// A program that ends our connection alone (xkill) is not taken for a server that has gone.
TEST(DyingServer, LivesWhenOnlyOurConnectionEnds) {
  const XServer server = serverFor(8);
  RunningProgram program{words("view " + kTeapot + kSmall), server.name()};
  {
    const WatchedWindow window{server};
    XKillClient(window.display(), window.id());
    XSync(window.display(), 0);
  }
  const Finished end = program.wait(kEnough);
  EXPECT_EQ(end.status, 1);
  EXPECT_EQ(end.err, cutAt(server.name()));
}

// A round trip takes at least the latency, and the latency does not change the picture.
TEST(XProxy, IsLateByItsLatency) {
  constexpr std::chrono::milliseconds kLatency{10};
  const XServer server = XServer::xvfb(8);
  XProxy proxy{server, kLatency};
  const OwnedDisplay display = openDisplay(proxy.name());
  proxy.begin();
  const auto start = std::chrono::steady_clock::now();
  XSync(display.get(), 0);
  EXPECT_GE(std::chrono::steady_clock::now() - start, kLatency);
  EXPECT_EQ(proxy.answered().size(), 1u);
  EXPECT_EQ(proxy.requests(), proxy.answered());
  const std::string line = "snapshot " + kDivided + " --size 64x48";
  EXPECT_EQ(pictureOf(line, proxy.name()), pictureOf(line, server.name()));
}

class RoundTripsAt : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Depths, RoundTripsAt, testing::ValuesIn(someOf({8, 24}, 1)),
                         testing::PrintToStringParamName());

// In every view, and over a connection that is 50 ms late, a key waits at most three times, whoever fills.
// New colours are stored without waiting if there is a colormap to store them in. What Xlib asks for the
// first watch cursor, which appears when work takes long, is not counted.
TEST_P(RoundTripsAt, AreFewInEveryView) {
  for (const std::string fill : {"", " --fill x11"}) {
    SCOPED_TRACE(fill);
    const XServer server = XServer::xvfb(GetParam(), 1280, 1024);
    XProxy proxy{server, std::chrono::milliseconds{50}};
    const RunningProgram program{words("view " + kDivided + fill), proxy.name()};
    const WatchedWindow window{server};
    window.moveTo(700, 15);         // on nothing
    ASSERT_TRUE(window.settles());  // the first key asks for the keyboard's mapping
    for (const KeySym key : {XK_2, XK_End, XK_3, XK_Right, XK_4, XK_Down, XK_5, XK_n, XK_7, XK_Down, XK_1,
                             XK_Right, XK_T, XK_H}) {
      SCOPED_TRACE(XKeysymToString(key));
      const RgbImage before = window.shown(kSeen);
      proxy.begin();
      window.press(key, key == XK_T || key == XK_H);
      EXPECT_TRUE(window.comesToDiffer(before, kSeen));
      EXPECT_FALSE(proxy.requests().empty());
      const auto waits = std::ranges::count_if(proxy.answered(), [&](const XRequest& request) {
        const std::string name = proxy.nameOf(request);
        return name != "X_QueryExtension" && !name.starts_with("RENDER.") && !name.starts_with("XFIXES.");
      });
      EXPECT_LE(waits, key == XK_H && GetParam() == 8 ? 0 : 3);
      ASSERT_TRUE(window.settles());
    }
  }
}

}  // namespace xnewell::THIS_FILE
