#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <fstream>
#include <functional>
#include <iomanip>
#include <iostream>
#include <map>
#include <set>
#include <sstream>

#include "tests/support/seeds.h"
#include "tests/x11/support/proxied_program.h"

#include <X11/Xproto.h>
#include <X11/keysym.h>

namespace xnewell::THIS_FILE {

// What the user sees of servers that refuse, die or hang: the right picture, or a message and status 1. There
// is never a wrong picture, half a file or a program that does not end.

namespace {

using testing::HasSubstr;

/// The different requests, in the order of their first occurrence.
std::vector<XRequest> kinds(const std::vector<XRequest>& requests) {
  std::vector<XRequest> different;
  for (const XRequest& r : requests)
    if (std::ranges::find(different, r) == different.end()) different.push_back(r);
  return different;
}

std::string contents(const std::string& file) {
  std::ifstream in{file, std::ios::binary};
  return {std::istreambuf_iterator<char>{in}, {}};
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
  /// Runs `use` once for each plan, and prints how each ended.
  void sweep(const std::string& fault, const Use& use,
             const std::function<std::vector<XFaultPlan>(const Course&)>& plans,
             const std::function<void(const XFaultPlan&, const Course&)>& judge) {
    const Course good = runThrough(use, server, proxy);
    ASSERT_EQ(good.end.status, 0) << good.end.err;
    ASSERT_EQ(good.end.err, "");
    const std::string file = contents(use.file);
    std::map<XRequest, std::string> outcomes;
    const std::vector<XFaultPlan> all = plans(good);
    for (const XFaultPlan& plan : someOf(all, 6)) {
      SCOPED_TRACE(proxy.nameOf(plan.request) + ", occurrence " + std::to_string(plan.occurrence));
      const Course course = runThrough(use, server, proxy, plan);
      outcomes[plan.request] += (plan.occurrence == 1 ? "  first: " : "  last: ") +
                                (course.carriedOut ? std::to_string(course.end.status) : "not reached");
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
    std::cout << fault << ": xnewell " << use.name << ", depth " << GetParam() << ", " << all.size()
              << " runs; how often asked, and exit statuses\n";
    for (const XRequest& r : kinds(good.requests))
      if (outcomes.contains(r))
        std::cout << "  " << std::left << std::setw(26) << proxy.nameOf(r) << std::right << std::setw(4)
                  << std::ranges::count(good.requests, r) << outcomes[r] << '\n';
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
    sweep("refused", use, plans, [&](const XFaultPlan& plan, const Course& course) {
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
        "cut", use, [](const Course& good) { return at(XFault::CutRequest, good.requests, good); }, judge);
    sweep(
        "cut in the reply", use,
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
        "stalled", use,
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

}  // namespace xnewell::THIS_FILE
