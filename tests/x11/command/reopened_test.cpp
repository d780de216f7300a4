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

// Pictures without a set-up, and files that are no pictures, are refused in one line.
TEST_F(ReopenedTest, RefusesOtherPictures) {
  refusedToDraw(file("none.png"), 1, ": No such file or directory");
  refusedToDraw(write("text.png", "hello"), 2, ": not a PNG file");
  const std::string bytes = encodePng(IndexImage{3, 2, 7}, Palette{}, "xnewell draw gone.obj -o picture.png");
  refusedToDraw(write("cut.png", bytes.substr(0, 100)), 2, ": the PNG file ends early");
  refusedToDraw(write("gone.png", bytes), 2,
                ": the scene of the set-up that it carries, gone.obj, is not there");
  refusedToDraw(write("plain.png", encodePng(IndexImage{3, 2, 7}, Palette{})), 2,
                ": the picture carries no set-up, so it is no scene");
}

}  // namespace xnewell::THIS_FILE
