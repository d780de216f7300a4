#pragma once

#include <span>
#include <string>

#include "x11/drawing/painter.h"

namespace xnewell {

/// The lines of an algorithm beside a page that steps through it: those of the book, and those that this
/// program adds, which are drawn in another tone and named.
struct CodeLine {
  enum class Ran {
    Never,   ///< not in this step
    Before,  ///< since the step before
    Now,     ///< the step is this line
  };
  std::string text;  ///< with two spaces for each level
  Ran ran = Ran::Never;
  std::string values = {};  ///< of its variables
  bool ours = false;        ///< the book has no such line
};

/// The key that shows them, on all such pages.
inline constexpr char kCodeKey = 'x';
inline constexpr const char* kCodeDoes =
    "show the book's lines and mark the line that runs; or put them away";

/// Draws the lines from the top of the area, as many as fit: the one that runs with a bar and a background,
/// those that ran on the way to it with a dot. Values are aligned right, where they have room.
void drawPseudocode(Pen& pen, const Rect& at, int line, std::string_view source,
                    std::span<const CodeLine> lines);

}  // namespace xnewell
