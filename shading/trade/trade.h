#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "shading/laboratory/errors.h"
#include "shading/picture/shared.h"
#include "shading/trade/configuration.h"
#include "shading/trade/timing.h"

namespace xnewell {

class Measure;

inline constexpr int kMostCombinations = 96;

/// Speed against accuracy: what each short cut saves on a scene, and what it costs in errors.
///
/// First each short cut alone takes its other values, about the set-up that the user asked for. Then the
/// useful values of several short cuts are combined; the single ones are among them. The front is the
/// combinations for which no other is cheaper and more accurate.
///
/// Beside them stands what the set-up cannot do without: what each item costs that the picture requires.
///
/// All errors are against one Reference, whose patches are divided finely. The combinations are chosen by
/// their errors on views that are turned by one or two degrees. What is told are their errors on the user's
/// own view, which had no part in the choice.

/// What one picture costs.
struct Cost {
  Timing time;                ///< its base is the set-up that was asked for
  StageTimes stages;          ///< medians
  std::int64_t bytes = 0;     ///< of memory that the picture holds; 0 if the system does not tell
  int cells = 0;              ///< of the colormap that get a colour for the picture or its window
  std::int64_t polygons = 0;  ///< painted: whole ones, and pieces of those that the depth sort cut
};

struct Measured {
  Configuration configuration;
  /// On the user's view. A combination off the front has only samples, wrongFaces, afterTable and worst.
  Errors here;
  double elsewhere = 0;  ///< the largest RMS error of the intensity after the table, on the other views
  Cost cost;
  bool samePixels = false;  ///< it shows exactly what the set-up that was asked for shows
};

/// What one item costs that a picture requires (required.h).
struct ItemCost {
  std::string_view name;
  /// Milliseconds of the processor: those of the step alone, or the median share of the picture's time that
  /// is saved without the item, times the picture's time; 0 if chance explains the difference.
  double ms = 0;
};

/// One short cut at one value, and everything else as the user asked.
struct TradeRow {
  int axis = 0;  ///< index into Trade::axes
  double value = 0;
  Measured measured;
  std::string sentence;
};

struct Trade {
  std::vector<Axis> axes;
  Measured asked;
  std::vector<TradeRow> rows;  ///< in the order of the axes
  /// What each item costs that the set-up requires, if no axes were named.
  std::vector<ItemCost> items;
  std::vector<Measured> combinations;
  std::vector<int> front;                     ///< indices into combinations, the cheapest first
  int referenceDivisions = 0;                 ///< of the reference's patches; 0 if there are none
  std::optional<PatchDistance> referenceOff;  ///< how far the reference's polygons are from the patches
  int views = 0;                              ///< other views that chose
  Timings ofRows, ofCombinations;
  std::vector<std::string> notes;  ///< what was left out, and why
  std::string neverTried;          ///< values that no combination had: "--order bsp; --divisions 64"
  bool stopped = false;            ///< the caller stopped it, and what is here is what was known
};

/// Is told what is being done, often, with what is known so far. Returns false to stop the trade; it then
/// returns what is known.
using TradeProgress = std::function<bool(const std::string& doing, const Trade& known)>;

/// `settings` are in the units of the scene. The pictures are painted without a server.
/// @throws ViewError if the set-up itself has no picture, nothing shows, or the scene has no extent
/// @throws std::invalid_argument if `request` names an axis that the scene does not have, or a value that the
/// axis does not have
[[nodiscard]] Trade tradeOf(const Shared<Scene>& scene, const PictureSettings& settings,
                            const TradeRequest& request, const TradeProgress& progress = {});

/// The same of what `measure` measures. It must not have been asked for anything yet.
[[nodiscard]] Trade tradeOf(Measure& measure, const TradeRequest& request,
                            const TradeProgress& progress = {});

/// "saves 23 % of the time", "takes 1.4 times as long", "takes as long".
[[nodiscard]] std::string savingOf(const Timing& time);

/// The front of a trade, and the choice on it.

/// Errors are equal if the larger is at most so many times the smaller.
inline constexpr double kErrorTie = 1.05;

/// The indices of those for which no other is cheaper and more accurate (by Measured::elsewhere), the
/// cheapest first. Of two that are equally fast, as far as their times tell, the more accurate counts; of two
/// that are equally accurate (kErrorTie), the faster.
[[nodiscard]] std::vector<int> frontOf(const std::vector<Measured>& measured);

/// True if any of them has a time.
[[nodiscard]] bool areTimed(const std::vector<Measured>& some);

/// A trade that is not far enough for combinations, with the single short cuts in their place; without any
/// if these have no times either.
[[nodiscard]] Trade withSingles(Trade trade);

/// The cheapest configuration that is accurate enough, and why it is this one.
struct Chosen {
  int combination = -1;   ///< index into Trade::combinations; -1 if there are none
  bool accurate = false;  ///< its error stays within the limit; otherwise it is the most accurate of all
  std::vector<std::string> why = {};  ///< sentences, with numbers
};

/// The largest RMS error of the intensity that a combination has on any view, the user's own included.
[[nodiscard]] double errorOnAllViews(const Measured& one);

/// What is chosen stays below the limit by this share, because other samples of the same view have a slightly
/// different error.
inline constexpr double kSpare = 0.03;

/// The cheapest point of the front of those combinations that keep the limit: on all views with kSpare for
/// the RMS error, on the user's own view for wrong faces. If none does, the most accurate of all.
[[nodiscard]] Chosen chooseWithin(const Trade& trade, const AccuracyLimit& limit);

/// Two numbers in two digits, or in as many as it takes to tell them apart: {"0.012", "0.01"}.
[[nodiscard]] std::pair<std::string, std::string> toldApart(double a, double b);

}  // namespace xnewell
