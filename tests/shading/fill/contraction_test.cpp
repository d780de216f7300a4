#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "shading/fill/lanes.h"
#include "tests/support/contracted.h"

namespace xnewell::THIS_FILE {

// No product and sum are fused: each rounds. The bounds, and the promise of the same picture on every
// machine, rest on it (-ffp-contract=off).

namespace {

// (1 + e) (1 - e) - 1 = -e^2. The product rounds to 1, so the sum is 0 if both operations round, and not if
// one rounding is left. The numbers are volatile, so that the compiler knows none of them.
constexpr double kE = 0x1p-30;
volatile double more = 1.0 + kE, less = 1.0 - kE, minusOne = -1.0;

XNEWELL_WITH_FMA double productAndSum(double a, double b, double c) { return a * b + c; }
XNEWELL_WITH_FMA double ofVectors(double a, double b) {
  // Whichever of the products is fused with the sum, the other one has rounded to -1 or 1.
  return dot(Vec<double>{a, a, 0.0}, Vec<double>{b, -b, 0.0});
}
XNEWELL_WITH_FMA double ofLanes(double a, double b) {
  using Four = Lanes<double, 4>;
  const Four as = splat<Four>(a), bs = splat<Four>(b), zero{};
  return dot(Vec<Four>{as, as, zero}, Vec<Four>{bs, -bs, zero})[2];
}

}  // namespace

TEST(Contraction, IsOff) {
  if (!hasFma()) GTEST_SKIP() << "this processor has no fused multiply-add";
  // The check itself: with the option that is not ours, the two are fused.
  EXPECT_EQ(contracted(more, less, minusOne), -kE * kE);
  EXPECT_EQ(productAndSum(more, less, minusOne), 0.0);
  EXPECT_EQ(ofVectors(more, less), 0.0);
  EXPECT_EQ(ofLanes(more, less), 0.0);
}

// The tests share their options with the libraries; but each file of the libraries has the option itself, and
// none that takes it back.
TEST(Contraction, IsOffInEveryFileOfTheLibraries) {
  std::ifstream file{XNEWELL_COMPILE_COMMANDS};
  ASSERT_TRUE(file) << XNEWELL_COMPILE_COMMANDS;
  int files = 0;
  for (const nlohmann::json& entry : nlohmann::json::parse(file)) {
    const std::string source = entry["file"], command = entry["command"];
    if (source.find("/tests/") != std::string::npos) continue;
    SCOPED_TRACE(source);
    ++files;
    const std::size_t off = command.rfind("-ffp-contract=");
    ASSERT_NE(off, std::string::npos);
    EXPECT_EQ(command.substr(off, 18), "-ffp-contract=off ");
    for (const char* other : {"-ffast-math", "-Ofast", "-funsafe-math-optimizations"})
      EXPECT_EQ(command.find(other), std::string::npos) << other;
  }
  EXPECT_GT(files, 20);  // with several files of a room in one, too
}

}  // namespace xnewell::THIS_FILE
