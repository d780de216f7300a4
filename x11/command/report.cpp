#include "x11/command/report.h"

#include <algorithm>
#include <iostream>
#include <vector>

#include "geometry/files/output_file.h"
#include "geometry/model/edges.h"
#include "shading/color/images.h"
#include "shading/color/png.h"
#include "shading/laboratory/errors.h"
#include "shading/picture/required.h"
#include "shading/scene/divide_anew.h"
#include "x11/terminal/terminal.h"
#include "x11/window/controls.h"

namespace xnewell {

namespace {

using page::Data;
using page::List;
using page::Object;

RgbImage idsOf(const Picture& picture) {
  RgbImage image{picture.settings().width, picture.settings().height};
  std::uint8_t* out = image.rgb.data();
  for (const std::uint32_t id : picture.faceImage())
    for (const int shift : {16, 8, 0}) *out++ = static_cast<std::uint8_t>(id >> shift);
  return image;
}

/// The items that were required, or why they were or were not.
Data requiredIn(const std::vector<Required>& required, bool why) {
  Object all;
  for (const Required& r : required)
    all.emplace_back(r.name, why ? Data{r.why} : std::visit([](auto what) { return Data{what}; }, r.what));
  return all;
}

/// Why --adapt stopped dividing polygons; null if it was not asked for.
Data adaptLimitOf(const Picture& picture) {
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

Object statsOf(const Options& options, const Picture& picture, const StageTimes& t) {
  const SnappedScene& scene = picture.snapped();
  const SortedScene& sorted = picture.sorted();
  const SortStatistics& sort = sorted.statistics;
  const auto painted = static_cast<std::int64_t>(sorted.fragments.size());
  const std::vector<Required> required = requiredBy(picture);
  const EdgeCounts edges = countEdges(picture.scene().mesh);
  Object tests;
  for (const TestRow& row : kTestRows)
    tests.emplace_back(row.name, row.name == "1"   ? sort.boxesApart[0]
                                 : row.name == "2" ? sort.boxesApart[1]
                                                   : sort.settled[static_cast<std::size_t>(row.id)]);
  return {{"scene", options.scene},
          {"size", List{picture.settings().width, picture.settings().height}},
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
          {"ms", Object{{"read", t.read},
                        {"shade", t.shade},
                        {"transform", t.transform},
                        {"sort", t.sort},
                        {"fill", t.fill},
                        {"present", t.present},
                        {"total", t.total()}}}};
}

Data dataOf(const WorstPlace& place) {
  const auto face = [](int number) { return number < 0 ? Data{nullptr} : Data{number}; };
  return Object{{"x", place.x},
                {"y", place.y},
                {"error", place.error},
                {"shows", place.shown},
                {"should", place.due},
                {"shows_face", face(place.shownFace)},
                {"should_face", face(place.face)}};
}

}  // namespace

Object spreadAsData(const Spread& spread) {
  return {{"mean", spread.mean},
          {"rms", spread.rootMeanSquare},
          {"p99", spread.p99},
          {"largest", spread.largest}};
}

Object errorsAsData(const Errors& errors) {
  Data patches, blocks;
  List worst;
  if (const auto& p = errors.patches)
    patches = Object{{"samples", p->samples},
                     {"mean", p->mean},
                     {"largest", p->largest},
                     {"mean_pixels", p->meanPixels},
                     {"largest_pixels", p->largestPixels}};
  if (errors.blocks) blocks = spreadAsData(*errors.blocks);
  for (const WorstPlace& place : errors.worst) worst.push_back(dataOf(place));
  return {{"samples", errors.samples},
          {"wrong_faces", errors.wrongFaces},
          {"intensity", Object{{"before_table", spreadAsData(errors.beforeTable)},
                               {"after_table", spreadAsData(errors.afterTable)}}},
          {"ciede2000", spreadAsData(errors.color)},
          {"distance_to_patches", patches},
          {"blocks_8x8", blocks},
          {"worst", worst}};
}

PictureSettings settingsOf(const Options& options, glm::ivec2 usual) {
  PictureSettings settings = options.picture;
  const glm::ivec2 size = options.size.value_or(usual);
  settings.width = size.x, settings.height = size.y;
  return settings;
}

void print(const Options& options, const page::Page& page) {
  std::cout << (options.json ? asJson(page) : asText(page)) << std::flush;
}

std::optional<Errors> measuredErrors(const Options& options, const Picture& picture) {
  if (!options.errors) return std::nullopt;
  const Doing measuring{"measuring the errors"};
  try {
    return errorsOf(picture, picture.palette(CellPlan{picture.settings().table.kind}));
  } catch (const ViewError& e) {
    throw ViewError{"the errors cannot be measured (the picture can be drawn without --errors): " +
                    std::string{e.what()}};
  }
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

void report(const Options& options, const Picture& picture, const std::optional<Errors>& errors,
            const StageTimes& times, const Data& accuracy, const Sent* sent) {
  noteNoEffect(std::cerr, options, picture);
  if (!options.stats) return;
  Object stats = statsOf(options, picture, times);
  if (accuracy.index() > 0) stats.emplace_back("accuracy", accuracy);
  if (sent != nullptr)
    stats.emplace_back("sent", Object{{"requests", sent->requests},
                                      {"bytes", sent->bytes},
                                      {"image_bytes", sent->imageBytes},
                                      {"bits_per_pixel", sent->bitsPerPixel},
                                      {"shared_memory", sent->sharedMemory}});
  if (errors) {
    Object found = errorsAsData(*errors);
    found.emplace_back("reference_divisions", finestDivisions(picture.scene()));
    stats.emplace_back("errors", found);
  }
  std::cout << page::asJson(stats);
}

}  // namespace xnewell
