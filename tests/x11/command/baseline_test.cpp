#include <gtest/gtest.h>

#include "geometry/files/text_file.h"
#include "shading/scene/scene_file.h"
#include "tests/support/seeds.h"
#include "tests/support/temporary_folder.h"
#include "tests/x11/support/program_picture.h"

namespace xnewell::THIS_FILE {

// The code for newer processors and the code for any processor give the same picture, bit for bit.

namespace {

/// The PNG that the program draws, and what it says.
std::string drawn(const std::string& program, const std::string& line, const TemporaryFolder& folder) {
  const std::string file = folder.file("drawn.png");
  std::vector<std::string> arguments{"draw"};
  for (const std::string& word : words(line)) arguments.push_back(word);
  arguments.insert(arguments.end(), {"-o", file});
  RunningProgram child{program, arguments, ""};
  const Finished end = child.wait();
  EXPECT_EQ(end.status, 0) << line << ": " << end.err;
  return end.err + readTextFile(file);
}

}  // namespace

TEST(Baseline, GivesTheSameBits) {
#if defined(__x86_64__)
  if (!__builtin_cpu_supports("avx2")) GTEST_SKIP() << "both programs run the same code here";
#endif
  const std::string program = builtProgram(), baseline = builtProgram("tests/xnewell_baseline");
  if (kSanitized) GTEST_SKIP() << "a sanitized build has only the latter";
  const TemporaryFolder folder;
  int pictures = 0;
  for (const std::string scene : {"teapot", "saturated", "highlight", "colored-lights", "spotlight", "hues"})
    for (const std::string method : {"flat", "gouraud", "phong", "phong --constant-v", "envmap"}) {
      const std::string line = scene + " --size 320x240 --shade " + method;
      EXPECT_EQ(drawn(program, line, folder), drawn(baseline, line, folder)) << line;
      ++pictures;
    }
  EXPECT_EQ(pictures, 30);
}

}  // namespace xnewell::THIS_FILE
