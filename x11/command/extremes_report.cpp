#include "x11/command/extremes_report.h"

#include <iomanip>
#include <nlohmann/json.hpp>
#include <ostream>

#include "shading/extremes/finding.h"
#include "x11/drawing/wording.h"

namespace xnewell {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kWay = 32, kRange = 20, kFinding = 66;

Json jsonOf(const ExtremeStep& step) {
  return {{"refused", step.refused},
          {"samples", step.seen.samples},
          {"wrong_face", step.seen.wrong},
          {"missing_face", step.seen.missing},
          {"doubtful_face", step.seen.doubtful},
          {"behind", step.seen.behind},
          {"shades_off", step.shadesOff},
          {"changed", step.changed},
          {"merged_shades", step.merged},
          {"wrong", step.isWrong()},
          {"doubtful", step.isDoubtful()}};
}

}  // namespace

void printExtremes(const Extremes& extremes, std::ostream& out) {
  for (const std::string& said : {stoppedText(extremes), findingOf(extremes.setUp)})
    if (!said.empty()) out << said << '\n';
  out << std::left << std::setw(kWay) << "way" << std::setw(kRange) << "tried"
      << "what was found\n";
  for (const Extreme& way : extremes.ways) {
    std::vector<std::string> lines = broken(findingOf(way, extremes.setUp), kFinding);
    if (const ExtremeStep* const explained = firstToExplain(way, extremes.setUp))
      for (const std::string& line : broken(explained->why, kFinding)) lines.push_back("  " + line);
    const bool ofPowers = way.unit.starts_with('(');
    out << std::setw(kWay) << std::string{way.name} + (ofPowers ? " " + std::string{way.unit} : "")
        << std::setw(kRange) << shortly(way.steps.front().value) + " to " + shortly(way.steps.back().value);
    for (std::size_t k = 0; k < lines.size(); ++k)
      out << (k > 0 ? std::string(kWay + kRange, ' ') : "") << lines[k] << '\n';
  }
}

void printExtremesAsJson(const Options& options, const Extremes& extremes, std::ostream& out) {
  Json ways = Json::array();
  for (const Extreme& way : extremes.ways) {
    Json steps = Json::array();
    for (const ExtremeStep& step : way.steps) {
      steps.push_back({{"value", step.value}});
      steps.back().update(jsonOf(step));
      steps.back()["why"] = step.why;
    }
    ways.push_back({{"way", way.name},
                    {"unit", way.unit},
                    {"drives", way.drives},
                    {"finding", findingOf(way, extremes.setUp)},
                    {"steps", steps}});
  }
  const Json json{{"scene", options.scene},
                  {"stopped", extremes.isStopped()},
                  {"set_up", jsonOf(extremes.setUp)},
                  {"extremes", ways}};
  out << json.dump(2) << '\n';
}

}  // namespace xnewell
