#include <algorithm>
#include <array>
#include <iostream>
#include <optional>

#include "geometry/files/output_file.h"
#include "shading/color/png.h"
#include "shading/picture/picture_cache.h"
#include "shading/picture/shared.h"
#include "shading/trade/measure.h"
#include "shading/trade/trade.h"
#include "x11/command/commands.h"
#include "x11/command/report.h"
#include "x11/drawing/wording.h"
#include "x11/options/exit_status.h"
#include "x11/options/options.h"
#include "x11/options/setup_command.h"
#include "x11/terminal/terminal.h"
#include "x11/views/trade_chart.h"

namespace xnewell {

namespace {

/// ---- The report: each short cut by itself with a sentence and the command that repeats it, then the front

using page::Data;
using page::List;
using page::Object;

/// The commands that draw the configurations of a trade and tell their errors.
struct TradeCommands {
  SetupCommand setup;
  CameraSettings camera;  ///< as the user said it

  /// With other divisions it says where the camera is, which otherwise depends on the polygons.
  [[nodiscard]] std::string of(const Configuration& one) const {
    PictureSettings settings = one.settings;
    if (std::ranges::all_of(one.changes, [](const Change& c) { return c.setting != nullptr; }))
      settings.camera = camera;
    return setup.of(settings, one.divisions) + " --errors";
  }
};

constexpr std::array<std::array<std::string_view, 2>, 3> kEndings{
    {{"sure", "until all intervals of 95 % were narrow"},
     {"out_of_time", "until the time was over"},
     {"stopped", "until it was stopped"}}};

Data dataOf(const Interval& interval) { return List{interval.low, interval.high}; }
Data dataOf(const Timing& time) {
  if (time.ms == 0) return nullptr;
  return Object{
      {"median", time.ms}, {"ratio", time.ratio}, {"interval", dataOf(time.interval)}, {"tie", time.tie}};
}
Data dataOf(const Timings& timings) {
  return Object{{"rounds", timings.rounds},
                {"twin", dataOf(timings.twin)},
                {"ended", kEndings[static_cast<std::size_t>(timings.ended)][0]}};
}
Data dataOf(const AccuracyLimit& limit) { return Object{{"rms", limit.rms}, {"wrong_faces", limit.wrong}}; }

/// All that is known of a configuration, after `first`. A combination off the front has only some errors.
Data dataOf(const TradeCommands& commands, const Measured& one, Object first = {}) {
  const StageTimes& t = one.cost.stages;
  const ServerCost server = serverCostOf(one);
  const Errors& e = one.here;
  Object all = std::move(first);
  for (auto& fact :
       Object{{"name", one.configuration.name()},
              {"command", commands.of(one.configuration)},
              {"ms", dataOf(one.cost.time)},
              {"ms_by_stage",
               Object{{"shade", t.shade}, {"transform", t.transform}, {"sort", t.sort}, {"fill", t.fill}}},
              {"bytes", one.cost.bytes},
              {"x_server",
               Object{{"cells", one.cost.cells}, {"requests", server.requests}, {"bytes", server.bytes}}},
              {"painted", one.cost.polygons},
              {"same_pixels", one.samePixels},
              {"rms_elsewhere", one.elsewhere},
              {"errors", e.color.count > 0
                             ? Data{errorsAsData(e)}
                             : Object{{"samples", e.samples},
                                      {"wrong_faces", e.wrongFaces},
                                      {"intensity", Object{{"after_table", spreadAsData(e.afterTable)}}}}}})
    all.push_back(std::move(fact));
  return all;
}

page::Page pageOf(const std::string& scene, const TradeCommands& commands, const Trade& trade) {
  constexpr int kSentence = 100;
  page::Page page{.sections = {{}}, .indent = 2};
  page::Section& s = page.sections.front();
  const auto say = [&](const std::string& words, std::string_view end = "") {
    std::vector<std::string> lines = broken(words, kSentence);
    lines.back() += end;
    for (std::string& line : lines) s.say(std::move(line));
  };
  s.fact("scene", scene);
  Object reference{{"divisions", trade.referenceDivisions}};
  std::string against = "Errors are those of the intensity, 0 to 1, against a reference without short cuts";
  if (trade.referenceDivisions > 0)
    against += ", with " + std::to_string(trade.referenceDivisions) + " divisions";
  if (trade.referenceOff) {
    reference.emplace_back("largest_pixels_off_patches", trade.referenceOff->largestPixels);
    against += " (" + fixed(trade.referenceOff->largestPixels, 3) + " pixels off the patches at most)";
  }
  say(against +
      ". Faces are samples that show a wrong face. dE is CIEDE2000, its mean and its largest. MB is what the "
      "picture holds. X bytes are what a window's first picture sends to an 8-bit server without shared "
      "memory; they are computed.");
  if (trade.stopped) s.say("The measuring was stopped. What was known is here.");
  const Timings& times = trade.ofRows;
  say(times.rounds == 0
          ? "Nothing was timed."
          : "Times are medians of " + std::to_string(times.rounds) + " rounds, in turn, " +
                std::string{kEndings[static_cast<std::size_t>(times.ended)][1]} +
                ". The set-up, timed twice under two names, is " + percentOf(times.twin.interval.low) +
                " to " + percentOf(times.twin.interval.high) +
                " of itself. = is a tie: chance alone may explain the difference, since the interval of "
                "this time (95 %) meets that one.",
      "\n");
  s.fact("reference", std::move(reference));
  s.fact("as_it_is", dataOf(commands, trade.asked));
  s.fact("timing_of_rows", dataOf(times));

  List rows, combinations;
  page::Table cuts = tradeTable("one short cut");
  addNumbers(cuts, "as it is", trade.asked);
  for (const TradeRow& row : trade.rows) {
    const Axis& axis = trade.axes[row.axis];
    rows.push_back(
        dataOf(commands, row.measured,
               {{"axis", axis.name()}, {"value", axis.text(row.value)}, {"sentence", row.sentence}}));
    std::vector<std::string> below = broken(row.sentence, kSentence);
    below.push_back(commands.of(row.measured.configuration));
    addNumbers(cuts, row.measured.configuration.name(), row.measured, below);
  }
  s.add(std::move(cuts));
  s.fact("rows", std::move(rows));

  Object items;
  if (!trade.items.empty())
    s.say("\nMilliseconds that are saved without one item that the picture requires:");
  for (const ItemCost& item : trade.items) {
    items.emplace_back(item.name, item.ms);
    s.say("    " + std::string{item.name} + ' ' + (item.ms > 0 ? msText(item.ms) : "too little to measure"));
  }
  s.fact("required_cost_ms", std::move(items));
  s.fact("other_views", trade.views);
  s.fact("timing_of_combinations", dataOf(trade.ofCombinations));

  page::Table front = tradeTable("combination");
  for (const int k : trade.front)
    addNumbers(front, trade.combinations[k].configuration.name(), trade.combinations[k],
               {commands.of(trade.combinations[k].configuration)});
  for (int k = 0; k < std::ssize(trade.combinations); ++k)
    combinations.push_back(dataOf(commands, trade.combinations[k],
                                  {{"front", std::ranges::find(trade.front, k) != trade.front.end()}}));
  if (!trade.front.empty()) {
    s.say('\n' + counted(combinations.size(), "combination") + ", chosen by their errors on " +
          std::to_string(trade.views) + " views that are turned by one or two degrees. On the front:\n");
    s.add(std::move(front));
  }
  s.fact("combinations", std::move(combinations));
  for (const std::string& note : trade.notes) s.say((&note == trade.notes.data() ? "\n" : "") + note);
  s.fact("notes", trade.notes);
  s.fact("stopped", trade.stopped);
  return page;
}

/// The trade, with its progress on the terminal.
Trade tradeWithProgress(const Options& options, const TradeRequest& request, const Shared<Scene>& scene) {
  std::optional<Doing> measuring;
  const Stopwatch watch;
  double shown = -100;
  return tradeOf(scene, settingsOf(options), request, [&](const std::string& doing, const Trade&) {
    if (watch.ms() > shown + 100) shown = watch.ms(), measuring.emplace(doing);
    return !wasInterrupted();
  });
}

/// ---- --accuracy

/// Says how far off the picture is when no short cut is left to choose.
Data errorAsItIs(const AccuracyLimit& limit, const Options& options, const Scene& scene) {
  const PictureSettings settings = settingsOf(options);
  const CellPlan plan{settings.table.kind};
  const Picture picture = makePicture(scene, settings, plan[Cell::Well]);
  const Errors errors = errorsOf(picture, picture.palette(plan));
  const double off = errors.afterTable.rootMeanSquare;
  const bool within = off <= limit.rms && (!limit.wrong || errors.wrongFaces <= *limit.wrong);
  const auto [found, allowed] = toldApart(off, limit.rms);
  std::string why = "nothing is left to choose. The RMS error is " + found + " in this view, " +
                    (off <= limit.rms ? "and " : "but ") + allowed + " is allowed.";
  if (limit.wrong)
    why += " Samples that show a wrong face: " + std::to_string(errors.wrongFaces) + " of " +
           std::to_string(*limit.wrong) + " allowed.";
  if (errors.samples > 0) std::cerr << "xnewell: " << why << '\n';
  return Object{{"limit", dataOf(limit)},           {"within", within}, {"chosen", nullptr}, {"rms", off},
                {"wrong_faces", errors.wrongFaces}, {"why", List{why}}};
}

/// A point of the measured front.
Data pointAsData(const Measured& one) {
  return Object{{"name", one.configuration.name()},
                {"options", one.configuration.options()},
                {"rms", errorOnAllViews(one)},
                {"wrong_faces", one.here.wrongFaces},
                {"ms", one.cost.time.ms},
                {"ratio", one.cost.time.ratio},
                {"interval", dataOf(one.cost.time.interval)}};
}

}  // namespace

int tellTrade(const Options& options, Scene scene) {
  awaitInterrupt();
  const Shared<Scene> shared{std::move(scene)};
  const Trade trade = tradeWithProgress(options, options.trade, shared);
  print(options, pageOf(options.scene, {SetupCommand{*shared}, options.picture.camera}, trade));
  if (!options.output.empty()) {
    const Trade shown = areTimed(trade.combinations) ? trade : withSingles(trade);
    if (shown.combinations.empty()) {
      std::cerr << "xnewell: no chart was written: nothing was timed\n";
    } else {
      const ColoredImage chart = drawTrade(shown, "Cost against error: " + titleOf(*shared));
      writeFile(options.output, encodePng(chart.image, chart.palette));
    }
  }
  return trade.stopped ? kInterrupted : kDone;
}

page::Data keepWithin(const AccuracyLimit& limit, Options& options, Scene& scene) {
  TradeRequest request = options.trade;
  if (!options.gave("--budget")) request.seconds = kAccuracySeconds;
  request.brief = true;
  const Picture asItIs = makePicture(scene, settingsOf(options));
  request.axes = choosableAxes(asItIs);
  std::erase_if(request.axes, [&](const std::string& axis) { return options.gave("--" + axis); });
  // Others have an effect only beside these.
  if (std::ranges::none_of(axesOf(asItIs), [&](const Axis& axis) {
        return std::ranges::find(request.axes, axis.name()) != request.axes.end();
      }))
    return errorAsItIs(limit, options, scene);
  Trade trade = tradeWithProgress(options, request, scene);
  if (!areTimed(trade.combinations)) trade = withSingles(std::move(trade));
  for (const std::string& note : trade.notes) std::cerr << "xnewell: " << note << '\n';
  const Chosen choice = chooseWithin(trade, limit);
  if (choice.combination < 0) {
    const std::string why = "nothing was chosen: the time did not suffice (--budget)";
    std::cerr << "xnewell: " << why << '\n';
    return Object{{"limit", dataOf(limit)}, {"within", nullptr}, {"chosen", nullptr}, {"why", List{why}}};
  }
  const Configuration& chosen = trade.combinations[choice.combination].configuration;
  const std::string line = chosen.name() + (chosen.changes.empty() ? "" : " (" + chosen.options() + ")");
  std::cerr << "xnewell: chosen: " << line << '\n';
  for (const std::string& why : choice.why) std::cerr << "xnewell: " << why << '\n';
  options.picture = chosen.settings;
  scene = dividedAnew(scene, chosen.divisions);
  List front;
  for (const int k : trade.front) front.push_back(pointAsData(trade.combinations[k]));
  return Object{{"limit", dataOf(limit)},
                {"within", choice.accurate},
                {"chosen", pointAsData(trade.combinations[choice.combination])},
                {"why", choice.why},
                {"timed", trade.combinations.size()},
                {"front", front},
                {"rounds", trade.ofCombinations.rounds},
                {"other_views", trade.views},
                {"never_tried", trade.neverTried},
                {"notes", trade.notes}};
}

}  // namespace xnewell
