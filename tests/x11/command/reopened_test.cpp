#include "tests/x11/support/command_fixture.h"
#include "tests/x11/support/program_picture.h"
#include "tests/x11/support/x_server.h"

namespace xnewell::THIS_FILE {

namespace {

using ReopenedTest = CommandTest;

}  // namespace

// A picture is its own source: the program makes the same file of it again, byte for byte.
TEST_F(ReopenedTest, DrawsThePictureAgain) {
  for (const std::string line :
       {"teapot --divisions 4 --shade phong --hue 0.3,0.5,1 --size 333x250",
        "teapot --divisions 3 --oblique cavalier --size 64x300 --table linear --order zmean",
        "cubes --parallel 6 --ia 0.4 --ka 0.3 --size 200x150 --gamma 2.2",
        "teapot --divisions 3 --vrp 1,0,0 --vpn 0.3,-1,0.4 --front 0.25 --size 100x80",
        "spotlight --ks 0.4 --keep n --size 160x120", "cycle --view machbands --scanline 200 --size 800x600",
        "teapot --divisions 3 --view colours --cell 33 --rotate 3", "cubes --parallel 3 --view wireframe"}) {
    SCOPED_TRACE(line);
    const Finished first = runProgram(Strings{"draw"} + words(line) + Strings{"-o", file("a.png")});
    ASSERT_EQ(first.status, 0) << first.err;
    const Finished second = runProgram({"draw", file("a.png"), "-o", file("b.png")});
    ASSERT_EQ(second.status, 0) << second.err;
    EXPECT_TRUE(contents(file("a.png")) == contents(file("b.png")));
    // The picture does carry the set-up: with another table, it is another picture of the same scene.
    const Finished other = runProgram({"draw", file("a.png"), "--shades", "40", "-o", file("b.png")});
    ASSERT_EQ(other.status, 0) << other.err;
    EXPECT_EQ(readPng(file("b.png")).width, readPng(file("a.png")).width);
    EXPECT_FALSE(contents(file("a.png")) == contents(file("b.png")));
  }
}

// So does a snapshot of the window, and of what the server fills.
TEST_F(ReopenedTest, TakesTheSnapshotAgain) {
  const XServer server = XServer::xvfb(24, 1024, 768);
  for (const std::string line :
       {"cubes --whole-window --view colours --size 900x700 --shades 90",
        "cycle --whole-window --view depthsort --step 12 --controls none",
        "cubes --whole-window --view pixel --pixel 120,90", "cubes --whole-window --view colours --cell 40",
        "cubes --whole-window --view machbands --scanline 100",
        "cubes --shade flat --fill x11 --size 120x90"}) {
    SCOPED_TRACE(line);
    const Finished first =
        runProgram(Strings{"snapshot"} + words(line) + Strings{"-o", file("a.png")}, server.name());
    ASSERT_EQ(first.status, 0) << first.err;
    const Finished second = runProgram({"snapshot", file("a.png"), "-o", file("b.png")}, server.name());
    ASSERT_EQ(second.status, 0) << second.err;
    EXPECT_TRUE(contents(file("a.png")) == contents(file("b.png")));
  }
}

}  // namespace xnewell::THIS_FILE
