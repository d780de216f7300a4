#include "shading/fill/cells_by_key.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace xnewell {

CellsByKey::CellsByKey(int first, std::vector<std::uint32_t> begins)
    : first_{first}, begins_{std::move(begins)} {
  assert(first + std::ssize(begins_) < kSearched && std::ranges::is_sorted(begins_));
  constexpr std::uint32_t kEntries = 1U << (32 - kLower);
  entries_.reserve(kEntries + 1);
  auto next = begins_.begin();
  for (std::uint32_t k = 0; k < kEntries; ++k) {
    // The sum of an entry and a key k 2^19 + lower is cell 2^19 + lower, or more by 2^19 - begin.
    const auto cell = static_cast<std::uint32_t>(first + (next - begins_.begin()));
    const auto begin = next;
    while (next != begins_.end() && *next >> kLower == k) ++next;
    crowded_ |= next - begin > 1;
    entries_.push_back(next == begin       ? (cell - k) << kLower
                       : next - begin == 1 ? ((cell + 1) << kLower) - *begin
                                           : (kSearched - k) << kLower);
  }
  entries_.push_back(0);
}

std::uint8_t CellsByKey::searched(std::uint32_t key) const {
  return static_cast<std::uint8_t>(first_ + (std::ranges::upper_bound(begins_, key) - begins_.begin()));
}

void CellsByKey::searchAll(std::uint8_t* cells, int count, std::uint32_t first, std::uint32_t step) const {
  std::uint8_t* const end = cells + count;
  for (std::uint8_t* at = cells; (at = std::find(at, end, kSearched)) != end; ++at)
    *at = searched(first + static_cast<std::uint32_t>(at - cells) * step);
}

}  // namespace xnewell
