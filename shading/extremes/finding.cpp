#include "shading/extremes/finding.h"

#include <algorithm>
#include <array>
#include <functional>
#include <vector>

namespace xnewell {

namespace {

constexpr std::string_view kWrong = "wrong", kDoubtful = "doubtful";

/// A kind of fault.
struct FaultRow {
  std::string_view verdict;           ///< what it makes of a picture
  int (*amount)(const ExtremeStep&);  ///< 0 if a step is free of it
  std::string (*words)(const ExtremeStep&);
};

std::string ofSamples(int count, const ExtremeStep& step) {
  return std::to_string(count) + " of " + std::to_string(step.seen.samples) + " samples";
}

const std::array kFaults{
    FaultRow{kWrong, [](const ExtremeStep& s) { return static_cast<int>(!s.refused.empty()); },
             [](const ExtremeStep& s) { return s.refused; }},
    FaultRow{kWrong, [](const ExtremeStep& s) { return s.seen.wrong - s.seen.missing; },
             [](const ExtremeStep& s) {
               return "a face that is not the nearest at " + ofSamples(s.seen.wrong - s.seen.missing, s);
             }},
    FaultRow{kWrong, [](const ExtremeStep& s) { return s.seen.missing; },
             [](const ExtremeStep& s) {
               return "no face at " + ofSamples(s.seen.missing, s) + " that should show one";
             }},
    FaultRow{kWrong, [](const ExtremeStep& s) { return s.shadesOff > 1 ? s.shadesOff : 0; },
             [](const ExtremeStep& s) {
               return "cells that are off by up to " + std::to_string(s.shadesOff) + " shades";
             }},
    FaultRow{kWrong, [](const ExtremeStep& s) { return s.changed; },
             [](const ExtremeStep& s) {
               return "another face or shade than at first at " + std::to_string(s.changed) +
                      (s.changed == 1 ? " sample" : " samples");
             }},
    FaultRow{kWrong, [](const ExtremeStep& s) { return s.merged; },
             [](const ExtremeStep& s) {
               return std::to_string(s.merged) + " shades that look like the next one";
             }},
    FaultRow{kDoubtful, [](const ExtremeStep& s) { return s.seen.doubtful; },
             [](const ExtremeStep& s) {
               return "a face as near as the nearest, to a step of the grid, at " +
                      ofSamples(s.seen.doubtful, s);
             }},
};

/// Steps one after the other, from `first` to `last`, that have something in common.
struct Run {
  int first, last;
};

template <typename Has>
std::vector<Run> runsOf(const std::vector<ExtremeStep>& steps, Has has) {
  std::vector<Run> runs;
  for (int k = 0; k < std::ssize(steps); ++k) {
    if (!std::invoke(has, steps[k])) continue;
    if (!runs.empty() && runs.back().last == k - 1)
      runs.back().last = k;
    else
      runs.push_back({k, k});
  }
  return runs;
}

std::string valueOf(const Extreme& way, int step) {
  const bool said = way.unit.empty() || way.unit.starts_with('(');
  return shortly(way.steps[step].value) + (said ? "" : " " + std::string{way.unit});
}

/// Where a run is: "from 1e+09 on", "at 10 degrees", "from 10 to 3 degrees".
std::string placeOf(const Extreme& way, Run run) {
  if (run.first == run.last) return "at " + valueOf(way, run.first);
  if (run.last + 1 == std::ssize(way.steps)) return "from " + valueOf(way, run.first) + " on";
  return "from " + shortly(way.steps[run.first].value) + " to " + valueOf(way, run.last);
}

/// What was found in a run: the fault where it begins, and where there is most of it.
std::string foundIn(const Extreme& way, Run run, const FaultRow& fault) {
  const auto begin = way.steps.begin() + run.first, end = way.steps.begin() + run.last + 1;
  const auto most = std::ranges::max_element(begin, end, {}, fault.amount);
  std::string text = placeOf(way, run) + ": " + fault.words(*begin);
  if (fault.amount(*most) > fault.amount(*begin))
    text += " (" + std::to_string(fault.amount(*most)) + " at " + shortly(most->value) + ")";
  return text;
}

bool isInherited(Run run, const FaultRow& fault, const ExtremeStep& setUp) {
  return run.first == 0 && fault.amount(setUp) > 0;
}

std::string joined(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : "; ") + part;
  return text;
}

/// The first step with a fault of this verdict that the set-up does not have.
const ExtremeStep* firstOf(std::string_view verdict, const Extreme& way, const ExtremeStep& setUp) {
  int first = static_cast<int>(std::ssize(way.steps));
  for (const FaultRow& fault : kFaults)
    if (fault.verdict == verdict)
      for (const Run& run : runsOf(way.steps, [&](const ExtremeStep& s) { return fault.amount(s) > 0; }))
        if (!isInherited(run, fault, setUp)) first = std::min(first, run.first);
  return first < std::ssize(way.steps) ? &way.steps[first] : nullptr;
}

/// That a way without a fault is right, and where it shows no face.
std::string rightness(const Extreme& way) {
  const int last = static_cast<int>(std::ssize(way.steps)) - 1;
  const std::vector<Run> empty = runsOf(way.steps, &ExtremeStep::isEmpty);
  if (empty.empty()) return "right up to " + valueOf(way, last);
  std::vector<std::string> parts;
  const int first = empty.front().first;
  if (first > 0) parts.push_back("right up to " + valueOf(way, first - 1));
  for (const Run& run : empty) parts.push_back("shows no face " + placeOf(way, run));
  if (first > 0 && empty.back().last < last) parts.emplace_back("elsewhere right");
  return joined(parts);
}

}  // namespace

bool ExtremeStep::isWrong() const {
  return std::ranges::any_of(
      kFaults, [&](const FaultRow& fault) { return fault.verdict == kWrong && fault.amount(*this) > 0; });
}

std::string stoppedText(const Extremes& extremes) {
  if (!extremes.isStopped()) return "";
  return "Stopped: " + std::to_string(extremes.ways.size()) + " of " + std::to_string(extremes.allWays) +
         " ways were finished.";
}

std::string findingOf(const ExtremeStep& setUp) {
  if (setUp.isEmpty()) return "The set-up itself shows no face.";
  const std::string_view verdict = setUp.isWrong() ? kWrong : kDoubtful;
  std::vector<std::string> parts;
  for (const FaultRow& fault : kFaults)
    if (fault.verdict == verdict && fault.amount(setUp) > 0) parts.push_back(fault.words(setUp));
  return parts.empty() ? "" : "The set-up itself is " + std::string{verdict} + ": " + joined(parts) + ".";
}

std::string findingOf(const Extreme& way, const ExtremeStep& setUp) {
  if (std::ranges::none_of(way.steps, [](const ExtremeStep& s) { return s.isWrong() || s.isDoubtful(); }))
    return rightness(way);
  struct Part {
    int first;
    std::string_view verdict;
    std::string text;
  };
  std::vector<Part> parts;
  for (const FaultRow& fault : kFaults)
    for (const Run& run : runsOf(way.steps, [&](const ExtremeStep& s) { return fault.amount(s) > 0; })) {
      if (!isInherited(run, fault, setUp))
        parts.push_back({run.first, fault.verdict, foundIn(way, run, fault)});
      else if (run.last + 1 == std::ssize(way.steps))
        parts.push_back({-1, fault.verdict, "as the set-up itself, at all values"});
      else
        parts.push_back({-1, fault.verdict, "as the set-up itself, up to " + valueOf(way, run.last)});
    }
  std::ranges::stable_sort(parts, {}, &Part::first);
  const auto same = [](const Part& a, const Part& b) { return a.verdict == b.verdict && a.text == b.text; };
  parts.erase(std::ranges::unique(parts, same).begin(), parts.end());
  std::vector<std::string> texts;
  std::string_view said;
  for (const Part& part : parts) {
    texts.push_back((part.verdict == said ? "" : std::string{part.verdict} + " ") + part.text);
    said = part.verdict;
  }
  for (const Run& run : runsOf(way.steps, &ExtremeStep::isEmpty))
    texts.push_back("no face shows " + placeOf(way, run));
  return joined(texts);
}

const ExtremeStep* firstWrong(const Extreme& way, const ExtremeStep& setUp) {
  return firstOf(kWrong, way, setUp);
}

const ExtremeStep* firstToExplain(const Extreme& way, const ExtremeStep& setUp) {
  if (const ExtremeStep* const wrong = firstWrong(way, setUp)) return wrong;
  if (const ExtremeStep* const doubtful = firstOf(kDoubtful, way, setUp)) return doubtful;
  const auto empty = std::ranges::find_if(way.steps, &ExtremeStep::isEmpty);
  return empty == way.steps.end() || setUp.isEmpty() ? nullptr : &*empty;
}

}  // namespace xnewell
