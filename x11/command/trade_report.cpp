#include "x11/command/trade_report.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <ostream>

#include "x11/command/errors_json.h"
#include "x11/drawing/wording.h"
#include "x11/views/trade_table.h"

namespace xnewell {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kSentence = 100;

/// One word for why the rounds ended.
std::string_view wordOf(Ended ended) {
  constexpr std::array<std::string_view, 3> kWords{"sure", "out_of_time", "stopped"};
  return kWords[static_cast<int>(ended)];
}

std::string endingOf(const Timings& timings) {
  switch (timings.ended) {
    case Ended::Sure:
      return "until all intervals of 95 % were narrow";
    case Ended::OutOfTime:
      return "until the time was over";
    case Ended::Stopped:
      return "until it was stopped";
  }
  return "";
}

Json jsonOf(const Timing& time) {
  if (time.ms == 0) return nullptr;
  return {{"median", time.ms},
          {"ratio", time.ratio},
          {"interval", {time.interval.low, time.interval.high}},
          {"tie", time.tie}};
}

/// The errors. A combination off the front has only some of them.
Json errorsIn(const Measured& one) {
  if (one.here.color.count > 0) return errorsAsJson(one.here);
  return {{"samples", one.here.samples},
          {"wrong_faces", one.here.wrongFaces},
          {"intensity", {{"after_table", errorsAsJson(one.here)["intensity"]["after_table"]}}}};
}

Json jsonOf(const TradeCommands& commands, const Measured& one) {
  const StageTimes& t = one.cost.stages;
  const PictureSettings& s = one.configuration.settings;
  const ServerCost server = serverCostOf(s.width, s.height, one.cost.cells);
  return {
      {"name", one.configuration.name()},
      {"command", commands.of(one.configuration)},
      {"ms", jsonOf(one.cost.time)},
      {"ms_by_stage", {{"shade", t.shade}, {"transform", t.transform}, {"sort", t.sort}, {"fill", t.fill}}},
      {"bytes", one.cost.bytes},
      {"x_server", {{"cells", one.cost.cells}, {"requests", server.requests}, {"bytes", server.bytes}}},
      {"painted", one.cost.polygons},
      {"same_pixels", one.samePixels},
      {"rms_elsewhere", one.elsewhere},
      {"errors", errorsIn(one)}};
}

Json jsonOf(const Timings& timings) {
  return {{"rounds", timings.rounds}, {"twin", jsonOf(timings.twin)}, {"ended", wordOf(timings.ended)}};
}

}  // namespace

Json itemCostsAsJson(const std::vector<ItemCost>& items) {
  Json json = Json::object();
  for (const ItemCost& item : items) json[std::string{item.name}] = item.ms;
  return json;
}

std::string TradeCommands::of(const Configuration& configuration) const {
  PictureSettings settings = configuration.settings;
  const bool divided = std::ranges::any_of(configuration.changes, [](const Change& c) { return !c.setting; });
  if (!divided) settings.camera = camera;
  return setup.of(settings, configuration.divisions) + " --errors";
}

void printTrade(const TradeCommands& commands, const Trade& trade, std::ostream& out) {
  out << "Errors are those of the intensity, 0 to 1, against a reference without short cuts";
  if (trade.referenceDivisions > 0) out << ", with " << trade.referenceDivisions << " divisions";
  if (trade.referenceOff)
    out << " (" << fixed(trade.referenceOff->largestPixels, 3) << " pixels off the patches at most)";
  out << ".\n";
  out << "Faces are samples that show a wrong face. dE is CIEDE2000, its mean and its largest. "
         "MB is what the picture holds. X bytes are what a window's first picture sends to an 8-bit server "
         "without shared memory; they are computed.\n";
  if (trade.stopped) out << "The measuring was stopped. What was known is here.\n";
  if (trade.ofRows.rounds == 0)
    out << "Nothing was timed.\n";
  else
    out << "Times are medians of " << trade.ofRows.rounds << " rounds, in turn, " << endingOf(trade.ofRows)
        << ".\nThe set-up, timed twice under two names, is " << percentOf(trade.ofRows.twin.interval.low)
        << " to " << percentOf(trade.ofRows.twin.interval.high)
        << " of itself. = is a tie: chance alone may explain the difference, since\nthe interval of this "
           "time "
           "(95 %) meets that one.\n";
  out << '\n';
  printTradeHead(out, "one short cut");
  printTradeNumbers(out, "as it is", trade.asked);
  for (const TradeRow& row : trade.rows) {
    printTradeNumbers(out, row.measured.configuration.name(), row.measured);
    for (const std::string& line : broken(row.sentence, kSentence)) out << "    " << line << '\n';
    out << "    " << commands.of(row.measured.configuration) << '\n';
  }
  if (!trade.items.empty())
    out << "\nMilliseconds that are saved without one item that the picture requires:\n";
  for (const ItemCost& item : trade.items)
    out << "    " << item.name << ' ' << (item.ms > 0 ? msText(item.ms) : "too little to measure") << '\n';
  if (!trade.front.empty()) {
    out << '\n'
        << counted(static_cast<std::int64_t>(trade.combinations.size()), "combination")
        << ", chosen by their errors on " << trade.views
        << " views that are turned by one or two degrees. On the front:\n\n";
    printTradeHead(out, "combination");
    for (const int k : trade.front) {
      const Configuration& one = trade.combinations[k].configuration;
      printTradeNumbers(out, one.name(), trade.combinations[k]);
      out << "    " << commands.of(one) << '\n';
    }
  }
  if (!trade.notes.empty()) out << '\n';
  for (const std::string& note : trade.notes) out << note << '\n';
}

void printTradeAsJson(const std::string& scene, const TradeCommands& commands, const Trade& trade,
                      std::ostream& out) {
  Json rows = Json::array(), combinations = Json::array();
  for (const TradeRow& row : trade.rows) {
    rows.push_back({{"axis", trade.axes[row.axis].name()},
                    {"value", trade.axes[row.axis].text(row.value)},
                    {"sentence", row.sentence}});
    rows.back().update(jsonOf(commands, row.measured));
  }
  for (std::size_t k = 0; k < trade.combinations.size(); ++k) {
    const bool front = std::ranges::find(trade.front, static_cast<int>(k)) != trade.front.end();
    combinations.push_back({{"front", front}});
    combinations.back().update(jsonOf(commands, trade.combinations[k]));
  }
  Json reference{{"divisions", trade.referenceDivisions}};
  if (trade.referenceOff) reference["largest_pixels_off_patches"] = trade.referenceOff->largestPixels;
  const Json json{{"scene", scene},
                  {"reference", reference},
                  {"as_it_is", jsonOf(commands, trade.asked)},
                  {"timing_of_rows", jsonOf(trade.ofRows)},
                  {"rows", rows},
                  {"required_cost_ms", itemCostsAsJson(trade.items)},
                  {"other_views", trade.views},
                  {"timing_of_combinations", jsonOf(trade.ofCombinations)},
                  {"combinations", combinations},
                  {"notes", trade.notes},
                  {"stopped", trade.stopped}};
  out << json.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
}

}  // namespace xnewell
