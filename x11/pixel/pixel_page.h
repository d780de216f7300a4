#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "x11/drawing/pen.h"
#include "x11/pixel/pixel_drawings.h"
#include "x11/pixel/pixel_words.h"
#include "x11/pixel/predict.h"
#include "x11/window/layout.h"

namespace xnewell {

/// The page of view 8: the picture with its pixel, the neighbourhood, and the four links of the explanation.

struct PixelLayout {
  Rect picture, neighbourhood;
  int facts = 0;     ///< the left edge of the words beside the neighbourhood
  Rect column;       ///< of the explanation
  int pitch = 16;    ///< from line to line
  int rows = 5;      ///< of the history
  int controls = 0;  ///< the baseline of the first row of controls
};
[[nodiscard]] PixelLayout layoutOfPixel(const Layout& at);

/// A pixel and its numbers from before the last change, for comparison.
struct PixelBefore {
  std::string I;  ///< as it is written
  int cell = 0;
  bool operator==(const PixelBefore&) const = default;
};

struct PixelPage {
  const PixelStory& story;
  int chosen = 0;   ///< index into history.painted: the polygon that is explained
  int vertex = 0;   ///< Gouraud: index into Explanation::vertices of the equation that is shown
  int channel = 0;  ///< of several
  std::optional<PixelBefore> before = {};
  BallTurn ball = {};
  std::optional<Predicted> asked = {};  ///< this value is hidden, and all that follows from it
  const Palette& palette;
  int shownBits = 0;  ///< as VisualInfo::shownBits(); 0 without a server
};

/// Where the parts are that the pointer can press.
struct PixelPlaces {
  std::vector<std::pair<Rect, int>> history;  ///< a row, and its index into history.painted
  Rect ball{};                                ///< of no height if there is none
};

/// Draws the words and the neighbourhood. The picture is drawn first, by the caller.
PixelPlaces drawPixelPage(Pen& pen, const PixelLayout& at, const PixelPage& page);

/// The rows of the history that have room: indices into history.painted, -1 for a gap. The chosen one is
/// among them.
[[nodiscard]] std::vector<int> shownRows(int count, int chosen, int room);

}  // namespace xnewell
