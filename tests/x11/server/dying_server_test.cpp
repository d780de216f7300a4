#include <gtest/gtest.h>

#include "tests/x11/support/proxied_program.h"

#include <X11/Xproto.h>

namespace xnewell::THIS_FILE {

// Servers that end, and connections that are cut while a picture is sent: a message and status 1. Every
// request that a server may refuse: bad_server_test.cpp.

// A connection that ends while a picture is being sent is told like any other. The picture is larger than the
// system takes at once.
TEST(DyingServer, EndsWhileAPictureIsSent) {
  const XServer server = XServer::xvfb(24, 320, 240, {"-extension", "MIT-SHM"});
  XProxy proxy{server};
  const TemporaryFolder folder;
  const Use use = snapshot(folder, "--divisions 2 --size 1600x1200");
  for (const int occurrence : {1, 100}) {
    const Course course = runThrough(
        use, server, proxy,
        XFaultPlan{.fault = XFault::CutRequest, .request = {X_PutImage}, .occurrence = occurrence});
    EXPECT_EQ(course.carriedOut, occurrence == 1);
    EXPECT_EQ(course.end.status, course.carriedOut ? 1 : 0);
    EXPECT_EQ(course.end.err.empty(), !course.carriedOut);
    EXPECT_EQ(folder.entries(), course.carriedOut ? 0 : 1);
  }
}

// A connection that ends just as the program writes is told like any other, although the write raises
// SIGPIPE.
TEST(DyingServer, EndsWhileWeWrite) {
  const XServer server = serverFor(8);
  XProxy proxy{server};
  const TemporaryFolder folder;
  // About a megabyte of requests, several times what fits between the two: when the first polygon arrives,
  // the program has not yet written the last one.
  const Use use = snapshot(folder, "--fill x11 --divisions 30" + kSmall);
  const Course course = runThrough(use, server, proxy, XFaultPlan{XFault::Deaf, {X_FillPoly}});
  EXPECT_TRUE(course.carriedOut);
  EXPECT_EQ(course.end.status, 1);
  EXPECT_EQ(course.end.err, cutAt(proxy.name()));  // the proxy still answers
  EXPECT_EQ(folder.entries(), 0);
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

// A snapshot needs nothing more of the server once it has the pixels. A server that ends then is no failure.
TEST(DyingServer, MayEndAfterThePictureIsRead) {
  const XServer server = serverFor(8);
  XProxy proxy{server};
  const TemporaryFolder folder;
  const Course course =
      runThrough(snapshot(folder), server, proxy, XFaultPlan{XFault::CutRequest, {X_DestroyWindow}});
  EXPECT_TRUE(course.carriedOut);
  EXPECT_EQ(course.end.status, 0);
  EXPECT_EQ(course.end.err, "");
  EXPECT_EQ(folder.entries(), 1);
}

}  // namespace xnewell::THIS_FILE
