#pragma once

#include <functional>

#include "tests/support/student.h"

namespace student {

/// The student's viewing transformation by 4 x 4 matrices, as in the textbook, for flat faces. `mistake`
/// plants one of the mistakes of the view; `variant` is another convention that gives the same picture.

/// The picture; `cellOf` tells the cell of a face.
[[nodiscard]] Result drawByMatrices(const World& world, const Program& program,
                                    const std::function<int(int face)>& cellOf);
/// What the program takes for the normal of a face, and for a light, in viewing coordinates, turned back to
/// the world's.
[[nodiscard]] Triple normalInView(const World& world, const Program& program, const Triple& N);
[[nodiscard]] Triple lightInView(const World& world, const Program& program, const Triple& light,
                                 const Triple& P);

}  // namespace student
