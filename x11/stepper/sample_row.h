#pragma once

namespace xnewell {

/// Samples of a row: columns [from, to).
struct SampleRow {
  int row = 0, from = 0, to = 0;
  bool operator==(const SampleRow&) const = default;
};

}  // namespace xnewell
