#include "x11/command/tell_trade.h"

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>

#include "geometry/files/output_file.h"
#include "shading/color/png.h"
#include "shading/extremes/extremes.h"
#include "shading/picture/picture_cache.h"
#include "shading/picture/stopwatch.h"
#include "shading/trade/choice.h"
#include "shading/trade/measure.h"
#include "x11/command/trade_report.h"
#include "x11/options/exit_status.h"
#include "x11/terminal/doing.h"
#include "x11/terminal/interrupt.h"
#include "x11/views/trade_chart.h"

namespace xnewell {

namespace {

/// The trade, with its progress on the terminal.
Trade measured(const Options& options, const TradeRequest& request, const Shared<Scene>& scene) {
  std::optional<Doing> measuring;
  const Stopwatch watch;
  double shown = 0;
  return tradeOf(scene, settingsOf(options), request, [&](const std::string& doing, const Trade&) {
    if (!measuring || watch.ms() > shown + 100) {
      shown = watch.ms();
      measuring.reset();  // each message replaces the one before
      measuring.emplace(doing);
    }
    return !wasInterrupted();
  });
}

nlohmann::ordered_json limitAsJson(const AccuracyLimit& limit) {
  nlohmann::ordered_json json{{"rms", limit.rms}, {"wrong_faces", nullptr}};
  if (limit.wrong) json["wrong_faces"] = *limit.wrong;
  return json;
}

/// Says how far off the picture is when no short cut is left to choose.
nlohmann::ordered_json tellError(const AccuracyLimit& limit, const Options& options, const Scene& scene) {
  const PictureSettings settings = settingsOf(options);
  const CellPlan plan{settings.table.kind};
  const Picture picture = makePicture(scene, settings, plan[Cell::Well]);
  const Errors errors = errorsOf(picture, picture.palette(plan));
  const double off = errors.afterTable.rootMeanSquare;
  const bool within = off <= limit.rms && (!limit.wrong || errors.wrongFaces <= *limit.wrong);
  const auto [told, allowed] = toldApart(off, limit.rms);
  std::string why = "nothing is left to choose. The RMS error is " + told + " in this view, " +
                    (off <= limit.rms ? "and " : "but ") + allowed + " is allowed.";
  if (limit.wrong)
    why += " Samples that show a wrong face: " + std::to_string(errors.wrongFaces) + " of " +
           std::to_string(*limit.wrong) + " allowed.";
  if (errors.samples > 0) std::cerr << "xnewell: " << why << '\n';
  return {{"limit", limitAsJson(limit)},      {"within", within}, {"chosen", nullptr}, {"rms", off},
          {"wrong_faces", errors.wrongFaces}, {"why", {why}}};
}

/// A point of the measured front.
nlohmann::ordered_json pointAsJson(const Measured& one) {
  return {{"name", one.configuration.name()},
          {"options", one.configuration.options()},
          {"rms", errorOnAllViews(one)},
          {"wrong_faces", one.here.wrongFaces},
          {"ms", one.cost.time.ms},
          {"ratio", one.cost.time.ratio},
          {"interval", {one.cost.time.interval.low, one.cost.time.interval.high}}};
}

/// The axes that --accuracy may choose on, but for those that the user gave.
std::vector<std::string> freeAxes(const Options& options, const Scene& scene) {
  const Picture picture = makePicture(scene, settingsOf(options));
  std::vector<std::string> given;
  for (const Axis& axis : axesInReach(picture))
    if (options.gave("--" + std::string{axis.name()})) given.emplace_back(axis.name());
  std::vector<std::string> axes = choosableAxes(picture, given);
  std::erase_if(axes, [&](const std::string& axis) { return options.gave("--" + axis); });
  return axes;
}

}  // namespace

PictureSettings settingsOf(const Options& options) {
  PictureSettings settings = options.picture;
  const glm::ivec2 size = options.size.value_or(kPictureSize);
  settings.width = size.x;
  settings.height = size.y;
  return settings;
}

int tellTrade(const Options& options, Scene scene) {
  awaitInterrupt();
  const Shared<Scene> shared{std::move(scene)};
  const Trade trade = measured(options, options.trade, shared);
  const TradeCommands commands{SetupCommand{*shared}, options.picture.camera};
  if (options.json)
    printTradeAsJson(options.scene, commands, trade, std::cout);
  else
    printTrade(commands, trade, std::cout);
  std::cout.flush();  // a chart that cannot be written must not cost the table
  if (!options.output.empty()) {
    const Trade told = areTimed(trade.combinations) ? trade : withSingles(trade);
    if (told.combinations.empty()) {
      std::cerr << "xnewell: no chart was written: nothing was timed\n";
    } else {
      const ColoredImage chart = drawTrade(told, "Cost against error: " + titleOf(*shared));
      writeFile(options.output, encodePng(chart.image, chart.palette));
    }
  }
  return trade.stopped ? kInterrupted : kDone;
}

nlohmann::ordered_json keepWithin(const AccuracyLimit& limit, Options& options, Scene& scene) {
  TradeRequest request = options.trade;
  if (!options.gave("--budget")) request.seconds = kAccuracySeconds;
  request.brief = true;
  request.axes = freeAxes(options, scene);
  if (request.axes.empty()) return tellError(limit, options, scene);
  Trade trade = measured(options, request, scene);
  if (!areTimed(trade.combinations)) trade = withSingles(std::move(trade));
  for (const std::string& note : trade.notes) std::cerr << "xnewell: " << note << '\n';
  const Chosen choice = chooseWithin(trade, limit);
  if (choice.combination < 0) {
    const std::string why = "nothing was chosen: the time did not suffice (--budget)";
    std::cerr << "xnewell: " << why << '\n';
    return {{"limit", limitAsJson(limit)}, {"within", nullptr}, {"chosen", nullptr}, {"why", {why}}};
  }
  const Configuration& chosen = trade.combinations[choice.combination].configuration;
  const std::string line = chosen.name() + (chosen.changes.empty() ? "" : " (" + chosen.options() + ")");
  std::cerr << "xnewell: chosen: " << line << '\n';
  for (const std::string& why : choice.why) std::cerr << "xnewell: " << why << '\n';
  options.picture = chosen.settings;
  scene = dividedAnew(scene, chosen.divisions);
  nlohmann::ordered_json front = nlohmann::ordered_json::array();
  for (const int k : trade.front) front.push_back(pointAsJson(trade.combinations[k]));
  return {{"limit", limitAsJson(limit)},
          {"within", choice.accurate},
          {"chosen", pointAsJson(trade.combinations[choice.combination])},
          {"why", choice.why},
          {"timed", trade.combinations.size()},
          {"front", front},
          {"rounds", trade.ofCombinations.rounds},
          {"other_views", trade.views},
          {"never_tried", trade.neverTried},
          {"notes", trade.notes}};
}

}  // namespace xnewell
