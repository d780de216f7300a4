#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <string>

#include "tests/x11/support/command_fixture.h"
#include "tests/x11/support/x_server.h"

namespace xnewell::THIS_FILE {

namespace {

const std::string kExample = XNEWELL_DATA_DIR "/../x11/example/";

}  // namespace

// The program that students begin with compiles, and its picture and its order are right. With the 2 taken
// out of R, its picture tells so.
TEST_F(CommandTest, StudentsProgramIsRightAndItsMistakesAreNamed) {
  const XServer server = XServer::xvfb(24);
  const std::string source = contents(kExample + "student.cpp");
  const auto drawn = [&](const std::string& text, const std::string& name) {
    std::ofstream{file(name + ".cpp")} << text;
    const std::string compiled = file(name), run = "DISPLAY=" + server.name() + " " + compiled + " " +
                                                   kExample + "house.obj " + file(name + ".ppm") + " " +
                                                   file(name + ".jsonl") + " " + file(name + ".run");
    std::ofstream{file("xnewell_run.h")} << runProgram({"run-header"}).out;
    EXPECT_EQ(std::system((std::string{XNEWELL_CXX} + " -std=c++20 " + file(name + ".cpp") + " -o " +
                           compiled + " -lX11")
                              .c_str()),
              0);
    EXPECT_EQ(std::system(run.c_str()), 0);
  };
  const Strings house{kExample + "house.obj",  "--eye", "4,3,6", "--look-at", "0,0.4,0",
                      "--light=-0.5,0.6,-0.4", "--n",   "4"};
  drawn(source, "right");
  auto said = runProgram(Strings{"diagnose"} + house + Strings{file("right.ppm")});
  EXPECT_TRUE(said.out.starts_with("right\n  this picture would be the same with ")) << said.out << said.err;
  said = runProgram(Strings{"judge"} + house + Strings{file("right.jsonl"), "--size", "640x480"});
  EXPECT_TRUE(said.out.starts_with("right: 9 steps")) << said.out << said.err;

  said = runProgram(Strings{"judge"} + house + Strings{"--run", file("right.run")});
  EXPECT_TRUE(said.out.starts_with("right: 18 steps")) << said.out << said.err;

  std::string wrong = source;
  const std::string R = "2.0 * NL * N - L";
  ASSERT_NE(wrong.find(R), std::string::npos);
  wrong.replace(wrong.find(R), R.size(), "NL * N - L");
  drawn(wrong, "wrong");
  said = runProgram(Strings{"diagnose"} + house + Strings{file("wrong.ppm")});
  EXPECT_TRUE(said.out.starts_with("wrong: R-without-2: ")) << said.out << said.err;
}

}  // namespace xnewell::THIS_FILE
