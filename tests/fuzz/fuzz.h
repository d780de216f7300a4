#pragma once

#include <cstddef>
#include <cstdint>

namespace xnewell {

/// Random polygons through snap, depth sort and painting. Aborts if an exact order shows another face than
/// the oracle.
void fuzzPolygons(const std::uint8_t* bytes, std::size_t size);

}  // namespace xnewell
