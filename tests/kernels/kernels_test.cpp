#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <sstream>

#include "tests/kernels/search.h"

namespace xnewell {

namespace {

const std::vector<Kernel>& kernels() {
  static const std::vector<Kernel> all = allKernels();
  return all;
}

std::string testName(const testing::TestParamInfo<std::size_t>& info) {
  std::string name;
  for (const char c : kernels()[info.param].name)
    name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  return name;
}

class KernelBound : public testing::TestWithParam<std::size_t> {};

/// A row of worst_inputs.txt.
struct Row {
  std::string kernel, mode;
  double share = 0;
  Numbers input;
};
std::vector<Row> worstInputs() {
  std::ifstream file{XNEWELL_WORST_INPUTS};
  std::vector<Row> rows;
  for (std::string line; std::getline(file, line);) {
    std::vector<std::string> fields;
    for (std::size_t at = 0; at != std::string::npos;) {
      const std::size_t end = line.find(" | ", at);
      fields.push_back(line.substr(at, end == std::string::npos ? end : end - at));
      at = end == std::string::npos ? end : end + 3;
    }
    if (fields.size() != 5) {
      ADD_FAILURE() << "not a row: " << line;
      continue;
    }
    Row row{fields[0], fields[4], std::stod(fields[2]), {}};
    std::istringstream numbers{fields[3]};
    for (std::string number; numbers >> number;) row.input.push_back(std::strtod(number.c_str(), nullptr));
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace

// Searches of a few thousand inputs find none beyond the bound that the header claims, in any rounding mode.
// Another seed looks in other places.
TEST_P(KernelBound, HoldsWhereASearchLooks) {
  const Kernel& kernel = kernels()[GetParam()];
  for (const RoundingMode& mode : kRoundingModes) {
    SCOPED_TRACE(mode.name);
    const bool nearest = mode.name == "nearest";
    const int evaluations = std::max(20, static_cast<int>((nearest ? 4'000 : 1'000) * kernel.effort));
    for (const std::uint64_t seed :
         nearest ? std::vector<std::uint64_t>{7, 8, 9} : std::vector<std::uint64_t>{7}) {
      const Worst worst = searchWorst(kernel, mode, evaluations, seed);
      EXPECT_LE(worst.share, 1.0) << kernel.header << ": " << kernel.claim << "; seed " << seed << ", input "
                                  << testing::PrintToString(worst.input);
    }
  }
}
INSTANTIATE_TEST_SUITE_P(Kernels, KernelBound, testing::Range(std::size_t{0}, kernels().size()), testName);

// The worst inputs that long searches found are within the bounds. To nearest, they are as bad as when they
// were found: else the kernel has changed, and the file must be made again.
TEST(KernelWorstInputs, AreWithinTheirBounds) {
  const std::vector<Row> rows = worstInputs();
  for (const Row& row : rows) {
    SCOPED_TRACE(row.kernel + ", " + row.mode);
    const auto kernel = std::ranges::find(kernels(), row.kernel, &Kernel::name);
    const auto mode = std::ranges::find(kRoundingModes, row.mode, &RoundingMode::name);
    ASSERT_TRUE(kernel != kernels().end() && mode != kRoundingModes.end());
    if (row.input.empty()) continue;  // the search found no error at all
    ASSERT_EQ(row.input.size(), kernel->input.size());
    const double share = shareAt(*kernel, row.input, *mode);
    EXPECT_LE(share, 1.0);
    // In other modes, compilers may round constants differently.
    if (row.mode == "nearest") {
      EXPECT_NEAR(share, row.share, 1e-3 * row.share);
    }
  }
  EXPECT_EQ(rows.size(), kernels().size() * kRoundingModes.size());
}

// The search finds the worst input of a small range: all floats from 1 to 1 + 2^-11, whose squares are
// judged one by one. It also finds a single input among 2^64 if the errors beside it lead there.
TEST(KernelSearch, FindsTheWorst) {
  const auto squareError = [](double x) {
    const float rounded = static_cast<float>(x) * static_cast<float>(x);
    return std::abs(rounded - x * x) * 0x1p23;
  };
  const Kernel square{.name = "square",
                      .claim = {},
                      .header = {},
                      .input = {floats(1, 1 + 0x1p-11)},
                      .run = [](const Numbers& in) { return in; },
                      .judge = [&](const Numbers& in, const Numbers&) { return squareError(in[0]); }};
  double worst = 0;
  for (int k = 0; k <= 1 << 12; ++k) worst = std::max(worst, squareError(1 + k * 0x1p-23));
  EXPECT_EQ(searchWorst(square, kRoundingModes[0], 30'000, 1).share, worst);

  const double needle = 0x1.23456789abcdep-345;
  const Kernel hill{.name = "hill",
                    .claim = {},
                    .header = {},
                    .input = {doubles(-1e300, 1e300)},
                    .run = [](const Numbers& in) { return in; },
                    .judge =
                        [&](const Numbers& in, const Numbers&) {
                          return 1 / (1 + std::abs(static_cast<double>(encoded(in[0])) -
                                                   static_cast<double>(encoded(needle))));
                        }};
  EXPECT_EQ(searchWorst(hill, kRoundingModes[0], 5'000, 1).share, 1.0);
}

}  // namespace xnewell
