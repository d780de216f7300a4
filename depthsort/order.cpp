#include "depthsort/order.h"

#include <array>
#include <numeric>
#include <utility>

std::vector<int> sortedByKey(std::span<const std::uint32_t> keys) {
  constexpr int kBits = 11, kDigits = 1 << kBits;
  std::array<std::array<int, kDigits>, 3> count{};
  for (const std::uint32_t key : keys)
    for (int pass = 0; pass < 3; ++pass) ++count[pass][(key >> (pass * kBits)) & (kDigits - 1)];

  std::vector<int> order(keys.size()), next(keys.size());
  std::iota(order.begin(), order.end(), 0);
  for (int pass = 0; pass < 3; ++pass) {
    int begin = 0;
    for (int& c : count[pass]) begin += std::exchange(c, begin);
    for (const int i : order) next[count[pass][(keys[i] >> (pass * kBits)) & (kDigits - 1)]++] = i;
    order.swap(next);
  }
  return order;
}
