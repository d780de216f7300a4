#pragma once

#include <optional>
#include <string>
#include <vector>

#include "shading/color/color_table.h"
#include "shading/explain/scanline_run.h"
#include "x11/kit/pseudocode.h"
#include "x11/kit/quiz.h"
#include "x11/kit/transport.h"
#include "x11/scanline/scanline_words.h"

namespace xnewell {

/// The page of view 0: a polygon under a large grid, its edges, the row and the pixel, each with its numbers.

/// In units.
struct ScanlineLayout : TransportLayout {
  Rect body;
  int line = 16;  ///< from one line of text to the next
  Rect grid;
  Rect value, drift;  ///< the charts under it, pixel under pixel
  Rect finding;
  Rect column;  ///< of the numbers
  Rect overview;
  int choices = 0;  ///< the baseline of the row of choices
};
[[nodiscard]] ScanlineLayout layoutOfScanline(const Rect& body);
/// Grid and charts in an area; the other parts are empty.
[[nodiscard]] ScanlineLayout layoutOfScanlineFigure(const Rect& area);
/// The room of the scene's picture: as large as all pixels that the left half could have.
[[nodiscard]] Rect scanlinePicture(const Rect& body);

/// The state of the page besides the run itself.
struct ScanlineState {
  int step = 0;
  ScanMark kind = ScanMark::Row;  ///< the kind of step to jump to
  int bits = 24;
  double speed = 8;
  bool playing = false, asking = false;
  bool code = false;              ///< the book's lines are shown, in place of the edges and the span
  std::optional<int> guess = {};  ///< the cell of the last answer while `asking`
  Score score = {};
  bool operator==(const ScanlineState&) const = default;
};

/// The pixels that the grid shows.
struct GridWindow {
  int column = 0, row = 0;  ///< the first
  int columns = 0, rows = 0;
  int side = 0;  ///< of a pixel, in units
};
/// The pixels around the polygon, as large as they can be; around the pixel of the step if there are too
/// many.
[[nodiscard]] GridWindow gridWindow(const Rect& grid, const ScanlineRun& run, int step);

struct ScanlinePage {
  const ScanlineRun& run;
  const ScanlineState& view;
  const Finding& finding;
  std::string polygon;      ///< its name
  const IndexImage& image;  ///< of the scene
};
/// The grid and the charts alone, for another page.
void drawScanlineFigure(Pen& pen, const Rect& at, const ScanlineRun& run, int step);
void drawScanlinePage(Pen& pen, const ScanlineLayout& at, const ScanlinePage& page, const ControlList* list);

/// How many pixels of the picture are one of the overview, in each direction.
[[nodiscard]] int overviewScale(const Rect& overview, const IndexImage& image, int unit);
[[nodiscard]] Control scanKindsControl(const ScanlineRun& run, const ScanlineState& view);

/// Filling a polygon line by line, with the lines that a step has run and the values of their variables.
/// @see Foley & van Dam 2e §3.6, §16.2.4
[[nodiscard]] std::vector<CodeLine> scanlineCode(const ScanlineRun& run, int step);

}  // namespace xnewell
