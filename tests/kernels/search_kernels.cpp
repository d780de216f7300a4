#include <cstdio>
#include <cstdlib>
#include <string>

#include "tests/kernels/search.h"

/// Searches kernels for their worst inputs, in each rounding mode, with three seeds. Prints a row for the
/// worst of the three:
///   kernel | bound | worst seen, as a share of the bound | input | rounding mode
/// tests/kernels/README.md says what they mean. The exit status is 1 if a bound is exceeded.

int main(int argc, char** argv) {
  using namespace xnewell;
  const int evaluations = argc > 1 ? std::atoi(argv[1]) : 100'000;
  const std::string part = argc > 2 ? argv[2] : "";
  constexpr std::uint64_t kSeeds = 3;
  const std::uint64_t seed = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1;
  if (evaluations <= 0 || argc > 4) {
    std::fputs("usage: search_kernels [EVALUATIONS [PART OF A NAME [FIRST SEED]]]\n", stderr);
    return 2;
  }
  bool exceeded = false;
  for (const Kernel& kernel : allKernels()) {
    if (kernel.name.find(part) == std::string::npos) continue;
    for (const RoundingMode& mode : kRoundingModes) {
      Worst worst;
      for (std::uint64_t of = seed; of < seed + kSeeds; ++of) {
        const Worst found = searchWorst(kernel, mode, static_cast<int>(evaluations * kernel.effort), of);
        if (of == seed || found.share > worst.share) worst = found;
      }
      exceeded = exceeded || worst.share > 1;
      std::string input;
      for (const double v : worst.input) {
        char number[40];
        std::snprintf(number, sizeof number, "%s%a", input.empty() ? "" : " ", v);
        input += number;
      }
      std::printf("%s | %s | %.4g | %s | %s\n", kernel.name.c_str(), kernel.claim.c_str(), worst.share,
                  input.c_str(), std::string{mode.name}.c_str());
      std::fflush(stdout);
    }
  }
  return exceeded ? 1 : 0;
}
