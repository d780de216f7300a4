#pragma once

#include <cstdint>
#include <span>
#include <vector>

/// Indices 0..#keys-1 in ascending order of key, equal keys in order of index (stable): a radix sort,
/// three passes of 11 bits, linear in #keys.
[[nodiscard]] std::vector<int> sortedByKey(std::span<const std::uint32_t> keys);
