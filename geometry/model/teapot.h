#pragma once

#include <array>

#include "geometry/model/bezier.h"

namespace xnewell {

/// The parts of data/teapot.bpt, in the order of its patches. A .bpt file has no place for names.
/// The bottom is not Newell's; it was added later. @see Crow 1987
inline constexpr std::array kTeapotParts{
    PatchPart{"rim", 4},   PatchPart{"upper body", 4}, PatchPart{"lower body", 4}, PatchPart{"handle", 4},
    PatchPart{"spout", 4}, PatchPart{"knob", 4},       PatchPart{"lid", 4},        PatchPart{"bottom", 4},
};

}  // namespace xnewell
