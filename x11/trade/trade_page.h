#pragma once

#include <string>
#include <vector>

#include "shading/color/index_image.h"
#include "shading/trade/choice.h"
#include "x11/kit/control.h"
#include "x11/views/trade_chart.h"

namespace xnewell {

/// What does accuracy cost on this scene, and which is enough? At the left the chart, at the right what is
/// chosen, why, and the limit.

/// The places of the page's parts, in units.
struct TradeLayout {
  bool compact = false;
  Rect chart;     ///< the area of the marks
  Rect column;    ///< everything at the right
  Rect well;      ///< the frame of the picture
  Rect picture;   ///< of the chosen combination, as wide for its height as the measured one
  Rect controls;  ///< the rows of the controls
};
/// `body` is at least 768 x 428. `measured` has the size of the pictures that are measured.
[[nodiscard]] TradeLayout layoutOfTrade(const Rect& body, const Rect& measured);

/// The limits that the slider reaches.
inline constexpr TrackRange kLimits{
    .low = 0.001, .high = 0.5, .step = 1.0 / 40, .logarithmic = true, .decimals = 4};
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
  bool stale = false;   ///< the set-up is no longer the one that was measured
  TradeAxes axes;
  double limit = 0.03;
  int chosen = -1;                      ///< index into trade.combinations
  Chosen within;                        ///< what chooseWithin() says
  const IndexImage* picture = nullptr;  ///< of the chosen combination; null for none
  std::vector<Rect> places = {};        ///< the worst places in the picture, the worst first
  int place = 0;                        ///< the place whose numbers are shown
};
/// The frames around the worst places of a combination, in units, the worst first. `measured`
/// has the size of the pictures that are measured.
[[nodiscard]] std::vector<Rect> framesOfWorst(const TradeLayout& at, const Rect& measured,
                                              const Measured& one);
/// Draws on a background of paper.
void drawTradePage(Painter paint, const TradeLayout& at, const TradePage& page, const CellPlan& plan);

}  // namespace xnewell
