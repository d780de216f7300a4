#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <fstream>

#include "tests/x11/support/program_picture.h"
#include "tests/x11/support/x_session.h"

#include "x11/server/canvas.h"
#include "x11/server/read_visuals.h"

namespace xnewell::THIS_FILE {

// Servers that are reached over the network, and servers that ask for a cookie.

namespace {

const std::string kTeapot = "teapot --divisions 4 --size 640x480";

/// The same server, through the loopback network.
std::string overTcp(const XServer& server) { return "127.0.0.1" + server.name(); }

/// A file with one cookie that is good for every display. @see Xau(3), Xsecurity(7)
void writeCookie(const std::string& file, char byte) {
  std::ofstream out{file, std::ios::binary};
  const auto counted = [&](const std::string& text) {
    out << '\0' << static_cast<char>(text.size()) << text;
  };
  out << "\xFF\xFF";  // FamilyWild
  for (const std::string& part :
       {std::string{}, std::string{}, std::string{"MIT-MAGIC-COOKIE-1"}, std::string(16, byte)})
    counted(part);
}

/// Sets XAUTHORITY as long as it lives.
class Authority {
 public:
  explicit Authority(const std::string& file) { ::setenv("XAUTHORITY", file.c_str(), 1); }
  Authority(const Authority&) = delete;
  Authority& operator=(const Authority&) = delete;
  ~Authority() { ::unsetenv("XAUTHORITY"); }
};

}  // namespace

// A server gives the same picture over the network, without shared memory, as through its local socket.
TEST(RemoteServer, GivesTheSamePicture) {
  for (const int depth : {8, 24}) {
    SCOPED_TRACE(depth);
    Session s{XServer::xvfb(depth, 640, 480, {"-listen", "tcp"})};
    const RgbImage drawn = pictureOf("draw " + kTeapot);
    EXPECT_EQ(pictureOf("snapshot " + kTeapot, s.server.name()), drawn);
    EXPECT_EQ(pictureOf("snapshot " + kTeapot, overTcp(s.server)), drawn);
    EXPECT_EQ(pictureOf("snapshot --fill x11 " + kTeapot, overTcp(s.server)),
              pictureOf("snapshot --fill x11 " + kTeapot, s.server.name()));

    const Canvas near{s.display.get(), s.colormap, {.width = 8, .height = 8}};
    EXPECT_TRUE(near.sharedMemory());
    const OwnedDisplay display = openDisplay(overTcp(s.server));
    const ServerColormap colormap{display.get(), chooseVisual(readVisuals(display.get()))};
    const Canvas far{display.get(), colormap, {.width = 8, .height = 8}};
    EXPECT_FALSE(far.sharedMemory());
  }
}

// Without the server's cookie, or with a wrong one, one line says why the server refuses. With the cookie it
// lets us in.
TEST(RemoteServer, SaysThatACookieIsNeeded) {
  const TemporaryFolder folder;
  writeCookie(folder.file("right"), 'r');
  writeCookie(folder.file("wrong"), 'w');
  const XServer server = XServer::xvfb(8, 640, 480, {"-listen", "tcp", "-auth", folder.file("right")});
  const std::string line = "snapshot " + kTeapot + " -o " + folder.file("picture.png");
  for (const std::string& display : {server.name(), overTcp(server)}) {
    SCOPED_TRACE(display);
    for (const std::string cookie : {"none", "wrong"}) {
      SCOPED_TRACE(cookie);
      const Authority authority{folder.file(cookie)};
      for (const std::string& command : {line, "view " + kTeapot, std::string{"visuals"}}) {
        const Finished refused = runProgram(words(command), display);
        EXPECT_EQ(refused.status, 1);
        EXPECT_EQ(refused.out, "");
        EXPECT_EQ(refused.err,
                  "xnewell: cannot open display '" + display + "': " +
                      (cookie == "none" ? "Authorization required, but no authorization protocol specified"
                                        : "Invalid MIT-MAGIC-COOKIE-1 key") +
                      "\n");
      }
    }
    EXPECT_EQ(folder.entries(), 2);
    const Authority authority{folder.file("right")};
    EXPECT_EQ(runProgram({"visuals"}, display).status, 0);
  }
}

}  // namespace xnewell::THIS_FILE
