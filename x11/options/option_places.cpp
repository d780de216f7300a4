#include <initializer_list>
#include <string_view>
#include <vector>

#include "x11/options/option_reader.h"

namespace xnewell {

void addPlaces(Reader& r) {
  const auto only = [&](std::initializer_list<const char*> names,
                        const std::vector<std::string_view>& places) {
    for (const char* name : names) r.only(name, places);
  };
  only({"--output"}, {"draw", "snapshot", "figure", "trade", "extremes", "diagnose", "judge", "grade"});
  only({"--size"}, {"view", "draw", "snapshot", "figure", "explain", "trace", "trade", "extremes", "diagnose",
                    "judge", "grade", "questions", "lesson", "lecture"});
  only({"--scale"}, {"view", "lesson", "lecture", "--whole-window"});
  only({"--visual", "--colormap", "--nearest"}, {"view", "snapshot", "lesson", "lecture", "visuals"});
  only({"--view"}, {"view", "draw", "snapshot"});
  only({"--step"}, {"--view depthsort", "--view viewing", "--view scanline", "lesson"});
  only({"--pixel"}, {"--view pixel"});
  only({"--viewing"}, {"explain", "--view viewing"});
  only({"--controls"}, {"view", "--whole-window"});
  only({"--beside", "--difference"}, {"--view sidebyside"});
  only({"--scanline"}, {"--view machbands", "--view scanline", "trace"});
  only({"--cell"}, {"--view colours"});
  only({"--store", "--turn", "--gamma", "--bend", "--rotate", "--lit"}, {"draw", "snapshot"});
  only({"--bare", "--ids", "--stats", "--errors"}, {"draw", "snapshot", "figure"});
  only({"--costs"}, {"draw", "snapshot"});
  only({"--paper", "--tolerance", "--smooth"}, {"figure"});
  only({"--edges", "--edge-color"}, {"view", "draw", "snapshot", "figure"});
  only({"--accuracy"}, {"view", "draw", "snapshot"});
  only({"--json"}, {"explain", "trade", "extremes", "diagnose", "judge"});
  only({"--axes", "--without"}, {"trade"});
  only({"--budget"}, {"trade", "--accuracy"});
  only({"--whole-window"}, {"snapshot", "trace --frames"});
  only({"--quick"}, {"trace"});
  only({"--frames"}, {"trace", "lesson"});
  only({"--every"}, {"trace --frames"});
  only({"--play"}, {"lecture"});
  only({"--answers"}, {"lesson", "lecture"});
  only({"--scene-for"}, {"diagnose"});
  only({"--run"}, {"judge"});
  only({"--page"}, {"grade"});
  only({"--count", "--seed", "--gift"}, {"questions"});
  only({"--worksheet"}, {"lesson"});
}

}  // namespace xnewell
