#include "shading/extremes/extremes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <future>
#include <glm/geometric.hpp>
#include <mutex>
#include <optional>
#include <span>
#include <thread>
#include <vector>

#include "depthsort/oracle.h"
#include "geometry/exact/box.h"
#include "geometry/exact/plane.h"
#include "geometry/exact/scale.h"
#include "shading/extremes/extreme_ways.h"
#include "shading/picture/picture_cache.h"

namespace xnewell {

namespace {

PictureSettings inOneHue(PictureSettings settings) {
  settings.colors = ColorPlan::OneHue;
  settings.inPixels = false;
  return settings;
}

Start startOf(const Picture& picture) {
  const Scene& scene = picture.scene();
  const PictureSettings& settings = picture.settings();
  Start start{.scene = scene,
              .settings = settings,
              .camera = picture.camera(),
              .size = boxOf(scene.mesh.points).side(),
              .pixel = 0,
              .target = picture.camera().lookAt,
              .facing = unit(picture.camera().eye - picture.camera().lookAt)};
  const ViewSpec& view = start.camera.view;
  const double away = glm::dot(start.facing, start.camera.eye - start.camera.lookAt);
  start.pixel = (view.windowMax.y - view.windowMin.y) / settings.height *
                (view.projection == Projection::Perspective ? away / view.prp.z : 1.0);
  const Rays rays{scene, start.camera, settings};
  double nearest = 1e300;
  for (int j = 0; j < settings.height; ++j)
    for (int i = 0; i < settings.width; ++i) {
      const double x = i + 0.5 - settings.width / 2.0, y = j + 0.5 - settings.height / 2.0;
      if (x * x + y * y >= nearest) continue;
      const std::optional<Rays::Hit> hit = rays.nearest(i + 0.5, j + 0.5);
      if (!hit) continue;
      nearest = x * x + y * y;
      start.target = rays.point(i + 0.5, j + 0.5, hit->t);
      const glm::dvec3 N = newellPlane(scene.mesh.points, scene.mesh.face(hit->face)).N;
      start.facing = glm::dot(N, start.camera.eye - start.target) < 0 ? -N : N;
    }
  return start;
}

/// The most by which a painted cell differs from the cell of the intensity in double precision.
int shadesOff(const Picture& picture) {
  const SeenRows rows = picture.seen(0, picture.settings().height);
  const std::vector<double> I = picture.intensities(rows);
  int most = 0;
  for (std::size_t k = 0; k < I.size(); ++k)
    if (rows.faces[k] != kNothing)
      most = std::max(most, std::abs(picture.image().pixels[k] - picture.table().cell(I[k])));
  return most;
}

int changedFrom(const Picture& first, const Picture& picture) {
  const std::vector<std::uint32_t> before = first.faceImage(), after = picture.faceImage();
  int changed = 0;
  for (std::size_t k = 0; k < before.size(); ++k)
    changed += before[k] != after[k] || std::abs(first.image().pixels[k] - picture.image().pixels[k]) > 1;
  return changed;
}

int mergedShades(const ColorTable& table) {
  int merged = 0;
  for (int j = 0; j + 1 < table.shades(); ++j) merged += table.color(j) == table.color(j + 1);
  return merged;
}

void judge(ExtremeStep& step, const Picture& picture) {
  step.seen = byGroundTruth(picture);
  step.shadesOff = shadesOff(picture);
  step.merged = mergedShades(picture.table());
}

/// Drives the scene one way. Returns nothing if `mayGoOn` says no.
std::optional<Extreme> driven(const Start& start, const Way& way,
                              const std::function<bool(const std::string&)>& mayGoOn) {
  Extreme extreme{way.name, way.unit, way.drives};
  std::optional<Picture> first;
  for (const double value : way.values) {
    if (!mayGoOn(std::string{way.name} + " " + shortly(value))) return std::nullopt;
    ExtremeStep& step = extreme.steps.emplace_back(ExtremeStep{.value = value});
    try {
      step.why = way.why(start, value);
      Case drive = way.at(start, value);
      const Picture picture = makePicture(std::move(drive.scene), drive.settings, 0);
      judge(step, picture);
      if (!first) first = picture;
      if (way.changesNothing) step.changed = changedFrom(*first, picture);
    } catch (const ViewError& e) {
      step.refused = e.what();
    }
  }
  return extreme;
}

}  // namespace

std::string shortly(double v) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4g", v);
  int exponent = 0;
  if (std::frexp(v, &exponent) == 0.5 && std::atof(text.data()) != v)
    return "2^" + std::to_string(exponent - 1);
  return text.data();
}

Extremes extremesOf(const Scene& scene, const PictureSettings& settings,
                    const std::function<bool(const std::string&)>& goOn, int threads) {
  if (boxOf(scene.mesh.points).side() == 0) throw ViewError{"the scene has no extent"};
  const Picture asItIs = makePicture(scene, inOneHue(settings), 0);
  const Start start = startOf(asItIs);
  const std::span<const Way> ways = extremeWays();
  Extremes extremes{.setUp = {}, .allWays = static_cast<int>(ways.size())};
  judge(extremes.setUp, asItIs);

  std::mutex turn;
  bool goesOn = true;
  std::size_t next = 0;
  std::vector<std::optional<Extreme>> done(ways.size());
  const auto mayGoOn = [&](const std::string& doing) {
    const std::scoped_lock alone{turn};
    return goesOn = goesOn && (!goOn || goOn(doing));
  };
  const auto takeWays = [&] {
    for (;;) {
      std::size_t mine = 0;
      {
        const std::scoped_lock alone{turn};
        if (!goesOn || next == ways.size()) return;
        mine = next++;
      }
      done[mine] = driven(start, ways[mine], mayGoOn);
    }
  };
  std::vector<std::future<void>> others;
  const int all = threads > 0 ? threads : static_cast<int>(std::thread::hardware_concurrency());
  for (int k = 1; k < std::min(all, extremes.allWays); ++k)
    others.push_back(std::async(std::launch::async | std::launch::deferred, takeWays));
  takeWays();
  for (std::future<void>& other : others) other.get();
  for (std::optional<Extreme>& way : done)
    if (way) extremes.ways.push_back(std::move(*way));
  return extremes;
}

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
