#include "x11/command/extremes_report.h"

#include <algorithm>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <ostream>

#include "x11/drawing/wording.h"

namespace xnewell {

namespace {

constexpr int kWay = 32, kRange = 20, kFinding = 66;

}  // namespace

void printExtremes(const std::vector<Extreme>& extremes, std::ostream& out) {
  out << std::left << std::setw(kWay) << "way" << std::setw(kRange) << "tried"
      << "what was found\n";
  for (const Extreme& extreme : extremes) {
    const auto wrong = std::ranges::find_if(extreme.steps, &ExtremeStep::isWrong);
    std::vector<std::string> lines = broken(findingOf(extreme), kFinding);
    if (wrong != extreme.steps.end())
      for (const std::string& line : broken(wrong->why, kFinding)) lines.push_back("  " + line);
    const bool ofPowers = extreme.unit.starts_with('(');
    out << std::setw(kWay) << std::string{extreme.name} + (ofPowers ? " " + std::string{extreme.unit} : "")
        << std::setw(kRange)
        << shortly(extreme.steps.front().value) + " to " + shortly(extreme.steps.back().value);
    for (std::size_t k = 0; k < lines.size(); ++k)
      out << (k > 0 ? std::string(kWay + kRange, ' ') : "") << lines[k] << '\n';
  }
}

void printExtremesAsJson(const Options& options, const std::vector<Extreme>& extremes, std::ostream& out) {
  nlohmann::ordered_json ways = nlohmann::ordered_json::array();
  for (const Extreme& extreme : extremes) {
    nlohmann::ordered_json steps = nlohmann::ordered_json::array();
    for (const ExtremeStep& step : extreme.steps)
      steps.push_back({{"value", step.value},
                       {"refused", step.refused},
                       {"samples", step.seen.samples},
                       {"wrong_face", step.seen.wrong},
                       {"behind", step.seen.behind},
                       {"shades_off", step.shadesOff},
                       {"changed", step.changed},
                       {"merged_shades", step.merged},
                       {"wrong", step.isWrong()},
                       {"why", step.why}});
    ways.push_back({{"way", extreme.name},
                    {"unit", extreme.unit},
                    {"drives", extreme.drives},
                    {"finding", findingOf(extreme)},
                    {"steps", steps}});
  }
  out << nlohmann::ordered_json{{"scene", options.scene}, {"extremes", ways}}.dump(2) << '\n';
}

}  // namespace xnewell
