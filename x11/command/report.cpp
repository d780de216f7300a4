#include "x11/command/report.h"

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>
#include <vector>

#include "geometry/files/output_file.h"
#include "geometry/model/edges.h"
#include "shading/color/png.h"
#include "shading/color/rgb_image.h"
#include "shading/laboratory/exactness.h"
#include "shading/picture/required.h"
#include "shading/scene/divide_anew.h"
#include "x11/command/errors_json.h"
#include "x11/command/trade_report.h"
#include "x11/terminal/doing.h"
#include "x11/window/moot.h"

namespace xnewell {

namespace {

RgbImage idsOf(const Picture& picture) {
  RgbImage image{picture.settings().width, picture.settings().height};
  std::uint8_t* out = image.rgb.data();
  for (const std::uint32_t id : picture.faceImage())
    for (const int shift : {16, 8, 0}) *out++ = static_cast<std::uint8_t>(id >> shift);
  return image;
}

/// The items that were required, or why they were or were not.
nlohmann::ordered_json requiredIn(const std::vector<Required>& required, bool why) {
  // If memory is refused to a null value that becomes an object, the library reads it all the same.
  auto json = nlohmann::ordered_json::object();
  for (const Required& r : required)
    if (why)
      json[std::string{r.name}] = r.why;
    else
      std::visit([&](auto what) { json[std::string{r.name}] = what; }, r.what);
  return json;
}

/// Why --adapt stopped dividing polygons; null if it was not asked for.
nlohmann::ordered_json adaptLimitOf(const Picture& picture) {
  const PictureSettings& s = picture.settings();
  if (s.adapt == 0.0 || (s.shading != Shading::Flat && s.shading != Shading::Gouraud)) return nullptr;
  const std::optional<Refined>& refined = picture.shading().refined();
  const RefineLimit limit = refined ? refined->limit : RefineLimit::None;  // no division: only ambient light
  return kRefineLimits[static_cast<int>(limit)].name;
}

/// The samples that show a farther face which rounding alone may part from the nearest. An exact order shows
/// the nearest face everywhere, unless it met a contact; only then they are counted, which takes as long as a
/// picture of the oracle.
int doubtfulIn(const Picture& picture) {
  const SortStatistics& sort = picture.sorted().statistics;
  const bool exact = rowOf(picture.settings().order).exact && sort.contacts == 0 && sort.voids == 0;
  return exact ? 0 : exactnessOf(picture).doubtful;
}

nlohmann::ordered_json statsOf(const Options& options, const Picture& picture, const StageTimes& t) {
  const SnappedScene& scene = picture.snapped();
  const SortedScene& sorted = picture.sorted();
  const SortStatistics& sort = sorted.statistics;
  const auto painted = static_cast<std::int64_t>(sorted.fragments.size());
  const std::vector<Required> required = requiredBy(picture);
  const EdgeCounts edges = countEdges(picture.scene().mesh);
  auto tests = nlohmann::ordered_json::object();
  for (const TestRow& row : kTestRows) tests[std::string{row.name}] = sort.settled[static_cast<int>(row.id)];
  tests["1"] = sort.boxesApart[0];
  tests["2"] = sort.boxesApart[1];
  return {{"scene", options.scene},
          {"size", {picture.settings().width, picture.settings().height}},
          {"faces", picture.scene().mesh.faceCount()},
          {"open_edges", edges.open},
          {"turned_edges", edges.turned},
          {"crowded_edges", edges.crowded},
          {"polygons", scene.polygons},
          {"degenerate", scene.degenerate},
          {"culled", scene.culled},
          {"outside", scene.outside},
          {"cut_by_front", picture.camera().cutByFront},
          {"in_view", static_cast<std::int64_t>(scene.faces.size())},
          {"fragments", painted},
          {"painted", painted},
          {"free", sort.free},
          {"planes_made", scene.planes.made()},
          {"splits", sort.splits},
          {"areas", sort.areas},
          {"hidden", sort.hidden},
          {"cycles", sort.cycles},
          {"contacts", sort.contacts},
          {"tree_nodes", sort.nodes},
          {"tree_depth", sort.nodes > 0 ? sort.deepest : 0},
          {"depth_tests", sort.depthTests},
          {"order_bytes", sort.bytes},
          {"doubtful", doubtfulIn(picture)},
          {"tests", tests},
          {"saturated", picture.saturated()},
          {"shading", rowOf(picture.settings().shading).name},
          {"colors", kColorPlans[static_cast<int>(picture.colors().plan())].name},
          {"adapt_limit", adaptLimitOf(picture)},
          {"required", requiredIn(required, /*why=*/false)},
          {"required_because", requiredIn(required, /*why=*/true)},
          {"ms",
           {{"read", t.read},
            {"shade", t.shade},
            {"transform", t.transform},
            {"sort", t.sort},
            {"fill", t.fill},
            {"present", t.present},
            {"total", t.total()}}}};
}

}  // namespace

Measurements measured(const Options& options, const Picture& picture) {
  Measurements measured;
  if (options.costs) {
    const Doing measuring{"measuring what each item costs"};
    measured.costs = itemCostsOf(picture, {.seconds = 2, .leastRounds = 3});
  }
  if (options.errors) try {
      const Doing measuring{"measuring the errors"};
      measured.errors = errorsOf(picture, picture.palette(CellPlan{picture.settings().table.kind}));
    } catch (const ViewError& e) {
      throw ViewError{"the errors cannot be measured (the picture can be drawn without --errors): " +
                      std::string{e.what()}};
    }
  return measured;
}

void writePictures(const Options& options, const Picture& picture, const std::string& png) {
  std::vector<OutputFile> files{{options.output, png}};
  std::string ids;
  if (!options.ids.empty()) {
    ids = encodePng(idsOf(picture));
    files.push_back({options.ids, ids});
  }
  writeFiles(files);
}

void report(const Options& options, const Picture& picture, const Measurements& measured,
            const StageTimes& times, const nlohmann::ordered_json& accuracy, const Sent* sent) {
  noteMoot(std::cerr, options, picture);
  if (!options.stats) return;
  // A file name need not be UTF-8, but JSON can hold nothing else.
  nlohmann::ordered_json stats = statsOf(options, picture, times);
  if (!accuracy.is_null()) stats["accuracy"] = accuracy;
  if (sent != nullptr)
    stats["sent"] = {{"requests", sent->requests},
                     {"bytes", sent->bytes},
                     {"image_bytes", sent->imageBytes},
                     {"bits_per_pixel", sent->bitsPerPixel},
                     {"shared_memory", sent->sharedMemory}};
  if (options.costs) stats["required_cost_ms"] = itemCostsAsJson(measured.costs);
  if (measured.errors) {
    stats["errors"] = errorsAsJson(*measured.errors);
    stats["errors"]["reference_divisions"] = finestDivisions(picture.scene());
  }
  std::cout << stats.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
}

}  // namespace xnewell
