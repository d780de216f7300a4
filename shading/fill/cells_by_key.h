#pragma once

#ifdef __SSE2__
#include <xmmintrin.h>
#endif

#include <cstdint>
#include <vector>

#include "shading/fill/eight.h"

namespace xnewell {

/// Finds the cells of numbers of 32 bits, here called keys. It finds what a search of the keys at which the
/// cells begin would find, but faster.
///
/// The upper 13 bits of a key choose an entry. Most entries have one cell, or two with the key at which the
/// second begins. Their sum with the key has the cell above its lower 19 bits: a carry makes the first cell
/// the second. Where more cells share an entry, the sum has kSearched there, and the cell is searched.
class CellsByKey {
 public:
  /// What stands for a cell that must be searched. No table has this cell.
  static constexpr std::uint8_t kSearched = 255;

  /// `begins[j]` is the least key of the cell first + j + 1. They ascend. Of equal ones only the last counts.
  CellsByKey(int first, std::vector<std::uint32_t> begins);

  [[nodiscard]] std::uint8_t operator()(std::uint32_t key) const {
    const auto cell = static_cast<std::uint8_t>((entries_[key >> kLower] + key) >> kLower);
    return cell != kSearched ? cell : searched(key);
  }
  /// Calls use(key, cell) with each cell that has keys, and the least of them.
  template <class Use>
  void forEach(const Use& use) const {
    for (std::size_t j = 0; j <= begins_.size(); ++j)
      if (j == 0 || j == begins_.size() || begins_[j - 1] < begins_[j])
        use(j == 0 ? 0 : begins_[j - 1], static_cast<std::uint8_t>(first_ + static_cast<int>(j)));
  }

  /// Reads the cells of four keys in steps. It is copied to a filler's loop, because the compiler must assume
  /// that a store changes members.
  class Entries {
   public:
    explicit Entries(const CellsByKey& of) : entries_{of.entries_.data()} {}
    /// The cells, or kSearched, of the keys first, first + step and so on. `keys` has the same keys.
    [[nodiscard]] EightWords operator()(std::uint32_t first, std::uint32_t step, Eight keys) const {
      keys.left += four(first, step), keys.right += four(first + 4 * step, step);
      return packed({keys.left >> kLower, keys.right >> kLower});
    }

   private:
    [[nodiscard]] Eight::Four four(std::uint32_t first, std::uint32_t step) const {
      const auto at = [&](std::uint32_t key) { return entries_ + (key >> kLower); };
#ifdef __SSE2__
      // The second load of a pair brings the next entry, too. The shuffle leaves it out.
      const auto pair = [&](std::uint32_t key) {
        return _mm_loadh_pi(_mm_load_ss(reinterpret_cast<const float*>(at(key))),
                            reinterpret_cast<const __m64*>(at(key + step)));
      };
      return reinterpret_cast<Eight::Four>(_mm_shuffle_ps(pair(first), pair(first + 2 * step), 0x88));
#else
      return Eight::Four{*at(first), *at(first + step), *at(first + 2 * step), *at(first + 3 * step)};
#endif
    }

    const std::uint32_t* entries_;
  };

  /// Puts the cells of the keys first, first + step and so on where kSearched stands for them.
  void search(std::uint8_t* cells, int count, std::uint32_t first, std::uint32_t step) const {
    if (crowded_) [[unlikely]]
      searchAll(cells, count, first, step);
  }

 private:
  static constexpr int kLower = 19;

  [[nodiscard]] std::uint8_t searched(std::uint32_t key) const;
  void searchAll(std::uint8_t* cells, int count, std::uint32_t first, std::uint32_t step) const;

  int first_;
  bool crowded_ = false;  ///< whether any cell must be searched
  std::vector<std::uint32_t> begins_;
  std::vector<std::uint32_t> entries_;  ///< 2^13, and one more that is loaded but not used
};

}  // namespace xnewell
