#pragma once

#include <gtest/gtest.h>

#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "shading/color/png.h"
#include "tests/support/temporary_folder.h"
#include "tests/x11/support/program.h"

namespace xnewell {

/// A command line as the words that a shell would make of it. Quotes are not understood.
inline std::vector<std::string> words(const std::string& line) {
  std::istringstream in{line};
  return {std::istream_iterator<std::string>{in}, {}};
}

/// What `xnewell LINE -o FILE` writes. If it writes nothing, the test fails and the image has no pixels.
inline RgbImage pictureOf(const std::string& line, const std::string& display = "") {
  const TemporaryFolder folder;
  std::vector<std::string> arguments = words(line);
  arguments.insert(arguments.end(), {"-o", folder.file("picture.png")});
  const Finished done = runProgram(arguments, display);
  EXPECT_EQ(done.status, 0) << done.err;
  EXPECT_EQ(done.err, "");
  return done.status == 0 ? readPng(folder.file("picture.png")) : RgbImage{};
}

}  // namespace xnewell
