#pragma once

#include <array>
#include <string_view>

#include "tests/support/student.h"

namespace student {

/// A second depth sort, as a student might write it: in doubles, on the screen, with a list that moves
/// reorder. It writes its run with xnewell_run.h and shares no code with xnewell's. `fault` plants a mistake;
/// `seed` chooses among what is legal: the order of the tests and of polygons of one z, which of two is
/// split, which piece is listed first.
struct Fault {
  std::string_view name;
  std::string_view kind;  ///< what judge calls it
};
inline constexpr std::array kFaults{
    Fault{"test 1 compares the wrong ends", "answer"},
    Fault{"test 2 compares the wrong ends", "answer"},
    Fault{"test 3 has the other sign", "answer"},
    Fault{"test 3 looks at one corner", "answer"},
    Fault{"test 4 has the other sign", "answer"},
    Fault{"test 4 looks at one corner", "answer"},
    Fault{"test 5 looks for corners inside", "answer"},
    Fault{"test 5 is always no", "answer"},
    Fault{"test 3' has the other sign", "answer"},
    Fault{"test 4' has the other sign", "answer"},
    Fault{"test 4' looks at one corner", "answer"},
    Fault{"no test 3", "left-out"},
    Fault{"no test 4", "left-out"},
    Fault{"no test 5", "left-out"},
    Fault{"no tests 3' and 4'", "left-out"},
    Fault{"paints instead of moving", "too-early"},
    Fault{"paints before the last Q is tested", "too-early"},
    Fault{"moves without a test", "not-first"},
    Fault{"no mark", "loop"},
    Fault{"no move", "loop"},
    Fault{"splits by another plane", "plane"},
    Fault{"exchanges the pieces", "sides"},
    Fault{"a gap between the pieces", "cover"},
    Fault{"the front piece is all of P", "cover"},
    Fault{"splits where no plane crosses", "no-cut"},
    Fault{"turns the normal of a piece", "shade"},
    Fault{"shades a piece anew", "shade"},
    Fault{"paints a piece with another cell", "shade"},
    Fault{"loses a piece", "lost"},
    Fault{"loses a polygon that was moved", "lost"},
    Fault{"keeps a polygon that was split", "gone"},
    Fault{"paints the last one twice", "gone"},
};

struct Sorted {
  int line = 0;       ///< of the file: where the fault was first done; 0: at the end
  bool done = false;  ///< the fault made a difference
  bool ended = true;  ///< within 20000 lines
  int lines = 0;
};
/// Perspective views of convex polygons.
Sorted writeRun(const World& world, int width, int height, const char* file, unsigned seed,
                std::string_view fault = "");

}  // namespace student
