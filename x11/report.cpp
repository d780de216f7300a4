#include "x11/report.h"

#include <iostream>
#include <nlohmann/json.hpp>
#include <vector>

#include "shading/output_file.h"
#include "shading/png.h"
#include "shading/rgb_image.h"

namespace {

RgbImage idsOf(const Picture& picture) {
  RgbImage image{picture.settings().width, picture.settings().height};
  std::uint8_t* out = image.rgb.data();
  for (const std::uint32_t id : picture.faceImage())
    for (const int shift : {16, 8, 0}) *out++ = static_cast<std::uint8_t>(id >> shift);
  return image;
}

/// What of the model this picture needed: nothing is computed for the rest.
nlohmann::ordered_json requiredBy(const Picture& picture) {
  const PictureSettings& s = picture.settings();
  const bool lit = s.shading != Shading::Full;
  return {{"illumination", lit},
          {"specular", lit && s.light.ks > 0},
          {"divided_faces",
           static_cast<int>(picture.scene().pieces.face.size()) - picture.scene().mesh.faceCount()}};
}

/// Of --adapt: what ended the division of polygons, null where none was asked for.
nlohmann::ordered_json adaptLimitOf(const Picture& picture) {
  const std::optional<Refined>& refined = picture.shading().refined();
  return refined ? nlohmann::ordered_json(kRefineLimits[static_cast<int>(refined->limit)].name) : nullptr;
}

nlohmann::ordered_json statsOf(const Options& options, const Picture& picture, const StageTimes& t) {
  const SnappedScene& scene = picture.snapped();
  const SortedScene& sorted = picture.sorted();
  const SortStatistics& sort = sorted.statistics;
  nlohmann::ordered_json tests;
  for (const TestRow& row : kTestRows) tests[std::string{row.name}] = sort.settled[static_cast<int>(row.id)];
  tests["1"] = sort.boxesApart[0];
  tests["2"] = sort.boxesApart[1];
  return {{"scene", options.scene},
          {"size", {picture.settings().width, picture.settings().height}},
          {"faces", picture.scene().mesh.faceCount()},
          {"polygons", scene.polygons},
          {"degenerate", scene.degenerate},
          {"culled", scene.culled},
          {"outside", scene.outside},
          {"fragments", static_cast<std::int64_t>(scene.faces.size()) + sort.splits},
          {"painted", static_cast<std::int64_t>(sorted.fragments.size())},
          {"splits", sort.splits},
          {"cycles", sort.cycles},
          {"contacts", sort.contacts},
          {"tests", tests},
          {"saturated", picture.saturated()},
          {"adapt_limit", adaptLimitOf(picture)},
          {"required", requiredBy(picture)},
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

void writePictures(const Options& options, const Picture& picture, const std::string& png) {
  std::vector<OutputFile> files{{options.output, png}};
  std::string ids;
  if (!options.ids.empty()) {
    ids = encodePng(idsOf(picture));
    files.push_back({options.ids, ids});
  }
  writeFiles(files);
}

void report(const Options& options, const Picture& picture, const StageTimes& times) {
  if (!options.stats) return;
  // A file's name may be no UTF-8, which JSON cannot hold.
  std::cout << statsOf(options, picture, times)
                   .dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace)
            << '\n';
}
