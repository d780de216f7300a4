#pragma once

#include <optional>
#include <string>

#include "x11/drawing/painter.h"
#include "x11/kit/key.h"

namespace xnewell {

/// What the pointer finds in what is written in the window, whatever view has written it: key caps are
/// buttons, counts are links, and words say what they mean.

/// Where a count leads: to the first cut of the depth sort, to a pixel that is clamped or shows a wrong face,
/// to a cell. The words of a mistake lead to the right picture.
enum class Lead { None, Cut, Clamped, Wrong, Cell, Right };

struct Pointed {
  Rect place;                   ///< of the cap, the count or the word
  std::string says = {};        ///< a sentence; "": none
  std::optional<Key> key = {};  ///< of a cap
  bool gesture = false;         ///< a cap without a key: the pointer does it
  Lead lead = Lead::None;
  int number = 0;  ///< of the cell
  bool operator==(const Pointed&) const = default;
};
/// What was written last at this place, in units.
[[nodiscard]] std::optional<Pointed> pointedAt(const Writing& writing, int x, int y);
/// The counts that lead somewhere.
[[nodiscard]] std::vector<Pointed> linksIn(const Written& written);

}  // namespace xnewell
