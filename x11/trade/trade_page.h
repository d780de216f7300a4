#pragma once

#include <string>
#include <vector>

#include "shading/color/index_image.h"
#include "shading/trade/choice.h"
#include "x11/drawing/rect.h"
#include "x11/views/trade_chart.h"

namespace xnewell {

/// What does accuracy cost on this scene, and which is enough? At the left the chart, at the right what is
/// chosen, why, and the limit.

/// The places of the page's parts, in pixels.
struct TradeLayout {
  bool compact = false;
  Rect chart;                 ///< the area of the marks
  Rect column;                ///< everything at the right
  Rect well;                  ///< the frame of the picture
  Rect picture;               ///< of the chosen combination, as wide for its height as the measured one
  Rect limit, costs, errors;  ///< the rows of the controls
};
/// `body` is at least 768 x 428. `measured` has the size of the pictures that are measured.
[[nodiscard]] TradeLayout layoutOfTrade(const Rect& body, const Rect& measured);

/// The limit on its track: a share in [0, 1], logarithmic from 0.001 to 0.5.
[[nodiscard]] double shareOfLimit(double limit);
[[nodiscard]] double limitOfShare(double share);

/// The limit in digits: 0.030, 0.0015.
[[nodiscard]] std::string textOfLimit(double limit);

/// The sentences in lines of at most `most` characters. What does not fit whole into so many lines (`room`)
/// is left out.
[[nodiscard]] std::vector<std::string> wholeSentences(const std::vector<std::string>& sentences, int most,
                                                      int room);

/// All that the page shows.
struct TradePage {
  const Trade& trade;
  std::string doing;    ///< what is being measured; "" if all is done
  std::string failure;  ///< why there is no trade
  bool single = false;  ///< the combinations are single short cuts, because no others are known yet
  bool kept = false;    ///< the limit is kept in all views
  bool stale = false;   ///< the set-up is no longer the one that was measured
  TradeAxes axes;
  double limit = 0.03;
  int chosen = -1;                      ///< index into trade.combinations
  Chosen within;                        ///< what chooseWithin() says
  const IndexImage* picture = nullptr;  ///< of the chosen combination; null for none
  std::vector<Rect> places = {};        ///< the worst places in the picture, the worst first
  int place = 0;                        ///< the place whose numbers are shown
  char hovered = 0, dragged = 0;
  int option = -1;
};
/// The frames around the worst places of a combination, in pixels of the window, the worst first. `measured`
/// has the size of the pictures that are measured.
[[nodiscard]] std::vector<Rect> framesOfWorst(const TradeLayout& at, const Rect& measured,
                                              const Measured& one);
/// The frames of the options in a row of choices.
[[nodiscard]] std::vector<Rect> costOptions(const TradeLayout& at);
[[nodiscard]] std::vector<Rect> errorOptions(const TradeLayout& at);

/// Draws on a background of paper.
void drawTradePage(IndexImage& image, const TradeLayout& at, const TradePage& page, const CellPlan& plan);

}  // namespace xnewell
